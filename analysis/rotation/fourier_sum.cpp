#include "analysis/rotation/fourier_sum.hpp"

// Left out: vectors whose length is known at run time only, which can't be members of a struct, and the sets that have
// nothing for doubles beyond the one before them.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/rotation/fourier_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#ifndef SWIRL_FOURIER_SUM_ONCE
#define SWIRL_FOURIER_SUM_ONCE
namespace swirl::analysis::rotation_detail {

constexpr std::size_t together = 8;  // samples, each with a phasor of its own, so that none waits for another
constexpr std::size_t renewal = 64;  // turns of a phasor from one that is exact to the next

/// What each of them adds up, and its phasor and place j − n/2.
struct Partial {
    std::array<double, together> real{}, imaginary{}, real_slope{}, imaginary_slope{};
    std::array<double, together> cosine, sine, place;
};

}  // namespace swirl::analysis::rotation_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::rotation_detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, together>;
using Lanes = hn::Vec<Tag>;
constexpr Tag tag;
constexpr std::size_t width = hn::MaxLanes(Tag());

/// Some of the samples that go together.
struct Chain {
    Lanes real, imaginary, real_slope, imaginary_slope, cosine, sine, place;

    HWY_INLINE Chain(const Partial& p, std::size_t k)
        : real(hn::LoadU(tag, p.real.data() + k)),
          imaginary(hn::LoadU(tag, p.imaginary.data() + k)),
          real_slope(hn::LoadU(tag, p.real_slope.data() + k)),
          imaginary_slope(hn::LoadU(tag, p.imaginary_slope.data() + k)),
          cosine(hn::LoadU(tag, p.cosine.data() + k)),
          sine(hn::LoadU(tag, p.sine.data() + k)),
          place(hn::LoadU(tag, p.place.data() + k)) {}

    HWY_INLINE void add(const double* samples, Lanes step_real, Lanes step_imaginary) {
        const Lanes x = hn::LoadU(tag, samples);
        const Lanes along = hn::Mul(x, cosine), across = hn::Mul(x, sine);
        real = hn::Add(real, along);
        imaginary = hn::Add(imaginary, across);
        real_slope = hn::Add(real_slope, hn::Mul(place, along));
        imaginary_slope = hn::Add(imaginary_slope, hn::Mul(place, across));
        place = hn::Add(place, hn::Set(tag, static_cast<double>(together)));
        const Lanes turned = hn::Sub(hn::Mul(cosine, step_real), hn::Mul(sine, step_imaginary));
        sine = hn::Add(hn::Mul(cosine, step_imaginary), hn::Mul(sine, step_real));
        cosine = turned;
    }

    HWY_INLINE void keep(Partial& p, std::size_t k) const {
        hn::StoreU(real, tag, p.real.data() + k);
        hn::StoreU(imaginary, tag, p.imaginary.data() + k);
        hn::StoreU(real_slope, tag, p.real_slope.data() + k);
        hn::StoreU(imaginary_slope, tag, p.imaginary_slope.data() + k);
        hn::StoreU(cosine, tag, p.cosine.data() + k);
        hn::StoreU(sine, tag, p.sine.data() + k);
        hn::StoreU(place, tag, p.place.data() + k);
    }
};

/// Adds `steps` times eight samples.
void add_samples(const double* samples, std::size_t steps, std::complex<double> step, Partial& sums) {
    const Lanes step_real = hn::Set(tag, step.real()), step_imaginary = hn::Set(tag, step.imag());
    constexpr std::size_t second = 2 * width <= together ? width : 0;  // two vectors at a time where one is not all
    for (std::size_t k = 0; k < together; k += width + second) {
        Chain one(sums, k), other(sums, k + second);
        for (std::size_t j = 0; j < steps * together; j += together) {
            one.add(samples + j + k, step_real, step_imaginary);
            if constexpr (second > 0) other.add(samples + j + k + second, step_real, step_imaginary);
        }
        one.keep(sums, k);
        if constexpr (second > 0) other.keep(sums, k + second);
    }
}

}  // namespace swirl::analysis::rotation_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::rotation_detail {

HWY_EXPORT(add_samples);

namespace {

double sum_of(const std::array<double, together>& parts) {
    return Eigen::Map<const Eigen::Array<double, together, 1>>(parts.data()).sum();
}

void set_phasors(double frequency, std::size_t start, double middle, Partial& sums) {
    for (std::size_t k = 0; k < together; ++k) {
        const std::complex<double> phasor = unit_phasor(-frequency * static_cast<double>(start + k));
        sums.cosine[k] = phasor.real();
        sums.sine[k] = phasor.imag();
        sums.place[k] = static_cast<double>(k) + (static_cast<double>(start) - middle);
    }
}

}  // namespace

std::complex<double> unit_phasor(double turns) {
    return std::polar(1.0, 2 * std::numbers::pi * (turns - std::floor(turns)));
}

FourierSum fourier_sum(std::span<const double> samples, double frequency) {
    const std::complex<double> step = unit_phasor(-frequency * static_cast<double>(together));
    const std::size_t n = samples.size();
    Partial sums;
    for (std::size_t start = 0; start < n; start += renewal * together) {
        set_phasors(frequency, start, static_cast<double>(n) / 2, sums);
        const std::size_t steps = std::min(renewal, (n - start) / together);
        HWY_DYNAMIC_DISPATCH(add_samples)(samples.data() + start, steps, step, sums);
        const std::size_t done = start + steps * together;
        if (steps == renewal || done == n) continue;
        std::array<double, together> last{};  // 0 beyond the last
        std::copy(samples.begin() + static_cast<std::ptrdiff_t>(done), samples.end(), last.begin());
        HWY_DYNAMIC_DISPATCH(add_samples)(last.data(), 1, step, sums);
    }
    return {{sum_of(sums.real), sum_of(sums.imaginary)}, {sum_of(sums.real_slope), sum_of(sums.imaginary_slope)}};
}

}  // namespace swirl::analysis::rotation_detail
#endif
