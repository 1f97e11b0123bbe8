#include "apps/python/scene_texts.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/program.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace swirl::python {

namespace {

constexpr const char* command_of_scene = "Scene";

/// A command of these flags alone.
struct SceneAlone {
    apps::SceneOptions scene;

    void add_to(apps::Flags& command) { scene.add_to(command); }
};

template <class Run>
void add_scene(apps::Program& program, Run run) {
    program.add_command<SceneAlone>(command_of_scene, "", "", std::move(run));
}

/// In units of 1: what a record has is dimensionless, and its lengths and times stand beside it.
void add_units(const apps::RecordReader& record, SceneTexts& texts) {
    if (!record.contains("/units")) return;
    const auto length = record.attribute<double>("/units", "length");
    const auto time = record.attribute<double>("/units", "time");
    texts["container-radius"] = fmt::format("{}", length);
    texts["swirl-rate"] = fmt::format("{}", 1 / time);
    texts["mass"] = fmt::format("{}", record.attribute<double>("/units", "mass"));
}

}  // namespace

std::vector<std::string> scene_names() {
    apps::Program program("", "", "");
    add_scene(program, [](SceneAlone&) { return 0; });
    std::vector<std::string> names;
    const apps::ProgramDefinition definition = program.definition();
    for (const auto& option : definition.command(command_of_scene)->options) {
        const std::string& flag = option.flags.back();
        if (option.group == "Scene" && flag != "--scene") names.push_back(flag.substr(2));
    }
    return names;
}

ReadScene read_scene(const std::vector<std::string>& words) {
    ReadScene found;
    apps::Program program("", "", "");
    add_scene(program, [&](SceneAlone& options) {
        options.scene.read_file(true);
        found.scene = options.scene.scene<double>(apps::Extensions::followed);
        found.units = options.scene.units();
        for (const std::string& name : scene_names())
            if (options.scene.has(name)) found.texts[name] = options.scene.text(name, "");
        return 0;
    });
    std::vector<std::string> line = {"swirl", command_of_scene};
    line.insert(line.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& itinerary : line) arguments.push_back(itinerary.data());
    program.called(static_cast<int>(arguments.size()), arguments.data())();
    return found;
}

SceneTexts scene_of_record(const std::string& file) {
    const apps::RecordReader record(file);
    SceneTexts texts;
    if (record.contains("/scene"))
        for (const std::string& name : scene_names()) {
            const std::string attribute = apps::record_name(name);
            if (!record.has_attribute("/scene", attribute)) continue;
            if (const auto text = apps::flag_text_of(record.attribute("/scene", attribute))) texts[name] = *text;
        }
    if (texts.empty()) throw apps::BadInput(fmt::format("record '{}' holds no scene", file));
    add_units(record, texts);
    return texts;
}

}  // namespace swirl::python
