#include "apps/record/hdf5_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <variant>

#include "apps/record/hdf5_attributes.hpp"
#include "apps/record/record_error.hpp"

namespace swirl::apps::hdf5 {

std::string dataset_action(const std::string& dataset) {
    return fmt::format("cannot read dataset '{}' of record", dataset);
}

std::string text_attribute(hid_t object, const std::string& name, const std::string& file) {
    if (!has_attribute(object, name)) return {};
    const AttributeValue value = read_attribute(object, name, file);
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? *text : std::string{};
}

ElementType element_type_of(hid_t dataset, const std::string& path, const std::string& file) {
    const Datatype type(check(api().H5Dget_type(dataset), dataset_action(path), file));
    const std::size_t size = api().H5Tget_size(type.id());
    const bool has_sign = api().H5Tget_sign(type.id()) == H5T_SGN_2;
    switch (api().H5Tget_class(type.id())) {
        case H5T_FLOAT:
            if (size == 8) return ElementType::float64;
            break;
        case H5T_INTEGER:
            if (size == 8 && has_sign) return ElementType::int64;
            if (size == 4 && has_sign) return ElementType::int32;
            if (size == 1 && !has_sign) {
                return text_attribute(dataset, "dtype", file) == "bool" ? ElementType::boolean : ElementType::uint8;
            }
            break;
        case H5T_STRING:
            if (api().H5Tis_variable_str(type.id()) > 0) return ElementType::string;
            break;
        default:
            break;
    }
    throw RecordError(dataset_action(path), file, "its type is none that a record holds");
}

std::vector<std::uint64_t> shape_of(hid_t dataset, const std::string& path, const std::string& file) {
    const Dataspace space(check(api().H5Dget_space(dataset), dataset_action(path), file));
    const int rank = check(api().H5Sget_simple_extent_ndims(space.id()), dataset_action(path), file);
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
    check(api().H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr), dataset_action(path), file);
    return {extent.begin(), extent.end()};
}

std::string last_component(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

std::string dimension_name(hid_t dataset, unsigned axis) {
    const auto keep = [](hid_t, unsigned, hid_t scale, void* target) -> herr_t {
        std::string name(static_cast<std::size_t>(std::max<ssize_t>(0, api().H5Iget_name(scale, nullptr, 0))), '\0');
        api().H5Iget_name(scale, name.data(), name.size() + 1);
        *static_cast<std::string*>(target) = last_component(name);
        return 1;
    };
    std::string name;
    api().H5DSiterate_scales(dataset, axis, nullptr, keep, &name);
    return name;
}

bool is_bare_scale(hid_t dataset) {
    if (api().H5DSis_scale(dataset) <= 0) return false;
    std::string name(64, '\0');
    api().H5DSget_scale_name(dataset, name.data(), name.size());
    return name.starts_with("This is a netCDF dimension but not a netCDF variable");
}

}  // namespace swirl::apps::hdf5
