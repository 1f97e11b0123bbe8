// `swirl simulate`: follows one orbit and lists its impacts.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"

#include <cstdint>

namespace swirl::apps {

struct SimulateOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::int64_t collisions = 0;  ///< 0: not given
    double time = 0;
    std::int64_t skip = 0;
    std::int64_t every = 1;

    void add_to(CLI::App& command);
};

/// The text under --help: outcomes and examples.
extern const char* const simulate_details;

/// @return the exit code. Throws BadInput, std::invalid_argument (input), RecordError, JsonError.
int simulate(SimulateOptions& options);

}  // namespace swirl::apps
