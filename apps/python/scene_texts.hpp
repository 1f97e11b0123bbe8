// A scene as flags give it, for scene.py: the command's own reading of numbers, units, ranges and TOML files.
#pragma once

#include "apps/output/units.hpp"
#include "map/model/scene.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace swirl::python {

/// By the names of the flags, "inertia-factor", each as the flag has it.
using SceneTexts = std::map<std::string, std::string>;

struct ReadScene {
    SceneTexts texts;  ///< of the flags and the file
    Scene<double> scene;
    std::optional<apps::Units> units;
};

/// The names of a scene's parameters, in the order of --help.
std::vector<std::string> scene_names();

/// Of the words of a command line, "--alpha=0.4", "--scene=FILE.toml". @throws BadInput, std::invalid_argument
ReadScene read_scene(const std::vector<std::string>& words);

/// The scene of a record, and its units. @throws RecordError for what is none; BadInput for a record of no scene
SceneTexts scene_of_record(const std::string& record);

}  // namespace swirl::python
