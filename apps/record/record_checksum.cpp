#include "apps/record/record_checksum.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/record/posix_file.hpp"
#include "apps/record/record_error.hpp"

namespace swirl::apps {

namespace {

constexpr auto text_of_block = "swirl record\ncrc-64/xz of the bytes from 512 on: {:016x}\nbytes: {}\n";
constexpr auto scan_of_block =
    "swirl record\ncrc-64/xz of the bytes from 512 on: %16" SCNx64 "\nbytes: %20" SCNu64 "\n";

struct Stated {
    std::uint64_t checksum = 0;
    std::uint64_t bytes = 0;  // of the whole file
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

Stated measure(int descriptor, const std::string& name) {
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693U, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> crc;
    std::vector<char> buffer(std::size_t{1} << 18);
    std::uint64_t offset = user_block_bytes;
    while (const std::size_t got = read_at(descriptor, buffer.data(), buffer.size(), offset, name)) {
        crc.process_bytes(buffer.data(), got);
        offset += got;
    }
    return {crc.checksum(), offset};
}

using Head = std::array<char, 2 * user_block_bytes>;

std::uint64_t integer_at(const Head& head, std::size_t place) {
    std::uint64_t value = 0;
    std::memcpy(&value, head.data() + place, sizeof value);
    return boost::endian::little_to_native(value);
}

// The length that HDF5's superblock states (HDF5 file format specification 3.0, section II.A), if it can be read.
std::optional<std::uint64_t> length_by_hdf5(const Head& head) {
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    const std::size_t begin = user_block_bytes;
    if (std::string_view(head.data() + begin, signature.size()) != signature) return std::nullopt;
    const int version = head[begin + signature.size()];
    if (version == 0 || version == 1) return integer_at(head, begin + (version == 0 ? 40U : 44U));
    if (version == 2 || version == 3) return integer_at(head, begin + 28);
    return std::nullopt;
}

// What the file states of itself; nothing where that does not speak for the file as it is now.
std::optional<Stated> stated_by(const Head& head, std::uint64_t bytes) {
    std::array<char, user_block_bytes + 1> text{};
    std::memcpy(text.data(), head.data(), user_block_bytes);
    Stated stated;
    if (std::sscanf(text.data(), scan_of_block, &stated.checksum, &stated.bytes) != 2) return std::nullopt;
    if (stated.bytes != bytes && length_by_hdf5(head) == bytes) return std::nullopt;
    return stated;
}

struct Opened {
    PosixFile file;
    std::uint64_t bytes = 0;
    Head head{};
};

Opened open_head(const std::filesystem::path& file) {
    Opened opened{PosixFile(::open(file.c_str(), O_RDONLY | O_CLOEXEC))};
    struct stat status {};
    if (opened.file.descriptor() < 0 || ::fstat(opened.file.descriptor(), &status) != 0)
        throw RecordError("cannot read record", file.string(), system_reason());
    opened.bytes = static_cast<std::uint64_t>(status.st_size);
    read_at(opened.file.descriptor(), opened.head.data(), opened.head.size(), 0, file.string());
    return opened;
}

}  // namespace

void write_checksum(int descriptor, const std::filesystem::path& name) {
    const Stated measured = measure(descriptor, name.string());
    const std::string text = fmt::format(text_of_block, measured.checksum, measured.bytes);
    std::array<char, user_block_bytes> block{};
    std::memcpy(block.data(), text.data(), text.size());
    ssize_t written = -1;
    do {
        written = ::pwrite(descriptor, block.data(), block.size(), 0);
    } while (written < 0 && errno == EINTR);
    if (written != static_cast<ssize_t>(block.size()))
        throw RecordError("cannot finish record", name.string(), system_reason());
}

Wholeness wholeness_of(const std::filesystem::path& file) {
    const Opened opened = open_head(file);
    const auto stated = stated_by(opened.head, opened.bytes);
    if (!stated) return Wholeness::unstated;
    if (stated->bytes != opened.bytes) return Wholeness::damaged;
    const Stated measured = measure(opened.file.descriptor(), file.string());
    return measured.checksum == stated->checksum ? Wholeness::whole : Wholeness::damaged;
}

bool has_checksum(const std::filesystem::path& file) {
    try {
        const Opened opened = open_head(file);
        return stated_by(opened.head, opened.bytes).has_value();
    } catch (const RecordError&) {
        return false;
    }
}

}  // namespace swirl::apps
