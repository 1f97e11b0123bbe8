#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/record/hdf5_handle.hpp"
#include "apps/record/record_types.hpp"

namespace swirl::apps::hdf5 {

/// What an open dataset is. `path` (in the record) and `file` are for the RecordError of a failure.

/// "cannot read dataset '/group/name' of record"
std::string dataset_action(const std::string& dataset);

/// Text of an attribute, empty when there is none.
std::string text_attribute(hid_t object, const std::string& name, const std::string& file);

ElementType element_type_of(hid_t dataset, const std::string& path, const std::string& file);

std::vector<std::uint64_t> shape_of(hid_t dataset, const std::string& path, const std::string& file);

/// "c" of "/a/b/c".
std::string last_component(const std::string& path);

/// The name of the dimension scale attached to `axis`, empty when there is none.
std::string dimension_name(hid_t dataset, unsigned axis);

/// A dimension without a coordinate, which netCDF keeps as a marked dataset.
bool is_bare_scale(hid_t dataset);

}  // namespace swirl::apps::hdf5
