#include "apps/record/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <system_error>

#include "apps/record/record_error.hpp"

namespace swirl::apps {

namespace {

// A link's own file is replaced, not the link.
std::filesystem::path resolve_link(const std::filesystem::path& path) {
    std::error_code missing;
    std::filesystem::path resolved = std::filesystem::canonical(path, missing);
    return missing ? path : resolved;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : name_(target), target_(resolve_link(target)) {
    if (const auto obstacle = obstacle_to_creating(target_)) {
        throw RecordError("cannot create record", name_.string(), *obstacle);
    }
    partial_ = target_.parent_path() / ("." + target_.filename().string() + ".partial");
    file_ = open_locked(partial_, "cannot create record", name_.string());
}

OutputFile::~OutputFile() {
    if (!committed_ && file_.descriptor() >= 0) ::unlink(partial_.c_str());
}

void OutputFile::commit() {
    if (::fsync(file_.descriptor()) != 0 || ::rename(partial_.c_str(), target_.c_str()) != 0) {
        throw RecordError("cannot finish record", name_.string(), system_reason());
    }
    committed_ = true;
    // The new name is on the disk when its directory is. Some file systems refuse to sync a directory; the record
    // itself is safe by then.
    const std::filesystem::path directory = target_.has_parent_path() ? target_.parent_path() : ".";
    const PosixFile opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.descriptor() >= 0) ::fsync(opened.descriptor());
}

}  // namespace swirl::apps
