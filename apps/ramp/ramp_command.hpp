// `swirl ramp`: one orbit while a parameter changes slowly, up and down.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/noise_options.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/studies/ramps/ramp.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace swirl::apps::ramp {

using namespace studies::ramps;

struct RampOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::string along;
    std::optional<double> rate, duration;
    bool down = false;
    std::int64_t cycles = 0;  ///< 0: not given
    RampSettings settings;    ///< what flags say of it
    bool branches = false;
    NoiseOptions noise;

    void add_to(Flags& command);
};

extern const char* const ramp_details;

/// What is written of a ramp.
struct RampResult {
    RampSettings settings;
    Ramp ramp;
    std::optional<RampBranches> branches;
};

void write_ramp_document(const RampOptions& options, const RampResult& result);
void write_ramp_record(RecordWriter& record, const RampOptions& options, const RampResult& result);
void print_ramp(const RampOptions& options, const RampResult& result);

int ramp(RampOptions& options);

}  // namespace swirl::apps::ramp
