// SPDX-License-Identifier: MIT
// Files that are either complete or not there: written beside their place under a hidden name, and renamed.
// An interrupt must reach the writer as an exception, so that destructors run: the program polls a flag that its signal handler sets.
// The program ignores SIGXFSZ and SIGPIPE at start, so that a file size limit or a closed pipe is an error here and no sudden death.
#pragma once
#include <filesystem>
#include <memory>
#include <ostream>

namespace gno::host {

/// One file being written. A target under /dev or /proc, or one that is a pipe or a device, is written straight; a symbolic link is followed.
class AtomicFile {
public:
    /// Opens `.NAME.XXXXXXXX.part` in the target's folder. Throws InputError: the folder is missing, a file, or not writable; the target is a
    /// folder. Throws RoomError: a full disk; WorkError: anything else.
    explicit AtomicFile(const std::filesystem::path& target);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    /// Removes the temporary when it was not committed; the target is then what it was before.
    ~AtomicFile();

    [[nodiscard]] const std::filesystem::path& target() const;
    [[nodiscard]] const std::filesystem::path& temporary() const;  ///< equals target() when that is written straight

    /// Where to write; can seek. A failed write sets badbit, and commit() tells the reason.
    [[nodiscard]] std::ostream& stream();

    /// Writes what is left, closes and renames. Throws RoomError (a full disk) or WorkError naming the target and the first error of any write; the
    /// temporary is gone then.
    void commit();

    struct Temporary;  ///< for removeUnfinishedFiles()

private:
    class Buffer;
    static Temporary* remember(const std::string& path);
    void discard();
    [[noreturn]] void fail(int error);
    std::filesystem::path target_, temporary_;
    Temporary* remembered_ = nullptr;  ///< null where the target is written straight
    std::unique_ptr<Buffer> buffer_;
    std::ostream stream_;
};

/// Removes the temporaries of all AtomicFiles alive in this process; for a way out that runs no destructors. Async-signal-safe: no lock, no memory.
void removeUnfinishedFiles() noexcept;

/// Makes `path` and its parents where they are missing. Throws InputError: a file is in the way, or no right to make it; RoomError: a full disk;
/// WorkError: else.
void makeFolder(const std::filesystem::path& path);

}  // namespace gno::host
