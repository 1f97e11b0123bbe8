#include "map/baselines/baseline_contact.hpp"
#include "map/baselines/touching_points.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace swirl {

namespace {

constexpr int most_iterations = 100;
constexpr int most_halvings = 60;

/// One point's gap as a function of time, and the count of moments looked at.
struct GapInTime {
    const Body<double>& body;
    const Flight<double>& flight;
    int point;
    int steps = 0;

    double at(double time) {
        ++steps;
        return detail::touching_point(body, flight, detail::moment_of(body, flight, time), point).gap;
    }
};

double gap_of_function(double time, void* gap) {
    return static_cast<GapInTime*>(gap)->at(time);
}

/// Brent's method between a moment inside and one that is not.
double brent_root(GapInTime& gap, double inside, double outside) {
    struct Free {
        void operator()(gsl_root_fsolver* solver) const { gsl_root_fsolver_free(solver); }
    };
    const std::unique_ptr<gsl_root_fsolver, Free> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
    gsl_function function{&gap_of_function, &gap};
    gsl_root_fsolver_set(solver.get(), &function, inside, outside);
    for (int i = 0; i < most_iterations; ++i) {
        if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
        const double low = gsl_root_fsolver_x_lower(solver.get()), high = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(low, high, 0, 4 * epsilon<double>()) == GSL_SUCCESS) break;
    }
    return gsl_root_fsolver_root(solver.get());
}

/// The root between two moments, at the later of which the point is outside; not positive if there is none. A point
/// that begins on the wall has a root at 0, too: from there the interval is halved until the point is inside.
double root_between(GapInTime& gap, double from, double to) {
    if (from == 0) {
        for (int i = 0; i < most_halvings; ++i) {
            from = 0.5 * to;
            if (gap.at(from) < 0) return brent_root(gap, from, to);
            to = from;
        }
        return -1;
    }
    return brent_root(gap, from, to);
}

/// The vertex that touches at the start already, beside the one that began the flight; −1 if none does.
int touches_at_start(const Body<double>& body, const Flight<double>& flight) {
    if (!flight.struck || body.sides == disk_sides) return -1;
    detail::NearestTwo<double> pair;
    detail::look_around(body, flight, instant_at_start(flight), pair);
    const auto* neighbour = detail::touching_neighbour(pair, detail::rate_rounding(body, flight));
    return neighbour ? neighbour->vertex : -1;
}

}  // namespace

FirstContact<double> brent_contact(const Body<double>& body, const Flight<double>& flight, double spacing) {
    if (const auto decided = detail::decided_at_start(body, flight)) return *decided;
    if (const int k = touches_at_start(body, flight); k >= 0)
        return detail::contact_of(body, instant_at_start(flight), k, 1);
    const int count = detail::touching_points(body);
    std::vector<char> inside(static_cast<std::size_t>(count), 1);
    GapInTime gap{body, flight, 0};
    long gaps = 0;
    for (int moment = 1; moment <= detail::most_moments && gaps <= detail::most_gaps; ++moment) {
        const double before = (moment - 1) * spacing, now = moment * spacing;
        const Instant<double> at = detail::moment_of(body, flight, now);
        ++gap.steps;
        if (detail::all_inside(body, at)) {
            std::fill(inside.begin(), inside.end(), 1);
            continue;
        }
        double earliest = 0;
        int vertex = -1;
        for (int k = 0; k < count; ++k) {
            const bool is_inside = detail::touching_point(body, flight, at, k).gap < 0;
            const bool was_inside = std::exchange(inside[static_cast<std::size_t>(k)], is_inside ? 1 : 0) != 0;
            if (is_inside || !was_inside) continue;
            gap.point = k;
            const double root = root_between(gap, before, now);
            if (!(root > 0) || (vertex >= 0 && root >= earliest)) continue;
            earliest = root;
            vertex = k;
        }
        gaps += count;
        if (vertex >= 0) return detail::contact_of(body, detail::moment_of(body, flight, earliest), vertex, gap.steps);
    }
    return detail::given_up(gap.steps);
}

}  // namespace swirl
