// The user's units, SI: what a scene is converted from, and results are shown in.
#pragma once

#include <optional>
#include <string>

namespace swirl::apps {

/// R_c in metres, 1/ω_s in seconds, m in kilograms.
struct Units {
    double length = 1;
    double time = 1;
    double mass = 1;
};

/// What a number in `unit` is multiplied by to be in the user's units: "R_c omega_s" gives R_c ω_s. None for what has
/// no such unit (rad, a pure number, names).
///   unit  R_c, omega_s and m with powers, "1/" before what divides: "1/omega_s", "m R_c^2 omega_s^2"
std::optional<double> physical_scale(const Units& units, const std::string& unit);

/// "m/s" of "R_c omega_s", "rad/s" of "omega_s"; "rad" is its own, what has no unit has none.
std::string unit_label(const std::string& unit);

/// How people read a number in `unit`: its label, and what it is multiplied by. Impulses, forces and energies of small
/// scenes have a prefix, so that the number where R_c = ω_s = m = 1 shows: "mN s" where m R_c ω_s is 0.02 N s, "uJ".
struct ShownUnit {
    std::string label;
    double scale = 1;
};
/// None for what physical_scale() has none of.
std::optional<ShownUnit> shown_unit(const Units& units, const std::string& unit);

/// A number in `unit` as people read it, and one as they gave it where R_c = ω_s = m = 1; the same without units.
double in_units(double value, const std::optional<Units>& units, const std::string& unit);
double without_units(double given, const std::optional<Units>& units, const std::string& unit);

/// "14.3 s", and "14.3" without units.
std::string with_unit(double value, const std::optional<Units>& units, const std::string& unit);

/// What users give as a text, in R_c = ω_s = m = 1, so that documents are without units; the same text without
/// units, or where it is not of this form.
///   point  "psi,chi,vn,vt,S", a disk's without chi: vn and vt are velocities, S is a ratio
///   range  "NAME=A:B", "NAME=A:B:COUNT" or "NAME=V,V,...": A, B, V in `unit`
std::string point_without_units(const std::string& text, const std::optional<Units>& units);
std::string range_without_units(const std::string& text, const std::optional<Units>& units, const std::string& unit);

/// "SI units: R_c = 2 m, omega_s = 4 rad/s (0.6366 Hz, 38.2 rpm), m = 3 kg", a line; nothing without units.
std::string units_in_words(const std::optional<Units>& units);

}  // namespace swirl::apps
