#include "apps/record/output_file.hpp"

#include "apps/record/record_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

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

namespace {

enum class State { free, filled, armed };

struct Place {
    std::atomic<State> state{State::free};
    std::array<char, PATH_MAX> path{};
};

// What the handler of a signal can reach is global, and memory that is never given back.
std::array<Place, 32> places;
static_assert(std::atomic<State>::is_always_lock_free, "a handler must not wait for a lock");

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path) {
    if (path.native().size() >= PATH_MAX) return;
    for (std::size_t i = 0; i < places.size(); ++i) {
        State expected = State::free;
        if (!places[i].state.compare_exchange_strong(expected, State::filled)) continue;
        std::memcpy(places[i].path.data(), path.c_str(), path.native().size() + 1);
        places[i].state = State::armed;
        place_ = i;
        return;
    }
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept : place_(std::exchange(other.place_, std::nullopt)) {}

UnfinishedFile& UnfinishedFile::operator=(UnfinishedFile&& other) noexcept {
    std::swap(place_, other.place_);
    return *this;
}

void UnfinishedFile::finished() noexcept {
    if (place_) places[*place_].state = State::free;
    place_.reset();
}

void remove_unfinished_files() noexcept {
    for (const Place& place : places)
        if (place.state == State::armed) ::unlink(place.path.data());
}

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
