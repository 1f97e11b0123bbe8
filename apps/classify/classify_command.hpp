// `swirl classify`: names the mode of a scene from one start, with its evidence; with --runs from several.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/classify/classify_series.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "map/outcome.hpp"

#include <string>

namespace swirl::apps {

struct ClassifyCommandOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    analysis::ClassifyOptions settings;
    ClassifyInput input;
    std::int64_t runs = 0;  ///< random starts; 0: one verdict, on the start that is given

    void add_to(CLI::App& command);
};

extern const char* const classify_details;

/// The verdict on one orbit, and how following it ended.
struct NamedMode {
    analysis::Classification verdict;
    Outcome outcome = Outcome::completed;
    long long impacts = 0;
};

/// Classifies one start of a scene. A pure function of its arguments.
/// @throws std::invalid_argument for a scene or start out of range
NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& settings);

int classify_scene(ClassifyCommandOptions& options);

}  // namespace swirl::apps
