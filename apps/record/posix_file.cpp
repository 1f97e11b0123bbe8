#include "apps/record/posix_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "apps/record/record_error.hpp"

namespace swirl::apps {

PosixFile::~PosixFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::string system_reason() {
    return std::generic_category().message(errno);
}

namespace {

// Between open() and flock() another writer may have finished and renamed the file away; the lock is then on the wrong
// file.
bool still_has_name(const PosixFile& file, const std::filesystem::path& path) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(file.descriptor(), &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

PosixFile open_locked(const std::filesystem::path& path, const std::string& action, const std::string& name) {
    while (true) {
        PosixFile file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
        if (file.descriptor() < 0) throw RecordError(action, name, system_reason());
        if (::flock(file.descriptor(), LOCK_EX | LOCK_NB) != 0) {
            throw RecordError(action, name, errno == EWOULDBLOCK ? "another process is writing it" : system_reason());
        }
        if (still_has_name(file, path)) return file;
    }
}

std::optional<std::string> obstacle_to_creating(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (path.filename().empty()) return "the name of a file is missing";
    const fs::path directory = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::exists(directory, ignored)) return fmt::format("directory '{}' does not exist", directory.string());
    if (!fs::is_directory(directory, ignored)) return fmt::format("'{}' is not a directory", directory.string());
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) return "it is a directory";
    if (fs::exists(status) && !fs::is_regular_file(status)) return "it exists and is not a regular file";
    if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) return system_reason();
    return std::nullopt;
}

}  // namespace swirl::apps
