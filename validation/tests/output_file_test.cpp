// SPDX-License-Identifier: MIT
// Files are complete or not there, whatever goes wrong while they are written.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"

using namespace gno::host;
namespace fs = std::filesystem;

namespace {

class OutputFile : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / ("gnomon_output_file_" + std::string(test->name()) + "_" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::size_t entries() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})); }
    static std::string read(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

    fs::path folder_;
};

/// Files may not grow beyond `bytes` while this lives; a longer write then fails with EFBIG.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

std::string textOfRoomError(AtomicFile& file) {
    try {
        file.commit();
    } catch (const RoomError& error) {
        return error.what();
    }
    return "no RoomError";
}

}  // namespace

TEST_F(OutputFile, CommitReplacesTheTargetAndLeavesNothingElse) {
    const fs::path target = folder_ / "result.txt";
    write(target, "old");
    AtomicFile file(target);
    file.stream() << "new " << 42;
    EXPECT_EQ(read(target), "old");
    EXPECT_EQ(file.temporary().parent_path(), folder_);
    EXPECT_TRUE(file.temporary().filename().string().starts_with(".result.txt."));
    EXPECT_EQ(file.temporary().extension(), ".part");
    EXPECT_TRUE(fs::exists(file.temporary()));
    file.commit();
    EXPECT_EQ(read(target), "new 42");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFile, ManyBytesAndSeeksArriveInPlace) {
    const fs::path target = folder_ / "big.bin";
    std::string want(300'000, 'x');
    for (std::size_t i = 0; i < want.size(); ++i) want[i] = static_cast<char>('a' + i * 7 % 26);
    AtomicFile file(target);
    file.stream().write(want.data(), 10);
    for (std::size_t at = 10; at < 1000; ++at) file.stream().put(want[at]);
    EXPECT_EQ(std::streamoff(file.stream().tellp()), 1000);
    file.stream().write(want.data() + 1000, static_cast<std::streamsize>(want.size() - 1000));
    file.stream().seekp(5);
    file.stream() << "HELLO";
    file.stream().seekp(0, std::ios::end);
    EXPECT_EQ(std::streamoff(file.stream().tellp()), 300'000);
    file.stream() << "END";
    file.commit();
    want.replace(5, 5, "HELLO");
    EXPECT_TRUE(read(target) == want + "END");
}

TEST_F(OutputFile, AnExceptionLeavesTheTargetAndNoTemporary) {
    const fs::path target = folder_ / "result.txt";
    write(target, "old");
    try {
        AtomicFile file(target);
        file.stream() << "half of it" << std::flush;
        throw WorkError("interrupted");
    } catch (const WorkError&) {
    }
    EXPECT_EQ(read(target), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFile, AFullDiskIsARoomErrorThatNamesFileAndReason) {
    const fs::path target = folder_ / "result.bin";
    write(target, "old");
    {
        AtomicFile file(target);
        const FileSizeLimit limit(4096);
        const std::string chunk(100'000, 'x');
        file.stream() << chunk;
        EXPECT_TRUE(file.stream().bad());
        const std::string text = textOfRoomError(file);
        EXPECT_NE(text.find("result.bin"), std::string::npos) << text;
        EXPECT_NE(text.find("File too large"), std::string::npos) << text;
    }
    EXPECT_EQ(read(target), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFile, AnErrorThatShowsOnlyAtTheEndIsSeenToo) {
    AtomicFile file(folder_ / "result.bin");
    const FileSizeLimit limit(4096);
    file.stream() << std::string(10'000, 'x');  // fits the buffer: nothing is written before commit()
    EXPECT_TRUE(file.stream().good());
    EXPECT_NE(textOfRoomError(file).find("File too large"), std::string::npos);
    EXPECT_EQ(entries(), 0u);
}

TEST_F(OutputFile, ADeviceIsWrittenStraight) {
    {
        AtomicFile file("/dev/null");
        file.stream() << "gone";
        file.commit();
    }
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    AtomicFile full("/dev/full");
    full.stream() << "does not fit";
    EXPECT_NE(textOfRoomError(full).find("No space left on device"), std::string::npos);
}

TEST_F(OutputFile, ALinkIsFollowed) {
    write(folder_ / "real.txt", "old");
    fs::create_symlink("real.txt", folder_ / "link.txt");
    AtomicFile file(folder_ / "link.txt");
    file.stream() << "new";
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
    EXPECT_EQ(read(folder_ / "real.txt"), "new");
}

TEST_F(OutputFile, PathsThatCannotBeAreInputErrors) {
    write(folder_ / "file", "text");
    EXPECT_THROW(AtomicFile(folder_ / "file" / "result.txt"), InputError);
    EXPECT_THROW(AtomicFile(folder_ / "missing" / "result.txt"), InputError);
    EXPECT_THROW(AtomicFile{folder_}, InputError);
    EXPECT_THROW(AtomicFile{fs::path()}, InputError);
    EXPECT_THROW(AtomicFile(folder_ / std::string(300, 'n')), InputError);
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFile, AFolderWithoutWriteAccessIsAnInputError) {
    // Who is root may write anywhere, so the case is made with a folder of the kernel that takes no files.
    const fs::path closed = ::geteuid() == 0 ? fs::path("/sys/kernel") : folder_ / "closed";
    if (::geteuid() != 0) {
        fs::create_directory(closed);
        fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
    }
    EXPECT_THROW(AtomicFile(closed / "result.txt"), InputError);
    if (::geteuid() != 0) fs::permissions(closed, fs::perms::owner_all);
}

TEST_F(OutputFile, FoldersAreMadeUnlessAFileIsInTheWay) {
    makeFolder(folder_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
    makeFolder(folder_ / "a" / "b");
    makeFolder(folder_ / "c/");
    EXPECT_TRUE(fs::is_directory(folder_ / "c"));
    write(folder_ / "file", "text");
    EXPECT_THROW(makeFolder(folder_ / "file"), InputError);
    EXPECT_THROW(makeFolder(folder_ / "file" / "below"), InputError);
}

TEST_F(OutputFile, TheEmergencyExitRemovesWhatIsUnfinishedOnly) {
    AtomicFile done(folder_ / "done.txt");
    done.stream() << "done";
    done.commit();
    AtomicFile open(folder_ / "open.txt");
    ASSERT_TRUE(fs::exists(open.temporary()));
    removeUnfinishedFiles();
    EXPECT_FALSE(fs::exists(open.temporary()));
    EXPECT_EQ(read(folder_ / "done.txt"), "done");
    EXPECT_EQ(entries(), 1u);
}

// A handler may run in any thread at any time; here it ends the process, and what is left is looked at from outside.
TEST_F(OutputFile, ASecondSignalEndsTheProcessAndRemovesWhatIsUnfinished) {
    const auto twice = [&] {
        catchInterrupts("writer", removeUnfinishedFiles);
        AtomicFile done(folder_ / "done.txt");
        done.commit();
        AtomicFile open(folder_ / "open.txt"), other(folder_ / "other.txt");
        open.stream() << "half" << std::flush;
        std::raise(SIGTERM);
        std::raise(SIGINT);
        std::abort();
    };
    EXPECT_EXIT(twice(), testing::ExitedWithCode(1), "^writer: interrupted; nothing half-written is left\n$");
    EXPECT_TRUE(fs::exists(folder_ / "done.txt"));
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFile, WithoutACheckTheProcessEndsAfterTwoSeconds) {
    const auto stuck = [&] {
        catchInterrupts("writer", removeUnfinishedFiles);
        AtomicFile open(folder_ / "open.txt");
        std::raise(SIGTERM);
        std::this_thread::sleep_for(std::chrono::seconds(60));
    };
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EXIT(stuck(), testing::ExitedWithCode(1), "^writer: interrupted");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_EQ(entries(), 0u);
}

TEST_F(OutputFile, AfterACheckTheProcessHasAllTheTimeItNeeds) {
    const auto slow = [&] {
        catchInterrupts("writer", removeUnfinishedFiles);
        std::raise(SIGTERM);
        try {
            throwIfInterrupted();
        } catch (const Interrupted&) {
            std::exit(::alarm(0) == 0 ? 3 : 4);  // 4: the end was still to come
        }
    };
    EXPECT_EXIT(slow(), testing::ExitedWithCode(3), "");
}
