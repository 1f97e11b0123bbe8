// The user's units: what a scene is converted from, and results are shown in.
#pragma once

#include <optional>
#include <string>

namespace swirl::apps {

/// The units of physical input: lengths in R_c, times in 1/ω_s, masses in m.
struct Units {
    double length = 1;
    double time = 1;
    double mass = 1;
};

/// What a number in `unit` is multiplied by to be in the user's units: "R_c omega_s" gives R_c ω_s. None for what has
/// no such unit (rad, a pure number, names).
///   unit  R_c, omega_s and m with powers, "1/" before what divides: "1/omega_s", "m R_c^2 omega_s^2"
std::optional<double> physical_scale(const Units& units, const std::string& unit);

/// "in your units: R_c = 2, 1/omega_s = 0.25, m = 3", a line; nothing without units.
std::string units_in_words(const std::optional<Units>& units);

}  // namespace swirl::apps
