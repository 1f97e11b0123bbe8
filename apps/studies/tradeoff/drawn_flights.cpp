#include "apps/studies/tradeoff/drawn_flights.hpp"

#include "apps/studies/scene_map/orbit_ending.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_set>

namespace swirl::studies::tradeoff {

namespace {

constexpr double same_flight = 1e-6;         // states this near to each other are one trial
constexpr std::size_t few = 100;             // an orbit with fewer flights does not tell how often contacts are missed
constexpr std::int64_t approach = 1000;      // impacts of a start's beginning
constexpr std::int64_t longest = 4096;       // of the stretch that models follow
constexpr std::size_t most_timed = 256;      // chains: their states stay in a first-level cache
constexpr std::int64_t between_looks = 256;  // steps from one look at the budget to the next

/// A step of an orbit.
struct Seen {
    PostImpactState<double> state;
    bool is_flight = false;
    double condition = 1;
};

template <int D>
double condition_of(const SceneMap<D>& map, const PostImpactState<double>& z, const ReturnStep<double>& step) {
    const analysis::Vector<D> from = map.coordinates(z), to = map.coordinates(step.collision.after);
    const Body<double>& body = map.body();
    const analysis::Vector<D> sensitivity = map.through_flight(z, step).cwiseAbs() * from.cwiseAbs().cwiseMax(1) +
                                            body.alpha * map.along(z, step, Parameter::alpha).cwiseAbs() +
                                            body.beta * map.along(z, step, Parameter::beta).cwiseAbs();
    return 1 + sensitivity.cwiseQuotient(to.cwiseAbs().cwiseMax(1)).maxCoeff();
}

/// Up to `count` steps from z on; fewer if the orbit ends, or the budget is spent.
template <int D>
std::vector<Seen> look_along(const SceneMap<D>& map, PostImpactState<double> z, std::int64_t count,
                             const Budget& budget) {
    std::vector<Seen> seen;
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % between_looks == 0 && budget.is_spent(counted_share)) break;
        const ReturnStep<double> step = map.return_step(z);
        if (!map.goes_on(step)) break;
        Seen one{z, step.contacts.empty(), 1};
        if (one.is_flight) one.condition = condition_of<D>(map, z, step);
        seen.push_back(one);
        z = step.collision.after;
    }
    return seen;
}

/// Tells flights apart.
template <int D>
class Distinct {
public:
    bool is_new(const analysis::Vector<D>& z) {
        std::uint64_t key = 0;
        for (const double coordinate : z) {
            const double cell = std::round(coordinate / same_flight);
            key = (key ^ std::hash<double>()(cell)) * 0x9e3779b97f4a7c15u;  // Knuth's multiplicative hash
            key ^= key >> 32;
        }
        return cells_.insert(key).second;
    }

private:
    std::unordered_set<std::uint64_t> cells_;
};

/// Takes the flights among the steps that are new.
template <int D>
void take(const SceneMap<D>& map, const std::vector<Seen>& seen, std::int64_t count, Distinct<D>& distinct,
          DrawnFlights& drawn) {
    std::vector<int> in_a_row(seen.size() + 1, 0);
    for (std::size_t i = seen.size(); i-- > 0;)
        in_a_row[i] = seen[i].is_flight ? std::min(ten, in_a_row[i + 1] + 1) : 0;
    std::size_t next_ten = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        ++drawn.steps;
        if (!seen[i].is_flight) ++drawn.through_contact;
        if (!seen[i].is_flight || static_cast<std::int64_t>(drawn.flights.size()) >= count) continue;
        if (!distinct.is_new(map.coordinates(seen[i].state))) continue;
        const bool begins = i >= next_ten && in_a_row[i] == ten;
        if (begins) next_ten = i + ten;
        drawn.flights.push_back({seen[i].state, in_a_row[i], begins, seen[i].condition});
    }
}

/// Starts of chains to be timed: of ten flights where there are enough of them.
void choose_timed(const std::vector<Seen>& seen, DrawnFlights& drawn) {
    for (const int steps : {ten, 1}) {
        drawn.timed.clear();
        drawn.timed_steps = steps;
        int row = 0;
        for (std::size_t i = 0; i < seen.size() && drawn.timed.size() < most_timed; ++i) {
            row = seen[i].is_flight ? row + 1 : 0;
            if (row < steps) continue;
            drawn.timed.push_back(seen[i + 1 - static_cast<std::size_t>(steps)].state);
            row = 0;
        }
        if (drawn.timed.size() * ten >= std::min<std::size_t>(seen.size(), few)) return;
    }
}

template <int D>
DrawnFlights draw(const SceneMap<D>& map, const OrbitStarts& starts, std::int64_t transient, std::int64_t count,
                  const Budget& budget) {
    DrawnFlights drawn;
    const double beta = map.body().beta;
    const OrbitBegin first = begin_orbit(map, starts.start(beta, 0));
    drawn.outcome = first.outcome;
    drawn.impacts = first.impacts;
    if (first.outcome != Outcome::completed) return drawn;
    Distinct<D> distinct;
    PostImpactState<double> z = first.state;
    const std::int64_t followed =
        analysis::follow(map, z, transient, [&budget] { return budget.is_spent(counted_share); });
    const bool lasts = followed == transient;
    drawn.begin = lasts ? z : first.state;
    const std::vector<Seen> seen = look_along(map, *drawn.begin, lasts ? count : followed, budget);
    drawn.stretch = std::min<std::int64_t>(longest, static_cast<std::int64_t>(seen.size()));
    drawn.impacts += (lasts ? transient : 0) + static_cast<std::int64_t>(seen.size());
    if (!lasts || static_cast<std::int64_t>(seen.size()) < count) {
        long long impacts = 0;
        const PostImpactState<double> last =
            seen.empty() ? *drawn.begin : map.return_step(seen.back().state).collision.after;
        drawn.outcome = ending_at(map, last, impacts);
    }
    take(map, seen, count, distinct, drawn);
    choose_timed(seen, drawn);
    drawn.after_transient = lasts && drawn.flights.size() >= few;
    for (std::int64_t run = 0; run < starts.count && !drawn.after_transient; ++run) {
        if (static_cast<std::int64_t>(drawn.flights.size()) >= count || budget.is_spent(counted_share)) break;
        const OrbitBegin begin = begin_orbit(map, starts.start(beta, run));
        if (begin.outcome == Outcome::completed)
            take(map, look_along(map, begin.state, approach, budget), count, distinct, drawn);
    }
    if (drawn.timed.empty())  // an orbit of contact alone: of the others, then
        for (const DrawnFlight& flight : drawn.flights)
            if (drawn.timed.size() < most_timed) drawn.timed.push_back(flight.state);
    return drawn;
}

}  // namespace

DrawnFlights draw_flights(const Scene<double>& scene, const OrbitStarts& starts, std::int64_t transient,
                          std::int64_t count, const Budget& budget) {
    return with_scene_map(scene, [&](const auto& map) { return draw(map, starts, transient, count, budget); });
}

}  // namespace swirl::studies::tradeoff
