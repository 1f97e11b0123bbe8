#include "apps/system/chatter_once.hpp"

namespace swirl::apps {

namespace {

constexpr std::int64_t most_rebounds = 100'000;
/// ln 2⁵²: flights that fall by a smaller share than this over `most_rebounds` each do not reach rounding in so many. A
/// body that runs along the wall without loss (e = 1) has such flights, thousands of them.
constexpr double slowest_fall = 1 - 36.0 / most_rebounds;

/// Which vertex a rebound is on, seen from the one before: the same, or a neighbour in turn.
bool is_on_same_support(int sides, int first, int before, int now) {
    if (sides == disk_sides || first == 0) return now == first;
    const bool neighbours = first == 1 || first == sides - 1;
    return neighbours && now == (sides - before) % sides;
}

}  // namespace

Letter joined(const Letter& first, const Letter& second, int sides) {
    const int steps = first.vertex_step + second.vertex_step;
    return {sides == disk_sides ? 0 : steps % sides, second.mode, first.through_contact || second.through_contact};
}

template <int D>
std::int64_t steps_as_one(const SceneMap<D>& map, const PostImpactState<double>& z) {
    const int sides = map.body().sides;
    ReturnStep<double> step = map.return_step(z);
    if (!step.contacts.empty() || !map.goes_on(step)) return 1;
    const int first = step.collision.vertex_step;
    if (!is_on_same_support(sides, first, sides - first, first)) return 1;
    for (std::int64_t n = 2; n <= most_rebounds; ++n) {
        const ReturnStep<double> next = map.return_step(step.collision.after);
        if (!map.goes_on(next)) return 1;
        if (!next.contacts.empty()) return n;
        if (!(next.collision.flight_time < slowest_fall * step.collision.flight_time)) return 1;
        if (!is_on_same_support(sides, first, step.collision.vertex_step, next.collision.vertex_step)) return 1;
        step = next;
    }
    return 1;
}

template <int D>
analysis::Advance<D, PostImpactState<double>> advance_as_one(const SceneMap<D>& map, const PostImpactState<double>& z) {
    const std::int64_t steps = steps_as_one(map, z);
    auto whole = map.advance(z);
    for (std::int64_t i = 1; i < steps && whole.alive; ++i) {
        const auto step = map.advance(whole.state);
        whole.state = step.state;
        whole.alive = step.alive;
        whole.duration += step.duration;
        whole.integral += step.integral;
        whole.letter = number_of(joined(letter_from(whole.letter), letter_from(step.letter), map.body().sides));
    }
    return whole;
}

template std::int64_t steps_as_one(const SceneMap<disk_dimension>&, const PostImpactState<double>&);
template std::int64_t steps_as_one(const SceneMap<polygon_dimension>&, const PostImpactState<double>&);
template analysis::Advance<disk_dimension, PostImpactState<double>> advance_as_one(const SceneMap<disk_dimension>&,
                                                                                   const PostImpactState<double>&);
template analysis::Advance<polygon_dimension, PostImpactState<double>> advance_as_one(
    const SceneMap<polygon_dimension>&, const PostImpactState<double>&);

}  // namespace swirl::apps
