// The collision map as analysis/ wants to see a map: the one place where map/ and analysis/ meet.
#pragma once

#include "analysis/section_map.hpp"
#include "map/derivative/derivative.hpp"
#include "map/orbit/return_map.hpp"
#include "map/orbit/speed_limits.hpp"

namespace swirl::apps {

/// The return map as a SectionMap with coordinates (ψ, χ, v_n, v_t, S), the disk's (ψ, v_n, v_t, S).
/// It ends (`alive` false) where there is no next impact. The letter of the word is 6 · vertex step + contact mode for
/// a flight from impact to impact, and −1 less that where the way led through sustained contact.
/// Its derivative is exact for a flight; through contact it is made of differences
/// (map/orbit/return_derivative.hpp).
/// Compiled once, in section_system.cpp, for the scenes of `with_collision_map`.
template <Shape shape, ImpactRule rule>
class SectionSystem {
public:
    static constexpr int dimension = section_dimension<shape>;
    static constexpr int integrated = dimension - 1;  ///< S: ∫S dt through contact, too
    using State = analysis::Vector<dimension>;

    ///   horizon  the map ends where contact lasts longer than that
    explicit SectionSystem(const CollisionMap<double, shape, rule>& map, double horizon = contact_horizon)
        : map_(map), return_(map_.map()), horizon_(horizon) {}
    SectionSystem(const SectionSystem& other) : SectionSystem(other.map(), other.horizon_) {}
    SectionSystem& operator=(const SectionSystem&) = delete;

    const CollisionMap<double, shape, rule>& map() const { return map_.map(); }
    const ReturnMap<CollisionMap<double, shape, rule>>& return_map() const { return return_; }

    analysis::Advance<dimension> advance(const State& z) const;
    analysis::Linearised<dimension> linearise(const State& z) const;
    /// DF(z), where `return_step` is F(z) and completed.
    Eigen::Matrix<double, dimension, dimension> derivative_of(const SectionPoint<double>& z,
                                                              const ReturnStep<double>& return_step) const;

    static double angle_period(int coordinate) {
        const int angles = shape == Shape::disk ? 1 : 2;
        return coordinate < angles ? 2 * pi<double>() : 0;
    }

    static SectionPoint<double> point_of(const State& z) {
        std::array<double, dimension> c;
        for (int i = 0; i < dimension; ++i) c[static_cast<std::size_t>(i)] = z[i];
        return section_point<shape>(c);
    }
    static State state_of(const SectionPoint<double>& z) {
        const auto c = coordinates<shape>(z);
        State state;
        for (int i = 0; i < dimension; ++i) state[i] = c[static_cast<std::size_t>(i)];
        return state;
    }

    /// What a step says of a return step.
    template <class Step>
    void fill(Step& step, const ReturnStep<double>& return_step) const {
        const Collision<double>& collision = return_step.collision;
        step.alive = return_step.outcome == Outcome::completed && !has_come_to_rest(map().body(), collision.after) &&
                     !has_diverged(map().body(), collision.after);
        if (return_step.outcome != Outcome::completed) return;
        step.state = state_of(section_point(collision.after));
        step.duration = collision.flight_time;
        step.integral = return_step.turned;
        const int letter = 6 * collision.vertex_step + static_cast<int>(collision.impulse.mode);
        step.letter = return_step.contacts.empty() ? letter : -1 - letter;
    }

private:
    DifferentiatedMap<double, shape, rule> map_;
    ReturnMap<CollisionMap<double, shape, rule>> return_;
    double horizon_;
};

template <Shape shape, ImpactRule rule>
SectionSystem(const CollisionMap<double, shape, rule>&) -> SectionSystem<shape, rule>;

}  // namespace swirl::apps
