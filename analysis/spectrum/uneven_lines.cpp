#include "analysis/spectrum/uneven_lines.hpp"

#include "analysis/special_values.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swirl::analysis {

namespace {

using Matrix3 = Eigen::Matrix3d;
using Vector3 = Eigen::Vector3d;

/// Least squares of c + a cos ωt + b sin ωt over samples begin … end − 1: a and b.
FittedLine amplitudes(std::span<const double> times, std::span<const double> values, double omega) {
    Matrix3 normal = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Vector3 row(std::cos(omega * times[i]), std::sin(omega * times[i]), 1);
        normal += row * row.transpose();
        right += row * values[i];
    }
    // At half the sampling frequency of even times one of the two waves is 0: a trace of its square keeps it at 0.
    normal.diagonal().array() += 1e-12 * static_cast<double>(times.size());
    const Vector3 found = normal.ldlt().solve(right);
    return {omega, found[0], found[1]};
}

/// One step of Gauss and Newton for a, b and ω.
FittedLine improved(std::span<const double> times, std::span<const double> values, const FittedLine& line) {
    Matrix3 normal = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    const double scale = times.back();  // so that all columns are of one size
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double c = std::cos(line.omega * times[i]), s = std::sin(line.omega * times[i]);
        const Vector3 row(c, s, times[i] / scale * (line.b * c - line.a * s));
        normal += row * row.transpose();
        right += row * (values[i] - line.a * c - line.b * s);
    }
    normal.diagonal() *= 1 + 1e-12;
    const Vector3 step = normal.ldlt().solve(right);
    return {line.omega + step[2] / scale, line.a + step[0], line.b + step[1]};
}

}  // namespace

LineFit::LineFit(std::span<const double> times, std::span<const double> values)
    : times_(times.begin(), times.end()), residual_(values.begin(), values.end()) {
    const double middle = times.front() + (times.back() - times.front()) / 2;
    for (double& t : times_) t -= middle;
    refine(0, 1);
}

void LineFit::put(const FittedLine& line, double factor) {
    for (std::size_t i = 0; i < times_.size(); ++i)
        residual_[i] +=
            factor * (line.a * std::cos(line.omega * times_[i]) + line.b * std::sin(line.omega * times_[i]));
}

FittedLine LineFit::fitted(FittedLine line, double reach, int steps) const {
    const double omega = line.omega;
    line = amplitudes(times_, residual_, omega);
    for (int k = 0; k < steps; ++k) {
        const FittedLine next = improved(times_, residual_, line);
        if (!(std::abs(next.omega - omega) < reach)) break;
        line = next;
    }
    return amplitudes(times_, residual_, line.omega);
}

void LineFit::add(double omega, double reach) {
    constexpr int steps = 4;
    lines_.push_back(fitted({omega, 0, 0}, reach, steps));
    put(lines_.back(), -1);
}

void LineFit::take_back() {
    put(lines_.back(), 1);
    lines_.pop_back();
}

void LineFit::refine(double reach, int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double mean = 0;
        for (const double x : residual_) mean += x / static_cast<double>(residual_.size());
        for (double& x : residual_) x -= mean;
        for (FittedLine& line : lines_) {
            put(line, 1);
            line = fitted(line, reach, 2);
            put(line, -1);
        }
    }
}

double LineFit::spread(const FittedLine& line, std::size_t parts) const {
    const double length = (times_.back() - times_.front()) / static_cast<double>(parts);
    if (line.omega * length < 3 * 2 * std::numbers::pi) return nan;
    std::vector<double> powers, part;
    for (std::size_t p = 0; p < parts; ++p) {
        const double from = times_.front() + static_cast<double>(p) * length;
        const auto begin = std::lower_bound(times_.begin(), times_.end(), from);
        const auto end = p + 1 == parts ? times_.end() : std::lower_bound(begin, times_.end(), from + length);
        if (end - begin < 8) return nan;
        const std::span<const double> times(&*begin, static_cast<std::size_t>(end - begin));
        const double* const rest = residual_.data() + (begin - times_.begin());
        part.clear();
        for (std::size_t i = 0; i < times.size(); ++i)
            part.push_back(rest[i] + line.a * std::cos(line.omega * times[i]) +
                           line.b * std::sin(line.omega * times[i]));
        powers.push_back(amplitudes(times, part, line.omega).power());
    }
    double mean = 0, squares = 0;
    for (const double power : powers) mean += power / static_cast<double>(parts);
    for (const double power : powers) squares += (power - mean) * (power - mean);
    return mean > 0 ? std::sqrt(squares / static_cast<double>(parts - 1)) / mean : 0;
}

}  // namespace swirl::analysis
