// One Fourier sum of a series at any frequency, for frequencies that are searched.
#pragma once

#include <complex>
#include <span>

namespace swirl::analysis::rotation_detail {

struct FourierSum {
    std::complex<double> value;  ///< A = Σ x_j e^{−2πi f j}
    std::complex<double> slope;  ///< Σ (j − n/2) x_j e^{−2πi f j}: i/2π dA/df up to a turn of the phase of A
};

/// e^{2πi turns}.
std::complex<double> unit_phasor(double turns);

/// A and its slope at `frequency` f, in turns a sample. Phasors are advanced by multiplication and set anew after 64
/// times, which adds some 64 ε to the rounding of f j. Eight samples go together, each with a phasor of its own; by
/// the widest vectors that the processor has, with the same bits. Cost: some 15 operations a sample.
FourierSum fourier_sum(std::span<const double> samples, double frequency);

}  // namespace swirl::analysis::rotation_detail
