#include "apps/record/journal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace swirl::apps {

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::string_view magic = "SWIRLJNL";
constexpr std::size_t entry_head_bytes = sizeof(std::uint64_t) + sizeof(std::uint32_t);
constexpr std::size_t crc_bytes = sizeof(std::uint32_t);
constexpr auto open_action = "cannot open journal";
constexpr auto write_action = "cannot write journal";

void put(Bytes& bytes, std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

template <class Integer>
void put_integer(Bytes& bytes, Integer value) {
    boost::endian::native_to_little_inplace(value);
    put(bytes, std::as_bytes(std::span<const Integer>(&value, 1)));
}

template <class Integer>
Integer get_integer(std::span<const std::byte> bytes) {
    Integer value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return boost::endian::little_to_native(value);
}

std::uint32_t crc_of(std::span<const std::byte> bytes) {
    boost::crc_32_type crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return crc.checksum();
}

Bytes header_block(std::span<const std::byte> header) {
    Bytes block;
    put(block, std::as_bytes(std::span(magic)));
    put_integer<std::uint64_t>(block, header.size());
    put(block, header);
    put_integer(block, crc_of(block));
    return block;
}

// Fewer bytes than asked for only at the end of the file.
Bytes read_up_to(std::ifstream& file, std::size_t size) {
    Bytes bytes(size);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

// Hands the entries from `begin` on to `replay` and returns where the last valid one ends.
std::uint64_t replay_entries(std::ifstream& file, std::uint64_t begin, std::uint64_t end,
                             const Journal::Replay& replay) {
    std::uint64_t valid_end = begin;
    while (true) {
        Bytes entry = read_up_to(file, entry_head_bytes);
        if (entry.size() < entry_head_bytes) return valid_end;
        const auto index = get_integer<std::uint64_t>(entry);
        const std::size_t length = get_integer<std::uint32_t>(std::span(entry).subspan(sizeof index));
        const std::uint64_t entry_bytes = entry_head_bytes + length + crc_bytes;
        if (entry_bytes > end - valid_end) return valid_end;
        put(entry, read_up_to(file, length + crc_bytes));
        if (entry.size() < entry_bytes) return valid_end;
        const auto content = std::span<const std::byte>(entry).first(entry_head_bytes + length);
        if (get_integer<std::uint32_t>(std::span(entry).subspan(content.size())) != crc_of(content)) return valid_end;
        replay(index, content.subspan(entry_head_bytes));
        valid_end += entry_bytes;
    }
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& record) {
    return record.parent_path() / ("." + record.filename().string() + ".journal");
}

Journal::Journal(const std::filesystem::path& path, std::span<const std::byte> header, const Replay& replay)
    : path_(path) {
    const std::string name = path.string();
    if (const auto obstacle = obstacle_to_creating(path)) throw RecordError(open_action, name, *obstacle);
    file_ = open_locked(path, open_action, name);
    const Bytes expected = header_block(header);
    std::ifstream file(path, std::ios::binary);
    const Bytes found = read_up_to(file, expected.size());
    if (found.size() < expected.size() && std::equal(found.begin(), found.end(), expected.begin())) {
        begin(expected);  // new, or killed while it was begun
        return;
    }
    if (found.size() < magic.size() || std::memcmp(found.data(), magic.data(), magic.size()) != 0) {
        throw RecordError(open_action, name, "it is not a journal");
    }
    if (found != expected) throw JournalMismatch(open_action, name, "it was begun with other options");
    const std::uint64_t end = std::filesystem::file_size(path);
    const std::uint64_t valid_end = replay_entries(file, expected.size(), end, replay);
    if (::ftruncate(file_.descriptor(), static_cast<off_t>(valid_end)) != 0 ||
        ::lseek(file_.descriptor(), 0, SEEK_END) < 0) {
        throw RecordError(open_action, name, system_reason());
    }
    if (valid_end == expected.size()) empty_ = UnfinishedFile(path_);
}

void Journal::begin(std::span<const std::byte> block) {
    if (::ftruncate(file_.descriptor(), 0) != 0) throw RecordError(open_action, path_.string(), system_reason());
    empty_ = UnfinishedFile(path_);
    put(buffer_, block);
    flush();
}

void Journal::append(std::uint64_t index, std::span<const std::byte> payload) {
    if (payload.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("a journal entry's payload must be smaller than 4 GiB");
    }
    const std::size_t begin = buffer_.size();
    put_integer(buffer_, index);
    put_integer(buffer_, static_cast<std::uint32_t>(payload.size()));
    put(buffer_, payload);
    put_integer(buffer_, crc_of(std::span<const std::byte>(buffer_).subspan(begin)));
    write_buffer();
    empty_.finished();
}

void Journal::write_buffer() {
    write_all(file_, buffer_, write_action, path_.string());
    buffer_.clear();
}

void Journal::flush() {
    write_buffer();
    if (::fdatasync(file_.descriptor()) != 0) throw RecordError(write_action, path_.string(), system_reason());
}

void Journal::remove() {
    if (::unlink(path_.c_str()) != 0) throw RecordError("cannot remove journal", path_.string(), system_reason());
}

}  // namespace swirl::apps
