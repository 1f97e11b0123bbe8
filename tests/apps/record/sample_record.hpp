#pragma once

#include <filesystem>

namespace swirl::tests {

/// Writes a small record with every kind of content: all element types, one to four dimensions, fixed and growing, with
/// and without coordinates, scalars, strings, flags, an empty dimension, nested groups, more than eight attributes
/// (HDF5 keeps those in another way) and enough rows for several chunks. check_xarray.py knows its values.
void write_sample_record(const std::filesystem::path& path);

/// Rows of the sample's group /impacts: two chunks and a part of a third.
inline constexpr int sample_rows = 40000;

}  // namespace swirl::tests
