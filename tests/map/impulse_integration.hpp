// The impulse of an impact by integrating dC, du_t in p, in long double: the reference for the closed forms.
//
// Along p all rates are constant until u_t or C passes zero or restitution ends, so that steps from event to
// event are exact. What happens is decided from the state alone: no modes, no closed form of any end.
#pragma once

#include "map/model/impact.hpp"

#include <cmath>
#include <limits>

namespace swirl::tests {

struct IntegratedImpulse {
    long double p = 0, q = 0;
    long double normal_work = 0;      ///< ∫ C dp
    long double tangential_work = 0;  ///< ∫ u_t dq
    int kinks = 0;                    ///< times that slip stopped
    bool kink_in_compression = false;
    bool sticks = false;
};

/// Integrates one impact. Ends: restitution ends, as C rises at a positive rate after the last kink.
inline IntegratedImpulse integrate_impulse(const ContactKinematics<double>& approach, double mu, double e, Law law) {
    using Real = long double;
    const Real inertia = approach.inertia, rn = approach.rn, rt = approach.rt;
    const Real b1 = 1 + rn * rn / inertia, b2 = 1 + rt * rt / inertia, b3 = rn * rt / inertia;
    constexpr Real never = std::numeric_limits<Real>::infinity();
    const Real start = -static_cast<Real>(approach.un);
    Real c = start, ut = approach.ut, compression = 0, restitution = 0, p_end = never;
    bool restoring = false, stopped = ut == 0;
    IntegratedImpulse result;
    for (int step = 0; step < 10; ++step) {
        // The friction cone: once slip has stopped it holds while |B₃| ≤ μB₁, and yields the way B₃ pulls, for good.
        Real rate;
        if (!stopped)
            rate = ut > 0 ? -Real(mu) : Real(mu);
        else if (std::fabs(b3) <= mu * b1)
            rate = -b3 / b1;
        else
            rate = b3 > 0 ? -Real(mu) : Real(mu);
        const bool held = stopped && std::fabs(b3) <= mu * b1;
        const Real dc = b2 + b3 * rate;
        const Real du = held ? 0 : b3 + b1 * rate;

        Real length = never;
        enum { none, slip_stops, compression_ends, restitution_ends } event = none;
        const auto offer = [&](Real at, auto what) {
            if (at < length) length = at, event = what;
        };
        if (!stopped && ut * du < 0) offer(-ut / du, slip_stops);
        if (!restoring && dc > 0) offer(-c / dc, compression_ends);
        if (restoring) {
            if (law == Law::poisson) offer(p_end - result.p, restitution_ends);
            if (law == Law::newton && dc > 0) offer((-Real(e) * start - c) / dc, restitution_ends);
            if (law == Law::stronge) {  // c s + ½ dc s² = e² W_c − W_r
                const Real missing = Real(e) * e * compression - restitution;
                const Real root = std::sqrt(c * c + 2 * dc * missing);
                offer(missing <= 0 ? Real(0) : 2 * missing / (c + root), restitution_ends);
            }
        }
        const Real s = length;
        const Real work = c * s + dc * s * s / 2;
        (restoring ? restitution : compression) += restoring ? work : -work;
        result.normal_work += work;
        result.tangential_work += rate * (ut * s + du * s * s / 2);
        result.p += s;
        result.q += rate * s;
        c += dc * s;
        ut += du * s;
        if (event == slip_stops) {
            ut = 0;
            stopped = true;
            ++result.kinks;
            result.kink_in_compression = !restoring;
            result.sticks = std::fabs(b3) <= mu * b1;
        } else if (event == compression_ends) {
            c = 0;
            restoring = true;
            p_end = (1 + Real(e)) * result.p;
        } else {
            if (event == none) result.p = std::numeric_limits<Real>::quiet_NaN();
            return result;
        }
    }
    result.p = std::numeric_limits<Real>::quiet_NaN();
    return result;
}

}  // namespace swirl::tests
