// SPDX-License-Identifier: MIT
#include "host_min/output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <random>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>

#include "host_min/error.hpp"

namespace gno::host {
namespace fs = std::filesystem;

/// A temporary of this process, in a list that a signal handler may walk at any time: what is in it is never changed but for `there`, and never
/// freed. That is some hundred bytes for each file written.
struct AtomicFile::Temporary {
    const std::string path;
    const Temporary* const next;
    std::atomic<bool> there{true};
};

namespace {

std::atomic<AtomicFile::Temporary*> temporaries{nullptr};
static_assert(std::atomic<AtomicFile::Temporary*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

std::string reason(int error) { return std::generic_category().message(error); }

/// Errors that another path cures.
bool isUsersMistake(int error) {
    return error == ENOENT || error == ENOTDIR || error == EACCES || error == EPERM || error == EROFS || error == EISDIR || error == ENAMETOOLONG ||
           error == ELOOP || error == ENXIO;
}

/// Errors of a full disk, or of a quota or a limit of file sizes.
bool isNoRoom(int error) { return error == ENOSPC || error == EDQUOT || error == EFBIG; }

constexpr const char* kMakeRoom = "; make room, or name a place with more of it";

[[noreturn]] void refuse(const fs::path& target, const std::string& why, int error) {
    const std::string text = fmt::format("cannot write '{}': {}", target.string(), why);
    if (isUsersMistake(error)) throw InputError(text + "; name a file in an existing folder that you may write to");
    if (isNoRoom(error)) throw RoomError(text + kMakeRoom);
    throw WorkError(text);
}

bool isStraight(const fs::path& target) {
    const std::string absolute = fs::absolute(target).lexically_normal().string();
    if (absolute.starts_with("/dev/") || absolute.starts_with("/proc/")) return true;
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string randomSuffix() {
    static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device device;
    std::uniform_int_distribution<std::size_t> pick(0, letters.size() - 1);
    std::string suffix;
    for (int i = 0; i < 8; ++i) suffix += letters[pick(device)];
    return suffix;
}

}  // namespace

/// A seekable stream buffer on a file descriptor that keeps the first error.
class AtomicFile::Buffer : public std::streambuf {
public:
    explicit Buffer(int fd) : fd_(fd) { setp(bytes_.data(), bytes_.data() + bytes_.size()); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() override {
        if (fd_ >= 0) ::close(fd_);
    }

    [[nodiscard]] int error() const { return error_; }

    /// Writes what is left and closes; the first error of all, or 0.
    int finish() {
        flush();
        const int fd = fd_;
        fd_ = -1;
        if (::close(fd) != 0 && error_ == 0 && errno != EINTR) error_ = errno;
        return error_;
    }

protected:
    int_type overflow(int_type c) override {
        if (!flush()) return traits_type::eof();
        if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
        *pptr() = traits_type::to_char_type(c);
        pbump(1);
        return c;
    }

    std::streamsize xsputn(const char* data, std::streamsize count) override {
        if (count <= epptr() - pptr()) {
            std::memcpy(pptr(), data, static_cast<std::size_t>(count));
            pbump(static_cast<int>(count));
            return count;
        }
        return flush() && write(data, static_cast<std::size_t>(count)) ? count : 0;
    }

    int sync() override { return flush() ? 0 : -1; }

    pos_type seekoff(off_type offset, std::ios_base::seekdir direction, std::ios_base::openmode) override {
        if (direction == std::ios_base::cur && offset == 0) {  // tellp: no need to write
            const off_t at = error_ == 0 ? ::lseek(fd_, 0, SEEK_CUR) : -1;
            return at < 0 ? pos_type(off_type(-1)) : pos_type(at + (pptr() - pbase()));
        }
        if (!flush()) return pos_type(off_type(-1));
        const int whence = direction == std::ios_base::beg ? SEEK_SET : direction == std::ios_base::cur ? SEEK_CUR : SEEK_END;
        const off_t at = ::lseek(fd_, offset, whence);
        if (at < 0) error_ = errno;
        return pos_type(at);
    }

    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override { return seekoff(off_type(position), std::ios_base::beg, mode); }

private:
    bool flush() {
        const auto count = static_cast<std::size_t>(pptr() - pbase());
        setp(bytes_.data(), bytes_.data() + bytes_.size());
        return write(bytes_.data(), count);
    }

    bool write(const char* data, std::size_t count) {
        if (fd_ < 0 && error_ == 0) error_ = EBADF;
        while (error_ == 0 && count > 0) {
            const ssize_t written = ::write(fd_, data, count);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) {
                error_ = written < 0 ? errno : ENOSPC;
            } else {
                data += written;
                count -= static_cast<std::size_t>(written);
            }
        }
        return error_ == 0;
    }

    int fd_;
    int error_ = 0;
    std::array<char, 65536> bytes_;
};

AtomicFile::Temporary* AtomicFile::remember(const std::string& path) {
    Temporary* first = temporaries.load();
    while (true) {
        auto* made = new Temporary{path, first};
        if (temporaries.compare_exchange_strong(first, made)) return made;
        delete made;
    }
}

AtomicFile::AtomicFile(const fs::path& target) : target_(target), stream_(nullptr) {
    std::error_code status;
    if (target.empty() || target.filename().empty()) refuse(target, "no file name", ENOENT);
    if (fs::is_directory(target, status)) refuse(target, "it is a folder", EISDIR);
    int fd = -1;
    if (isStraight(target)) {
        temporary_ = target;
        fd = ::open(target.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
        if (fd < 0) refuse(target, reason(errno), errno);
    } else {
        const fs::path real = fs::is_symlink(target, status) ? fs::weakly_canonical(target, status) : target;
        if (!real.empty()) target_ = real;
        struct stat before {};
        const bool exists = ::stat(target_.c_str(), &before) == 0;
        if (!exists && (errno == ENAMETOOLONG || errno == ELOOP)) refuse(target, reason(errno), errno);
        const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
        do {
            temporary_ = folder / fmt::format(".{}.{}.part", target_.filename().string().substr(0, 200), randomSuffix());
            remembered_ = remember(temporary_.string());  // before it is there: an interrupt may come between
            fd = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (fd < 0) remembered_->there = false;
        } while (fd < 0 && errno == EEXIST);
        if (fd < 0) {
            const int error = errno;
            if (error == ENOENT) refuse(target, fmt::format("there is no folder '{}'", folder.string()), error);
            if (error == ENOTDIR) refuse(target, fmt::format("'{}' is no folder", folder.string()), error);
            refuse(target, reason(error), error);
        }
        if (exists) {  // a file that is replaced keeps its access rights
            [[maybe_unused]] const int ignored = ::fchmod(fd, before.st_mode & 07777);
        }
    }
    try {
        buffer_ = std::make_unique<Buffer>(fd);
    } catch (...) {
        ::close(fd);
        discard();
        throw;
    }
    stream_.rdbuf(buffer_.get());
}

AtomicFile::~AtomicFile() {
    stream_.rdbuf(nullptr);
    if (buffer_ == nullptr) return;
    buffer_.reset();
    discard();
}

void AtomicFile::discard() {
    if (remembered_ == nullptr) return;
    ::unlink(temporary_.c_str());
    remembered_->there = false;
}

const fs::path& AtomicFile::target() const { return target_; }
const fs::path& AtomicFile::temporary() const { return temporary_; }
std::ostream& AtomicFile::stream() { return stream_; }

void AtomicFile::fail(int error) {
    const bool kept = temporary_ != target_;
    stream_.rdbuf(nullptr);
    buffer_.reset();
    discard();
    const std::string text =
        fmt::format("cannot write '{}': {}{}", target_.string(), reason(error), kept ? "; what was there before is unchanged" : "");
    if (isNoRoom(error)) throw RoomError(text + kMakeRoom);
    throw WorkError(text);
}

void AtomicFile::commit() {
    if (buffer_ == nullptr) throw std::logic_error("AtomicFile::commit: committed before, or failed");
    const int error = buffer_->finish();
    if (error != 0) fail(error);
    if (stream_.bad()) fail(EIO);
    if (temporary_ != target_ && ::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    stream_.rdbuf(nullptr);
    buffer_.reset();
    if (remembered_ != nullptr) remembered_->there = false;
}

void removeUnfinishedFiles() noexcept {
    for (const AtomicFile::Temporary* file = temporaries.load(); file != nullptr; file = file->next)
        if (file->there) ::unlink(file->path.c_str());
}

void makeFolder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return;
    const std::string text = fmt::format("cannot make the folder '{}': ", path.string());
    if (!error) throw InputError(text + "a file is in the way; name another folder");
    if (isUsersMistake(error.value()) || error.value() == EEXIST) throw InputError(text + error.message() + "; name another folder");
    if (isNoRoom(error.value())) throw RoomError(text + error.message() + kMakeRoom);
    throw WorkError(text + error.message());
}

}  // namespace gno::host
