// Discrete Fourier transforms by FFTW: one plan, one pair of buffers, made once and used for many transforms.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace swirl::analysis {

/// X_k = Σ_j x_j e^{−2πi jk/n}, not normalised, of n real or complex samples.
///   Sample = double                 k = 0 … ⌊n/2⌋
///   Sample = std::complex<double>   k = 0 … n − 1; k > n/2 are the negative frequencies k − n
/// Plans use FFTW_ESTIMATE, so that the same input gives the same bits in every run. One object serves one thread at a
/// time; objects may be made and destroyed in several threads at once (the planner is guarded here; other code of the
/// process that plans with FFTW itself is not). Cost O(n log n) for every n ≥ 1.
template <class Sample>
class Fft {
public:
    explicit Fft(std::size_t length);  ///< throws std::invalid_argument unless 1 ≤ length ≤ 2³¹ − 1
    ~Fft();
    Fft(Fft&&) noexcept;
    Fft& operator=(Fft&&) noexcept;

    std::size_t length() const;
    std::span<Sample> input();                          ///< n samples, to be filled by the caller; kept by transform()
    std::span<const std::complex<double>> transform();  ///< of what input() holds; valid until the next call

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

extern template class Fft<double>;
extern template class Fft<std::complex<double>>;

using RealFft = Fft<double>;
using ComplexFft = Fft<std::complex<double>>;

}  // namespace swirl::analysis
