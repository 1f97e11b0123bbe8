// How far an impact is from its reference, and how far it may be.
#pragma once

#include "map/orbit/laboratory.hpp"
#include "tests/references/references.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::tests {

/// Error ≤ max(relative × amplification, floor) at every impact whose amplification is at most `reach`.
struct Tolerance {
    double relative, floor, reach;
};

/// Largest error of one impact, in all that the reference has (times and angles as they are, unwound; ψ as an angle).
template <class T>
double error_of(const LabState<T>& state, const Collision<T>& collision, const nlohmann::json& row) {
    using std::fabs;
    double error = 0;
    const auto compare = [&](const T& value, const char* key) {
        error = std::max(error, static_cast<double>(fabs(T(value - number<T>(row[key])))));
    };
    compare(state.t, "t");
    compare(state.x, "x");
    compare(state.y, "y");
    compare(state.vx, "vx");
    compare(state.vy, "vy");
    compare(state.angle, "angle");
    compare(state.spin, "spin");
    compare(collision.impulse.normal, "normal_impulse");
    compare(collision.impulse.tangential, "tangential_impulse");
    const T psi = section_point(collision.after).psi - number<T>(row["psi"]);
    return std::max(error, static_cast<double>(fabs(wrapped_angle(psi))));
}

}  // namespace swirl::tests
