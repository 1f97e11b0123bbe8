#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "apps/record/output_file.hpp"
#include "apps/record/record_error.hpp"

namespace swirl::apps {

/// The journal belongs to a computation with another header.
class JournalMismatch : public RecordError {
public:
    using RecordError::RecordError;
};

/// Where the journal of a record lies while it is being made: `.NAME.journal` beside it.
std::filesystem::path journal_path(const std::filesystem::path& record);

/// Finished pieces of a long computation, on disk as they come, so that killing it loses no more than the batch being
/// written. The record itself is written from them at the end, whole, and so is the same however often it was
/// interrupted. Append-only; every entry carries a CRC-32.
//
/// Layout, little-endian: "SWIRLJNL", header length (u64), header, CRC-32 (u32) of all before; then entries of index
/// (u64), payload length (u32), payload, CRC-32 (u32) of the three. Payloads are the caller's bytes, meant for the
/// machine that wrote them.
class Journal {
public:
    using Replay = std::function<void(std::uint64_t index, std::span<const std::byte> payload)>;

    /// Opens the journal, or begins one, and hands every valid entry to `replay` in the order of writing. `header` says
    /// whose work this is (scene, options, seed, version); what follows the last valid entry (a write cut short) is cut
    /// off. JournalMismatch if the file's header is another; RecordError if it cannot be created or read, is not a
    /// journal or is in use by another process. Memory: O(largest payload).
    Journal(const std::filesystem::path& path, std::span<const std::byte> header, const Replay& replay);

    /// Handed to the system, which keeps it if the process ends. RecordError if that fails.
    void append(std::uint64_t index, std::span<const std::byte> payload);

    /// Everything appended is on the disk (fdatasync) when this returns. RecordError if it cannot be.
    void flush();

    /// Deletes the file: the record is finished. Nothing may be appended after it.
    void remove();

private:
    void write_buffer();
    void begin(std::span<const std::byte> block);

    std::filesystem::path path_;
    PosixFile file_;
    UnfinishedFile empty_;  // until the first entry
    std::vector<std::byte> buffer_;
};

}  // namespace swirl::apps
