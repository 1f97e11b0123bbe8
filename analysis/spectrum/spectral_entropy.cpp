#include "analysis/spectrum/spectral_entropy.hpp"

#include "analysis/special_values.hpp"

#include <cmath>
#include <cstddef>

namespace swirl::analysis {

double spectral_entropy(const PowerSpectrum& spectrum) {
    double total = 0;
    double count = 0;
    for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
        if (spectrum.frequency[k] == 0) continue;
        total += spectrum.power[k];
        count += 1;
    }
    if (!(total > 0)) return nan;
    double entropy = 0;
    for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
        const double share = spectrum.power[k] / total;
        if (spectrum.frequency[k] != 0 && share > 0) entropy -= share * std::log(share);
    }
    return entropy / std::log(count);
}

}  // namespace swirl::analysis
