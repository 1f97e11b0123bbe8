// A flight in interval arithmetic, from the very doubles that the search was given: what it does between them and its
// contact is enclosed, with nothing of the search in it (no tables, no neighbours, no bounds of its own).
//
// Exactly: X(t) = X₀ + Vt − w₀E(t), a_k(t) = a₀ cis(2πk/N) cis(St), E(t) = cis t − 1, w₀ = β·phase. The vertex that has
// just struck is at (1, 0) + (what it has moved), the others at X + a_k; all those numbers are the flight's doubles.
#pragma once

#include "map/intervals/ball_vec.hpp"
#include "map/model/flight.hpp"

#include <map>
#include <optional>
#include <vector>

namespace swirl::tests {

using intervals::Ball;
using intervals::BallVec;

class FlightInBalls {
public:
    FlightInBalls(const Scene<double>& scene, const Flight<double>& flight);

    int sides() const { return sides_; }
    bool begins_on_the_wall() const { return struck_; }

    /// The flight at a moment, or over a piece of time.
    struct Moment {
        BallVec moved;  ///< X − X₀
        BallVec swirl;  ///< w = X″
        BallVec drift;  ///< X′
        BallVec spun;   ///< cis St
    };
    Moment at(const Ball& time) const;
    /// Over [from, to], by the mean value theorem from what is known at `middle` there.
    Moment over(double from, double to, double middle, const Moment& at_middle) const;

    /// Where vertex k (the disk's centre) is.
    BallVec place(const Moment& moment, int k) const;

    /// g of vertex k (of the disk) with g′ and g″.
    struct Gap {
        Ball value, rate, curvature;
    };
    Gap gap(const Moment& moment, int k) const;

    /// True if vertex k (the disk) cannot touch within `half` of a moment: no point is faster than |V| + β + α|S|.
    bool is_far_inside(const Moment& middle, int k, double half) const;
    /// True if none can: the circumscribed circle is inside.
    bool all_far_inside(const Moment& middle, double half) const;
    /// The vertices that are not far inside, and perhaps more; nothing if they are more than `most`.
    std::optional<std::vector<int>> perhaps_at_wall(double middle_time, const Moment& middle, double half,
                                                    int most) const;

    /// The most that a point can have moved, (|V| + α|S| + β) t; rounding is relative to 1 + that.
    double way(double time) const { return fastest_ * time; }

private:
    const BallVec& arm_of(int k) const;

    int sides_;
    bool struck_;
    double alpha_, spin_double_, fastest_ = 0, centre_fastest_ = 0, arm_angle_ = 0;
    Ball spin_, reach_;  ///< the distance at which it touches: 1, or the disk's 1 − α
    BallVec centre_, velocity_, swirl_;
    mutable std::map<int, BallVec> arms_;  ///< a_k at the start
};

}  // namespace swirl::tests
