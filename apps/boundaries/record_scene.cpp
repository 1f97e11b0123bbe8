#include "apps/boundaries/record_scene.hpp"

#include "apps/record/flag_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace swirl::apps::boundaries {

void require_same_scene(const RecordReader& record, const std::string& what, const std::string& group,
                        const Settings& scene, const std::vector<std::string>& varied) {
    for (const auto& [name, value] : scene) {
        if (std::find(varied.begin(), varied.end(), name) != varied.end() || !record.has_attribute(group, name))
            continue;
        const std::string there = flag_text_of(record.attribute(group, name)).value_or("?"),
                          here = flag_text_of(value).value_or("?");
        if (there != here) throw BadInput(fmt::format("{} has {} = {}; the scene has {}", what, name, there, here));
    }
}

}  // namespace swirl::apps::boundaries
