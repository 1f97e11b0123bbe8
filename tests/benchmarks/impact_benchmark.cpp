// Time per impact, in units of one libm sincos measured in the same process: a loop in which each argument depends on
// the last result. Goals: disk 5, hexagon 14, N = 1000 at most 1.5 times the hexagon; all with friction, to rounding.
#include "map/orbit/laboratory.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;

/// Seconds per dependent sincos; the best of a few runs, since other work only ever adds.
double sincos_seconds() {
    constexpr int count = 1'000'000;
    double best = 1;
    for (int run = 0; run < 5; ++run) {
        double x = 1.234;
        const auto begin = Clock::now();
        for (int i = 0; i < count; ++i) {
            double s = 0, c = 0;
            ::sincos(x, &s, &c);
            x = s + c + 1.5;
        }
        benchmark::DoNotOptimize(x);
        best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count() / count);
    }
    return best;
}

/// One impact per iteration along one orbit; counter `sincos` is the time per impact in units of a sincos.
void impact(benchmark::State& state, int sides, double alpha, double beta, double mu, double restitution) {
    const swirl::Scene<double> scene{
        sides, alpha, beta, mu, restitution, swirl::Law::poisson, swirl::uniform_inertia_factor<double>(sides)};
    const double unit = sincos_seconds();
    swirl::with_collision_map(scene, [&](const auto& map) {
        const auto start = swirl::flight_from(map.body(), swirl::LabStart<double>{beta, 0, 0.1, 0.2, 0.3, 0.1});
        auto collision = map.advance(start);
        const auto begin = Clock::now();
        for (auto _ : state) {
            map.advance(collision.after, collision);
            if (collision.outcome != swirl::FirstContactOutcome::contact) state.SkipWithError("the orbit ended");
        }
        benchmark::DoNotOptimize(collision);
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        state.counters["sincos"] = seconds / static_cast<double>(state.iterations()) / unit;
        state.counters["sincos_ns"] = unit * 1e9;
    });
}

}  // namespace

BENCHMARK_CAPTURE(impact, disk_steady, 0, 0.3, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, disk_small_swirl, 0, 0.3, 0.1, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, hexagon_steady, 6, 0.4, 0.5, 0.5, 0.9);
BENCHMARK_CAPTURE(impact, hexagon_chaotic, 6, 0.3, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, triangle_chaotic, 3, 0.4, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, thousand_steady, 1000, 0.4, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, thousand_small_swirl, 1000, 0.3, 0.1, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, million_steady, 1000000, 0.4, 0.5, 0.5, 1.0);

BENCHMARK_MAIN();
