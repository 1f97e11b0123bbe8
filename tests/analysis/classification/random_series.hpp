// Noises that are no chaos, and chaos of a known exponent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace swirl::tests {

using Step = std::function<double(std::mt19937_64&)>;

inline double uniform(std::mt19937_64& random) {
    return std::uniform_real_distribution<double>()(random);
}

inline double normal(std::mt19937_64& random) {
    return std::normal_distribution<double>()(random);
}

struct Noise {
    std::string name;
    std::function<Step()> begin;

    std::vector<double> draw(int count, unsigned seed) const {
        std::mt19937_64 random(seed);
        const Step step = begin();
        for (int i = 0; i < 500; ++i) step(random);
        std::vector<double> x(static_cast<std::size_t>(count));
        for (double& v : x) v = step(random);
        return x;
    }
};

/// Of two values: ±1 that turns about with a probability, or after stays of 5 to 24 samples, or as two before say.
inline std::vector<Noise> telegraphs() {
    const auto flips = [](double chance) {
        return [chance]() -> Step {
            return [chance, s = 1.0](auto& random) mutable { return s = uniform(random) < chance ? -s : s; };
        };
    };
    const auto noisy = []() -> Step {
        return [s = 1.0](auto& random) mutable {
            if (uniform(random) < 0.05) s = -s;
            return s + 0.05 * normal(random);
        };
    };
    const auto stays = []() -> Step {
        return [s = 1.0, left = 0](auto& random) mutable {
            if (left-- <= 0) s = -s, left = 4 + static_cast<int>(10 * uniform(random) + 10 * uniform(random));
            return s;
        };
    };
    const auto second_order = []() -> Step {
        return [last = 0, before = 0](auto& random) mutable {
            const double chance = last == before ? 0.85 : last == 1 ? 0.3 : 0.6;
            before = std::exchange(last, uniform(random) < chance ? 1 - last : last);
            return static_cast<double>(last);
        };
    };
    return {{"telegraph, 2 %", flips(0.02)},
            {"telegraph, 20 %", flips(0.2)},
            {"telegraph with noise", noisy},
            {"telegraph of bounded stays", stays},
            {"chain of the second order", second_order}};
}

inline std::vector<Noise> chains() {
    const auto ring = []() -> Step {
        return [s = 0](auto& random) mutable {
            const double u = uniform(random);
            s = (s + (u < 0.7 ? 1 : u < 0.9 ? 0 : 11)) % 12;
            return std::round(100 * std::sin(std::numbers::pi * s / 6 + 0.3)) / 100;
        };
    };
    const auto levels = []() -> Step {
        return [s = 10](auto& random) mutable {
            const double u = uniform(random);
            s = std::clamp(s + (u < 0.4 ? 1 : u < 0.8 ? -1 : 0), 0, 19);
            return static_cast<double>(s);
        };
    };
    return {{"ring of twelve", ring}, {"walk on twenty levels", levels}};
}

inline std::vector<Noise> bounded_noises() {
    const auto reflected = []() -> Step {
        return [x = 0.5](auto& random) mutable {
            x = std::abs(x + 0.05 * normal(random));
            return x = x > 1 ? 2 - x : x;
        };
    };
    const auto sine_of_walk = [](double drift, double step) {
        return [drift, step]() -> Step {
            return [drift, step, phase = 0.0](auto& random) mutable {
                phase += drift + step * normal(random);
                return std::sin(phase) + 0.3 * std::sin(2 * phase);
            };
        };
    };
    const auto smooth = []() -> Step {
        return [x = 0.0, y = 0.0](auto& random) mutable {
            x = 0.95 * x + normal(random);
            return std::tanh(y = 0.9 * y + 0.1 * x);
        };
    };
    const auto filtered = []() -> Step {
        return [s = 1.0, x = 0.0, y = 0.0](auto& random) mutable {
            if (uniform(random) < 0.05) s = -s;
            x = 0.9 * x + 0.1 * s;
            return y = 0.9 * y + 0.1 * x;
        };
    };
    const auto halving = []() -> Step {
        return [x = 0.3](auto& random) mutable { return x = 0.5 * x + (uniform(random) < 0.5 ? 0.5 : 0); };
    };
    const auto threshold = []() -> Step {
        return [x = 0.0](auto& random) mutable {
            return x = (x > 0 ? -1.5 + 0.3 * x : 1 + 0.5 * x) + 0.4 * (2 * uniform(random) - 1);
        };
    };
    return {{"reflected walk", reflected},
            {"sine of a walk", sine_of_walk(0, 0.2)},
            {"sine of a drifting walk", sine_of_walk(0.3, 0.1)},
            {"smooth, bounded", smooth},
            {"telegraph, filtered twice", filtered},
            {"halving", halving},
            {"threshold", threshold}};
}

