#include "apps/record/hdf5_attributes.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <system_error>
#include <variant>

#include "apps/record/record_error.hpp"

namespace swirl::apps::hdf5 {

namespace {

struct Target {
    hid_t object;
    const std::string& name;
    const std::string& file;

    [[nodiscard]] std::string action(const char* verb) const {
        return fmt::format("cannot {} attribute '{}' of record", verb, name);
    }
};

void create(const Target& target, hid_t stored, hid_t memory, hid_t space, const void* data) {
    const std::string action = target.action("write");
    const Properties properties(api().H5Pcreate(api().H5P_CLS_ATTRIBUTE_CREATE_ID_g));
    api().H5Pset_char_encoding(properties.id(), H5T_CSET_UTF8);
    const Attribute attribute(
        check(api().H5Acreate2(target.object, target.name.c_str(), stored, space, properties.id(), H5P_DEFAULT), action,
              target.file));
    // HDF5 takes the null pointer of an empty list for a mistake.
    if (data != nullptr) check(api().H5Awrite(attribute.id(), memory, data), action, target.file);
}

void create_scalar(const Target& target, hid_t stored, hid_t memory, const void* data) {
    const Dataspace space(api().H5Screate(H5S_SCALAR));
    create(target, stored, memory, space.id(), data);
}

void create_list(const Target& target, hid_t stored, hid_t memory, std::size_t size, const void* data) {
    const hsize_t extent = size;
    const Dataspace space(api().H5Screate_simple(1, &extent, nullptr));
    create(target, stored, memory, space.id(), data);
}

struct Writer {
    const Target& target;

    void operator()(bool value) const {
        const std::uint8_t byte = value ? 1 : 0;
        create_scalar(target, api().H5T_STD_U8LE_g, api().H5T_NATIVE_UINT8_g, &byte);
    }
    void operator()(std::int64_t value) const {
        create_scalar(target, api().H5T_STD_I64LE_g, api().H5T_NATIVE_INT64_g, &value);
    }
    void operator()(std::uint64_t value) const {
        create_scalar(target, api().H5T_STD_U64LE_g, api().H5T_NATIVE_UINT64_g, &value);
    }
    void operator()(double value) const {
        create_scalar(target, api().H5T_IEEE_F64LE_g, api().H5T_NATIVE_DOUBLE_g, &value);
    }
    void operator()(const std::string& value) const {
        const Datatype type = string_type();
        const char* text = value.c_str();
        create_scalar(target, type.id(), type.id(), &text);
    }
    void operator()(const std::vector<std::int64_t>& values) const {
        create_list(target, api().H5T_STD_I64LE_g, api().H5T_NATIVE_INT64_g, values.size(), values.data());
    }
    void operator()(const std::vector<double>& values) const {
        create_list(target, api().H5T_IEEE_F64LE_g, api().H5T_NATIVE_DOUBLE_g, values.size(), values.data());
    }
    void operator()(const std::vector<std::string>& values) const {
        const Datatype type = string_type();
        std::vector<const char*> texts;
        texts.reserve(values.size());
        for (const std::string& value : values) texts.push_back(value.c_str());
        create_list(target, type.id(), type.id(), texts.size(), texts.data());
    }
};

template <class T>
std::vector<T> read_numbers(const Attribute& attribute, hid_t memory, std::size_t size, const Target& target) {
    std::vector<T> values(size);
    if (size > 0) check(api().H5Aread(attribute.id(), memory, values.data()), target.action("read"), target.file);
    return values;
}

std::vector<std::string> read_texts(const Attribute& attribute, hid_t space, std::size_t size, const Target& target) {
    if (size == 0) return {};
    std::vector<char*> texts(size, nullptr);
    const Datatype type = string_type();
    check(api().H5Aread(attribute.id(), type.id(), texts.data()), target.action("read"), target.file);
    std::vector<std::string> values;
    values.reserve(size);
    for (const char* text : texts) values.emplace_back(text != nullptr ? text : "");
    api().H5Dvlen_reclaim(type.id(), space, H5P_DEFAULT, texts.data());
    return values;
}

template <class T>
AttributeValue one_or_all(std::vector<T> values, bool scalar) {
    if (scalar) return values.at(0);
    return values;
}

AttributeValue read_integers(const Attribute& attribute, hid_t type, std::size_t size, bool scalar,
                             const Target& target) {
    if (scalar && api().H5Tget_size(type) == 1)
        return read_numbers<std::uint8_t>(attribute, api().H5T_NATIVE_UINT8_g, 1, target)[0] != 0;
    if (scalar && api().H5Tget_size(type) == 8 && api().H5Tget_sign(type) == H5T_SGN_NONE) {
        return read_numbers<std::uint64_t>(attribute, api().H5T_NATIVE_UINT64_g, 1, target)[0];
    }
    return one_or_all(read_numbers<std::int64_t>(attribute, api().H5T_NATIVE_INT64_g, size, target), scalar);
}

}  // namespace

void write_attribute(hid_t object, const std::string& name, const AttributeValue& value, const std::string& file) {
    const Target target{object, name, file};
    std::visit(Writer{target}, value);
}

void write_integers(hid_t object, const std::string& name, const std::vector<std::int64_t>& values, hid_t stored,
                    const std::string& file) {
    create_list({object, name, file}, stored, api().H5T_NATIVE_INT64_g, values.size(), values.data());
}

AttributeValue read_attribute(hid_t object, const std::string& name, const std::string& file) {
    const Target target{object, name, file};
    const std::string action = target.action("read");
    if (!has_attribute(object, name)) throw RecordError(action, file, "there is none of that name");
    const Attribute attribute(check(api().H5Aopen(object, name.c_str(), H5P_DEFAULT), action, file));
    const Datatype type(check(api().H5Aget_type(attribute.id()), action, file));
    const Dataspace space(check(api().H5Aget_space(attribute.id()), action, file));
    const auto size = static_cast<std::size_t>(check(api().H5Sget_simple_extent_npoints(space.id()), action, file));
    std::error_code unknown;  // a damaged size must not claim the machine's memory
    if (const auto bytes = std::filesystem::file_size(file, unknown); !unknown && size > bytes)
        throw RecordError(action, file, fmt::format("it claims {} values in a file of {} bytes", size, bytes));
    const bool scalar = api().H5Sget_simple_extent_type(space.id()) == H5S_SCALAR;
    switch (api().H5Tget_class(type.id())) {
        case H5T_FLOAT:
            return one_or_all(read_numbers<double>(attribute, api().H5T_NATIVE_DOUBLE_g, size, target), scalar);
        case H5T_INTEGER:
            return read_integers(attribute, type.id(), size, scalar, target);
        case H5T_STRING:
            if (api().H5Tis_variable_str(type.id()) > 0)
                return one_or_all(read_texts(attribute, space.id(), size, target), scalar);
            break;
        default:
            break;
    }
    throw RecordError(action, file, "its type is none that a record holds");
}

bool has_attribute(hid_t object, const std::string& name) {
    return api().H5Aexists(object, name.c_str()) > 0;
}

std::vector<std::string> attribute_names(hid_t object) {
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* target) -> herr_t {
        static_cast<std::vector<std::string>*>(target)->emplace_back(name);
        return 0;
    };
    hsize_t index = 0;
    api().H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &index, keep, &names);
    return names;
}

}  // namespace swirl::apps::hdf5
