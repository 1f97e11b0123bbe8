// `swirl fit`: restitution, friction and the law of impact from measurements.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/fit/dish_film.hpp"
#include "apps/fit/fallen_bodies.hpp"

#include <cstdint>
#include <string>

namespace swirl::apps::fit {

struct FitOptions {
    OutputOptions output;
    std::string impacts;  ///< a table of measured impacts
    FilmOptions film;
    FallsOptions falls;
    std::string inertia;  ///< I/m as text; empty: momentum tells it
    std::int64_t resamples = 200;
    std::uint64_t seed = 1;

    void add_to(Flags& command);
};

extern const char* const fit_details;

/// @return the exit code
int fit(FitOptions& options);

}  // namespace swirl::apps::fit
