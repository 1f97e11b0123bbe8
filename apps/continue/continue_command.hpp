// `swirl continue`: one-parameter branches of cycles.
#pragma once

#include "apps/branches/branch_document.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace swirl::apps::continuation {

struct ContinueOptions {
    SceneOptions scene;
    StartOptions start;  ///< of --from attractor
    OutputOptions output;
    std::string record;                 ///< whose cycle is followed
    std::optional<std::int64_t> orbit;  ///< its number there, from 1
    std::string from;                   ///< psi,chi,vn,vt,S, or attractor
    std::string along;
    std::optional<std::int64_t> its_period;  ///< of the cycle near that point
    int switches = 1;
    double longest_step = 0.02;

    void add_to(Flags& command);
};

extern const char* const continue_details;
inline constexpr const char* from_attractor = "attractor";  ///< --from: what the start settles on

int continue_orbit(ContinueOptions& options);

}  // namespace swirl::apps::continuation
