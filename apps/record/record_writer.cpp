#include "apps/record/record_writer.hpp"

#include "apps/record/record_store.hpp"

#include <utility>

namespace swirl::apps {

template <RecordElement T>
void Column<T>::append(std::span<const T> values) {
    store_->append(std::as_bytes(values));
}

RecordGroup RecordGroup::group(const std::string& name) const {
    return {*store_, store_->require_group(path_, name)};
}

void RecordGroup::attribute(const std::string& name, const AttributeValue& value) const {
    store_->attribute(path_, name, value);
}

void RecordGroup::dimension(const std::string& name, std::uint64_t size) const {
    store_->dimension(path_, name, size);
}

template <RecordElement T>
Column<T> RecordGroup::column(const std::string& name, const std::vector<std::string>& dimensions,
                              const Description& description) const {
    return Column<T>(store_->column(path_, name, element_type<T>(), dimensions, description));
}

template <RecordElement T>
void RecordGroup::write(const std::string& name, const std::vector<std::string>& dimensions, std::span<const T> values,
                        const Description& description) const {
    column<T>(name, dimensions, description).append(values);
}

void RecordGroup::write_strings(const std::string& name, const std::vector<std::string>& dimensions,
                                std::span<const std::string> values, const Description& description) const {
    store_->column(path_, name, ElementType::string, dimensions, description).write_strings(values);
}

RecordWriter::RecordWriter(const std::filesystem::path& path, const RecordHeader& header)
    : store_(std::make_unique<RecordStore>(path)) {
    const RecordGroup group = root();
    group.attribute("schema_version", record_schema_version);
    group.attribute("title", header.title);
    if (!header.command.empty()) group.attribute("command", header.command);
    group.attribute("swirl_version", header.swirl_version);
    group.attribute("instruction_set", header.instruction_set);
}

RecordWriter::~RecordWriter() = default;
RecordWriter::RecordWriter(RecordWriter&&) noexcept = default;
RecordWriter& RecordWriter::operator=(RecordWriter&&) noexcept = default;

RecordGroup RecordWriter::root() {
    return {*store_, "/"};
}

void RecordWriter::scale_units(std::function<std::optional<double>(const std::string&)> scale) {
    store_->scale_units(std::move(scale));
}

void RecordWriter::finish() {
    store_->finish();
}

#define SWIRL_FOR_ELEMENT(T)                                                                                           \
    template class Column<T>;                                                                                          \
    template Column<T> RecordGroup::column<T>(const std::string&, const std::vector<std::string>&, const Description&) \
        const;                                                                                                         \
    template void RecordGroup::write<T>(const std::string&, const std::vector<std::string>&, std::span<const T>,       \
                                        const Description&) const;
SWIRL_FOR_ELEMENT(double)
SWIRL_FOR_ELEMENT(std::int64_t)
SWIRL_FOR_ELEMENT(std::int32_t)
SWIRL_FOR_ELEMENT(std::uint8_t)
SWIRL_FOR_ELEMENT(bool)
#undef SWIRL_FOR_ELEMENT

}  // namespace swirl::apps
