#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/record/column_store.hpp"
#include "apps/record/hdf5_handle.hpp"
#include "apps/record/output_file.hpp"

namespace swirl::apps {

/// The open file behind a RecordWriter; internal to it. Groups are named by their path with a slash at the end ("/",
/// "/orbits/").
class RecordStore {
public:
    explicit RecordStore(const std::filesystem::path& path);
    /// Without finish(): HDF5 never closes the file. Closing writes what is left, of a file that is about to be
    /// removed; on a full disk HDF5 2.2 then aborts the process. What it keeps of the file in memory stays until the
    /// process ends.
    ~RecordStore();
    RecordStore(const RecordStore&) = delete;
    RecordStore& operator=(const RecordStore&) = delete;

    /// The path of group `name` in `parent`, created when it does not exist.
    std::string require_group(const std::string& parent, const std::string& name);
    void attribute(const std::string& group, const std::string& name, const AttributeValue& value);
    void dimension(const std::string& group, const std::string& name, std::uint64_t size);
    ColumnStore& column(const std::string& group, const std::string& name, ElementType type,
                        const std::vector<std::string>& dimensions, const Description& description);
    /// Columns get a physical_scale by their units from now on.
    void scale_units(std::function<std::optional<double>(const std::string&)> scale) { scale_ = std::move(scale); }
    void finish();

private:
    struct Dimension {
        std::string name;
        std::uint64_t size;
    };
    struct Group {
        std::string path;
        hdf5::Group handle;
        std::vector<Dimension> dimensions;
        std::deque<ColumnStore> columns;  // a deque: their addresses stay
    };

    [[nodiscard]] std::string file_name() const { return output_.name().string(); }
    [[noreturn]] void refuse(const std::string& object, const std::string& reason) const;
    Group& find(const std::string& path);
    [[nodiscard]] bool has_object(const Group& group, const std::string& name) const;
    void check_name(const Group& group, const std::string& name) const;
    void check_new_column(const Group& group, const std::string& name, const std::vector<std::string>& dimensions,
                          const Description& description) const;
    [[nodiscard]] const Dimension& find_dimension(const Group& group, const std::string& name) const;
    [[nodiscard]] std::uint64_t final_size(const Group& group, const Dimension& dimension) const;
    void label(Group& group, const Dimension& dimension);

    OutputFile output_;
    hdf5::File file_;
    std::function<std::optional<double>(const std::string&)> scale_;
    std::deque<Group> groups_;  // in the order of their creation; closed before the file
};

}  // namespace swirl::apps
