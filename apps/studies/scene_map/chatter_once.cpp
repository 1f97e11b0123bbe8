#include "apps/studies/scene_map/chatter_once.hpp"

#include <cstddef>
#include <utility>

namespace swirl::studies {

namespace {

constexpr std::size_t most_rebounds = 100'000;
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
std::vector<ReturnStep<double>> steps_as_one(const SceneMap<D>& map, const PostImpactState<double>& z) {
    const int sides = map.body().sides;
    std::vector<ReturnStep<double>> steps{map.return_step(z)};
    if (!steps.front().contacts.empty() || !map.goes_on(steps.front())) return steps;
    const int first = steps.front().collision.vertex_step;
    if (!is_on_same_support(sides, first, sides - first, first)) return steps;
    while (steps.size() < most_rebounds) {
        const Collision<double>& before = steps.back().collision;
        ReturnStep<double> next = map.return_step(before.after);
        if (!map.goes_on(next)) break;
        const bool lands = !next.contacts.empty();
        if (!lands && !(next.collision.flight_time < slowest_fall * before.flight_time &&
                        is_on_same_support(sides, first, before.vertex_step, next.collision.vertex_step)))
            break;
        steps.push_back(std::move(next));
        if (lands) return steps;
    }
    steps.erase(steps.begin() + 1, steps.end());
    return steps;
}

template <int D>
analysis::Advance<D, PostImpactState<double>> sum_of(const SceneMap<D>& map,
                                                     const std::vector<ReturnStep<double>>& steps) {
    auto whole = map.advance_by(steps.front());
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const auto step = map.advance_by(steps[i]);
        whole.state = step.state;
        whole.alive = step.alive;
        whole.derivative_is_zero |= step.derivative_is_zero;
        whole.duration += step.duration;
        whole.integral += step.integral;
        whole.letter = number_of(joined(letter_from(whole.letter), letter_from(step.letter), map.body().sides));
    }
    return whole;
}

template std::vector<ReturnStep<double>> steps_as_one(const SceneMap<disk_dimension>&, const PostImpactState<double>&);
template std::vector<ReturnStep<double>> steps_as_one(const SceneMap<polygon_dimension>&,
                                                      const PostImpactState<double>&);
template analysis::Advance<disk_dimension, PostImpactState<double>> sum_of(const SceneMap<disk_dimension>&,
                                                                           const std::vector<ReturnStep<double>>&);
template analysis::Advance<polygon_dimension, PostImpactState<double>> sum_of(const SceneMap<polygon_dimension>&,
                                                                              const std::vector<ReturnStep<double>>&);

}  // namespace swirl::studies
