#include "apps/studies/exponents/orbit_spectrum.hpp"

#include "analysis/classification/tail.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"

#include <cstddef>
#include <limits>
#include <numeric>

namespace swirl::studies {

namespace {

/// ∇J on the section, by central differences of the closed form (J is quadratic in the velocities, so they are exact
/// there; h = 10⁻⁵ leaves 10⁻¹⁰ in the angles).
template <int D>
analysis::Vector<D> jacobi_gradient(const SceneMap<D>& map, const PostImpactState<double>& state) {
    constexpr double h = 1e-5;
    const analysis::Vector<D> z = map.coordinates(state);
    analysis::Vector<D> gradient;
    for (int i = 0; i < D; ++i) {
        analysis::Vector<D> up = z, down = z;
        up[i] += h;
        down[i] -= h;
        gradient[i] = (jacobi_of(map.body(), map.state_at(up)) - jacobi_of(map.body(), map.state_at(down))) / (2 * h);
    }
    return gradient;
}

std::vector<double> better_means(const analysis::LyapunovSpectrum& spectrum) {
    std::vector<double> means = spectrum.exponents;
    for (std::size_t i = 0; i < means.size(); ++i)
        if (spectrum.weighted_half_difference[i] <= regular_agreement) means[i] = spectrum.weighted_exponents[i];
    return means;
}

}  // namespace

OrbitSpectrum spectrum_of(const Scene<double>& scene, const Start<double>& start, std::int64_t transient,
                          std::int64_t collisions, Accuracy accuracy) {
    const auto measure = [&](const auto& map) {
        OrbitSpectrum result;
        result.jacobi_residual = std::numeric_limits<double>::quiet_NaN();
        const OrbitBegin begin = begin_orbit(map, start);
        result.outcome = begin.outcome;
        result.impacts = begin.impacts;
        analysis::LyapunovOptions options;
        options.transient = transient;
        options.steps = collisions;
        result.before = begin.impacts + transient;
        if (begin.outcome != Outcome::completed) {
            result.spectrum = analysis::ExponentAccumulator(map.dimension, options)
                                  .finish(analysis::LyapunovOutcome::ended_in_transient);
            return result;
        }
        result.spectrum = analysis::lyapunov_spectrum(map, begin.state, options);
        if (result.spectrum.outcome == analysis::LyapunovOutcome::completed) {
            result.impacts += transient + collisions;
        } else {
            const auto tail = analysis::follow_tail(map, begin.state, transient + collisions, 0);
            result.impacts += tail.steps;
            result.outcome =
                tail.ended ? ending_at(map, tail.end, result.impacts) : Outcome::unresolved;  // a derivative overflowed
        }
        if (result.spectrum.steps > 0) {
            for (std::size_t i = 0; i < result.spectrum.exponents.size(); ++i)
                result.signs.push_back(analysis::judge_sign(result.spectrum, i));
            result.exponents = better_means(result.spectrum);
            for (const double exponent : result.exponents)
                result.per_time.push_back(exponent * static_cast<double>(result.spectrum.steps) / result.spectrum.time);
            result.sum = std::accumulate(result.exponents.begin(), result.exponents.end(), 0.0);
        }
        if (scene.mu == 0 && scene.restitution == 1 && !scene.acts_in_flight())
            result.jacobi_residual =
                analysis::gradient_invariance(
                    map, begin.state, [&](const auto& state) { return jacobi_gradient(map, state); }, 100)
                    .largest_residual;
        return result;
    };
    return with_scene_map(scene, measure, contact_horizon, accuracy);
}

}  // namespace swirl::studies
