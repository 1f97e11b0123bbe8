#include "apps/record/record_checksum.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/record/output_file.hpp"
#include "apps/record/record_error.hpp"

namespace swirl::apps {

namespace {

constexpr auto text_of_trailer = "swirl record\ncrc-64/xz of the bytes before: {:016x}\nbytes: {:020}\n";
constexpr auto scan_of_trailer = "swirl record\ncrc-64/xz of the bytes before: %16" SCNx64 "\nbytes: %20" SCNu64 "\n";
constexpr auto scan_of_block =
    "swirl record\ncrc-64/xz of the bytes from 512 on: %16" SCNx64 "\nbytes: %20" SCNu64 "\n";

// The checksum of the bytes from `begin` up to `end`, in a file of so many bytes.
struct Stated {
    std::uint64_t checksum = 0;
    std::uint64_t bytes = 0;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

// What was read, fewer bytes only at the end of the file. Throws RecordError.
std::size_t read_at(int descriptor, char* buffer, std::size_t size, std::uint64_t offset, const std::string& name) {
    std::size_t got = 0;
    while (got < size) {
        const ssize_t more = ::pread(descriptor, buffer + got, size - got, static_cast<off_t>(offset + got));
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) throw RecordError("cannot read record", name, system_reason());
        if (more == 0) break;
        got += static_cast<std::size_t>(more);
    }
    return got;
}

// Up to `end`, or to the end of the file.
Stated measure(int descriptor, std::uint64_t begin, std::uint64_t end, const std::string& name) {
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693U, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> crc;
    std::vector<char> buffer(std::size_t{1} << 18);
    std::uint64_t offset = begin;
    const auto wanted = [&] { return static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), end - offset)); };
    while (const std::size_t got = read_at(descriptor, buffer.data(), wanted(), offset, name)) {
        crc.process_bytes(buffer.data(), got);
        offset += got;
    }
    return {crc.checksum(), offset, begin, offset};
}

using Head = std::array<char, 2 * user_block_bytes>;
using Trailer = std::array<char, trailer_bytes>;

std::uint64_t integer_at(const Head& head, std::size_t place) {
    std::uint64_t value = 0;
    std::memcpy(&value, head.data() + place, sizeof value);
    return boost::endian::little_to_native(value);
}

// The length that HDF5's superblock at `begin` states (HDF5 file format specification 3.0, section II.A), if it can be
// read.
std::optional<std::uint64_t> length_by_hdf5(const Head& head, std::size_t begin) {
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    if (std::string_view(head.data() + begin, signature.size()) != signature) return std::nullopt;
    const int version = head[begin + signature.size()];
    if (version == 0 || version == 1) return integer_at(head, begin + (version == 0 ? 40U : 44U));
    if (version == 2 || version == 3) return integer_at(head, begin + 28);
    return std::nullopt;
}

struct Opened {
    PosixFile file;
    std::uint64_t bytes = 0;
    Head head{};
    Trailer trailer{};
};

// By a user block, schema 1.
std::optional<Stated> stated_by_head(const Head& head) {
    std::array<char, user_block_bytes + 1> text{};
    std::memcpy(text.data(), head.data(), user_block_bytes);
    Stated stated;
    if (std::sscanf(text.data(), scan_of_block, &stated.checksum, &stated.bytes) != 2) return std::nullopt;
    stated.begin = user_block_bytes;
    stated.end = stated.bytes;
    return stated;
}

// Every byte of a trailer is as it is written, so that a damaged one is none.
std::optional<Stated> stated_by_trailer(const Trailer& trailer) {
    const std::string text(trailer.data(), trailer.size());
    Stated stated;
    if (std::sscanf(text.c_str(), scan_of_trailer, &stated.checksum, &stated.bytes) != 2) return std::nullopt;
    if (fmt::format(text_of_trailer, stated.checksum, stated.bytes) != text) return std::nullopt;
    if (stated.bytes < trailer_bytes) return std::nullopt;
    stated.end = stated.bytes - trailer_bytes;
    return stated;
}

// What the file states of itself; nothing where that does not speak for the file as it is now.
std::optional<Stated> stated_by(const Opened& opened) {
    if (const auto stated = stated_by_head(opened.head)) {
        const bool edited =
            stated->bytes != opened.bytes && length_by_hdf5(opened.head, user_block_bytes) == opened.bytes;
        return edited ? std::nullopt : stated;
    }
    if (const auto stated = stated_by_trailer(opened.trailer)) return stated;
    // A trailer that is missing was cut off by a program that wrote the file; a part of one, or one that can't be read,
    // was damaged, and the length that is stated is then never the file's.
    const auto length = length_by_hdf5(opened.head, 0);
    if (!length || *length == opened.bytes) return std::nullopt;
    return Stated{0, ~opened.bytes, 0, 0};
}

Opened open_ends(const std::filesystem::path& file) {
    Opened opened{PosixFile(::open(file.c_str(), O_RDONLY | O_CLOEXEC))};
    struct stat status {};
    if (opened.file.descriptor() < 0 || ::fstat(opened.file.descriptor(), &status) != 0)
        throw RecordError("cannot read record", file.string(), system_reason());
    opened.bytes = static_cast<std::uint64_t>(status.st_size);
    read_at(opened.file.descriptor(), opened.head.data(), opened.head.size(), 0, file.string());
    if (opened.bytes >= trailer_bytes)
        read_at(opened.file.descriptor(), opened.trailer.data(), trailer_bytes, opened.bytes - trailer_bytes,
                file.string());
    return opened;
}

}  // namespace

void write_checksum(int descriptor, const std::filesystem::path& name) {
    const Stated measured = measure(descriptor, 0, std::numeric_limits<std::uint64_t>::max(), name.string());
    const std::string text = fmt::format(text_of_trailer, measured.checksum, measured.bytes + trailer_bytes);
    for (std::size_t written = 0; written < text.size();) {
        const auto place = static_cast<off_t>(measured.bytes + written);
        const ssize_t now = ::pwrite(descriptor, text.data() + written, text.size() - written, place);
        if (now < 0 && errno == EINTR) continue;
        if (now < 0) throw RecordError("cannot finish record", name.string(), system_reason());
        written += static_cast<std::size_t>(now);
    }
}

Wholeness wholeness_of(const std::filesystem::path& file) {
    const Opened opened = open_ends(file);
    const auto stated = stated_by(opened);
    if (!stated) return Wholeness::unstated;
    if (stated->bytes != opened.bytes) return Wholeness::damaged;
    const Stated measured = measure(opened.file.descriptor(), stated->begin, stated->end, file.string());
    const bool same = measured.checksum == stated->checksum && measured.end == stated->end;
    return same ? Wholeness::whole : Wholeness::damaged;
}

bool has_checksum(const std::filesystem::path& file) {
    try {
        return stated_by(open_ends(file)).has_value();
    } catch (const RecordError&) {
        return false;
    }
}

}  // namespace swirl::apps
