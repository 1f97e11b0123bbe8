#include "analysis/classification/tail.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "apps/lyapunov/lyapunov_command.hpp"
#include "apps/system/orbit_ending.hpp"
#include "apps/system/section_system.hpp"

#include <limits>
#include <numeric>

namespace swirl::apps::lyapunov {

namespace {

/// ∇J on the section, by central differences of the closed form (J is quadratic in the velocities, so they are exact
/// there; h = 10⁻⁵ leaves 10⁻¹⁰ in the angles).
template <class System>
typename System::State jacobi_gradient(const System& system, const typename System::State& z) {
    constexpr double h = 1e-5;
    typename System::State gradient;
    for (int i = 0; i < System::dimension; ++i) {
        auto up = z, down = z;
        up[i] += h;
        down[i] -= h;
        const auto& body = system.map().body();
        gradient[i] = (jacobi_of(body, post_impact_state(system.point_of(up))) -
                       jacobi_of(body, post_impact_state(system.point_of(down)))) /
                      (2 * h);
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
                          std::int64_t collisions) {
    return with_collision_map(scene, [&](const auto& map) {
        OrbitSpectrum result;
        result.jacobi_residual = std::numeric_limits<double>::quiet_NaN();
        SectionPoint<double> first{};
        result.outcome = ending_of(map, start, 1, first, result.impacts);
        analysis::LyapunovOptions options;
        options.transient = transient;
        options.steps = collisions;
        const SectionSystem system(map);
        if (result.impacts == 0) {
            result.spectrum = analysis::ExponentAccumulator(system.dimension, options)
                                  .finish(analysis::LyapunovOutcome::ended_in_transient);
            return result;
        }
        const auto z = system.state_of(first);
        result.spectrum = analysis::lyapunov_spectrum(system, z, options);
        if (result.spectrum.outcome == analysis::LyapunovOutcome::completed) {
            result.impacts += transient + collisions;
        } else {
            const auto tail = analysis::follow_tail(system, z, transient + collisions, 0);
            result.impacts += tail.steps;
            result.outcome = tail.ended ? ending_at(system, tail.end, result.impacts)
                                        : Outcome::unresolved;  // a derivative overflowed
        }
        if (result.spectrum.steps > 0) {
            for (std::size_t i = 0; i < result.spectrum.exponents.size(); ++i)
                result.signs.push_back(analysis::judge_sign(result.spectrum, i));
            result.exponents = better_means(result.spectrum);
            for (const double exponent : result.exponents)
                result.per_time.push_back(exponent * static_cast<double>(result.spectrum.steps) / result.spectrum.time);
            result.sum = std::accumulate(result.exponents.begin(), result.exponents.end(), 0.0);
        }
        if (scene.mu == 0 && scene.restitution == 1)
            result.jacobi_residual =
                analysis::gradient_invariance(
                    system, z, [&](const auto& state) { return jacobi_gradient(system, state); }, 100)
                    .largest_residual;
        return result;
    });
}

}  // namespace swirl::apps::lyapunov
