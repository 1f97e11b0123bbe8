#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace swirl::apps {

/// Owns a POSIX file descriptor.
class PosixFile {
public:
    PosixFile() = default;
    explicit PosixFile(int descriptor) : descriptor_(descriptor) {}
    PosixFile(PosixFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    PosixFile& operator=(PosixFile&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~PosixFile();

    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    int descriptor_ = -1;
};

/// The text of errno.
std::string system_reason();

/// Opens `path` for reading and writing, creates it when it is missing, and takes the advisory lock (flock) that keeps
/// every other writer of the same file out until it is closed. `action` and `name` begin the RecordError of a failure,
/// which includes the lock being held elsewhere.
PosixFile open_locked(const std::filesystem::path& path, const std::string& action, const std::string& name);

/// Writes where the file stands, whatever interrupts it. RecordError(action, name, ...) if it can't.
void write_all(const PosixFile& file, std::span<const std::byte> bytes, const std::string& action,
               const std::string& name);

/// Do two names, or a name and an open descriptor, lead to one file (the same name, a link, a hard link)? False where
/// one of them is missing.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);
bool is_same_file(const std::filesystem::path& path, int descriptor);

/// What a plain file of this name could not be created for, if anything: its directory is missing or is no directory,
/// something that is not a regular file has the name, a file of that name may not be written.
std::optional<std::string> obstacle_to_creating(const std::filesystem::path& path);

}  // namespace swirl::apps
