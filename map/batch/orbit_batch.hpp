// Many orbits advance together, one in each lane of a vector, with the bits of the scalar map. map/batch/README.md.
#pragma once

#include "map/batch/lane_block.hpp"
#include "map/orbit/return_map.hpp"
#include "map/orbit/speed_limits.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl {

/// An orbit of a batch, and how far it is to go. The return map must outlive the batch.
template <class Map>
struct BatchedOrbit {
    const ReturnMap<Map>* map = nullptr;
    PostImpactState<double> state{};  ///< just after its last impact; it goes on from here
    long long wanted = 0;             ///< impacts
    long long done = 0;
    Outcome outcome = Outcome::completed;  ///< else why there are fewer than `wanted`, as ReducedOrbit ends
};

/// An impact of one of them, as an observer sees it.
struct BatchedImpact {
    double flight_time = 0;
    int vertex_step = 0;
    int steps = 0;  ///< moments at which the flight was evaluated
    Impulse<double> impulse;
    const ReturnStep<double>* alone = nullptr;  ///< the whole step, where the scalar code made it; none: the lanes did
};

/// How a batch went.
struct BatchUse {
    long long impacts = 0;
    long long left = 0;  ///< steps that the lanes left to the scalar code …
    long long search_failed =
        0;  ///< … of these, without the searches from the circle's return, made without success by the lane
    long long sampled = 0;  ///< impacts that lanes found by their second search, from samples (disks)
    long long rounds = 0;   ///< looks at all lanes, without that
    long long filled = 0;   ///< lanes with an orbit, summed over the rounds

    /// Of the impacts; 0 where there was none.
    double share_left() const { return impacts == 0 ? 0 : static_cast<double>(left) / static_cast<double>(impacts); }
    /// 0 where no round was made.
    double lanes_in_use() const {
        return rounds == 0 ? 0 : static_cast<double>(filled) / (static_cast<double>(rounds) * detail::block_lanes);
    }
};

namespace detail {

void fill_scene(const Body<double>& body, double mu, double restitution, double widest_sine, int lane,
                LaneBlock& block);
void fill_state(const PostImpactState<double>& state, int lane, LaneBlock& block);

/// Number by number, also in what follows: a copy in pairs of numbers that were just written one by one waits for them.
inline void copy_state(const PostImpactState<double>& from, PostImpactState<double>& to) {
    to.psi.x = from.psi.x;
    to.psi.y = from.psi.y;
    to.chi.x = from.chi.x;
    to.chi.y = from.chi.y;
    to.vn = from.vn;
    to.vt = from.vt;
    to.spin = from.spin;
}
inline void take_state(const LaneBlock& block, int lane, PostImpactState<double>& state) {
    state.psi.x = block.psi_x.of[lane];
    state.psi.y = block.psi_y.of[lane];
    state.chi.x = block.chi_x.of[lane];
    state.chi.y = block.chi_y.of[lane];
    state.vn = block.vn.of[lane];
    state.vt = block.vt.of[lane];
    state.spin = block.spin.of[lane];
}
inline BatchedImpact impact_of(const LaneBlock& block, int lane) {
    BatchedImpact impact;
    impact.flight_time = block.flight_time.of[lane];
    impact.vertex_step = static_cast<int>(block.vertex_step.of[lane]);
    impact.steps = static_cast<int>(block.steps.of[lane]);
    impact.impulse.normal = block.normal.of[lane];
    impact.impulse.tangential = block.tangential.of[lane];
    impact.impulse.mode = static_cast<ContactMode>(static_cast<int>(block.mode.of[lane]));
    return impact;
}

/// The vertices of all polygons of a batch, one table for each number of sides.
class VertexTables {
public:
    /// @return the row at which the body's vertices begin
    std::int64_t add(const Body<double>& body);
    const double* numbers() const { return numbers_.data(); }

private:
    std::vector<std::pair<int, std::int64_t>> begins_;
    std::vector<double> numbers_;
};

/// What observes nothing.
struct NoObserver {
    template <class Orbit>
    static bool wants(const Orbit&) {
        return false;
    }
    template <class Orbit>
    void operator()(const Orbit&, const BatchedImpact&) const {}
};

template <class Map, class Observe>
class BatchRun {
public:
    BatchRun(std::span<BatchedOrbit<Map>> orbits, Observe& observe) : orbits_(orbits), observe_(observe) {
        kind_ = {Map::shape, Map::rule, false};
        for (const auto& orbit : orbits_) kind_.sums_chatter |= orbit.map->map().scene().restitution < 1;
        if constexpr (Map::shape == Shape::polygon)
            for (const auto& orbit : orbits_) first_vertex_.push_back(tables_.add(orbit.map->map().body()));
        first_.block.vertices = tables_.numbers();
    }

