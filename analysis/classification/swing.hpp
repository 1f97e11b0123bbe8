// How an angle that obeys an autonomous equation goes on: at rest, swinging, turning, or none of these yet.
#pragma once

#include <string_view>
#include <vector>

namespace swirl::analysis {

/// Samples along a motion, in the order of time.
struct SwingSample {
    double time = 0;
    double angle = 0;     ///< unwound, radians
    double rate = 0;      ///< its derivative
    double rotation = 0;  ///< S
    double turned = 0;    ///< the integral of S
};

enum class SwingKind { at_rest, librating, circulating, irregular };

struct Swing {
    SwingKind kind = SwingKind::irregular;
    double mean = 0;           ///< time mean of S over whole periods (at rest and irregular: over all samples)
    double range = 0;          ///< largest less smallest S
    double period = 0;         ///< time from crossing to crossing, 0 if there is none
    double period_spread = 0;  ///< largest relative difference of the periods
    int periods = 0;
    double settling_exponent = 0;  ///< of the periods' changes where they differ by more than the tolerance
    double still_to_come = 0;      ///< their change to come, relative; infinite if they come to no limit
};

/// Judges samples of one motion. Crossings of the middle of the swing (upwards), or of whole turns, are found on cubic
/// Hermite interpolants; the motion is periodic if at least three periods agree to `tolerance`, or if their changes
/// fall so that they come to a limit (settling_of) that is nearer than `nearly`.
///   samples  the second half of what was followed
///   rest     an angle and S that stay within this are at rest, radians and units of S
Swing judge_swing(const std::vector<SwingSample>& samples, double rest = 1e-7, double tolerance = 1e-5,
                  double nearly = 1e-2);

}  // namespace swirl::analysis
