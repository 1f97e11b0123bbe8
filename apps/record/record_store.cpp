#include "apps/record/record_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>

#include "apps/record/hdf5_attributes.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_error.hpp"

namespace swirl::apps {

namespace {

// More than a superblock and the root's object header take; a block of most file systems.
constexpr std::size_t first_bytes = 4096;

// The format of HDF5 1.10 (2016), not the newest that the library knows: its checksums find damage, its chunk index
// stays small in long records. Locking is OutputFile's.
hdf5::File create_file(const OutputFile& output) {
    hdf5::prepare();
    // HDF5 2.2 aborts the process where the first bytes of a file find no room.
    output.find_room(first_bytes);
    const hdf5::Properties access(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_FILE_ACCESS_ID_g));
    hdf5::api().H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    hdf5::api().H5Pset_file_locking(access.id(), false, true);
    const hdf5::Properties creation(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_FILE_CREATE_ID_g));
    hdf5::api().H5Pset_obj_track_times(creation.id(), false);
    return hdf5::File(
        hdf5::check(hdf5::api().H5Fcreate(output.partial_path().c_str(), H5F_ACC_TRUNC, creation.id(), access.id()),
                    "cannot create record", output.name().string()));
}

// The words that xarray converts to datetime64/timedelta64 when they stand alone as units.
bool is_time_span_word(const std::string& units) {
    static const std::set<std::string> words{"nanoseconds", "microseconds", "milliseconds", "seconds",
                                             "minutes",     "hours",        "days"};
    return words.contains(units);
}

// netCDF's mark of a dimension without a variable, with the size in ten columns.
void make_bare_scale(hid_t group, const std::string& name, std::uint64_t size, const std::string& file) {
    const std::string action = fmt::format("cannot write dimension '{}' of record", name);
    const hsize_t extent = size;
    const hdf5::Dataspace space(hdf5::api().H5Screate_simple(1, &extent, nullptr));
    const hdf5::Properties creation(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_DATASET_CREATE_ID_g));
    hdf5::api().H5Pset_obj_track_times(creation.id(), false);
    // Never written, so it takes no room.
    const hdf5::Dataset scale(hdf5::check(hdf5::api().H5Dcreate2(group, name.c_str(), hdf5::api().H5T_IEEE_F32BE_g,
                                                                 space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                                          action, file));
    const std::string mark = fmt::format("This is a netCDF dimension but not a netCDF variable.{:10}", size);
    hdf5::check(hdf5::api().H5DSset_scale(scale.id(), mark.c_str()), action, file);
}

}  // namespace

RecordStore::RecordStore(const std::filesystem::path& path) : output_(path), file_(create_file(output_)) {
    groups_.push_back({"/", hdf5::Group(hdf5::api().H5Gopen2(file_.id(), "/", H5P_DEFAULT)), {}, {}});
}

RecordStore::~RecordStore() {
    file_.abandon();
}

void RecordStore::refuse(const std::string& object, const std::string& reason) const {
    throw std::invalid_argument(fmt::format("record '{}': '{}' {}", file_name(), object, reason));
}

RecordStore::Group& RecordStore::find(const std::string& path) {
    const auto same = [&](const Group& group) { return group.path == path; };
    const auto found = std::find_if(groups_.begin(), groups_.end(), same);
    if (found == groups_.end()) throw std::logic_error("a finished record is written to");
    return *found;
}

void RecordStore::check_name(const Group& group, const std::string& name) const {
    if (name.empty() || name[0] == '.' || name.find('/') != std::string::npos) {
        refuse(group.path + name, "is no name: it must not be empty, begin with '.' or hold '/'");
    }
}

bool RecordStore::has_object(const Group& group, const std::string& name) const {
    const auto same_column = [&](const ColumnStore& column) { return column.layout().name == name; };
    const auto same_group = [&](const Group& other) { return other.path == group.path + name + "/"; };
    return std::any_of(group.columns.begin(), group.columns.end(), same_column) ||
           std::any_of(groups_.begin(), groups_.end(), same_group);
}

std::string RecordStore::require_group(const std::string& parent_path, const std::string& name) {
    const Group& parent = find(parent_path);
    check_name(parent, name);
    std::string path = parent.path + name + "/";
    const auto same = [&](const Group& group) { return group.path == path; };
    if (std::any_of(groups_.begin(), groups_.end(), same)) return path;
    for (const Dimension& dimension : parent.dimensions) {
        if (dimension.name == name) refuse(path, "is a dimension already");
    }
    if (has_object(parent, name)) refuse(path, "is a dataset already");
    const hdf5::Properties creation(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_GROUP_CREATE_ID_g));
    hdf5::api().H5Pset_obj_track_times(creation.id(), false);
    const hdf5::Properties link(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_LINK_CREATE_ID_g));
    hdf5::api().H5Pset_char_encoding(link.id(), H5T_CSET_UTF8);
    hdf5::Group handle(
        hdf5::check(hdf5::api().H5Gcreate2(parent.handle.id(), name.c_str(), link.id(), creation.id(), H5P_DEFAULT),
                    fmt::format("cannot write group '{}' of record", path), file_name()));
    groups_.push_back({path, std::move(handle), {}, {}});
    return path;
}

void RecordStore::attribute(const std::string& group, const std::string& name, const AttributeValue& value) {
    const hid_t object = find(group).handle.id();
    if (name.empty()) refuse(group, "has an attribute without a name");
    if (hdf5::has_attribute(object, name)) refuse(group, fmt::format("has an attribute '{}' already", name));
    hdf5::write_attribute(object, name, value, file_name());
}

