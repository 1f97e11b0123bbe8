// A flight over a range of parameters: does another vertex touch earlier? (Or, of a disk, the disk itself.)
#pragma once

#include "map/intervals/sloped.hpp"
#include "map/proof/step_in_balls.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace swirl::proof {

/// A flight in the axes of the impact that began it. Time is counted in shares of τ, so that it ends at 1 for every
/// parameter.
template <class S>
class CellFlight {
public:
    CellFlight(const SceneIn<S>& scene, const BallPoint<S>& z, const S& tau) : scene_(scene), z_(z), tau_(tau) {
        const auto chi = sine_cosine(z.chi), psi = sine_cosine(z.psi);
        x_ = S(1) - scene.alpha * chi.cosine + scene.beta * psi.cosine;
        y_ = -(scene.alpha * chi.sine + scene.beta * psi.sine);
        reach2_ = scene.is_disk() ? square(S(1) - scene.alpha) : S(1);
        for (int k = 0; k < vertices(); ++k) {
            const auto turn = sine_cosine(scene.spacing * S(k));
            turns_.push_back({turn.cosine, turn.sine});
        }
    }
    /// Of a disk the centre stands for its one vertex, in a circle of radius 1 − α.
    int vertices() const { return scene_.is_disk() ? 1 : scene_.sides; }
    struct Moment {
        S x, y, vx, vy;        ///< the centre from the container's, and its velocity in the container
        S offset_x, offset_y;  ///< of vertex 0 from the centre
    };
    Moment at(const S& share) const {
        const S t = share * tau_;
        const auto arm = sine_cosine(t - z_.psi), body = sine_cosine(z_.chi + z_.spin * t);
        return {x_ + t * z_.vn - scene_.beta * arm.cosine,
                y_ + t * z_.vt - scene_.beta * arm.sine,
                z_.vn + scene_.beta * arm.sine,
                z_.vt - scene_.beta * arm.cosine,
                scene_.alpha * body.cosine,
                scene_.alpha * body.sine};
    }
    /// The gap |x|² − 1 of vertex k (of a disk |x|² − (1 − α)²), and half its rate.
    struct Gap {
        S value, rate;
    };
    Gap gap(const Moment& m, int k) const {
        if (scene_.is_disk()) return {square(m.x) + square(m.y) - reach2_, m.x * m.vx + m.y * m.vy};
        const Vec& turn = turns_[static_cast<std::size_t>(k)];
        const S along = turn.x * m.offset_x - turn.y * m.offset_y, across = turn.x * m.offset_y + turn.y * m.offset_x;
        const S x = m.x + along, y = m.y + across;
        return {square(x) + square(y) - reach2_, x * (m.vx - z_.spin * across) + y * (m.vy + z_.spin * along)};
    }
    /// No vertex reaches the wall.
    bool is_far_inside(const Moment& m) const {
        return !scene_.is_disk() && is_negative(square(m.x) + square(m.y) - square(S(1) - scene_.alpha));
    }

private:
    struct Vec {
        S x, y;
    };
    const SceneIn<S>& scene_;
    const BallPoint<S>& z_;
    S tau_, x_, y_, reach2_;
    std::vector<Vec> turns_;
};

/// True if at some moment of the flight, the same for all parameters, a vertex is outside.
template <class S>
bool is_met_at_a_moment(const SceneIn<S>& scene, const BallPoint<S>& z, const S& tau, long j) {
    const CellFlight<S> flight(scene, z, tau);
    const int arriving = static_cast<int>(((j % scene.sides) + scene.sides) % scene.sides);
    constexpr int moments = 8;
    for (int i = 0; i <= moments; ++i) {
        const auto moment = flight.at(S(static_cast<double>(i) / moments));
        for (int k = 0; k < scene.sides; ++k) {
            if ((i == 0 && k == 0) || (i == moments && k == arriving)) continue;  // on the wall, by the equations
            if (is_positive(flight.gap(moment, k).value)) return true;
        }
    }
    return false;
}

/// Both parameters, then the share of the flight's time.
using Timed = intervals::Sloped<3>;

/// How far time is halved.
struct TimePieces {
    double shortest = 0x1p-9;  ///< as a share of the flight
    int most = 120;            ///< that are looked at
};

/// Proven: no vertex touches between the flight's ends, whatever the parameters; refuted: one is outside at a moment.
/// Cost: some ten pieces of time, each with all vertices.
Verdict clear_over_cell(const SceneIn<Timed>& scene, const BallPoint<Timed>& z, const Timed& tau, long j,
                        const TimePieces& pieces = {});

}  // namespace swirl::proof
