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

bool is_same(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

}  // namespace

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    struct stat first {};
    struct stat second {};
    return ::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0 && is_same(first, second);
}

bool is_same_file(const std::filesystem::path& path, int descriptor) {
    struct stat named {};
    struct stat opened {};
    return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && is_same(named, opened);
}

PosixFile open_locked(const std::filesystem::path& path, const std::string& action, const std::string& name) {
    while (true) {
        PosixFile file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
        if (file.descriptor() < 0) throw RecordError(action, name, system_reason());
        if (::flock(file.descriptor(), LOCK_EX | LOCK_NB) != 0) {
            throw RecordError(action, name, errno == EWOULDBLOCK ? "another process is writing it" : system_reason());
        }
        // Between open() and flock() another writer may have finished and renamed the file away; the lock is then on
        // the wrong file.
        if (is_same_file(path, file.descriptor())) return file;
    }
}

void write_all(const PosixFile& file, std::span<const std::byte> bytes, const std::string& action,
               const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.descriptor(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw RecordError(action, name, system_reason());
        bytes = bytes.subspan(static_cast<std::size_t>(written));
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
