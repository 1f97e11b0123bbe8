// One impact as it is listed: the state just after it, and what the impact did. Keys: docs/command-line.md, "simulate".
#pragma once

#include "apps/studies/scene_map/scene_orbit.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace swirl::studies {

struct ImpactRow {
    long long number = 0;  ///< 1, 2, … in the order of impacts
    double t = 0, x = 0, y = 0, vx = 0, vy = 0, angle = 0, spin = 0;
    double t_turns = 0, t_phase = 0, angle_turns = 0, angle_phase = 0;
    int vertex = 0;
    double psi = 0, chi = 0, vn = 0, vt = 0;
    double flight_time = 0, impulse_normal = 0, impulse_tangential = 0;
    ContactMode contact_mode = ContactMode::frictionless;
    bool simultaneous = false;
    double jacobi = 0, jacobi_restitution = 0, jacobi_friction = 0;
    double energy = 0;  ///< E_p = (v² + I S²)/2, in the laboratory
};

template <class T>
ImpactRow impact_row(const SceneOrbit<T>& orbit) {
    const auto& c = orbit.collision();
    const auto lab = orbit.lab();
    const auto z = section_point(c.after);
    const auto number = [](const auto& value) { return static_cast<double>(value); };
    ImpactRow row;
    row.number = orbit.impacts();
    row.t = number(lab.t);
    row.x = number(lab.x);
    row.y = number(lab.y);
    row.vx = number(lab.vx);
    row.vy = number(lab.vy);
    row.angle = number(lab.angle);
    row.spin = number(lab.spin);
    row.t_turns = number(lab.time.turns);
    row.t_phase = number(lab.time.phase);
    row.angle_turns = number(lab.direction.turns);
    row.angle_phase = number(lab.direction.phase);
    row.vertex = orbit.frame().vertex;
    row.psi = number(z.psi);
    row.chi = number(z.chi);
    row.vn = number(z.vn);
    row.vt = number(z.vt);
    row.flight_time = number(c.flight_time);
    row.impulse_normal = number(c.impulse.normal);
    row.impulse_tangential = number(c.impulse.tangential);
    row.contact_mode = c.impulse.mode;
    row.simultaneous = c.simultaneous;
    row.jacobi = number(jacobi_of(orbit.body(), c.after));
    row.jacobi_restitution = number(c.jacobi_restitution);
    row.jacobi_friction = number(c.jacobi_friction);
    const auto& body = orbit.body();
    const T inertia = body.unit * body.unit * body.inertia;
    row.energy = number((lab.vx * lab.vx + lab.vy * lab.vy + inertia * lab.spin * lab.spin) / 2);
    return row;
}

/// One piece of sustained contact as it is listed.
struct ContactRow {
    double t_start = 0, t_end = 0;
    std::vector<int> vertices;  ///< one, or the two of an edge (clockwise first); a disk has 0
    std::string_view begin, end, motion;
    double mean_spin = 0, jacobi_friction = 0;
    double landing_jacobi = 0;  ///< what summing up chatter before it added to J
    double landing_error = 0;   ///< what summing up chatter did to place and velocities before it (an estimate)
    std::int64_t number = 0;    ///< 1, 2, … of those that are listed

    double turned() const { return mean_spin * (t_end - t_start); }
};

/// The pieces of contact of the orbit's last return step.
///   t, vertex  time and vertex of the impact before it
template <class T>
std::vector<ContactRow> contact_rows(const SceneOrbit<T>& orbit, double t, int vertex) {
    std::vector<ContactRow> rows;
    const auto& body = orbit.body();
    for (const ContactSegment& piece : orbit.contacts()) {
        ContactRow row{t + piece.start,
                       t + piece.end,
                       {0},
                       name_of(piece.begin),
                       name_of(piece.finish),
                       rests_in_dish(piece) ? "resting" : name_of(piece.support, piece.motion),
                       piece.end > piece.start ? piece.turned / (piece.end - piece.start) : piece.from.spin,
                       piece.work,
                       piece.landing_jacobi,
                       piece.error,
                       0};
        if (piece.support != Support::rim) row.vertices[0] = body.vertex_number(vertex + piece.vertex_step);
        if (piece.support == Support::edge) row.vertices.push_back(body.vertex_number(row.vertices[0] + 1));
        rows.push_back(row);
    }
    return rows;
}

}  // namespace swirl::studies
