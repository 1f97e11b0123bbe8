#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/record/record_error.hpp"
#include "apps/record/record_types.hpp"

namespace swirl::apps {

/// What every record says about itself, in attributes of its root beside schema_version.
struct RecordHeader {
    std::string title;
    std::string swirl_version;
    /// What the numerics were compiled for ("x86-64", "avx2", ...): equal bits are promised on one of them.
    std::string instruction_set;
    /// The command that wrote it; empty: none, and no attribute.
    std::string command{};
};

class RecordStore;  // the open file and its datasets
class ColumnStore;  // one dataset being written

/// One dataset being written, row by row along its first dimension. A small value that is valid as long as its writer.
template <RecordElement T>
class Column {
public:
    explicit Column(ColumnStore& store) : store_(&store) {}

    /// Appends whole rows, `values` in row-major order: a multiple of the product of the other dimensions' sizes
    /// (std::invalid_argument otherwise, or when a dimension that does not grow would overflow). Rows are kept until
    /// they fill a chunk (about 128 KiB). RecordError if they cannot be written then.
    void append(std::span<const T> values);
    void append(T value) { append(std::span<const T>(&value, 1)); }

private:
    ColumnStore* store_;
};

/// A group of a record: attributes, named dimensions, datasets on them. A small value that is valid as long as its
/// writer. Names are plain: not empty, no '/', not beginning with '.'; each once per group (std::invalid_argument). A
/// dataset named as a dimension holds that dimension's coordinate and has no other dimension.
class RecordGroup {
public:
    RecordGroup(RecordStore& store, std::string path) : store_(&store), path_(std::move(path)) {}

    /// Group `name` within this one; created when it does not exist.
    [[nodiscard]] RecordGroup group(const std::string& name) const;

    void attribute(const std::string& name, const AttributeValue& value) const;

    /// Every dataset of this group names its dimensions by these. `size` may be `growing`.
    void dimension(const std::string& name, std::uint64_t size) const;

    /// A dataset to be appended to. Only the first of its dimensions may be `growing`; at finish() every dimension must
    /// be filled, and datasets that share a growing one must be equally long. The bytes of the file depend on the order
    /// in which datasets are created and appended to, not on time.
    template <RecordElement T>
    [[nodiscard]] Column<T> column(const std::string& name, const std::vector<std::string>& dimensions,
                                   const Description& description) const;

    /// A whole dataset, `values` in row-major order. Without dimensions: one value, a scalar.
    template <RecordElement T>
    void write(const std::string& name, const std::vector<std::string>& dimensions, std::span<const T> values,
               const Description& description) const;
    template <RecordElement T>
    void write(const std::string& name, const std::vector<std::string>& dimensions, const std::vector<T>& values,
               const Description& description) const {
        write<T>(name, dimensions, std::span<const T>(values), description);
    }

    /// Strings (UTF-8, of any length, without a zero byte), for coordinates and the like: kept in memory, not
    /// compressed.
    void write_strings(const std::string& name, const std::vector<std::string>& dimensions,
                       std::span<const std::string> values, const Description& description) const;

private:
    RecordStore* store_;
    std::string path_;
};

/// Writes a record, an HDF5 file that netCDF readers open as well. Equal calls give equal bytes: the file holds no
/// path, host or time. Memory: about 128 KiB per dataset that is appended to. Use from one thread. Linux and like
/// systems.
class RecordWriter {
public:
    /// RecordError if the record cannot be created, before any work is lost; an existing file stays as it is until
    /// finish().
    RecordWriter(const std::filesystem::path& path, const RecordHeader& header);
    /// Without finish(): removes what was written.
    ~RecordWriter();
    RecordWriter(RecordWriter&&) noexcept;
    RecordWriter& operator=(RecordWriter&&) noexcept;

    [[nodiscard]] RecordGroup root();

    /// Columns that are made from now on get the attribute `physical_scale` that `scale` gives for their units, if any.
    void scale_units(std::function<std::optional<double>(const std::string&)> scale);

    /// Writes what is buffered, labels the dimensions, closes, syncs and renames. Once; nothing may be written after
    /// it. RecordError if something cannot be written; std::invalid_argument if a dataset has not its full length.
    void finish();

private:
    std::unique_ptr<RecordStore> store_;
};

}  // namespace swirl::apps
