// A flight over a range of parameters, looked at again: in axes along the swirl's arm at the start.
#pragma once

#include "map/intervals/sloped.hpp"
#include "map/proof_check/impact_equations.hpp"

#include <cstddef>
#include <vector>

namespace swirl::proof_check {

/// The state after an impact.
template <class S>
struct MotionStart {
    S psi, chi, vn, vt, spin;
};

/// A vertex from the container's centre; of a disk its centre, in units of 1 − α.
template <class S>
struct VertexPlace {
    S x, y, rate_x, rate_y;

    S beyond() const { return square(x) + square(y) - S(1); }  ///< |x|² − 1
    S rises() const { return x * rate_x + y * rate_y; }
};

template <class S>
class CellMotion {
public:
    CellMotion(const SceneOver<S>& scene, const MotionStart<S>& z, const S& tau) : scene_(scene), z_(z), tau_(tau) {
        const auto n = sine_cosine(z.psi), r = sine_cosine(z.psi + z.chi);
        x_ = scene.beta + n.cosine - scene.alpha * r.cosine;
        y_ = n.sine - scene.alpha * r.sine;
        vx_ = n.cosine * z.vn - n.sine * z.vt;
        vy_ = n.sine * z.vn + n.cosine * z.vt;
    }
    /// All vertices after a share of the flight's time.
    std::vector<VertexPlace<S>> at(const S& share) const {
        const S t = share * tau_;
        const auto arm = sine_cosine(t), body = sine_cosine(z_.psi + z_.chi + z_.spin * t),
                   next = sine_cosine(scene_.spacing);
        const S x = x_ + vx_ * t - scene_.beta * arm.cosine, y = y_ + vy_ * t - scene_.beta * arm.sine;
        const S vx = vx_ + scene_.beta * arm.sine, vy = vy_ - scene_.beta * arm.cosine;
        S ax = scene_.alpha * body.cosine, ay = scene_.alpha * body.sine;
        std::vector<VertexPlace<S>> places;
        if (scene_.disk()) {
            const S unit = S(1) / (S(1) - scene_.alpha);
            return {{unit * x, unit * y, unit * vx, unit * vy}};
        }
        for (int k = 0; k < scene_.sides; ++k) {
            places.push_back({x + ax, y + ay, vx - z_.spin * ay, vy + z_.spin * ax});
            const S turned = ax * next.cosine - ay * next.sine;
            ay = ax * next.sine + ay * next.cosine;
            ax = turned;
        }
        return places;
    }

private:
    const SceneOver<S>& scene_;
    MotionStart<S> z_;
    S tau_, x_, y_, vx_, vy_;
};

/// At one of some moments, the same for all parameters, a vertex is outside.
template <class S>
bool is_outside_at_a_moment(const SceneOver<S>& scene, const MotionStart<S>& z, const S& tau, long j) {
    const CellMotion<S> motion(scene, z, tau);
    const long arriving = ((j % scene.sides) + scene.sides) % scene.sides;
    for (const double share : {0.0, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 1.0}) {
        const auto places = motion.at(S(share));
        for (long k = 0; k < scene.sides; ++k) {
            const bool on_wall = (share == 0 && k == 0) || (share == 1 && k == arriving);
            if (!on_wall && is_positive(places[static_cast<std::size_t>(k)].beyond())) return true;
        }
    }
    return false;
}

using Timed = intervals::Sloped<3>;  ///< by both parameters and the share of the flight's time

enum class FlightSight { clear, outside, unclear };
///   shortest  piece of time, as a share of the flight;   most  pieces that are looked at
FlightSight sight_of_flight(const SceneOver<Timed>& scene, const MotionStart<Timed>& z, const Timed& tau, long j,
                            double shortest = 0x1p-9, int most = 200);

}  // namespace swirl::proof_check
