#include "apps/record/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/record/record_error.hpp"

namespace swirl::apps {

namespace {

// A link's own file is replaced, not the link.
std::filesystem::path resolve_link(const std::filesystem::path& path) {
    std::error_code missing;
    std::filesystem::path resolved = std::filesystem::canonical(path, missing);
    return missing ? path : resolved;
}

// Owner, group and permissions of what is going to be replaced, as far as the system lets one give them. Who was not
// let in by the old group is not let in by another one.
void take_permissions(const PosixFile& file, const std::filesystem::path& target) {
    struct stat old {};
    if (::stat(target.c_str(), &old) != 0) return;
    mode_t mode = old.st_mode & 07777;
    const bool has_group = ::fchown(file.descriptor(), static_cast<uid_t>(-1), old.st_gid) == 0;
    if (!has_group) mode &= ~static_cast<mode_t>(070);
    // Only the system's administrator can give a file away: for everyone else it stays the writer's own.
    static_cast<void>(::fchown(file.descriptor(), old.st_uid, static_cast<gid_t>(-1)) == 0);
    ::fchmod(file.descriptor(), mode);
}

}  // namespace

std::filesystem::path partial_path_of(const std::filesystem::path& target) {
    const std::filesystem::path resolved = resolve_link(target);
    return resolved.parent_path() / ("." + resolved.filename().string() + ".partial");
}

OutputFile::OutputFile(const std::filesystem::path& target, std::string what)
    : what_(std::move(what)), name_(target), target_(resolve_link(target)) {
    if (const auto obstacle = obstacle_to_creating(target_))
        throw RecordError("cannot create " + what_, name_.string(), *obstacle);
    partial_ = partial_path_of(target_);
    file_ = open_locked(partial_, "cannot create " + what_, name_.string());
    unfinished_ = UnfinishedFile(partial_);
    take_permissions(file_, target_);
}

OutputFile::~OutputFile() {
    if (committed_ || file_.descriptor() < 0) return;
    ::unlink(partial_.c_str());
    // Whoever has it open still, as HDF5 does, holds no room on the disk.
    static_cast<void>(::ftruncate(file_.descriptor(), 0) == 0);
}

void OutputFile::append(std::string_view text) const {
    write_all(file_, std::as_bytes(std::span(text)), "cannot write", name_.string());
}

void OutputFile::find_room(std::size_t bytes) const {
    const std::vector<std::byte> zeros(bytes);
    write_all(file_, zeros, "cannot create " + what_, name_.string());
    if (::ftruncate(file_.descriptor(), 0) != 0 || ::lseek(file_.descriptor(), 0, SEEK_SET) < 0)
        throw RecordError("cannot create " + what_, name_.string(), system_reason());
}

void OutputFile::commit() {
    if (::fsync(file_.descriptor()) != 0 || ::rename(partial_.c_str(), target_.c_str()) != 0) {
        throw RecordError("cannot finish " + what_, name_.string(), system_reason());
    }
    committed_ = true;
    unfinished_.finished();
    // The new name is on the disk when its directory is. Some file systems refuse to sync a directory; the record
    // itself is safe by then.
    const std::filesystem::path directory = target_.has_parent_path() ? target_.parent_path() : ".";
    const PosixFile opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.descriptor() >= 0) ::fsync(opened.descriptor());
}

}  // namespace swirl::apps