void RecordStore::dimension(const std::string& group_path, const std::string& name, std::uint64_t size) {
    Group& group = find(group_path);
    check_name(group, name);
    for (const Dimension& other : group.dimensions) {
        if (other.name == name) refuse(group.path + name, "is a dimension already");
    }
    if (has_object(group, name)) refuse(group.path + name, "is a dataset or a group already");
    group.dimensions.push_back({name, size});
}

const RecordStore::Dimension& RecordStore::find_dimension(const Group& group, const std::string& name) const {
    for (const Dimension& dimension : group.dimensions) {
        if (dimension.name == name) return dimension;
    }
    refuse(group.path + name, "is no dimension of its group");
}

void RecordStore::check_new_column(const Group& group, const std::string& name,
                                   const std::vector<std::string>& dimensions, const Description& description) const {
    const std::string object = group.path + name;
    check_name(group, name);
    if (has_object(group, name)) refuse(object, "is a dataset or a group already");
    for (const Dimension& dimension : group.dimensions) {
        if (dimension.name == name && dimensions != std::vector{name}) {
            refuse(object, "is a dimension's coordinate: it must have that dimension and no other");
        }
    }
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        if (find_dimension(group, dimensions[i]).size == growing && i > 0) {
            refuse(object, fmt::format("has the growing dimension '{}' not as its first", dimensions[i]));
        }
        if (std::count(dimensions.begin(), dimensions.end(), dimensions[i]) > 1) {
            refuse(object, fmt::format("has the dimension '{}' twice", dimensions[i]));
        }
    }
    if (is_time_span_word(description.units)) {
        refuse(object, fmt::format("has the units '{}', which xarray would round to nanoseconds; write an abbreviation",
                                   description.units));
    }
    for (const std::string& meaning : description.flag_meanings) {
        if (meaning.empty() || meaning.find(' ') != std::string::npos) {
            refuse(object, fmt::format("has the flag meaning '{}': it must be a name without blanks", meaning));
        }
    }
}

ColumnStore& RecordStore::column(const std::string& group_path, const std::string& name, ElementType type,
                                 const std::vector<std::string>& dimensions, const Description& description) {
    Group& group = find(group_path);
    check_new_column(group, name, dimensions, description);
    std::vector<std::uint64_t> shape;
    shape.reserve(dimensions.size());
    for (const std::string& dimension : dimensions) shape.push_back(find_dimension(group, dimension).size);
    ColumnLayout layout{file_name(), group.path, name, type, dimensions, std::move(shape), description};
    if (scale_) layout.description.physical_scale = scale_(description.units);
    group.columns.emplace_back(group.handle.id(), std::move(layout));
    return group.columns.back();
}

std::uint64_t RecordStore::final_size(const Group& group, const Dimension& dimension) const {
    if (dimension.size != growing) return dimension.size;
    const ColumnStore* first = nullptr;
    for (const ColumnStore& column : group.columns) {
        if (column.layout().dimensions.empty() || column.layout().dimensions[0] != dimension.name) continue;
        if (first == nullptr) first = &column;
        if (column.rows() != first->rows()) {
            throw std::invalid_argument(fmt::format("{}: has {} rows where '{}' has {}", column.place(), column.rows(),
                                                    first->layout().name, first->rows()));
        }
    }
    return first == nullptr ? 0 : first->rows();
}

void RecordStore::label(Group& group, const Dimension& dimension) {
    const std::string action = fmt::format("cannot write dimension '{}{}' of record", group.path, dimension.name);
    const auto is_coordinate = [&](const ColumnStore& column) { return column.layout().name == dimension.name; };
    const auto coordinate = std::find_if(group.columns.begin(), group.columns.end(), is_coordinate);
    if (coordinate == group.columns.end()) {
        make_bare_scale(group.handle.id(), dimension.name, final_size(group, dimension), file_name());
    } else {
        hdf5::check(hdf5::api().H5DSset_scale(coordinate->dataset(), dimension.name.c_str()), action, file_name());
    }
    const hdf5::Dataset scale(
        hdf5::check(hdf5::api().H5Dopen2(group.handle.id(), dimension.name.c_str(), H5P_DEFAULT), action, file_name()));
    for (const ColumnStore& column : group.columns) {
        if (is_coordinate(column)) continue;
        const auto& names = column.layout().dimensions;
        for (std::size_t axis = 0; axis < names.size(); ++axis) {
            if (names[axis] != dimension.name) continue;
            hdf5::check(hdf5::api().H5DSattach_scale(column.dataset(), scale.id(), static_cast<unsigned>(axis)), action,
                        file_name());
        }
    }
}

void RecordStore::finish() {
    // Every length is checked before anything more is written.
    for (Group& group : groups_) {
        for (const Dimension& dimension : group.dimensions) static_cast<void>(final_size(group, dimension));
    }
    for (Group& group : groups_) {
        for (ColumnStore& column : group.columns) column.finish();
        for (const Dimension& dimension : group.dimensions) label(group, dimension);
    }
    groups_.clear();
    hdf5::check(hdf5::api().H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "cannot finish record", file_name());
    hdf5::check(file_.close(), "cannot finish record", file_name());
    write_checksum(output_.descriptor(), output_.name());
    output_.commit();
}

}  // namespace swirl::apps
