// An independent check in long double: is any vertex outside at a moment, or between two moments of a flight?
//
// Between moments a and b of a flight with |g″| ≤ M while inside (map/README.md, "Flight"), every gap stays below the
// chord of its ends by no more than M (b − a)²/8; so the interval is clear if the larger end plus that is within the
// tolerance, and is halved otherwise. That is a dense scan which is finest where the wall is near, and it cannot step
// over an excursion, however short. It shares nothing with the search: no derivatives, no neighbours in time, its own
// positions.
#pragma once

#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace swirl::tests {

using Real = long double;

/// A flight seen from the container's centre: X(t) = centre + V t − β (cis(phase + t) − cis phase), vertex 0 at
/// `angle` + S t.
struct ScannedFlight {
    int sides;
    Real alpha, beta;
    Real x, y, vx, vy;
    Real phase, angle, spin;
    bool struck;  ///< begins on the wall

    Real speed() const { return std::hypot(vx, vy); }
    /// The largest of all gaps |x|² − 1 (of the vertex nearest to the centre's direction: the farthest out).
    Real gap(Real t) const {
        const Real px = x + vx * t - beta * (std::cos(phase + t) - std::cos(phase));
        const Real py = y + vy * t - beta * (std::sin(phase + t) - std::sin(phase));
        const Real distance2 = px * px + py * py;
        if (sides == disk_sides) return distance2 - (1 - alpha) * (1 - alpha);
        const Real spacing = 2 * pi<Real>() / sides;
        const Real off = std::remainder(angle + spin * t - std::atan2(py, px), spacing);
        return distance2 + alpha * alpha + 2 * alpha * std::sqrt(distance2) * std::cos(off) - 1;
    }
    /// |g″| ≤ 2[(|V| + |S|α + β)² + S²α + β], for the disk 2[(|V| + β)² + β(1 − α)].
    Real curvature() const {
        const Real turning = sides == disk_sides ? 0 : std::fabs(spin) * alpha;
        const Real rate = speed() + turning + beta;
        const Real pull = sides == disk_sides ? beta * (1 - alpha) : spin * spin * alpha + beta;
        return 2 * (rate * rate + pull);
    }
};

struct Scan {
    bool clear = true;
    Real earliest = 0;  ///< a time at which something is outside, if not clear
    long moments = 0;
};

/// Looks for a gap above `tolerance` in [0, end].
inline Scan scan(const ScannedFlight& flight, Real end, Real tolerance) {
    struct Interval {
        Real from, to, gap_from, gap_to;
    };
    const Real eighth = flight.curvature() / 8;
    Scan result;
    std::vector<Interval> left{{0, end, flight.gap(0), flight.gap(end)}};
    result.moments = 2;
    while (!left.empty()) {  // ends: h halves, and M h²/8 is within the tolerance in the end
        const Interval interval = left.back();
        left.pop_back();
        const Real highest = std::max(interval.gap_from, interval.gap_to);
        if (highest > tolerance) {
            result.clear = false;
            result.earliest = interval.gap_from > tolerance ? interval.from : interval.to;
            return result;
        }
        const Real h = interval.to - interval.from;
        if (highest + eighth * h * h <= tolerance) continue;
        const Real middle = interval.from + h / 2;
        const Real gap = flight.gap(middle);
        ++result.moments;
        left.push_back({middle, interval.to, gap, interval.gap_to});
        left.push_back({interval.from, middle, interval.gap_from, gap});  // the earlier half first
    }
    return result;
}

}  // namespace swirl::tests
