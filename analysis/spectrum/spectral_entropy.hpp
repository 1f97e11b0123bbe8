// How evenly a spectrum's power is spread.
#pragma once

#include "analysis/spectrum/power_spectrum.hpp"

namespace swirl::analysis {

/// −Σ p ln p / ln m with p = power/Σ power over the m frequencies other than 0: 0 for one line, 1 for white. NaN if
/// there is no power.
double spectral_entropy(const PowerSpectrum& spectrum);

}  // namespace swirl::analysis
