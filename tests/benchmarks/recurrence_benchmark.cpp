// Cost of recurrence analysis against the number of points: full quantification (diagonal and vertical lines,
// entropies, recurrence times) at RR = 1 %, RC alone, and the memory that the first takes. Goals at n = 1e5 on two
// cores: 0.6 s for a scalar series, 1.2 s embedded in three dimensions; RC at 1e6: 0.5 s; 100 bytes per point.
// Full quantification at n = 1e6 takes about a minute: --benchmark_filter=-full.*1000000 leaves it out.
#include "analysis/recurrence/measures.hpp"
#include "analysis/recurrence/rates.hpp"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <new>
#include <random>
#include <span>
#include <vector>

namespace {

// Bytes in use by operator new, and their greatest number: what the algorithms allocate, without the process around.
std::atomic<std::size_t> in_use{0}, peak{0};

void* counted_new(std::size_t size) {
    void* const memory = std::malloc(size);
    if (memory == nullptr) throw std::bad_alloc();
    const std::size_t now = in_use += malloc_usable_size(memory);
    std::size_t seen = peak;
    while (seen < now && !peak.compare_exchange_weak(seen, now)) {
    }
    return memory;
}
void counted_delete(void* memory) noexcept {
    if (memory != nullptr) in_use -= malloc_usable_size(memory);
    std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
    return counted_new(size);
}
void operator delete(void* memory) noexcept {
    counted_delete(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    counted_delete(memory);
}

namespace {

using namespace swirl::analysis::recurrence;

enum Series { noise, logistic, rossler };

// x of the Rossler system (a = b = 0.25, c = 4) at steps of 0.05, by the classical Runge-Kutta method.
std::vector<double> rossler_series(std::size_t n) {
    using Vector = std::array<double, 3>;
    const auto rate = [](const Vector& v) { return Vector{-v[1] - v[2], v[0] + v[1] / 4, 0.25 + v[2] * (v[0] - 4)}; };
    const auto along = [](const Vector& v, const Vector& w, double h) {
        return Vector{v[0] + h * w[0], v[1] + h * w[1], v[2] + h * w[2]};
    };
    constexpr double h = 0.05;
    constexpr std::size_t transient = 4000;
    std::vector<double> series;
    Vector v{1, 1, 0};
    for (std::size_t i = 0; i < transient + n; ++i) {
        const Vector a = rate(v), b = rate(along(v, a, h / 2)), c = rate(along(v, b, h / 2)), d = rate(along(v, c, h));
        v = along(along(along(along(v, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
        if (i >= transient) series.push_back(v[0]);
    }
    return series;
}

// Two extremes: no line is long (noise), and lines that last as the map's largest exponent lets them (logistic); and a
// smooth trajectory.
std::vector<double> make_series(Series kind, std::size_t n) {
    if (kind == rossler) return rossler_series(n);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> series(n);
    double x = 0.3;
    for (double& v : series) {
        x = 4 * x * (1 - x);
        v = kind == noise ? uniform(random) : x;
    }
    return series;
}

// The threshold for RR = 1 %, from 3000 of the points where the exact one would take longer than what is measured.
double one_per_cent(const std::vector<double>& series, int dimension) {
    if (dimension == 1) return threshold_of_rate(embed_series(series), 0.01);
    const std::size_t sample = std::min<std::size_t>(series.size(), 3000);
    return threshold_of_rate(embed_series(std::span(series).first(sample), dimension, 1), 0.01);
}

void full_quantification(benchmark::State& state, Series kind, int dimension) {
    const auto n = static_cast<std::size_t>(state.range(0));
    const std::vector<double> series = make_series(kind, n);
    const double threshold = one_per_cent(series, dimension);
    Measures m;
    const std::size_t before = in_use;
    peak = before;
    for (auto _ : state) {
        m = measures(count_lines(embed_series(series, dimension, 1), threshold));
        benchmark::DoNotOptimize(m);
    }
    state.counters["RR"] = m.RR;
    state.counters["DET"] = m.DET;
    state.counters["bytes_per_point"] = static_cast<double>(peak - before) / static_cast<double>(n);
}

// As the field's benchmark has it: m = 3, tau = 6, epsilon = 1.2, Euclidean.
void smooth_trajectory(benchmark::State& state) {
    const std::vector<double> series = make_series(rossler, static_cast<std::size_t>(state.range(0)));
    Measures m;
    for (auto _ : state) {
        m = measures(count_lines(embed_series(series, 3, 6), 1.2));
        benchmark::DoNotOptimize(m);
    }
    state.counters["RR"] = m.RR;
    state.counters["DET"] = m.DET;
}

void rc_alone(benchmark::State& state) {
    const std::vector<double> series = make_series(noise, static_cast<std::size_t>(state.range(0)));
    const Points points = embed_series(series);
    for (auto _ : state) benchmark::DoNotOptimize(recurrence_rate(points, 1e-6).with_diagonal());
}

void sizes(benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
    for (const int n : {1000, 3000, 10000, 30000, 100000}) b->Arg(n);
}
void once(benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(1)->Arg(1000000);
}

BENCHMARK_CAPTURE(full_quantification, scalar_noise, noise, 1)->Apply(sizes);
BENCHMARK_CAPTURE(full_quantification, scalar_logistic, logistic, 1)->Apply(sizes);
BENCHMARK_CAPTURE(full_quantification, embedded3_noise, noise, 3)->Apply(sizes);
BENCHMARK_CAPTURE(full_quantification, embedded3_logistic, logistic, 3)->Apply(sizes);
BENCHMARK_CAPTURE(full_quantification, scalar_logistic, logistic, 1)->Apply(once);
BENCHMARK(smooth_trajectory)->Apply(sizes)->Arg(100237);
BENCHMARK(rc_alone)->Apply(sizes)->Arg(1000000);

}  // namespace

BENCHMARK_MAIN();
