#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace swirl::apps {

/// A record ends with a trailer, which lies beyond the end that HDF5 states of its own file, so that no reader of HDF5
/// meets it: what it is, in words, and a checksum of all before it, so that accidental damage is known before the HDF5
/// library meets it. Text of 89 bytes:
///
///     swirl record
///     crc-64/xz of the bytes before: 0123456789abcdef
///     bytes: 00000000000000081920
///
/// A program that opens the file for writing cuts the trailer off (HDF5 ends a file where its data end): then no
/// checksum speaks for it. Records of schema 1 have the same words in a user block at their head, filled up with zeros
/// to 512 bytes, and the checksum of the bytes from 512 on.
///
/// (CRC-64/XZ: polynomial 42f0e1eba9ea3693, reflected; any one damaged place of up to 64 bits is found, and of other
/// damage all but one in 2^64. It is no protection against intent.) Cost: one pass over the file.
inline constexpr std::size_t trailer_bytes = 89;
inline constexpr std::size_t user_block_bytes = 512;  ///< of schema 1

enum class Wholeness {
    whole,     ///< as it was written
    damaged,   ///< no longer
    unstated,  ///< there is no checksum and the length is the one that HDF5's superblock states, as of what another
               ///< program has written; or it is no file of HDF5 that states its length
};

/// Writes the trailer of a file that is finished but for it. @throws RecordError
void write_checksum(int descriptor, const std::filesystem::path& name);

/// @throws RecordError if it cannot be read
Wholeness wholeness_of(const std::filesystem::path& file);

/// Does a checksum speak for this file? Looks at its two ends alone. False for what can't be read.
bool has_checksum(const std::filesystem::path& file);

}  // namespace swirl::apps
