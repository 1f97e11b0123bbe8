#include "apps/record/read_everything.hpp"

#include <exception>

namespace swirl::apps {

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
