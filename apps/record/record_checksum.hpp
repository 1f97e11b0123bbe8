#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace swirl::apps {

/// A record begins with a user block, which HDF5's readers skip: what it is, in words, and a checksum of all that
/// follows, so that accidental damage is known before the HDF5 library meets it. Text, filled up with zeros:
///
///     swirl record
///     crc-64/xz of the bytes from 512 on: 0123456789abcdef
///     bytes: 81920
///
/// (CRC-64/XZ: polynomial 42f0e1eba9ea3693, reflected; any one damaged place of up to 64 bits is found, and of other
/// damage all but one in 2^64. It is no protection against intent.) Cost: one pass over the file.
inline constexpr std::size_t user_block_bytes = 512;

enum class Wholeness {
    whole,     ///< as it was written
    damaged,   ///< no longer
    unstated,  ///< there is no checksum, or another program has written the file since (its length is another, and the
               ///< one that HDF5's superblock states)
};

/// Writes the user block of a finished file that keeps the room for it. @throws RecordError
void write_checksum(int descriptor, const std::filesystem::path& name);

/// @throws RecordError if it cannot be read
Wholeness wholeness_of(const std::filesystem::path& file);

/// Does a checksum speak for this file? Looks at its head alone. False for what can't be read.
bool has_checksum(const std::filesystem::path& file);

}  // namespace swirl::apps
