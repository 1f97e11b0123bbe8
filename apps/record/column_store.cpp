#include "apps/record/column_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "apps/record/hdf5_attributes.hpp"

namespace swirl::apps {

namespace {

// Small enough that dozens of datasets can be open, large enough to compress well and to keep their number low.
constexpr std::size_t chunk_bytes = std::size_t{128} * 1024;

// zlib's level: 4 takes a third longer for 2 % less, on the samples of a diagram.
constexpr unsigned deflate_level = 1;

struct ElementFormat {
    hid_t stored;
    hid_t memory;
    std::size_t size;
};

ElementFormat format_of(ElementType type) {
    switch (type) {
        case ElementType::float64:
            return {hdf5::api().H5T_IEEE_F64LE_g, hdf5::api().H5T_NATIVE_DOUBLE_g, 8};
        case ElementType::int64:
            return {hdf5::api().H5T_STD_I64LE_g, hdf5::api().H5T_NATIVE_INT64_g, 8};
        case ElementType::int32:
            return {hdf5::api().H5T_STD_I32LE_g, hdf5::api().H5T_NATIVE_INT32_g, 4};
        case ElementType::uint8:
        case ElementType::boolean:
            return {hdf5::api().H5T_STD_U8LE_g, hdf5::api().H5T_NATIVE_UINT8_g, 1};
        case ElementType::string:
            break;
    }
    throw std::logic_error("strings have no fixed format");
}

static_assert(sizeof(bool) == 1, "a bool is stored as the byte that it is");

// Whole inner dimensions as far as they fit, so that a chunk is a run of rows; one row in several chunks when it alone
// is larger. Every extent is at least 1, as HDF5 asks.
std::vector<hsize_t> chunk_shape(const std::vector<std::uint64_t>& shape, std::size_t element_bytes) {
    std::vector<hsize_t> chunk(shape.size());
    std::uint64_t room = std::max<std::uint64_t>(1, chunk_bytes / element_bytes);
    for (std::size_t axis = shape.size(); axis-- > 0;) {
        chunk[axis] = std::max<std::uint64_t>(1, std::min(shape[axis], room));
        room = std::max<std::uint64_t>(1, room / chunk[axis]);
    }
    return chunk;
}

std::size_t bytes_per_row(const std::vector<std::uint64_t>& shape, std::size_t element_bytes) {
    std::size_t bytes = element_bytes;
    for (std::size_t axis = 1; axis < shape.size(); ++axis) bytes *= shape[axis];
    return bytes;
}

hdf5::Properties creation_properties(const std::vector<hsize_t>& chunk) {
    hdf5::Properties properties(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_DATASET_CREATE_ID_g));
    hdf5::api().H5Pset_obj_track_times(properties.id(), false);
    if (!chunk.empty()) {
        hdf5::api().H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
        hdf5::api().H5Pset_shuffle(properties.id());
        hdf5::api().H5Pset_deflate(properties.id(), deflate_level);
    }
    return properties;
}

hdf5::Properties link_properties() {
    hdf5::Properties properties(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_LINK_CREATE_ID_g));
    hdf5::api().H5Pset_char_encoding(properties.id(), H5T_CSET_UTF8);
    return properties;
}

// Chunks are written whole, once: nothing to cache.
hdf5::Properties access_properties() {
    hdf5::Properties properties(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_DATASET_ACCESS_ID_g));
    hdf5::api().H5Pset_chunk_cache(properties.id(), 0, 0, 1.0);
    return properties;
}

hdf5::Dataspace dataspace(const std::vector<hsize_t>& extent, const std::vector<hsize_t>& limit) {
    if (extent.empty()) return hdf5::Dataspace(hdf5::api().H5Screate(H5S_SCALAR));
    return hdf5::Dataspace(hdf5::api().H5Screate_simple(static_cast<int>(extent.size()), extent.data(), limit.data()));
}

}  // namespace

ColumnStore::ColumnStore(hid_t group, ColumnLayout layout) : group_(group), layout_(std::move(layout)) {
    if (layout_.type == ElementType::string) return;
    const std::size_t element_bytes = format_of(layout_.type).size;
    // A row without elements (a dimension of size 0) counts as one byte that never comes.
    row_bytes_ = std::max<std::size_t>(1, bytes_per_row(layout_.shape, element_bytes));
    chunk_ = chunk_shape(layout_.shape, element_bytes);
}

std::string ColumnStore::place() const {
    return fmt::format("record '{}': dataset '{}{}'", layout_.file, layout_.group, layout_.name);
}

std::string ColumnStore::action() const {
    return fmt::format("cannot write dataset '{}{}' of record", layout_.group, layout_.name);
}

void ColumnStore::append(std::span<const std::byte> values) {
    if (values.size() % row_bytes_ != 0) {
        throw std::invalid_argument(
            fmt::format("{}: {} bytes appended, must be whole rows of {} bytes", place(), values.size(), row_bytes_));
    }
    const std::uint64_t allowed = layout_.shape.empty() ? 1 : layout_.shape[0];
    if (!grows() && rows() + values.size() / row_bytes_ > allowed) {
        throw std::invalid_argument(fmt::format("{}: {} rows appended, must be at most {}", place(),
                                                rows() + values.size() / row_bytes_, allowed));
    }
    const std::size_t capacity = row_bytes_ * (chunk_.empty() ? 1 : chunk_[0]);
    while (!values.empty()) {
        const std::size_t taken = std::min(values.size(), capacity - buffer_.size());
        buffer_.insert(buffer_.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(taken));
        values = values.subspan(taken);
        if (buffer_.size() == capacity && !layout_.shape.empty()) write_buffer();
    }
}

