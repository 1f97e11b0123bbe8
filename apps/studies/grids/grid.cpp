#include "apps/studies/grids/grid.hpp"

#include "analysis/random_draws.hpp"

#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <memory>
#include <new>
#include <numeric>
#include <utility>

namespace swirl::studies::grids {

std::size_t cell_count(const std::vector<GridAxis>& grid) {
    if (grid.front().sampled) return grid.front().points.size();
    std::size_t count = 1;
    for (const auto& axis : grid) count *= axis.points.size();
    return count;
}

std::vector<double> cell_point(const std::vector<GridAxis>& grid, std::size_t cell) {
    std::vector<double> point(grid.size());
    for (std::size_t k = grid.size(); k-- > 0;) {
        if (grid[k].sampled) {
            point[k] = grid[k].points[cell];
            continue;
        }
        point[k] = grid[k].points[cell % grid[k].points.size()];
        cell /= grid[k].points.size();
    }
    return point;
}

bool has_axis(const std::vector<GridAxis>& grid, const std::string& name) {
    return std::any_of(grid.begin(), grid.end(), [&](const GridAxis& axis) { return axis.name == name; });
}

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