inline std::vector<Noise> all_noises() {
    std::vector<Noise> all = telegraphs();
    for (const auto& more : {chains(), bounded_noises()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// A system of a known largest exponent per sample.
struct Chaos {
    std::string name;
    bool flow;
    double exponent;
    std::function<std::vector<double>(int count, unsigned seed)> draw;
};

using State = std::array<double, 3>;

/// The first coordinate every `spacing`, by Runge and Kutta's fourth order in `parts` steps each.
inline std::vector<double> flow(const std::function<State(const State&)>& rate, State at, double spacing, int parts,
                                int count) {
    const double h = spacing / parts;
    const auto moved = [](const State& a, double t, const State& v) {
        return State{a[0] + t * v[0], a[1] + t * v[1], a[2] + t * v[2]};
    };
    std::vector<double> x;
    for (int i = -2000; i < count; ++i) {
        if (i >= 0) x.push_back(at[0]);
        for (int part = 0; part < parts; ++part) {
            const State a = rate(at), b = rate(moved(at, h / 2, a)), c = rate(moved(at, h / 2, b));
            const State d = rate(moved(at, h, c));
            for (std::size_t k = 0; k < 3; ++k) at[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
        }
    }
    return x;
}

/// Exponents: ln 2; Sprott, Chaos and Time-Series Analysis (2003), tables of appendix A.
inline std::vector<Chaos> chaoses() {
    const auto start = [](unsigned seed) {
        std::mt19937_64 random(seed);
        return State{uniform(random), uniform(random), uniform(random)};
    };
    const auto logistic = [start](int count, unsigned seed) {
        double at = 0.1 + 0.8 * start(seed)[0];
        std::vector<double> x;
        for (int i = 0; i < count; ++i) x.push_back(at = 4 * at * (1 - at));
        return x;
    };
    const auto henon = [start](int count, unsigned seed) {
        double x = 0.2 * start(seed)[0] - 0.1, y = 0.2 * start(seed)[1] - 0.1;
        std::vector<double> series;
        for (int i = -100; i < count; ++i) {
            x = std::exchange(y, 0.3 * x) + 1 - 1.4 * x * x;
            if (i >= 0) series.push_back(x);
        }
        return series;
    };
    const auto rossler = [start](int count, unsigned seed) {
        const auto rate = [](const State& s) {
            return State{-s[1] - s[2], s[0] + 0.2 * s[1], 0.2 + s[2] * (s[0] - 5.7)};
        };
        return flow(rate, start(seed), 0.1, 4, count);
    };
    const auto lorenz = [start](int count, unsigned seed) {
        const auto rate = [](const State& s) {
            return State{10 * (s[1] - s[0]), s[0] * (28 - s[2]) - s[1], s[0] * s[1] - 8.0 / 3 * s[2]};
        };
        State at = start(seed);
        at[2] += 20;
        return flow(rate, at, 0.05, 5, count);
    };
    return {{"logistic", false, std::log(2), logistic},
            {"Henon", false, 0.41922, henon},
            {"Rossler", true, 0.0714 * 0.1, rossler},
            {"Lorenz", true, 0.9056 * 0.05, lorenz}};
}

}  // namespace swirl::tests
