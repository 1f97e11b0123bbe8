// The numbers of an impact by name, in the order of docs/command-line.md, "simulate", with what a record says of them.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/studies/scene_map/impact_row.hpp"

#include <array>

namespace swirl::apps {

struct ImpactField {
    const char* name;
    double ImpactRow::*member;
    const char* units;
    const char* long_name;
    const char* heading = "";  ///< in the table for people, which lists those that have one
};

inline constexpr std::array<ImpactField, 22> impact_fields = {{
    {"t", &ImpactRow::t, "1/omega_s", "time", "t"},
    {"x", &ImpactRow::x, "R_c", "centre of the body, from the swirl's centre"},
    {"y", &ImpactRow::y, "R_c", "centre of the body, from the swirl's centre"},
    {"vx", &ImpactRow::vx, "R_c omega_s", "velocity of the centre just after the impact"},
    {"vy", &ImpactRow::vy, "R_c omega_s", "velocity of the centre just after the impact"},
    {"angle", &ImpactRow::angle, "rad", "direction of vertex 0, unwound"},
    {"spin", &ImpactRow::spin, "omega_s", "S just after the impact"},
    {"t_turns", &ImpactRow::t_turns, "1", "whole turns of the swirl: t = t_phase + 2 pi t_turns"},
    {"t_phase", &ImpactRow::t_phase, "rad", "direction of the swirl's arm, 0 to 2 pi, to all digits however long t"},
    {"angle_turns", &ImpactRow::angle_turns, "1", "whole turns of the body: angle = angle_phase + 2 pi angle_turns"},
    {"angle_phase", &ImpactRow::angle_phase, "rad", "direction of vertex 0, 0 to 2 pi, to all digits"},
    {"psi", &ImpactRow::psi, "rad", "section coordinate psi = arg n - t", "psi"},
    {"chi", &ImpactRow::chi, "rad", "section coordinate chi = arg r - arg n", "chi"},
    {"vn", &ImpactRow::vn, "R_c omega_s", "velocity of the centre along n", "vn"},
    {"vt", &ImpactRow::vt, "R_c omega_s", "velocity of the centre along t", "vt"},
    {"flight_time", &ImpactRow::flight_time, "1/omega_s", "duration of the flight before the impact"},
    {"impulse_normal", &ImpactRow::impulse_normal, "m R_c omega_s", "p, the impulse is -p n + q t", "p"},
    {"impulse_tangential", &ImpactRow::impulse_tangential, "m R_c omega_s", "q", "q"},
    {"jacobi", &ImpactRow::jacobi, "m R_c^2 omega_s^2", "J, energy in the swirling frame", "J"},
    {"jacobi_restitution", &ImpactRow::jacobi_restitution, "m R_c^2 omega_s^2", "change of J by restitution, -p u_n"},
    {"jacobi_friction", &ImpactRow::jacobi_friction, "m R_c^2 omega_s^2", "change of J by friction, q (u_t - 1)"},
    {"energy", &ImpactRow::energy, "m R_c^2 omega_s^2",
     "E_p = (v^2 + I S^2)/2 just after the impact, in the laboratory"},
}};

/// A disk has no chi.
inline bool belongs(const ImpactField& field, bool disk) {
    return !(disk && field.member == &ImpactRow::chi);
}

}  // namespace swirl::apps
