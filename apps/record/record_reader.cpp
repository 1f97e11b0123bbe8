#include "apps/record/record_reader.hpp"

#include "apps/record/hdf5_attributes.hpp"
#include "apps/record/hdf5_dataset.hpp"
#include "apps/record/output_file.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_error.hpp"
#include "apps/record/trial_reading.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <sstream>
#include <system_error>
#include <type_traits>
#include <utility>

namespace swirl::apps {

namespace {

hdf5::File open_file(const std::string& name);

}  // namespace

struct RecordReader::OpenFile {
    std::string name;
    hdf5::File file;

    explicit OpenFile(const std::string& path) : name(path), file(open_file(path)) {}

    [[nodiscard]] hdf5::Object open(const std::string& path) const {
        const std::string action = fmt::format("cannot read '{}' of record", path);
        if (path.empty() || (path != "/" && hdf5::api().H5Oexists_by_name(file.id(), path.c_str(), H5P_DEFAULT) <= 0)) {
            throw RecordError(action, name, "there is nothing of that name");
        }
        return hdf5::Object(hdf5::check(hdf5::api().H5Oopen(file.id(), path.c_str(), H5P_DEFAULT), action, name));
    }

    // Throws when `path` is not of the wanted kind.
    [[nodiscard]] hdf5::Object open(const std::string& path, H5I_type_t kind) const {
        hdf5::Object object = open(path);
        if (hdf5::api().H5Iget_type(object.id()) != kind) {
            throw RecordError(fmt::format("cannot read '{}' of record", path), name,
                              kind == H5I_GROUP ? "it is not a group" : "it is not a dataset");
        }
        return object;
    }
};

namespace {

constexpr auto reading = "cannot read record";

void require_hdf5(const std::string& name) {
    hdf5::prepare();
    // Before it is opened: opening a pipe waits for its other end.
    std::error_code ignored;
    const auto status = std::filesystem::status(name, ignored);
    if (std::filesystem::is_directory(status)) throw RecordError(reading, name, "it is a directory");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw RecordError(reading, name, "it is not a regular file");
    // The system's own reason (no such file, permission denied) before HDF5's.
    if (const PosixFile probe(::open(name.c_str(), O_RDONLY | O_CLOEXEC)); probe.descriptor() < 0) {
        throw RecordError(reading, name, system_reason());
    }
    if (hdf5::api().H5Fis_hdf5(name.c_str()) <= 0) throw RecordError(reading, name, "it is not an HDF5 file");
}

hdf5::File open_file(const std::string& name) {
    const hdf5::Properties access(hdf5::api().H5Pcreate(hdf5::api().H5P_CLS_FILE_ACCESS_ID_g));
    // A record has its name only when it is whole, so reading needs no lock (and file systems without locks do).
    hdf5::api().H5Pset_file_locking(access.id(), false, true);
    return hdf5::File(hdf5::check(hdf5::api().H5Fopen(name.c_str(), H5F_ACC_RDONLY, access.id()), reading, name));
}

std::vector<std::string> link_names(hid_t group, const std::string& path, const std::string& file) {
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* target) -> herr_t {
        static_cast<std::vector<std::string>*>(target)->emplace_back(name);
        return 0;
    };
    hdf5::check(hdf5::api().H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &names),
                fmt::format("cannot read group '{}' of record", path), file);
    return names;
}

// Without loss.
bool readable_as(ElementType stored, ElementType wanted) {
    const bool to_int32 = wanted == ElementType::int32 && stored == ElementType::uint8;
    const bool to_int64 =
        wanted == ElementType::int64 && (stored == ElementType::int32 || stored == ElementType::uint8);
    return stored == wanted || to_int32 || to_int64;
}