    BatchUse run() {
        for (int lane = 0; lane < block_lanes; ++lane) refill(lane);
        while (filled_ != 0) {
            const RoundResult result = advance_lanes(kind_, first_.block);
            ++use_.rounds;
            use_.filled += std::popcount(filled_);
            each(result.struck & filled_, [&](int lane) {
                if (!strike(first_, lane)) refill(lane);
            });
            each(result.left & filled_, [&](int lane) { leave(lane, (result.search_failed >> lane & 1u) != 0); });
            each(result.left & ~filled_ & ((1u << block_lanes) - 1), [&](int lane) { idle(lane); });
        }
        return use_;
    }

private:
    using Orbit = BatchedOrbit<Map>;

    /// A block, and whose orbits are in its lanes.
    struct Lanes {
        LaneBlock block;
        std::size_t place[block_lanes] = {};
        const Map* map[block_lanes] = {};  ///< whose scene a lane holds
    };

    template <class Use>
    static void each(std::uint32_t lanes, const Use& use) {
        for (; lanes != 0; lanes &= lanes - 1) use(std::countr_zero(lanes));
    }

    /// The next orbit for a lane, none if there is none left.
    void refill(int lane) {
        filled_ &= ~(1u << lane);
        if (waiting_.empty() && next_ == orbits_.size()) seek_from_samples();
        while (!waiting_.empty() || next_ < orbits_.size()) {
            const std::size_t place = next_place();
            Orbit& orbit = orbits_[place];
            if (orbit.done >= orbit.wanted || orbit.outcome != Outcome::completed) continue;
            const Map& map = orbit.map->map();
            if (Map::shape == Shape::polygon && map.body().vertices.empty()) {  // too many for a table
                while (step_alone(orbit, orbit.state, false) && orbit.done < orbit.wanted) {
                }
                continue;
            }
            fill(first_, lane, place, orbit.state);
            filled_ |= 1u << lane;
            return;
        }
        idle(lane);
    }

    std::size_t next_place() {
        if (waiting_.empty()) return next_++;
        const std::size_t place = waiting_.back();
        waiting_.pop_back();
        return place;
    }

    void fill(Lanes& lanes, int lane, std::size_t place, const PostImpactState<double>& state) {
        const auto& step = *orbits_[place].map;
        const Map& map = step.map();
        if (lanes.map[lane] != &map) {
            const double widest = map.scene().restitution < 1 ? step.contact().widest_sine : 0;
            fill_scene(map.body(), map.scene().mu, map.scene().restitution, widest, lane, lanes.block);
            if constexpr (Map::shape == Shape::polygon) lanes.block.scenes.first_vertex[lane] = first_vertex_[place];
            lanes.map[lane] = &map;
        }
        lanes.place[lane] = place;
        fill_state(state, lane, lanes.block);
    }

    /// A lane without an orbit repeats another's, so that its numbers are those of a flight and its vector does not
    /// wait for it; nobody looks at what it does.
    void idle(int lane) {
        if (filled_ == 0) return;
        const int other = std::countr_zero(filled_);
        PostImpactState<double> state;
        take_state(first_.block, other, state);
        fill(first_, lane, first_.place[other], state);
    }

    /// Are the impacts that its lane makes shown?
    bool is_observed(const Orbit& orbit) const {
        if constexpr (requires { observe_.wants(orbit); })
            return observe_.wants(orbit);
        else
            return true;
    }

    /// @return the orbit goes on
    bool strike(Lanes& lanes, int lane) {
        Orbit& orbit = orbits_[lanes.place[lane]];
        ++use_.impacts;
        ++orbit.done;
        const bool goes_on = orbit.done < orbit.wanted;
        if (is_observed(orbit)) {
            take_state(lanes.block, lane, orbit.state);
            observe_(orbit, impact_of(lanes.block, lane));
        } else if (!goes_on) {
            take_state(lanes.block, lane, orbit.state);
        }
        return goes_on;
    }

