#include "apps/studies/grids/sample.hpp"

#include "analysis/random_draws.hpp"

#include <gsl/gsl_qrng.h>

#include <memory>
#include <new>
#include <numeric>
#include <utility>

namespace swirl::studies::grids {

namespace {

constexpr std::uint64_t latin_hypercube = 0x6c6174696e;  // another stream than the starts'

std::vector<std::vector<double>> sobol_points(std::size_t count, std::size_t axes) {
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(axes)), &gsl_qrng_free);
    if (!sequence) throw std::bad_alloc();
    std::vector<std::vector<double>> points(axes, std::vector<double>(count));
    std::vector<double> point(axes);
    for (std::size_t i = 0; i < count; ++i) {
        gsl_qrng_get(sequence.get(), point.data());
        for (std::size_t k = 0; k < axes; ++k) points[k][i] = point[k];
    }
    return points;
}

std::vector<std::vector<double>> latin_points(std::size_t count, std::size_t axes, std::uint64_t seed) {
    std::vector<std::vector<double>> points(axes, std::vector<double>(count));
    for (std::size_t k = 0; k < axes; ++k) {
        std::vector<std::size_t> slice(count);
        std::iota(slice.begin(), slice.end(), std::size_t{0});
        for (std::size_t i = count; i-- > 0;) {
            const auto bits = analysis::random_bits({i, k, 0, latin_hypercube}, {seed, 0});
            std::swap(slice[i], slice[bits[0] % (i + 1)]);     // not even by 10⁶/2⁶⁴
            points[k][i] = 1 - analysis::uniform_of(bits[1]);  // (0, 1] to [0, 1)
        }
        for (std::size_t i = 0; i < count; ++i)
            points[k][i] = (static_cast<double>(slice[i]) + points[k][i]) / static_cast<double>(count);
    }
    return points;
}

}  // namespace

std::vector<std::vector<double>> unit_points(const Sample& sample, std::size_t axes, std::uint64_t seed) {
    return sample.kind == Sample::Kind::sobol ? sobol_points(sample.count, axes)
                                              : latin_points(sample.count, axes, seed);
}

}  // namespace swirl::studies::grids
