// `swirl lyapunov`: the whole Lyapunov spectrum of an orbit, with its errors and how it converged.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/studies/exponents/orbit_spectrum.hpp"

#include <cstdint>

namespace swirl::apps::lyapunov {

struct LyapunovCommandOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::int64_t transient = 10'000;
    std::int64_t collisions = 100'000;

    void add_to(Flags& command);
};

extern const char* const lyapunov_details;

int lyapunov(LyapunovCommandOptions& options);

}  // namespace swirl::apps::lyapunov