hid_t memory_type(ElementType type) {
    switch (type) {
        case ElementType::float64:
            return hdf5::api().H5T_NATIVE_DOUBLE_g;
        case ElementType::int64:
            return hdf5::api().H5T_NATIVE_INT64_g;
        case ElementType::int32:
            return hdf5::api().H5T_NATIVE_INT32_g;
        default:
            return hdf5::api().H5T_NATIVE_UINT8_g;
    }
}

// A damaged shape must not claim the machine's memory. Of one byte deflate makes 1032 at most.
std::size_t product_of(const std::vector<hsize_t>& count, const std::string& path, const std::string& file) {
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
    double elements = 1;
    for (const hsize_t size : count) elements *= static_cast<double>(size);
    if (!unknown && elements > 1032.0 * static_cast<double>(bytes))
        throw RecordError(hdf5::dataset_action(path), file,
                          fmt::format("it claims {:g} values in a file of {} bytes", elements, bytes));
    return static_cast<std::size_t>(elements);  // exact: far below 2^53
}

struct Selection {
    hdf5::Dataspace source;  // in the file
    hdf5::Dataspace target;  // in memory
    std::size_t elements = 1;
};

Selection select(hid_t dataset, const Slab& slab, const std::string& path, const std::string& file) {
    const std::vector<std::uint64_t> shape = hdf5::shape_of(dataset, path, file);
    const bool all = slab.offset.empty() && slab.count.empty();
    std::vector<hsize_t> offset(slab.offset.begin(), slab.offset.end());
    std::vector<hsize_t> count(slab.count.begin(), slab.count.end());
    if (all) offset.assign(shape.size(), 0), count.assign(shape.begin(), shape.end());
    bool inside = offset.size() == shape.size() && count.size() == shape.size();
    for (std::size_t i = 0; inside && i < shape.size(); ++i)
        inside = offset[i] <= shape[i] && count[i] <= shape[i] - offset[i];
    if (!inside)
        throw RecordError(hdf5::dataset_action(path), file,
                          fmt::format("offset [{}] and count [{}] lie outside its shape [{}]", fmt::join(offset, ", "),
                                      fmt::join(count, ", "), fmt::join(shape, ", ")));
    Selection selection{hdf5::Dataspace(hdf5::api().H5Dget_space(dataset)), {}, 1};
    selection.elements = product_of(count, path, file);
    if (count.empty()) {
        selection.target = hdf5::Dataspace(hdf5::api().H5Screate(H5S_SCALAR));
    } else {
        selection.target =
            hdf5::Dataspace(hdf5::api().H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr));
        hdf5::api().H5Sselect_hyperslab(selection.source.id(), H5S_SELECT_SET, offset.data(), nullptr, count.data(),
                                        nullptr);
    }
    return selection;
}

// Any byte but zero is true, whatever a damaged file holds.
std::vector<bool> as_bools(const std::vector<std::uint8_t>& bytes) {
    std::vector<bool> values(bytes.size());
    std::transform(bytes.begin(), bytes.end(), values.begin(), [](std::uint8_t byte) { return byte != 0; });
    return values;
}

}  // namespace

bool is_hdf5_file(const std::filesystem::path& file) {
    std::error_code unreadable;
    hdf5::prepare();
    return std::filesystem::is_regular_file(file, unreadable) && hdf5::api().H5Fis_hdf5(file.c_str()) > 0;
}

RecordReader::RecordReader(const std::filesystem::path& path) {
    const std::string name = path.string();
    require_hdf5(name);
    switch (wholeness_of(path)) {
        case Wholeness::whole:
            break;
        case Wholeness::damaged:
            throw RecordError(
                reading, name,
                "it is damaged: it was cut short, or changed after it was written; make it anew (if it was "
                "changed on purpose, cut off the last 89 bytes, its checksum; of schema 1, zero the first 512)");
        case Wholeness::unstated:
            try_reading(path, [&] { read_everything(RecordReader(std::make_unique<OpenFile>(name))); });
    }
    file_ = std::make_unique<OpenFile>(name);
    require_schema();
}