void ColumnStore::create(bool whole) {
    std::vector<hsize_t> extent(layout_.shape.begin(), layout_.shape.end());
    std::vector<hsize_t> limit = extent;
    if (grows()) {
        extent[0] = whole ? rows() : 0;
        limit[0] = whole ? rows() : H5S_UNLIMITED;
        if (whole) chunk_[0] = std::clamp<hsize_t>(rows(), 1, chunk_[0]);
    }
    const bool empty = whole && std::find(extent.begin(), extent.end(), 0) != extent.end();
    const hdf5::Dataspace space = dataspace(extent, limit);
    const hdf5::Properties creation = creation_properties(empty ? std::vector<hsize_t>{} : chunk_);
    const hdf5::Properties link = link_properties();
    const hdf5::Properties access = access_properties();
    dataset_ =
        hdf5::Dataset(hdf5::check(hdf5::api().H5Dcreate2(group_, layout_.name.c_str(), format_of(layout_.type).stored,
                                                         space.id(), link.id(), creation.id(), access.id()),
                                  action(), layout_.file));
    describe();
}

void ColumnStore::describe() {
    const Description& description = layout_.description;
    const auto write = [this](const char* name, const AttributeValue& value) {
        hdf5::write_attribute(dataset_.id(), name, value, layout_.file);
    };
    if (!description.units.empty()) write("units", description.units);
    if (!description.long_name.empty()) write("long_name", description.long_name);
    if (description.physical_scale) write("physical_scale", *description.physical_scale);
    // xarray's own mark: such bytes open as booleans.
    if (layout_.type == ElementType::boolean) write("dtype", std::string("bool"));
    if (!description.flag_meanings.empty()) {
        std::vector<std::int64_t> values;
        for (std::size_t i = 0; i < description.flag_meanings.size(); ++i)
            values.push_back(static_cast<std::int64_t>(i));
        hdf5::write_integers(dataset_.id(), "flag_values", values, format_of(layout_.type).stored, layout_.file);
        write("flag_meanings", fmt::format("{}", fmt::join(description.flag_meanings, " ")));
    }
}

void ColumnStore::write_buffer() {
    const std::uint64_t new_rows = buffer_.size() / row_bytes_;
    if (!dataset_.open()) create(false);
    std::vector<hsize_t> extent(layout_.shape.begin(), layout_.shape.end());
    if (grows()) {
        extent[0] = written_rows_ + new_rows;
        hdf5::check(hdf5::api().H5Dset_extent(dataset_.id(), extent.data()), action(), layout_.file);
    }
    const hdf5::Dataspace target(hdf5::api().H5Dget_space(dataset_.id()));
    std::vector<hsize_t> count(layout_.shape.begin(), layout_.shape.end());
    if (!count.empty()) {
        count[0] = new_rows;
        std::vector<hsize_t> offset(count.size());
        offset[0] = written_rows_;
        hdf5::api().H5Sselect_hyperslab(target.id(), H5S_SELECT_SET, offset.data(), nullptr, count.data(), nullptr);
    }
    const hdf5::Dataspace source = dataspace(count, count);
    hdf5::check(hdf5::api().H5Dwrite(dataset_.id(), format_of(layout_.type).memory, source.id(), target.id(),
                                     H5P_DEFAULT, buffer_.data()),
                action(), layout_.file);
    written_rows_ += new_rows;
    buffer_.clear();
}

void ColumnStore::write_strings(std::span<const std::string> values) {
    std::vector<hsize_t> extent(layout_.shape.begin(), layout_.shape.end());
    std::size_t row = 1;
    for (std::size_t axis = 1; axis < extent.size(); ++axis) row *= extent[axis];
    if (grows()) extent[0] = row > 0 ? values.size() / row : 0;
    const std::size_t expected = extent.empty() ? 1 : extent[0] * row;
    if (values.size() != expected) {
        throw std::invalid_argument(fmt::format("{}: {} strings, must be {}", place(), values.size(), expected));
    }
    std::vector<const char*> texts;
    for (const std::string& value : values) texts.push_back(value.c_str());
    const hdf5::Datatype type = hdf5::string_type();
    const hdf5::Dataspace space = dataspace(extent, extent);
    const hdf5::Properties creation = creation_properties({});
    const hdf5::Properties link = link_properties();
    dataset_ = hdf5::Dataset(hdf5::check(hdf5::api().H5Dcreate2(group_, layout_.name.c_str(), type.id(), space.id(),
                                                                link.id(), creation.id(), H5P_DEFAULT),
                                         action(), layout_.file));
    if (!texts.empty()) {
        hdf5::check(hdf5::api().H5Dwrite(dataset_.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()),
                    action(), layout_.file);
    }
    describe();
    written_rows_ = extent.empty() ? 1 : extent[0];
}

void ColumnStore::finish() {
    const std::uint64_t full = layout_.shape.empty() ? 1 : layout_.shape[0];
    const bool has_elements = std::find(layout_.shape.begin(), layout_.shape.end(), 0) == layout_.shape.end();
    if (!grows() && has_elements && rows() != full) {
        throw std::invalid_argument(fmt::format("{}: has {} rows, must have {}", place(), rows(), full));
    }
    if (!dataset_.open()) create(true);
    if (!buffer_.empty()) write_buffer();
    buffer_.shrink_to_fit();
}

}  // namespace swirl::apps
