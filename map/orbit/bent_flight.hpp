// A flight that is neither straight nor in closed form, and a contact without a power series, for who asks where the
// body is on it.
#pragma once

#include "map/contact/contact_state.hpp"
#include "map/numbers/vec2.hpp"

#include <functional>
#include <memory>

namespace swirl {

/// A flight in the laboratory's axes.
class BentFlight {
public:
    /// What the body is at a moment.
    struct Place {
        Vec2<double> centre;  ///< in the laboratory, R_c
        double spin = 0;      ///< S
        double turned = 0;    ///< ∫ S dt from the start
    };

    virtual ~BentFlight() = default;
    /// A time after the start, in 1/ω_s.
    virtual Place at(double later) const = 0;
};

/// How a flight begins in the laboratory.
struct FlightBegin {
    double time = 0;  ///< t
    Vec2<double> centre, velocity;
    double angle = 0, spin = 0;  ///< vertex 0's direction, S
};

/// The flight from there, which lasts so long.
using BendFlight = std::function<std::shared_ptr<const BentFlight>(const FlightBegin& begin, double lasts)>;

/// What a contact has come to a time after a state on its way.
struct ContactPlace {
    ContactState<double> state;
    double turned = 0;                ///< ∫ S dt
    double normal = 0, friction = 0;  ///< the wall's force, −λ n + f t, in m R_c ω_s²; of an edge the sums of both
};

/// `later`: so short a time, in 1/ω_s, that one step of the integration gives it to rounding.
using BendContact =
    std::function<ContactPlace(Support support, ContactMotion motion, const ContactState<double>& from, double later)>;

/// What moves the bodies of a scene; both empty where flights are straight or in closed form.
struct BentPaths {
    BendFlight flight;
    BendContact contact;  ///< empty where contact is not followed either
};

}  // namespace swirl
