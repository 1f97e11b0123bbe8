#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "apps/record/hdf5_handle.hpp"
#include "apps/record/record_types.hpp"

namespace swirl::apps {

/// What a dataset is made with. `shape[0]` may be `growing`; a scalar has no shape.
struct ColumnLayout {
    std::string file;   // for messages
    std::string group;  // its path in the record
    std::string name;
    ElementType type;
    std::vector<std::string> dimensions;
    std::vector<std::uint64_t> shape;
    Description description;
};

/// One dataset being written; internal to the writer. The dataset is created in the file when its first chunk is full
/// or at the end, whichever is first, so that a short one gets a chunk of its own length.
class ColumnStore {
public:
    /// `group` is the open group, which outlives this.
    ColumnStore(hid_t group, ColumnLayout layout);

    void append(std::span<const std::byte> values);
    void write_strings(std::span<const std::string> values);

    /// Writes what is buffered. std::invalid_argument if a dimension that does not grow is not filled.
    void finish();

    [[nodiscard]] const ColumnLayout& layout() const { return layout_; }
    /// Along the first dimension, appended so far.
    [[nodiscard]] std::uint64_t rows() const { return written_rows_ + buffer_.size() / row_bytes_; }
    /// Open after finish().
    [[nodiscard]] hid_t dataset() const { return dataset_.id(); }
    /// "record 'a.h5': dataset '/group/name'", for messages.
    [[nodiscard]] std::string place() const;

private:
    [[nodiscard]] bool grows() const { return !layout_.shape.empty() && layout_.shape[0] == growing; }
    void create(bool whole);
    void describe();
    void write_buffer();
    [[nodiscard]] std::string action() const;

    hid_t group_;
    ColumnLayout layout_;
    std::size_t row_bytes_ = 1;
    std::vector<hsize_t> chunk_;
    std::vector<std::byte> buffer_;
    std::uint64_t written_rows_ = 0;
    hdf5::Dataset dataset_;
};

}  // namespace swirl::apps
