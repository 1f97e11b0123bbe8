// `swirl classify`: names the mode of a scene from one start, with its evidence; with --runs from several.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/classify/classify_series.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/studies/modes/name_mode.hpp"

#include <cstdint>
#include <limits>
#include <string>

namespace swirl::apps::classify {

struct ClassifyCommandOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    analysis::ClassifyOptions settings;
    ClassifyInput input;
    bool verbose = false;                                    ///< the table for people has the evidence
    double risk = 0;                                         ///< of chaos that is called before the limits
    double error = std::numeric_limits<double>::infinity();  ///< of their mean S, to which it is followed on
    std::int64_t runs = 0;  ///< random starts; 0: one verdict, on the start that is given

    void add_to(Flags& command);
};

extern const char* const classify_details;

int classify_scene(ClassifyCommandOptions& options);

}  // namespace swirl::apps::classify
