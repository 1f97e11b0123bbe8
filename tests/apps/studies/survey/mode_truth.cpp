#include "tests/apps/studies/survey/mode_truth.hpp"

#include "analysis/classification/classify.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace swirl::studies {

namespace {

constexpr double closure = 1e-9, near_closure = 1e-7;
constexpr double shake = 1e-13;
constexpr double apart = 1e-8;
constexpr int blocks = 32;

template <class Map>
std::int64_t period_of(const Map& map, const analysis::Tail<Map>& tail, double within) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    for (std::int64_t k = 1; k <= n / 2; ++k)
        if (analysis::classification_detail::return_distance(map, tail, k, std::max(k, n / 4), within) <= within)
            return k;
    return 0;
}

/// The period of the orbit that is shaken by 10⁻¹³ at every impact: what that destroys is an accident of rounding.
template <class Map>
std::int64_t nearly_shaken(const Map& map, const analysis::Tail<Map>& tail) {
    analysis::Tail<Map> other;
    auto z = tail.points.back();
    for (std::size_t i = 0; i < tail.points.size(); ++i) {
        for (int c = 0; c < Map::dimension; ++c) z[c] += shake * std::cos(1.0 + c + 2.4 * static_cast<double>(i));
        const auto step = map.advance(map.state_at(z));
        if (!step.alive) return 0;
        other.points.push_back(z);
        z = map.coordinates(step.state);
    }
    return period_of(map, other, near_closure);
}

/// ln of the separation's growth over one impact, and the neighbour drawn back to `apart`. The orbit goes on from its
/// state, so that it stays the one that is judged: from its coordinates it would part from it within chaos.
template <class Map, class State, class Point>
double part(const Map& map, State& orbit, Point& neighbour, int direction) {
    constexpr double rounding = 1e-15;
    const auto other = map.advance(map.state_at(neighbour));
    orbit = map.advance(orbit).state;  // alive: the tail went the same way
    neighbour = map.coordinates(orbit);
    const Point gap = other.alive ? analysis::difference(map, map.coordinates(other.state), neighbour) : Point::Zero();
    const double size = gap.norm();
    if (size > rounding)
        neighbour += gap * (apart / size);
    else
        neighbour[direction] += apart;
    return other.alive ? std::log(std::max(size, rounding) / apart) : 0;
}

template <class Map, class State>
void find_exponent(const Map& map, const State& start, std::int64_t steps, Truth& truth) {
    State orbit = start;
    auto neighbour = map.coordinates(start);
    neighbour[0] += apart;
    std::array<double, blocks> sums{};
    const std::int64_t length = steps / blocks;
    for (std::int64_t i = 0; i < length * blocks; ++i)
        sums[static_cast<std::size_t>(i / length)] +=
            part(map, orbit, neighbour, static_cast<int>(i % Map::dimension)) / static_cast<double>(length);
    double squares = 0;
    for (const double sum : sums) truth.exponent += sum / blocks;
    for (const double sum : sums) squares += (sum - truth.exponent) * (sum - truth.exponent);
    truth.exponent_error = std::sqrt(squares / (blocks * (blocks - 1)));
}

}  // namespace

Truth truth_of(const Scene<double>& scene, const Start<double>& start, const TruthOptions& options) {
    return with_scene_map(scene, [&](const auto& map) {
        Truth truth;
        const auto begin = begin_orbit(map, start);
        truth.ended = begin.outcome != Outcome::completed;
        if (truth.ended) return truth;
        const auto tail = analysis::follow_tail(map, begin.state, options.transient, options.tail);
        truth.ended = tail.ended;
        if (truth.ended) return truth;
        truth.period = period_of(map, tail, closure);
        if (truth.period > 0) {
            truth.nearly = period_of(map, tail, near_closure);
            if (nearly_shaken(map, tail) == truth.nearly)
                truth.mode = truth.period == 1 ? analysis::Mode::steady : analysis::Mode::quasi_steady;
            return truth;
        }
        find_exponent(map, tail.first, options.tail, truth);
        if (truth.exponent > std::max(5 * truth.exponent_error, 20 / static_cast<double>(options.tail))) {
            truth.mode = analysis::Mode::chaotic;
        } else {
            const auto rotation = analysis::classification_detail::rotation_of(map, tail);
            const double change = analysis::classification_detail::spread_change(map, tail);
            const bool settled = std::abs(std::log(change)) <= std::log(analysis::ClassifyOptions{}.settled_spread);
            if (settled && rotation.outcome == analysis::RotationOutcome::quasi_periodic)
                truth.mode = analysis::Mode::quasi_steady;
        }
        return truth;
    });
}

}  // namespace swirl::studies
