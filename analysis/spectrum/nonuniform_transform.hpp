// The Fourier transform of samples at any times, by a fine even grid and FFTW.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

/// F_k = Σ_j x_j e^{−2πi k step (t_j − start)}, k = 0 … count.
///   times   finite, any order;   values   as many
///   step    of the frequencies, > 0, in cycles per unit of time
/// Each sample is spread over 16 points of an even grid of twice as many points as the frequencies need, with the
/// kernel exp(β (√(1 − z²) − 1)), whose transform is divided out: right to 10⁻¹² Σ|x_j|, but for what rounding t_j step
/// loses of a phase. O(16 n + count log count). Source: Barnett, Magland, af Klinteberg, SIAM J. Sci. Comput. 41 (2019)
/// C479.
std::vector<std::complex<double>> nonuniform_transform(std::span<const double> times, std::span<const double> values,
                                                       double start, double step, std::size_t count);

}  // namespace swirl::analysis
