// Records made out of a fuzzer's bytes: whole files of HDF5 with a good checksum, whatever they hold.
#pragma once

#include "tests/fuzz/bytes.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace swirl::tests::fuzz {

/// How a number or a text lies in the file. The first six are those of a record.
enum class Stored { float64, int64, int32, uint8, boolean, text, float32, uint64, short_text };

/// An attribute or a dataset. A shape of no axes is one value; `nothing` is HDF5's null space.
struct Item {
    std::string group, name;
    bool attribute = true;
    Stored stored = Stored::float64;
    std::vector<std::uint64_t> shape{};
    std::vector<double> numbers{};     ///< as many as fit, then zeros
    std::vector<std::string> texts{};  ///< the same of texts
    bool nothing = false;
};

/// What a command writes into a record that another command reads, small: an orbit, a series, special points of
/// branches, boundaries, cycles that were found or followed, a shard of a sweep.
std::vector<Item> items_of_command(int command);
inline constexpr int reading_commands = 7;

/// Changes some items as the bytes say: their type, shape, values, place, or whether they are there.
void change(std::vector<Item>& items, Bytes& bytes);

/// Writes them with a user block and its checksum into a file that is open under `descriptor` and has this name. Items
/// that HDF5 refuses (a name that is taken) are left out.
void write_record(const std::vector<Item>& items, int descriptor, const std::string& name);

}  // namespace swirl::tests::fuzz
