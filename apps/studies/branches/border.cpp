#include "apps/studies/branches/branches.hpp"
#include "apps/studies/scene_map/scene_map.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::studies {

namespace {

/// A gap, or an impulse, as small as that at the last cycle before a border touches. While one vertex strikes its
/// neighbour's gap is about α(1 − α)(2π/N)², and must be told from that.
double touching_of(const Body<double>& body) {
    if (body.sides == disk_sides) return 1e-6;
    const double angle = 2 * pi<double>() / body.sides;
    return std::min(1e-6, 1e-3 * body.alpha * body.inner * angle * angle);
}

/// The gap of whatever is nearest to the wall at time t of a flight.
template <Shape shape>
double largest_gap(const Body<double>& body, const Flight<double>& flight, double t) {
    const Instant<double> at = instant_at<shape>(flight, t);
    if constexpr (shape == Shape::disk) {
        return centre_gap(body, flight, at).value;
    } else {
        detail::NearestTwo<double> pair;
        detail::look_around(body, flight, at, pair);
        return std::max(pair.first.gap.value, pair.second.gap.value);
    }
}

/// The second vertex's gap at time t.
template <Shape shape>
double second_gap(const Body<double>& body, const Flight<double>& flight, double t) {
    if constexpr (shape == Shape::disk) return -1;
    const Instant<double> at = instant_at<shape>(flight, t);
    detail::NearestTwo<double> pair;
    detail::look_around(body, flight, at, pair);
    return std::min(pair.first.gap.value, pair.second.gap.value);
}

/// Does anything touch the wall in between, to rounding? The largest inner maximum of the gap.
template <Shape shape>
bool grazes(const Body<double>& body, const Flight<double>& flight, double duration) {
    constexpr int samples = 2000;
    const auto gap = [&](double t) { return largest_gap<shape>(body, flight, t); };
    std::vector<double> seen;
    for (int i = 0; i <= samples; ++i) seen.push_back(gap(duration * i / samples));
    for (int i = 1; i < samples; ++i) {
        const auto j = static_cast<std::size_t>(i);
        if (seen[j] < seen[j - 1] || seen[j] < seen[j + 1] || seen[j] < -1e-3) continue;
        const auto top = boost::math::tools::brent_find_minima(
            [&](double t) { return -gap(t); }, duration * (i - 1) / samples, duration * (i + 1) / samples, 40);
        if (-top.second > -touching_of(body)) return true;
    }
    return false;
}

template <int D>
std::string name_without_cycle(const SceneMap<D>& map, const analysis::CurvePoint& last) {
    constexpr Shape shape = shape_of<D>;
    const double touching = touching_of(map.body());
    for (const auto& z : last.points()) {
        const PostImpactState<double> post_impact = post_impact_state(section_point_of(z));
        const ReturnStep<double> return_step = map.return_step(post_impact);
        if (return_step.outcome != Outcome::completed) return "landing";
        if (!return_step.contacts.empty()) continue;
        const Flight<double> flight = flight_from(map.body(), post_impact);
        const double duration = return_step.collision.flight_time;
        if (std::abs(second_gap<shape>(map.body(), flight, 0)) < touching ||
            std::abs(second_gap<shape>(map.body(), flight, duration)) < touching)
            return "two-vertices";
        if (return_step.collision.impulse.normal < touching) return "grazing";
        if (grazes<shape>(map.body(), flight, duration)) return "grazing";
    }
    return analysis::nameless_border;
}

}  // namespace

std::string border_name(const Scene<double>& scene, const analysis::CurvePoint& last,
                        const std::vector<std::int64_t>& itinerary_after, bool goes_on, Accuracy accuracy) {
    if (!goes_on && !scene.has_own_map()) {  // flights are looked at as those of CollisionMap
        const std::string name = with_scene_map(
            scene, [&](const auto& map) { return name_without_cycle(map, last); }, contact_horizon, accuracy);
        if (name != analysis::nameless_border) return name;
    }
    const auto before = last.shooting.itinerary;
    for (std::size_t i = 0; i < before.size() && i < itinerary_after.size(); ++i) {
        if (before[i] == itinerary_after[i]) continue;
        const Letter a = letter_from(before[i]), b = letter_from(itinerary_after[i]);
        if (a.through_contact != b.through_contact) return "landing";
        return a.vertex_step == b.vertex_step ? "stick-slip" : "two-vertices";
    }
    return analysis::nameless_border;
}

}  // namespace swirl::studies
