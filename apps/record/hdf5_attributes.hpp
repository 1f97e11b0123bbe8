#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/record/hdf5_handle.hpp"
#include "apps/record/record_types.hpp"

namespace swirl::apps::hdf5 {

/// Attribute `name` of `object` (a file, group or dataset). `file` is for the RecordError of a failure.
void write_attribute(hid_t object, const std::string& name, const AttributeValue& value, const std::string& file);

/// Integers in the type `stored`: CF wants the flag_values of a variable to be of its type.
void write_integers(hid_t object, const std::string& name, const std::vector<std::int64_t>& values, hid_t stored,
                    const std::string& file);

/// A one-byte attribute is a bool; integers come back as int64_t (uint64_t if stored unsigned with 8 bytes).
AttributeValue read_attribute(hid_t object, const std::string& name, const std::string& file);

bool has_attribute(hid_t object, const std::string& name);

/// In the order of their names.
std::vector<std::string> attribute_names(hid_t object);

}  // namespace swirl::apps::hdf5
