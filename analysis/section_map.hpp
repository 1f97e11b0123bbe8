// The only thing that analysis/ knows of a dynamical system: a map of a section to itself.
#pragma once

#include "analysis/special_values.hpp"

#include <Eigen/Core>

#include <concepts>
#include <cstdint>
#include <functional>

namespace swirl::analysis {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;
template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

/// One application of the map, z ↦ z′. `State` is what the map iterates: the coordinates themselves unless it has its
/// own.
template <int D, class State = Vector<D>>
struct Advance {
    State state;              ///< z′; meaningless unless `alive`
    double duration = 1;      ///< time that the step took (1 for a map without a flow)
    std::int64_t letter = 0;  ///< which smooth branch of the map was taken; their sequence is the itinerary
    bool alive = true;        ///< false: the map ends here (no next impact, sustained contact, escape)
    double integral = 0;      ///< ∫ of the observable over the step's duration, for maps that have one
    double cost = 1;          ///< what it cost, in ordinary steps of this map: by count, the same on every machine
    bool derivative_is_zero =
        false;  ///< DF(z) = 0: z′ is the same whatever was before, so that the orbit repeats once it recurs
};

/// A step, as Advance has it, with the derivative DF(z), by the coordinates.
template <int D, class State = Vector<D>>
struct Linearised {
    State state;
    double duration = 1;
    std::int64_t letter = 0;
    bool alive = true;
    Matrix<D> derivative;
    double integral = 0;
    double cost = 2;  ///< as of Advance: an ordinary derivative costs as much as the step
};

/// What an orbit keeps of a step that it has taken.
template <class State>
struct KnownStep {
    const State& state;  ///< that it led to
    double duration = 1;
    std::int64_t letter = 0;
};

namespace section_map_detail {

template <class M>
struct StateOf {
    using type = Vector<M::dimension>;
};
template <class M>
requires requires {
    typename M::State;
}
struct StateOf<M> {
    using type = typename M::State;
};

}  // namespace section_map_detail

/// What a map iterates: M::State, or the coordinates where it names none.
template <class M>
using State = typename section_map_detail::StateOf<M>::type;

/// True if the states of a map are its coordinates.
template <class M>
inline constexpr bool iterates_coordinates = std::same_as<State<M>, Vector<M::dimension>>;

/// The D coordinates of a state. An orbit goes on from its states alone: coordinates are for whoever needs numbers.
template <class M>
Vector<M::dimension> coordinates(const M& map, const State<M>& z) {
    if constexpr (iterates_coordinates<M>)
        return z;
    else
        return map.coordinates(z);
}

/// One of them: where the map gives it alone no angle costs an arc tangent that isn't wanted.
template <class M>
double coordinate(const M& map, const State<M>& z, int i) {
    if constexpr (requires { map.coordinate(z, i); })
        return map.coordinate(z, i);
    else
        return coordinates(map, z)[i];
}

/// The state at coordinates: for solvers, which have numbers only. The state of coordinates(z) is z to rounding.
template <class M>
State<M> state_at(const M& map, const Vector<M::dimension>& point) {
    if constexpr (iterates_coordinates<M>)
        return point;
    else
        return map.state_at(point);
}

/// A map of R^D (some coordinates possibly angles) with its exact derivative.
///   M::dimension           D, known at compile time
///   M::State               if it is there: what the map iterates, with
///     map.coordinates(z)     its D numbers,
///     map.state_at(point)    and back;
///                          a state that a step leads to is finite wherever it is `alive`
///   map.advance(z)         F(z)
///   map.linearise(z)       F(z) and DF(z), by the coordinates; the same F bit for bit
///   map.angle_period(i)    the period of coordinate i if it is an angle (2π), 0 if it is a plain number
///   M::integrated          optional: the coordinate whose integral over a step is `integral`; all others (all, without
///                          it) count as constant over a step
///   map.follow(z, n, stop, budget)  optional: see `follow`
///   map.coordinate(z, i)   optional: coordinate i alone, for those that cost less than all
///   map.linearise(z, known)  optional: see `linearise_known`
template <class M>
concept SectionMap = requires(const M& map, const State<M>& z, const Vector<M::dimension>& point, int i) {
    { M::dimension } -> std::convertible_to<int>;
    { map.advance(z) } -> std::same_as<Advance<M::dimension, State<M>>>;
    { map.linearise(z) } -> std::same_as<Linearised<M::dimension, State<M>>>;
    { coordinates(map, z) } -> std::same_as<Vector<M::dimension>>;
    { state_at(map, point) } -> std::same_as<State<M>>;
    { map.angle_period(i) } -> std::convertible_to<double>;
};

/// Can an orbit go on from what a step led to?
template <SectionMap M, class Step>
bool goes_on(const M&, const Step& step) {
    if constexpr (iterates_coordinates<M>)
        return step.alive && step.state.allFinite();
    else
        return step.alive;
}

/// F(z) and DF(z) of a step that an orbit has taken. A map that need not take it again for its derivative has a
/// `linearise(z, known)` of its own, whose DF may be off by rounding.
template <SectionMap M>
Linearised<M::dimension, State<M>> linearise_known(const M& map, const State<M>& z, const KnownStep<State<M>>& known) {
    if constexpr (requires { map.linearise(z, known); })
        return map.linearise(z, known);
    else
        return map.linearise(z);
}

/// Asked now and then by what takes long: true to end it. Empty: never.
using Stop = std::function<bool()>;

/// What following an orbit has cost, in ordinary steps (Advance::cost), and how much it may.
struct StepBudget {
    double spent = 0;
    double most = infinity;

    bool is_spent() const { return spent >= most; }
};

/// Moves z on by `steps` steps and returns how many there were: fewer where the map ends (z is then the state that has
/// no next one) or where it was stopped, or its budget is spent. A map that can do so faster than step by step has a
/// `follow` of its own.
template <SectionMap M>
std::int64_t follow(const M& map, State<M>& z, std::int64_t steps, const Stop& stop, StepBudget& budget) {
    if constexpr (requires { map.follow(z, steps, stop, budget); }) {
        return map.follow(z, steps, stop, budget);
    } else {
        constexpr std::int64_t between = 1024;  // steps from look to look
        for (std::int64_t i = 0; i < steps; ++i) {
            if (budget.is_spent() || (stop && i % between == 0 && stop())) return i;
            const auto step = map.advance(z);
            budget.spent += step.cost;
            if (!goes_on(map, step)) return i;
            z = step.state;
        }
        return steps;
    }
}

/// Follows the orbit, whatever it costs.
template <SectionMap M>
std::int64_t follow(const M& map, State<M>& z, std::int64_t steps, const Stop& stop = {}) {
    StepBudget budget;
    return follow(map, z, steps, stop, budget);
}

/// The coordinate whose integral a map gives, −1 if none.
template <SectionMap M>
constexpr int integrated_coordinate() {
    if constexpr (requires { M::integrated; })
        return M::integrated;
    else
        return -1;
}

}  // namespace swirl::analysis
