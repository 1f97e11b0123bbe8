// Files that are written: under another name until they are whole, and cleared away if they never are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// A file that means nothing until it is finished: one that is being written, a journal without an entry. While this
/// lives, remove_unfinished_files() removes it. The list has room for a few dozen; what does not fit is left to the
/// writer's own clearing up.
class UnfinishedFile {
public:
    UnfinishedFile() = default;
    explicit UnfinishedFile(const std::filesystem::path& path);
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    ~UnfinishedFile() { finished(); }

    /// It has got its meaning, or is gone.
    void finished() noexcept;

private:
    std::optional<std::size_t> place_;
};

/// Removes them all; nothing is to be written to them afterwards. For a process that has to leave: may be called
/// from the handler of a signal, whatever the process was doing.
void remove_unfinished_files() noexcept;

/// Where a file is written until it is whole: `.NAME.partial` beside it, or beside what a link points to.
std::filesystem::path partial_path_of(const std::filesystem::path& target);

/// A file that appears under its name only when it is whole. It is written as `.NAME.partial` beside the target (a
/// rename is atomic only within one file system) and takes the target's place in commit(). What stood under the
/// target's name stays untouched until then, and for good if commit() is never reached: the destructor removes the
/// partial file. A file that is replaced leaves its group and permissions to the new one. The partial file is locked
/// against a second writer; one left by a killed process is not locked and is written over.
class OutputFile {
public:
    /// Creates the partial file, empty. RecordError if the target could not be created: no such directory, a directory
    /// or a device of that name, no permission, another process writing it.
    ///   what  it is, for messages: "cannot create record 'a.h5': …"
    explicit OutputFile(const std::filesystem::path& target, std::string what = "record");
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Where to write until commit().
    [[nodiscard]] const std::filesystem::path& partial_path() const { return partial_; }
    /// Of the partial file, open for reading and writing.
    [[nodiscard]] int descriptor() const { return file_.descriptor(); }
    /// As the user gave it, for messages.
    [[nodiscard]] const std::filesystem::path& name() const { return name_; }

    /// Writes at the end. RecordError if that fails.
    void append(std::string_view text) const;

    /// RecordError if the disk has no room for so many. To be called before anything is written.
    void find_room(std::size_t bytes) const;

    /// Puts the partial file's bytes on the disk (fsync) and renames it. RecordError if either fails.
    void commit();

private:
    std::string what_;
    std::filesystem::path name_;
    std::filesystem::path target_;
    std::filesystem::path partial_;
    UnfinishedFile unfinished_;
    PosixFile file_;
    bool committed_ = false;
};

}  // namespace swirl::apps
