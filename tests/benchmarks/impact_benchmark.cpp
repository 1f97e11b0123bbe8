// Time per impact, in units of one libm sincos measured in the same process: a loop in which each argument depends on
// the last result. Goals: disk 5, hexagon 14, N = 1000 at most 1.5 times the hexagon; all with friction, to rounding.
// Of a batch (AVX2): disk 3, hexagon 9, with all that its lanes leave to the scalar code.
#include "map/batch/orbit_batch.hpp"
#include "map/orbit/laboratory.hpp"

#include <hwy/targets.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

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

/// Times impacts of 64 orbits in a batch; counters: `sincos` per impact, the share of impacts that left the lanes and
/// the share of lanes in use.
///   set  the instruction set, 0: the best of this processor
void batch(benchmark::State& state, int sides, double alpha, double beta, double mu, double restitution,
           std::int64_t set = 0) {
    constexpr long long impacts = 1000;  // of each orbit in an iteration
    const swirl::Scene<double> scene{
        sides, alpha, beta, mu, restitution, swirl::Law::poisson, swirl::uniform_inertia_factor<double>(sides)};
    if (set != 0 && !(hwy::SupportedTargets() & set)) return state.SkipWithError("not on this processor");
    hwy::SetSupportedTargetsForTest(set);
    const double unit = sincos_seconds();
    swirl::with_collision_map(scene, [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        const swirl::ReturnMap<Map> return_map(map);
        std::vector<swirl::BatchedOrbit<Map>> starts;
        for (int k = 0; k < 64; ++k) {
            const swirl::LabStart<double> start{beta, 0, 0.1 + 0.001 * k, 0.2, 0.3, 0.1};
            starts.push_back({&return_map, map.advance(swirl::flight_from(map.body(), start)).after});
        }
        auto orbits = starts;
        swirl::BatchUse all;
        const auto begin = Clock::now();
        for (auto _ : state) {
            for (std::size_t i = 0; i < orbits.size(); ++i) {
                if (orbits[i].outcome != swirl::Outcome::completed) orbits[i] = starts[i];
                orbits[i].wanted = orbits[i].done + impacts;
            }
            const swirl::BatchUse use = swirl::follow_batch(std::span(orbits));
            all.impacts += use.impacts;
            all.left += use.left;
            all.rounds += use.rounds;
            all.filled += use.filled;
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        state.counters["sincos"] = seconds / static_cast<double>(all.impacts) / unit;
        state.counters["sincos_ns"] = unit * 1e9;
        state.counters["left"] = all.share_left();
        state.counters["in_use"] = all.lanes_in_use();
        state.SetLabel(swirl::detail::name_of_instruction_set());
    });
    hwy::SetSupportedTargetsForTest(0);
}

}  // namespace

BENCHMARK_CAPTURE(impact, disk_steady, 0, 0.3, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, disk_small_swirl, 0, 0.3, 0.1, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, disk_frictionless, 0, 0.3, 0.5, 0.0, 1.0);
BENCHMARK_CAPTURE(impact, hexagon_steady, 6, 0.4, 0.5, 0.5, 0.9);
BENCHMARK_CAPTURE(impact, hexagon_chaotic, 6, 0.3, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, triangle_chaotic, 3, 0.4, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, thousand_steady, 1000, 0.4, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, thousand_small_swirl, 1000, 0.3, 0.1, 0.5, 1.0);
BENCHMARK_CAPTURE(impact, million_steady, 1000000, 0.4, 0.5, 0.5, 1.0);

BENCHMARK_CAPTURE(batch, disk_steady, 0, 0.3, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(batch, disk_steady_avx2, 0, 0.3, 0.5, 0.5, 1.0, HWY_AVX2);
BENCHMARK_CAPTURE(batch, disk_steady_sse4, 0, 0.3, 0.5, 0.5, 1.0, HWY_SSE4);
BENCHMARK_CAPTURE(batch, disk_small_swirl, 0, 0.3, 0.1, 0.5, 1.0);
BENCHMARK_CAPTURE(batch, disk_frictionless, 0, 0.3, 0.5, 0.0, 1.0);
BENCHMARK_CAPTURE(batch, disk_frictionless_avx2, 0, 0.3, 0.5, 0.0, 1.0, HWY_AVX2);
BENCHMARK_CAPTURE(batch, hexagon_steady, 6, 0.4, 0.5, 0.5, 0.9);
BENCHMARK_CAPTURE(batch, hexagon_steady_avx2, 6, 0.4, 0.5, 0.5, 0.9, HWY_AVX2);
BENCHMARK_CAPTURE(batch, hexagon_steady_sse4, 6, 0.4, 0.5, 0.5, 0.9, HWY_SSE4);
BENCHMARK_CAPTURE(batch, hexagon_chaotic, 6, 0.3, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(batch, hexagon_chaotic_avx2, 6, 0.3, 0.5, 0.5, 1.0, HWY_AVX2);
BENCHMARK_CAPTURE(batch, hexagon_chaotic_sse4, 6, 0.3, 0.5, 0.5, 1.0, HWY_SSE4);
BENCHMARK_CAPTURE(batch, triangle_chaotic, 3, 0.4, 0.5, 0.5, 1.0);
BENCHMARK_CAPTURE(batch, thousand_steady, 1000, 0.4, 0.5, 0.5, 1.0);

BENCHMARK_MAIN();
