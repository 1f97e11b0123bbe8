#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "apps/record/posix_file.hpp"
#include "apps/record/unfinished_files.hpp"

namespace swirl::apps {

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
