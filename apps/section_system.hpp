// The collision map as analysis/ wants to see a map: the one place where map/ and analysis/ meet.
#pragma once

#include "analysis/section_map.hpp"
#include "map/chatter.hpp"
#include "map/derivative.hpp"

namespace swirl::apps {

/// CollisionMap as a SectionMap with coordinates (ψ, χ, v_n, v_t, S), the disk's (ψ, v_n, v_t, S).
/// It ends (`alive` false) where there is no next impact, and where a flight with e < 1 lifts the struck vertex by less
/// than rounding: the end of chatter. The letter of the word is 6 · vertex step + contact mode.
template <Shape shape, ImpactRule rule>
class SectionSystem {
public:
    static constexpr int dimension = section_dimension<shape>;
    using State = analysis::Vector<dimension>;

    explicit SectionSystem(const CollisionMap<double, shape, rule>& map) : map_(map) {}

    const CollisionMap<double, shape, rule>& map() const { return map_.map(); }

    analysis::Advance<dimension> advance(const State& z) const {
        const Launch<double> launch = launch_from(point_of(z));
        const Collision<double> collision = map().advance(launch);
        analysis::Advance<dimension> step;
        fill(step, launch, collision);
        return step;
    }

    analysis::Linearised<dimension> linearise(const State& z) const {
        const auto linearised = map_.linearise(point_of(z));
        analysis::Linearised<dimension> step;
        fill(step, launch_from(point_of(z)), linearised.collision);
        if (step.alive) step.derivative = linearised.derivative;
        return step;
    }

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

private:
    template <class Step>
    void fill(Step& step, const Launch<double>& launch, const Collision<double>& collision) const {
        step.alive = collision.contact == ContactOutcome::contact &&
                     !ends_chatter(map().body(), map().scene().restitution, launch, collision) &&
                     !has_died_away(map().body(), collision.after);
        if (collision.contact != ContactOutcome::contact) return;
        step.state = state_of(section_point(collision.after));
        step.duration = collision.flight_time;
        step.letter = 6 * collision.vertex_step + static_cast<int>(collision.impulse.mode);
    }

    DifferentiatedMap<double, shape, rule> map_;
};

template <Shape shape, ImpactRule rule>
SectionSystem(const CollisionMap<double, shape, rule>&) -> SectionSystem<shape, rule>;

}  // namespace swirl::apps
