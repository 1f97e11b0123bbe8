// `swirl tradeoff`: accuracy, evidence and model against their cost, measured on the user's scene.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/studies/tradeoff/tradeoff.hpp"

namespace swirl::apps::tradeoff {

using namespace studies::tradeoff;

struct TradeoffOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    double budget = 10;  ///< seconds

    void add_to(Flags& command);
};

extern const char* const tradeoff_details;

int tradeoff(TradeoffOptions& options);

}  // namespace swirl::apps::tradeoff
