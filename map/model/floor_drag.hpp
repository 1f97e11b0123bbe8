// A viscous floor: force −γ(V − V_f) and torque −γ_r I S on a body in flight. map/dragged/README.md, "Flight".
#pragma once

#include "map/model/scene.hpp"
#include "map/numbers/vec2.hpp"

#include <cmath>
#include <limits>

namespace swirl {

/// What a flight needs to know of its floor.
template <class T>
struct FloorDrag {
    T drag{};                      ///< γ
    T spin_drag{};                 ///< γ_r
    Vec2<T> response{T(1), T(0)};  ///< h = 1/(1 − iγ) of a dish, 1 of a table: X goes along −h w
    Vec2<T> carrying{T(0), T(0)};  ///< γh of a dish, 0 of a table: V goes along γh w

    bool drags() const { return drag != T(0) || spin_drag != T(0); }
};

template <class T>
FloorDrag<T> floor_drag(const Scene<T>& scene) {
    FloorDrag<T> floor;
    floor.drag = scene.drag;
    floor.spin_drag = scene.turning_drag();
    if (scene.floor == Floor::table) return floor;
    const T square = T(1) + scene.drag * scene.drag;
    floor.response = {T(1) / square, scene.drag / square};
    floor.carrying = scene.drag * floor.response;
    return floor;
}

/// D(τ) = ∫₀^τ e^{−γs} ds = (1 − e^{−γτ})/γ to a few ε of itself, τ where γ = 0.
template <class T>
inline T decayed_time(const T& rate, const T& time) {
    using std::expm1;
    if (!(rate > T(0))) return time;
    return -expm1(T(-rate * time)) / rate;
}

/// The time at which D is `decayed`; +∞ where D never comes so far.
template <class T>
inline T time_decayed(const T& rate, const T& decayed) {
    using std::log1p;
    if (!(rate > T(0))) return decayed;
    const T left = rate * decayed;
    return left < T(1) ? T(-log1p(T(-left)) / rate) : std::numeric_limits<T>::infinity();
}

}  // namespace swirl
