#include "apps/command_line/noise_options.hpp"

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace swirl::apps {

void NoiseOptions::add_to(Flags& command) {
    Flags noise = command.under("Noise at impacts, by --seed");
    noise.add_option("--noise-restitution", restitution, "SIGMA", "of e, reflected into [0, 1]: standard deviation");
    noise.add_option("--noise-mu", mu, "SIGMA", "of mu, reflected at 0: standard deviation");
    noise.add_option("--noise-wall", wall, "SIGMA", "of the wall's normal at an impact, in rad: standard deviation");
}

ImpactNoise NoiseOptions::noise(const StartOptions& start, const OutputOptions& output) const {
    const auto require = [](const char* name, double value) {
        if (!(value >= 0 && value <= 1))
            throw BadInput(fmt::format("{} = {} is outside its range: 0 to 1", name, value));
    };
    require("noise-restitution", restitution);
    require("noise-mu", mu);
    require("noise-wall", wall);
    if (is_any()) output.require_double("noise at impacts is not extended to it; double is wanted");
    return {restitution, mu, wall, start.seed(), 0};
}

void add_noise_settings(Settings& settings, const ImpactNoise& noise) {
    if (!noise.is_any()) return;
    settings.emplace_back("noise_restitution", noise.restitution);
    settings.emplace_back("noise_mu", noise.mu);
    settings.emplace_back("noise_wall", noise.wall);
    settings.emplace_back("noise_seed", noise.seed);
}

}  // namespace swirl::apps
