// An orbit in continuous time: where the body is and how it turns at any moment, in flight and in contact.
//
// Between two impacts an orbit is a row of segments: flights, on which the centre moves uniformly and S is constant
// (over a floor that drags: in closed form, map/dragged; with dry friction: integrated, map/dry), and pieces of contact
// so short that one power series (contact_series.hpp) gives the motion to rounding.
#pragma once

#include "map/model/floor_drag.hpp"
#include "map/orbit/bent_flight.hpp"
#include "map/orbit/orbit.hpp"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace swirl {

/// From `start` to `end`, t in 1/ω_s. Places are the laboratory's, in R_c.
struct TrajectorySegment {
    double start = 0, end = 0;
    bool in_contact = false;
    double angle = 0;                        ///< vertex 0's direction at the start, unwound
    double spin = 0;                         ///< in flight: S
    Vec2<double> from, to;                   ///< in flight: the centre at both ends
    FloorDrag<double> floor;                 ///< in flight: what the floor does
    std::shared_ptr<const BentFlight> path;  ///< in flight over a floor with dry friction

    /// Is its flight no straight line with constant S?
    bool is_bent() const { return floor.drags() || path != nullptr; }
    Support support = Support::vertex;  ///< in contact, and so are the next two
    ContactMotion motion = ContactMotion::sticking;
    ContactState<double> state;  ///< at the start
    BendContact bent;            ///< in contact over a floor with dry friction
};

/// Position and orientation of the body at a time, and in contact the wall's force on it, −λ n + f t (of an edge the
/// sum over its two vertices); NaN in flight.
struct Moment {
    Vec2<double> centre;                                             ///< laboratory, R_c
    double angle = 0;                                                ///< vertex 0's direction, unwound
    double spin = 0;                                                 ///< S
    double turned = 0;                                               ///< ∫ S dt from the segment's start
    double normal_force = std::numeric_limits<double>::quiet_NaN();  ///< λ, in m R_c ω_s²
    double friction = std::numeric_limits<double>::quiet_NaN();      ///< f, in m R_c ω_s²
    double slip = std::numeric_limits<double>::quiet_NaN();          ///< u_t, in R_c ω_s
};

/// The body at a time within a segment. Cost: in contact, a power series (about a microsecond).
Moment moment_at(const ContactScene<double>& scene, const TrajectorySegment& segment, double t);

/// Cuts the return steps of an orbit into segments. Give `sink()` to every Orbit::advance, and call `passed` after it.
class TrajectorySegmenter {
public:
    /// Begins at t = 0 where the orbit begins.
    template <class T>
    TrajectorySegmenter(const Scene<T>& scene, const LabStart<T>& start) : TrajectorySegmenter(in_double(scene)) {
        position_ = {number(start.x), number(start.y)};
        angle_ = number(start.angle);
        spin_ = number(start.spin);
        velocity_ = {number(start.vx), number(start.vy)};
    }
    template <class T>
    TrajectorySegmenter(const Scene<T>& scene, const SectionPoint<T>& z) : TrajectorySegmenter(in_double(scene)) {
        const ContactState<double> state{number(z.psi), number(z.chi), 0, number(z.spin)};
        position_ = centre_in_contact(state, 0);
        angle_ = state.psi + state.chi;
        spin_ = state.spin;
        velocity_ = times(cis(state.psi), Vec2<double>{number(z.vn), number(z.vt)});
    }

    const ContactScene<double>& scene() const { return scene_; }
    /// From now on the body moves so: in a scene with dry friction (map/orbit/dry_path.hpp).
    void take_paths_from(BentPaths paths) { bent_ = std::move(paths); }
    /// Are flights no straight lines with constant S?
    bool bends_flights() const { return floor_.drags() || bent_.flight; }
    /// Refers to this object.
    ContactSink sink();

    /// The segments of the return step that `orbit.advance` has just made; where it returned false, those of the
    /// contact that came after the last impact.
    ///   orbit  an Orbit, or what gives contacts() and lab() as it does
    template <class AnyOrbit>
    const std::vector<TrajectorySegment>& passed(const AnyOrbit& orbit, bool struck) {
        trajectory_.clear();
        add_contacts(orbit.contacts());
        if (struck) {
            const auto lab = orbit.lab();
            add_flight(number(lab.t), {number(lab.x), number(lab.y)});
            angle_ = number(lab.angle);  // free of the sum's accumulated rounding
            spin_ = number(lab.spin);
            velocity_ = {number(lab.vx), number(lab.vy)};
        }
        looks_.clear();
        return trajectory_;
    }

private:
    struct Look {
        ContactSums<double> sums;
        Support support;
        ContactMotion motion;
        ContactState<double> state;
    };

    explicit TrajectorySegmenter(const Scene<double>& scene);
    template <class T>
    static double number(const T& value) {
        return static_cast<double>(value);
    }
    template <class T>
    static Scene<double> in_double(const Scene<T>& s) {
        return {s.sides,
                number(s.alpha),
                number(s.beta),
                number(s.mu),
                number(s.restitution),
                s.law,
                number(s.inertia_factor),
                number(s.drag),
                number(s.spin_drag),
                s.floor,
                number(s.tangential_restitution),
                number(s.corner),
                number(s.floor_friction),
                number(s.gravity_ratio)};
    }
    Vec2<double> centre_in_contact(const ContactState<double>& state, double t) const;
    void add_contacts(const std::vector<ContactSegment>& segments);
    void add_flight(double until, const Vec2<double>& position);

    ContactScene<double> scene_;
    FloorDrag<double> floor_;
    bool has_dry_floor_ = false;
    BentPaths bent_;
    std::vector<Look> looks_;
    std::vector<TrajectorySegment> trajectory_;
    double time_ = 0;  ///< where the next segment begins: t, centre, angle, S
    Vec2<double> position_{}, velocity_{};
    double angle_ = 0, spin_ = 0;
};

}  // namespace swirl
