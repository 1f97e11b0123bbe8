// A much longer orbit, stretch by stretch, by the map alone: no classification and no theory of chords.
#pragma once

#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/start.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::studies {

struct LongRun {
    std::vector<double> energies;  ///< mean energy in the container's frame, of each stretch
    std::vector<double> spins;     ///< mean S
    bool one_itinerary = true;     ///< every impact sticks, and goes on by the same number of vertices
    bool ended = false;            ///< no impact any more, or faster than the numbers, before all were seen

    /// The energy's mean rises from each stretch to the next.
    bool grows() const {
        return std::adjacent_find(energies.begin(), energies.end(), [](double a, double b) { return !(b > a); }) ==
               energies.end();
    }
    /// The mean of S comes nearer to a limit from each stretch to the next, or is within `share` of it.
    bool approaches(double limit, double share) const {
        for (std::size_t i = 1; i < spins.size(); ++i) {
            const double now = std::abs(spins[i] - limit);
            if (now > share * std::abs(limit) && now >= std::abs(spins[i - 1] - limit)) return false;
        }
        return true;
    }
};

/// The energy of a body in the container's frame.
inline double energy_in_container(const Scene<double>& scene, const PostImpactState<double>& z) {
    const double wn = z.vn - scene.beta * z.psi.y, wt = z.vt - scene.beta * z.psi.x;
    return 0.5 * (wn * wn + wt * wt + scene.inertia_factor * std::pow(scene.alpha * z.spin, 2));
}

/// `stretches` stretches of `length` impacts after a transient. Cost: a step of the map each.
inline LongRun long_run_of(const Scene<double>& scene, const Start<double>& start, std::int64_t transient,
                           std::int64_t length, int stretches) {
    return with_scene_map(scene, [&](const auto& map) {
        LongRun run;
        const auto begin = begin_orbit(map, start);
        auto z = begin.state;
        run.ended = begin.outcome != Outcome::completed;
        int vertices = -1;
        for (std::int64_t n = -transient; n < length * stretches && !run.ended; ++n) {
            const auto step = map.return_step(z);
            if (!map.goes_on(step)) {
                run.ended = true;
                break;
            }
            z = step.collision.after;
            if (n < 0) continue;
            if (n % length == 0) {
                run.energies.push_back(0);
                run.spins.push_back(0);
            }
            if (vertices < 0) vertices = step.collision.vertex_step;
            run.one_itinerary &= step.contacts.empty() && ends_in_stick(step.collision.impulse.mode) &&
                                 step.collision.vertex_step == vertices;
            run.energies.back() += energy_in_container(scene, z) / static_cast<double>(length);
            run.spins.back() += z.spin / static_cast<double>(length);
        }
        return run;
    });
}

}  // namespace swirl::studies
