// The integral of a uniformly moving point's position over time, in the three frames of a swirl: what BinAverager needs
// to average the positions of free flights exactly.
#pragma once

#include <complex>
#include <string_view>

namespace swirl::analysis {

/// Positions are x + iy; the swirl is β e^{it} (rate 1).
enum class Frame {
    laboratory,  ///< z
    container,   ///< z − β e^{it}: axes parallel to the laboratory's, origin on the swirl
    corotating,  ///< z e^{−it}: origin at the swirl's centre, the swirl at rest at β
};
std::string_view name_of(Frame frame);
Frame frame_from_name(
    std::string_view word);  ///< "laboratory", "container", "corotating"; throws std::invalid_argument

/// z + v (t − t₀) for all t.
struct UniformMotion {
    std::complex<double> position;  ///< at `time`, laboratory frame
    std::complex<double> velocity;
    double time = 0;
};

/// Position at t as seen in `frame`, and ∫_a^b of it, exactly. `swirl_radius` β is used by the container's frame only.
std::complex<double> position_at(const UniformMotion& motion, double t, Frame frame, double swirl_radius);
std::complex<double> position_integral(const UniformMotion& motion, double a, double b, Frame frame,
                                       double swirl_radius);

}  // namespace swirl::analysis