RecordReader::RecordReader(std::unique_ptr<OpenFile> file) : file_(std::move(file)) {}

void RecordReader::require_schema() const {
    if (!has_attribute("/", "schema_version")) {
        throw RecordError(reading, file_->name, "it has no schema_version, so it is not a Swirl record");
    }
    if (const std::int64_t version = schema_version(); version < 1 || version > record_schema_version) {
        throw RecordError(
            reading, file_->name,
            fmt::format("its schema_version is {}, this program reads 1 to {}", version, record_schema_version));
    }
}

RecordReader::~RecordReader() = default;
RecordReader::RecordReader(RecordReader&&) noexcept = default;
RecordReader& RecordReader::operator=(RecordReader&&) noexcept = default;

std::string RecordReader::file_name() const {
    return file_->name;
}

std::int64_t RecordReader::schema_version() const {
    return attribute<std::int64_t>("/", "schema_version");
}

std::vector<std::string> RecordReader::members(const std::string& group) const {
    return link_names(file_->open(group, H5I_GROUP).id(), group, file_->name);
}

std::vector<std::string> RecordReader::groups(const std::string& group) const {
    std::vector<std::string> names = members(group);
    std::erase_if(names, [&](const std::string& name) {
        return hdf5::api().H5Iget_type(file_->open(group + "/" + name).id()) != H5I_GROUP;
    });
    return names;
}

std::vector<std::string> RecordReader::datasets(const std::string& group) const {
    std::vector<std::string> names = members(group);
    std::erase_if(names, [&](const std::string& name) {
        const hdf5::Object member = file_->open(group + "/" + name);
        return hdf5::api().H5Iget_type(member.id()) != H5I_DATASET || hdf5::is_bare_scale(member.id());
    });
    return names;
}

bool RecordReader::contains(const std::string& path) const {
    // HDF5 takes a missing group on the way for an error, and here it is an answer.
    return path == "/" ||
           (!path.empty() && hdf5::api().H5Oexists_by_name(file_->file.id(), path.c_str(), H5P_DEFAULT) > 0);
}

std::vector<std::string> RecordReader::attributes(const std::string& object) const {
    return hdf5::attribute_names(file_->open(object).id());
}

bool RecordReader::has_attribute(const std::string& object, const std::string& name) const {
    return hdf5::has_attribute(file_->open(object).id(), name);
}

AttributeValue RecordReader::attribute(const std::string& object, const std::string& name) const {
    return hdf5::read_attribute(file_->open(object).id(), name, file_->name);
}

DatasetInfo RecordReader::info(const std::string& dataset) const {
    const hdf5::Object object = file_->open(dataset, H5I_DATASET);
    const hid_t id = object.id();
    DatasetInfo info{hdf5::element_type_of(id, dataset, file_->name), hdf5::shape_of(id, dataset, file_->name), {}, {}};
    const bool coordinate = hdf5::api().H5DSis_scale(id) > 0;
    for (unsigned axis = 0; axis < info.shape.size(); ++axis) {
        info.dimensions.push_back(coordinate ? hdf5::last_component(dataset) : hdf5::dimension_name(id, axis));
    }
    info.description.units = hdf5::text_attribute(id, "units", file_->name);
    info.description.long_name = hdf5::text_attribute(id, "long_name", file_->name);
    std::istringstream meanings(hdf5::text_attribute(id, "flag_meanings", file_->name));
    for (std::string meaning; meanings >> meaning;) info.description.flag_meanings.push_back(meaning);
    return info;
}

