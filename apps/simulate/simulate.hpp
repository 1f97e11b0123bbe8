// `swirl simulate`: follows one orbit and lists its impacts.
#pragma once

#include "apps/command_line/noise_options.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/simulate/film.hpp"

#include <cstdint>
#include <optional>

namespace swirl::apps::simulate {

struct SimulateOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::optional<std::int64_t> collisions;
    std::optional<double> time;
    std::int64_t skip = 0;
    std::int64_t every = 1;
    std::optional<double> sample;  ///< time step of `samples`, or of the film's frames
    FilmOptions film;
    NoiseOptions noise;

    void add_to(Flags& command);
    std::int64_t limit() const { return collisions.value_or(100); }
};

/// The text under --help: outcomes and examples.
extern const char* const simulate_details;

/// @return the exit code. Throws BadInput, std::invalid_argument (input), RecordError, JsonError.
int simulate(SimulateOptions& options);

}  // namespace swirl::apps::simulate
