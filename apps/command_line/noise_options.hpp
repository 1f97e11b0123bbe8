// --noise-restitution, --noise-mu, --noise-wall: noise at impacts, of commands that follow single orbits.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/studies/noise/impact_noise.hpp"

namespace swirl::apps {

struct NoiseOptions {
    double restitution = 0, mu = 0, wall = 0;

    void add_to(Flags& command);

    bool is_any() const { return restitution != 0 || mu != 0 || wall != 0; }
    /// Beside noise --seed is no way to give a start: it seeds the noise. Call before the start is taken.
    void keep_seed_apart(StartOptions& start) const {
        if (is_any()) start.keep_seed_apart();
    }
    /// @throws BadInput out of range, or in another accuracy than double's
    ImpactNoise noise(const StartOptions& start, const OutputOptions& output) const;
};

/// Of what a record or document says; nothing without noise.
void add_noise_settings(Settings& settings, const ImpactNoise& noise);

}  // namespace swirl::apps