template <RecordElement T>
std::vector<T> RecordReader::read(const std::string& dataset, const Slab& slab) const {
    using Stored = std::conditional_t<std::same_as<T, bool>, std::uint8_t, T>;
    const hdf5::Object object = file_->open(dataset, H5I_DATASET);
    if (!readable_as(hdf5::element_type_of(object.id(), dataset, file_->name), element_type<T>())) {
        throw RecordError(hdf5::dataset_action(dataset), file_->name, "its type is another");
    }
    const Selection selection = select(object.id(), slab, dataset, file_->name);
    std::vector<Stored> values(selection.elements);
    if (selection.elements == 0) return {};
    hdf5::check(hdf5::api().H5Dread(object.id(), memory_type(element_type<T>()), selection.target.id(),
                                    selection.source.id(), H5P_DEFAULT, values.data()),
                hdf5::dataset_action(dataset), file_->name);
    if constexpr (std::same_as<T, bool>) return as_bools(values);
    if constexpr (!std::same_as<T, bool>) return values;
}

std::vector<std::string> RecordReader::read_strings(const std::string& dataset) const {
    const hdf5::Object object = file_->open(dataset, H5I_DATASET);
    if (hdf5::element_type_of(object.id(), dataset, file_->name) != ElementType::string) {
        throw RecordError(hdf5::dataset_action(dataset), file_->name, "its type is another");
    }
    const Selection selection = select(object.id(), {}, dataset, file_->name);
    const hdf5::Datatype type = hdf5::string_type();
    if (selection.elements == 0) return {};
    std::vector<char*> texts(selection.elements, nullptr);
    hdf5::check(hdf5::api().H5Dread(object.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()),
                hdf5::dataset_action(dataset), file_->name);
    std::vector<std::string> values;
    values.reserve(selection.elements);
    for (const char* text : texts) values.emplace_back(text != nullptr ? text : "");
    hdf5::api().H5Dvlen_reclaim(type.id(), selection.target.id(), H5P_DEFAULT, texts.data());
    return values;
}

template std::vector<double> RecordReader::read<double>(const std::string&, const Slab&) const;
template std::vector<std::int64_t> RecordReader::read<std::int64_t>(const std::string&, const Slab&) const;
template std::vector<std::int32_t> RecordReader::read<std::int32_t>(const std::string&, const Slab&) const;
template std::vector<std::uint8_t> RecordReader::read<std::uint8_t>(const std::string&, const Slab&) const;
template std::vector<bool> RecordReader::read<bool>(const std::string&, const Slab&) const;

namespace {

// No record is nested as deeply; a damaged one may hold itself.
constexpr int deepest = 16;

template <class Read>
void attempt(const Read& read) {
    try {
        read();
    } catch (const std::exception&) {  // this one can't be read: on to the next
    }
}

void read_attributes(const RecordReader& record, const std::string& object) {
    attempt([&] {
        for (const auto& name : record.attributes(object))
            attempt([&] { static_cast<void>(record.attribute(object, name)); });
    });
}

void read_dataset(const RecordReader& record, const std::string& path) {
    const DatasetInfo info = record.info(path);
    switch (info.type) {
        case ElementType::float64:
            static_cast<void>(record.read<double>(path));
            break;
        case ElementType::int64:
            static_cast<void>(record.read<std::int64_t>(path));
            break;
        case ElementType::int32:
            static_cast<void>(record.read<std::int32_t>(path));
            break;
        case ElementType::uint8:
            static_cast<void>(record.read<std::uint8_t>(path));
            break;
        case ElementType::boolean:
            static_cast<void>(record.read<bool>(path));
            break;
        case ElementType::string:
            static_cast<void>(record.read_strings(path));
            break;
    }
}

void read_group(const RecordReader& record, const std::string& group, int depth) {
    read_attributes(record, group);
    if (depth == deepest) return;
    attempt([&] {
        for (const auto& name : record.members(group)) {
            const std::string path = group + (group == "/" ? "" : "/") + name;
            attempt([&] { read_dataset(record, path); });
            read_group(record, path, depth + 1);
        }
    });
}

}  // namespace

void read_everything(const RecordReader& record) {
    read_group(record, "/", 0);
    attempt([&] { static_cast<void>(record.datasets("/")); });
}

}  // namespace swirl::apps
