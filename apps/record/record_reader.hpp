// A record that is read, its checksum or a trial in a child process (trial_reading.hpp) first.
#pragma once

#include "apps/record/record_error.hpp"
#include "apps/record/record_types.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps {

/// Is it an HDF5 file, with or without a user block? False for what is no plain file or can't be read.
bool is_hdf5_file(const std::filesystem::path& file);

struct DatasetInfo {
    ElementType type;
    std::vector<std::uint64_t> shape;     // empty: a scalar
    std::vector<std::string> dimensions;  // one name per axis
    Description description;
};

/// Part of a dataset, one offset and count per dimension; the default is all of it.
struct Slab {
    std::vector<std::uint64_t> offset;
    std::vector<std::uint64_t> count;
};

/// Reads a record. Paths are "/group/name", the root is "/". Every failure is a RecordError of one line: the file is
/// missing, is not HDF5, is damaged (record_checksum.hpp), is no record, is of a later schema, holds no such object, or
/// holds it in another type. A file without a checksum is read in a child process first.
class RecordReader {
public:
    explicit RecordReader(const std::filesystem::path& path);
    ~RecordReader();
    RecordReader(RecordReader&&) noexcept;
    RecordReader& operator=(RecordReader&&) noexcept;

    [[nodiscard]] std::int64_t schema_version() const;

    /// Names in `group`, in alphabetical order. A dimension without a coordinate is no dataset.
    [[nodiscard]] std::vector<std::string> groups(const std::string& group = "/") const;
    [[nodiscard]] std::vector<std::string> datasets(const std::string& group = "/") const;
    /// All of them, and whatever else there is.
    [[nodiscard]] std::vector<std::string> members(const std::string& group = "/") const;
    [[nodiscard]] bool contains(const std::string& path) const;

    /// Attributes of a group or dataset.
    [[nodiscard]] std::vector<std::string> attributes(const std::string& object = "/") const;
    [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] AttributeValue attribute(const std::string& object, const std::string& name) const;
    /// `T` is one of AttributeValue's types, as it was written.
    template <class T>
    [[nodiscard]] T attribute(const std::string& object, const std::string& name) const {
        const AttributeValue value = attribute(object, name);
        if (const T* typed = std::get_if<T>(&value)) return *typed;
        throw RecordError("cannot read attribute '" + name + "' of record", file_name(), "its type is another");
    }

    [[nodiscard]] DatasetInfo info(const std::string& dataset) const;

    /// Row-major. `T` must be the dataset's own type, except that integers may be read into a wider type.
    template <RecordElement T>
    [[nodiscard]] std::vector<T> read(const std::string& dataset, const Slab& slab = {}) const;
    [[nodiscard]] std::vector<std::string> read_strings(const std::string& dataset) const;

private:
    [[nodiscard]] std::string file_name() const;

    struct OpenFile;
    explicit RecordReader(std::unique_ptr<OpenFile> file);
    void require_schema() const;
    std::unique_ptr<OpenFile> file_;
};

/// Reads whatever a record holds, and throws it away: all groups, attributes and datasets that can be read, each on its
/// own, so that one that can't does not hide another. For try_reading().
void read_everything(const RecordReader& record);

}  // namespace swirl::apps
