// What fits of films share beyond the impacts: which of these are fitted as one or left out, and what noise does.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "analysis/fits/free_arcs.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::studies {

/// Impacts as they are fitted.
struct FittedGroups {
    std::vector<analysis::AlikeImpacts> groups;
    std::size_t thinned = 0;  ///< impacts that are left out beyond `most_fitted_impacts`
    std::size_t alike = 0;    ///< impacts that are fitted as the means of alike ones
};

/// Alike ones as one (analysis::alike_impacts), or each alone where too few would be left; and of those that are like
/// no others at most `most_fitted_impacts`, kept evenly.
FittedGroups fitted_groups(std::span<const analysis::MeasuredImpact> impacts);

/// Adds so much of how `moved` differ from `impacts`, each the same of all three.
void add_share(std::vector<analysis::MeasuredImpact>& seen, double share,
               const std::vector<analysis::MeasuredImpact>& moved,
               const std::vector<analysis::MeasuredImpact>& impacts);

/// The film with as much noise again as was found in it, other noise for each draw.
///   covariance  FilmArcs::noise
std::vector<analysis::FilmFrame> with_more_noise(std::span<const analysis::FilmFrame> frames,
                                                 const Eigen::Matrix3d& covariance, std::uint64_t seed,
                                                 std::size_t draw);

/// Mean shift of e and μ.
struct NoiseShift {
    double restitution = 0, friction = 0;
};

/// Makes the intervals of a fit longer by what noise does beyond scatter, as the fits of noisier films show it: by the
/// mean shift, towards where it came from (SIMEX: Cook & Stefanski, J. Am. Stat. Assoc. 89 (1994) 1314), and so that
/// they hold a μ of another minimum.
NoiseShift add_noise_shift(analysis::ImpactFit& fit, std::span<const analysis::ImpactFit> noisier);

}  // namespace swirl::studies
