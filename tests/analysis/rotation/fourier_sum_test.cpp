// The Fourier sum by vectors has the bits of the same operations one after the other, and is the sum.
#include "analysis/rotation/fourier_sum.hpp"
#include "tests/analysis/only_targets.hpp"

#include <gtest/gtest.h>
#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace swirl::analysis {
namespace {

using rotation_detail::FourierSum, rotation_detail::fourier_sum, rotation_detail::unit_phasor;
using Complex = std::complex<double>;

std::vector<double> random_samples(std::size_t n) {
    std::mt19937_64 random(n);
    std::normal_distribution<double> normal;
    std::vector<double> samples(n);
    for (double& x : samples) x = normal(random);
    return samples;
}

/// Eight partial sums, sample by sample.
FourierSum one_after_the_other(const std::vector<double>& samples, double frequency) {
    const Complex step = unit_phasor(-frequency * 8);
    const std::size_t n = samples.size();
    Eigen::Array<double, 8, 1> real, imaginary, real_slope, imaginary_slope;
    for (Eigen::Index k = 0; k < 8; ++k) {
        real[k] = imaginary[k] = real_slope[k] = imaginary_slope[k] = 0;
        Complex phasor;
        for (std::size_t j = static_cast<std::size_t>(k), turns = 0; j < n; j += 8, ++turns) {
            if (turns % 64 == 0) phasor = unit_phasor(-frequency * static_cast<double>(j));
            const double place = static_cast<double>(j) - static_cast<double>(n) / 2;
            const double along = samples[j] * phasor.real(), across = samples[j] * phasor.imag();
            real[k] += along;
            imaginary[k] += across;
            real_slope[k] += place * along;
            imaginary_slope[k] += place * across;
            phasor = {phasor.real() * step.real() - phasor.imag() * step.imag(),
                      phasor.real() * step.imag() + phasor.imag() * step.real()};
        }
    }
    return {{real.sum(), imaginary.sum()}, {real_slope.sum(), imaginary_slope.sum()}};
}

TEST(FourierSum, HasTheBitsOfOneSampleAfterTheOtherOnEveryInstructionSet) {
    for (const std::size_t n : {0, 1, 7, 8, 9, 511, 512, 513, 1000, 1031, 10'000})
        for (const double frequency : {0.0, 0.1234567, 0.25, 0.4999, 0.5}) {
            const auto samples = random_samples(n);
            const FourierSum plain = one_after_the_other(samples, frequency);
            for (const std::int64_t target : tests::all_targets()) {
                const tests::OnlyTargets only(target);
                const FourierSum found = fourier_sum(samples, frequency);
                EXPECT_EQ(found.value, plain.value) << n << " samples, f = " << frequency << hwy::TargetName(target);
                EXPECT_EQ(found.slope, plain.slope) << n << " samples, f = " << frequency << hwy::TargetName(target);
            }
        }
}

TEST(FourierSum, AndItsSlopeAreTheSums) {
    constexpr std::size_t n = 1000;
    const auto samples = random_samples(n);
    for (const double frequency : {0.0, 0.1234567, 0.31, 0.5}) {
        std::complex<long double> sum = 0, slope = 0;
        for (std::size_t j = 0; j < n; ++j) {
            const auto place = static_cast<long double>(j);
            const auto turned = std::polar(1.0L, -2 * std::numbers::pi_v<long double> * frequency * place);
            sum += static_cast<long double>(samples[j]) * turned;
            slope += (place - 0.5L * n) * static_cast<long double>(samples[j]) * turned;
        }
        // 64 ε of the phasors, and the argument's rounding, 2π f n ε, of each of n terms.
        const double bound = (64 + 2 * std::numbers::pi * 500) * 0x1p-53 * n;
        const FourierSum found = fourier_sum(samples, frequency);
        EXPECT_LE(std::abs(found.value - static_cast<Complex>(sum)), bound);
        EXPECT_LE(std::abs(found.slope - static_cast<Complex>(slope)), 0.5 * bound * n);
    }
}

}  // namespace
}  // namespace swirl::analysis
