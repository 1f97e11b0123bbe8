// The return map of a scene as analysis/ wants to see a map: the one place where map/ and analysis/ meet.
#pragma once

#include "analysis/section_map.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "apps/studies/scene_map/lanes.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "map/model/parameter.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/return_map.hpp"
#include "map/orbit/speed_limits.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace swirl::studies {

template <int D>
class SceneDynamics;

/// F with sustained contact, of dimension 5 (polygons) or 4 (disks), whatever the impact rule: what differs is compiled
/// once for each, behind an abstract class (scene_dynamics.hpp), so that analyses are compiled once a dimension.
/// In double its states are those that `simulate` iterates, bit for bit; in another accuracy each step is computed
/// there and rounded to double (rounded_dynamics.hpp). Coordinates are (ψ, χ, v_n, v_t, S), a disk's (ψ, v_n, v_t, S).
/// It ends (`alive` false) where there is no next impact, and where speeds leave the numbers. The derivative, by the
/// coordinates, is exact, also through contact (map/orbit/return_derivative.hpp). Copies
/// share what they are made of.
template <int D>
class SceneMap {
public:
    static constexpr int dimension = D;
    static constexpr int integrated = D - 1;  ///< S: ∫S dt through contact, too
    using State = PostImpactState<double>;
    using Derivative = analysis::Matrix<D>;

    ///   horizon   the map ends where contact lasts longer than that
    ///   accuracy  in which a step is computed; its result is rounded to double
    /// @throws std::invalid_argument if the scene is out of range
    explicit SceneMap(const Scene<double>& scene, double horizon = contact_horizon,
                      Accuracy accuracy = Accuracy::double_precision);

    /// A scene of this shape and impact rule with other numbers: friction stays, where μ is 0 too (its limit μ → 0).
    SceneMap with(const Scene<double>& scene) const;

    const Body<double>& body() const { return *body_; }
    /// What contact needs of the scene; only where ReturnMap has it.
    const ContactScene<double>& contact() const;

    analysis::Advance<D, State> advance(const State& z) const { return advance_by(return_step(z)); }
    /// The step where it is known already.
    analysis::Advance<D, State> advance_by(const ReturnStep<double>& known) const;
    analysis::Linearised<D, State> linearise(const State& z) const;
    /// The step that an orbit has taken and its derivative: without a search for the contact where it was a flight.
    analysis::Linearised<D, State> linearise(const State& z, const analysis::KnownStep<State>& known) const;
    /// See analysis::follow. In place, and what repeats itself to the bit (ExactReturn) is not followed again.
    std::int64_t follow(State& z, std::int64_t steps, const analysis::Stop& stop, analysis::StepBudget& budget) const;

    /// May this scene's orbits take their steps together with those of the other's? (Of one shape and impact rule.)
    bool goes_together_with(const SceneMap& other) const;
    /// Steps that an orbit is to take together with others …
    LaneOrbit<D> lane_orbit(const State& z, std::int64_t count) const {
        return {dynamics_.get(), z, count, nullptr, false, most_excess(count)};
    }
    /// … and they do: scenes that go together, of which this is one.
    void follow_together(std::span<LaneOrbit<D>> orbits) const;

    static analysis::Vector<D> coordinates(const State& z) { return coordinates_of<D>(section_point(z)); }
    static double coordinate(const State& z, int i) {
        return i == D - 1 ? z.spin : i == D - 2 ? z.vt : i == D - 3 ? z.vn : coordinates(z)[i];
    }
    static State state_at(const analysis::Vector<D>& point) { return post_impact_state(section_point_of(point)); }
    static double angle_period(int coordinate) { return coordinate < D - 3 ? 2 * pi<double>() : 0; }

    /// The whole step from z, with what came before its impact or instead of one; `collision` is of a completed step
    /// only.
    ReturnStep<double> return_step(const State& z) const { return return_step(z, horizon_); }
    ReturnStep<double> return_step(const State& z, double horizon, const ContactSink& sink = {}) const;
    /// The first impact of a start. @throws std::invalid_argument if it is not inside the container
    ReturnStep<double> first_impact(const LabStart<double>& start) const;
    /// True if an orbit goes on from a step's end: there was an impact, and its speeds are within the numbers.
    bool goes_on(const ReturnStep<double>& step) const {
        return step.outcome == Outcome::completed && !has_come_to_rest(body(), step.collision.after) &&
               !has_diverged(body(), step.collision.after);
    }

    /// DF at z where the step from there is known: a flight …
    Derivative through_flight(const State& z, const ReturnStep<double>& known) const;
    /// … and ∂F/∂p beside it, of either, p a parameter of the scene …
    analysis::Vector<D> along(const State& z, const ReturnStep<double>& known, Parameter parameter) const;
    /// … or one with contact.
    Derivative through_contact(const SectionPoint<double>& z, const ReturnStep<double>& known) const {
        long series = 0;
        return through_contact(z, known, series);
    }
    /// … `series` is added the power series that it took.
    Derivative through_contact(const SectionPoint<double>& z, const ReturnStep<double>& known, long& series) const;

private:
    SceneMap(std::shared_ptr<const SceneDynamics<D>> dynamics, double horizon);

    std::shared_ptr<const SceneDynamics<D>> dynamics_;
    const Body<double>* body_;  ///< its own
    double horizon_;
};

extern template class SceneMap<disk_dimension>;
extern template class SceneMap<polygon_dimension>;

/// Calls `use(map)` with the scene's map: the one place where a scene's dimension is looked at.
template <class Use>
auto with_scene_map(const Scene<double>& scene, Use&& use, double horizon = contact_horizon,
                    Accuracy accuracy = Accuracy::double_precision) {
    if (scene.is_disk()) return use(SceneMap<disk_dimension>(scene, horizon, accuracy));
    return use(SceneMap<polygon_dimension>(scene, horizon, accuracy));
}

}  // namespace swirl::studies