    /// A step that the lanes did not decide.
    ///   search_failed  neither would the scalar code's searches from the circle's return
    void leave(int lane, bool search_failed) {
        const std::size_t place = first_.place[lane];
        Orbit& orbit = orbits_[place];
        PostImpactState<double> from;
        take_state(first_.block, lane, from);
        // The second search waits until it has all its lanes; others meanwhile need to be there for this one.
        if (Map::shape == Shape::disk && search_failed && (!waiting_.empty() || next_ < orbits_.size())) {
            fill(sampled_, to_sample_++, place, from);
            if (to_sample_ == block_lanes) seek_from_samples();
            return refill(lane);
        }
        if (!step_alone(orbit, from, search_failed) || orbit.done >= orbit.wanted) return refill(lane);
        fill_state(orbit.state, lane, first_.block);
    }

    /// The second search of the orbits that wait for it; those that go on then wait for a lane.
    void seek_from_samples() {
        const int count = std::exchange(to_sample_, 0);
        if (count == 0) return;
        const RoundResult result = advance_sampled_disks(Map::rule, sampled_.block);
        for (int lane = 0; lane < count; ++lane) {
            const std::size_t place = sampled_.place[lane];
            Orbit& orbit = orbits_[place];
            PostImpactState<double> state;
            take_state(sampled_.block, lane, state);
            if ((result.struck >> lane & 1u) != 0) {
                ++use_.sampled;
                if (!strike(sampled_, lane)) continue;
                copy_state(state, orbit.state);
                waiting_.push_back(place);
            } else if (step_alone(orbit, state, true)) {
                waiting_.push_back(place);
            }
        }
    }

    /// By the scalar code. @return the orbit goes on
    bool step_alone(Orbit& orbit, const PostImpactState<double>& from, bool search_failed) {
        ++use_.left;
        use_.search_failed += search_failed ? 1 : 0;
        ReturnStep<double> step;
        copy_state(from, step.collision.after);
        orbit.outcome = search_failed ? orbit.map->advance_undecided(step) : orbit.map->advance(step);
        copy_state(step.collision.after, orbit.state);
        if (orbit.outcome != Outcome::completed) return false;
        ++use_.impacts;
        ++orbit.done;
        const Collision<double>& c = step.collision;
        observe_(orbit, BatchedImpact{c.flight_time, c.vertex_step, c.steps, c.impulse, &step});
        const Body<double>& body = orbit.map->map().body();
        if (has_come_to_rest(body, orbit.state)) orbit.outcome = Outcome::resting;
        if (has_diverged(body, orbit.state)) orbit.outcome = Outcome::diverged;
        return orbit.outcome == Outcome::completed;
    }

    std::span<Orbit> orbits_;
    Observe& observe_;
    KernelKind kind_;
    VertexTables tables_;
    std::vector<std::int64_t> first_vertex_;
    Lanes first_;
    Lanes sampled_;                     ///< for the second search
    int to_sample_ = 0;                 ///< … its lanes that are filled, from the first on
    std::vector<std::size_t> waiting_;  ///< places of orbits that go on from there and have no lane
    std::size_t next_ = 0;
    std::uint32_t filled_ = 0;  ///< a bit for each lane with an orbit
    BatchUse use_;
};

}  // namespace detail

/// Follows orbits of one shape and impact rule, whatever else of their scenes differs, each by its `wanted` impacts or
/// to its end. Bit for bit what `ReturnMap::advance` gives, step by step, whatever stands in the other lanes.
///   observe  called as observe(orbit, impact) after every impact, the orbits' impacts in turn, orbit by orbit mixed;
///            of an orbit that its `wants(orbit)` refuses, if it has one, only after those that the scalar code made
/// Cost: see map/batch/README.md; of fewer orbits than lanes that of as many as lanes.
template <class Map, class Observe>
BatchUse follow_batch(std::span<BatchedOrbit<Map>> orbits, Observe&& observe) {
    return detail::BatchRun<Map, std::remove_reference_t<Observe>>(orbits, observe).run();
}

template <class Map>
BatchUse follow_batch(std::span<BatchedOrbit<Map>> orbits) {
    detail::NoObserver nobody;
    return detail::BatchRun<Map, detail::NoObserver>(orbits, nobody).run();
}

}  // namespace swirl
