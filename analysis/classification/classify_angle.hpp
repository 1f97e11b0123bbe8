// Names the mode of a body whose angle a camera measured: S is its rate, and the noise is the angle's.
//
// Of the division of S in lines, a continuum and drift (angle_spectrum.hpp), in this order:
//   nothing but the rounding of a straight line      steady
//   drift more than half of all                      undecided, transient
//   neither lines nor continuum                      steady, S constant within noise and rounding; undecided if
//                                                    something is above what rounding leaves beside that noise
//   lines, continuum at most 0.5 % of both           quasi-steady (a cycle or a torus: periodic or not in time);
//                                                    undecided, transient, if one half alone is steady, or has less
//                                                    than a fifth of the variance of S in the other: lines die out
//   continuum at least 30 %, three blocks or more    chaotic
//   else                                             undecided
// A continuum is chaos because nothing else than the camera is random in a body that slides and strikes; a shaken
// container would look the same, and the evidence says so. Chaos whose continuum is below the noise is not seen. The
// 0.5 %: tori leave up to 2 % in a minute and less than 10⁻⁴ in ten, the weakest chaos tried (exponent 0.03 an impact)
// 1 % or more.
//
// A noise that is given is checked. Less than the level is not believed: the level counts. More than 1.5 times the
// level must give the verdict that the level gives, else it is undecided.
#pragma once

#include "analysis/classification/angle_spectrum.hpp"
#include "analysis/classification/classify_series.hpp"

#include <span>

namespace swirl::analysis {

/// The verdict; its mean is the slope. `options.noise` is the angle's. @throws as spectrum_of_angle
Classification classify_angle(std::span<const double> angle, double spacing, const ClassifySeriesOptions& options = {},
                              double resolution = 0);

}  // namespace swirl::analysis
