// Proves that no vertex touches the wall on a flight before the one that ends it.
#pragma once

#include "map/proof/step_in_balls.hpp"

#include <string>

namespace swirl::proof {

struct Clearance {
    Verdict verdict = Verdict::undecided;
    std::string reason;  ///< empty if it is clear
    int pieces = 0;      ///< of time that were looked at
};

/// For every state of the box and every τ of the ball: all gaps are negative on (0, τ), but that of vertex 0, which
/// leaves at 0, and of `arriving`, which touches at τ (of the disk its one gap). Refuted where a gap is positive for
/// all of the box. Time is halved until each piece is clear: the circumscribed circle first, then those vertices that
/// the piece's directions allow.
///   most_pieces  of time, after which it is undecided
Clearance clear_flight(const BallScene& scene, const BallPoint<Ball>& z, const Ball& tau, int arriving,
                       int most_pieces = 100'000);

}  // namespace swirl::proof
