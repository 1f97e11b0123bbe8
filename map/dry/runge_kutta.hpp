// A step of DOP853 (dop853_coefficients.hpp) in any number type.
#pragma once

#include "map/dry/dop853_coefficients.hpp"
#include "map/numbers/real.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace swirl::detail {

/// What a step has come to, and its error against orders 5 and 3, as numbers alone.
template <class T, std::size_t n>
struct RungeKuttaStep {
    std::array<T, n> place;
    std::array<double, n> fifth_error{}, third_error{};
};

/// y(t + h) of y′ = rate(t, y), a function of T and array to array. Cost: eleven rates.
///   first  rate(t, y)
template <class T, std::size_t n, class Rate>
RungeKuttaStep<T, n> runge_kutta_step(const Rate& rate, const T& time, const std::array<T, n>& place,
                                      const std::array<T, n>& first, const T& h) {
    std::array<std::array<T, n>, dop853::stages> rates;
    rates[0] = first;
    const auto sum = [&](const auto& coefficients, std::size_t i) {
        T total(0);
        for (const dop853::Coefficient& c : coefficients)
            total = total + T(c.value) * rates[static_cast<std::size_t>(c.of)][i];
        return total;
    };
    std::array<T, n> at;
    const auto stage = [&](std::size_t of, const auto& coefficients) {
        for (std::size_t i = 0; i < n; ++i) at[i] = place[i] + h * sum(coefficients, i);
        rates[of] = rate(T(time + T(dop853::nodes[of]) * h), at);
    };
    stage(1, dop853::a1);
    stage(2, dop853::a2);
    stage(3, dop853::a3);
    stage(4, dop853::a4);
    stage(5, dop853::a5);
    stage(6, dop853::a6);
    stage(7, dop853::a7);
    stage(8, dop853::a8);
    stage(9, dop853::a9);
    stage(10, dop853::a10);
    stage(11, dop853::a11);
    RungeKuttaStep<T, n> step;
    for (std::size_t i = 0; i < n; ++i) {
        const T change = sum(dop853::eighth, i);
        step.place[i] = place[i] + h * change;
        step.fifth_error[i] = static_cast<double>(plain(sum(dop853::fifth_error, i)));
        step.third_error[i] = static_cast<double>(plain(T(change - sum(dop853::third, i))));
    }
    return step;
}

/// The error of a step of length h in units of `tolerance`, as DOP853 weighs the two estimates.
template <class T, std::size_t n>
double error_of(const RungeKuttaStep<T, n>& step, double h, const std::array<double, n>& tolerance) {
    double fifth = 0, third = 0;
    for (std::size_t i = 0; i < n; ++i) {
        fifth += (step.fifth_error[i] / tolerance[i]) * (step.fifth_error[i] / tolerance[i]);
        third += (step.third_error[i] / tolerance[i]) * (step.third_error[i] / tolerance[i]);
    }
    const double weight = fifth + 0.01 * third;
    return weight > 0 ? std::fabs(h) * fifth / std::sqrt(weight * static_cast<double>(n)) : 0.0;
}

/// The shortest step, in 1/ω_s: it is taken whatever its error.
inline constexpr double shortest_step = 0x1p-44;

/// A step whose error is within the tolerances, or the shortest.
template <std::size_t n>
struct TakenStep {
    std::array<double, n> place;
    double length;    ///< what was tried, or less
    double proposed;  ///< the length that its error lets the next one have
};

/// As `runge_kutta_step` from a step that is tried first.
template <std::size_t n, class Rate>
TakenStep<n> step_within(const std::array<double, n>& tolerance, const Rate& rate, double time,
                         const std::array<double, n>& place, const std::array<double, n>& first, double h) {
    while (true) {  // ends: h falls to the shortest step
        const auto tried = runge_kutta_step(rate, time, place, first, h);
        const double error = error_of<double, n>(tried, h, tolerance);
        const double factor = error > 0 ? 0.9 * std::pow(error, -0.125) : error == 0 ? 6.0 : 0.1;  // or no number
        if (error <= 1 || h <= shortest_step) return {tried.place, h, h * std::clamp(factor, 0.333, 6.0)};
        h = std::max(shortest_step, h * std::clamp(factor, 0.1, 0.9));
    }
}

}  // namespace swirl::detail
