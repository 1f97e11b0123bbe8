#include "map/dry/uniform_pressure.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl {

namespace {

/// Steps across a border are off by some 300 a_f h³, and a_f h² of a rod's: by 10⁻¹³ of a_f, at weak friction by 10⁻¹⁵.
double shortest_across_border(double deceleration) {
    return 0x1p-16 / std::cbrt(std::min(1e3 * deceleration, 1.0));
}
double shortest_across_rod(double deceleration) {
    return 0x1p-20 / std::sqrt(std::min(1e3 * deceleration, 1.0));
}

/// Over one of the N triangles between the centre and a side, in R_p; r is a part of the way from the centre to a point
/// of the side: what is `of` such a point e goes as rⁿ.
template <class Of>
double mean_over_triangle(int sides, int n, const Of& of) {
    const std::complex<double> next = std::polar(1.0, 2 * pi<double>() / sides);
    const auto along = [&](double s) { return of(1.0 + s * (next - 1.0)); };
    return boost::math::quadrature::gauss<double, 30>::integrate(along, 0.0, 1.0) * 2 / (n + 2);
}

}  // namespace

UniformPressure::UniformPressure(int sides) : sides_(sides) {
    if (sides != disk_sides && (sides < rod_sides || sides > most_sides))
        throw std::invalid_argument("sides = " + std::to_string(sides) + " is outside its range: 2 to " +
                                    std::to_string(most_sides) + ", or disk (over a floor with dry friction)");
    force_ = harmonics(0);
    torque_ = harmonics(1);
    square_ = moment(1, 1);
    if (sides == disk_sides)
        distance_ = 2.0 / 3;
    else if (sides == rod_sides)
        distance_ = 0.5;
    else
        distance_ = mean_over_triangle(sides, 1, [](const std::complex<double>& e) { return std::abs(e); });
}

double UniformPressure::moment(int a, int b) const {
    if (sides_ == disk_sides) return a == b ? 1.0 / (a + 1) : 0.0;
    if ((a - b) % sides_ != 0) return 0;
    if (sides_ == rod_sides) return 1.0 / (a + b + 1);
    return mean_over_triangle(sides_, a + b, [&](const std::complex<double>& e) {
        return std::real(std::pow(e, a) * std::pow(std::conj(e), b));
    });
}

std::vector<UniformPressure::Harmonic> UniformPressure::harmonics(int shift) const {
    std::vector<double> roots(order + 1, 1.0), inverse_roots(order + 1, 1.0);  // binom(±½, k)
    for (std::size_t k = 1; k <= order; ++k) {
        const double before = static_cast<double>(k) - 1;
        roots[k] = roots[k - 1] * (0.5 - before) / static_cast<double>(k);
        inverse_roots[k] = inverse_roots[k - 1] * (-0.5 - before) / static_cast<double>(k);
    }
    std::vector<Harmonic> all;
    for (int n = -order; n <= order; ++n) {
        const bool is_there = sides_ == disk_sides ? n == shift : (n - shift) % sides_ == 0;
        if (!is_there) continue;
        Harmonic harmonic{n, {}};
        for (int a = std::max(n, 0); 2 * a - n <= order; ++a)
            harmonic.coefficients.push_back(roots[static_cast<std::size_t>(a)] *
                                            inverse_roots[static_cast<std::size_t>(a - n)] * moment(a, a - n + shift));
        all.push_back(std::move(harmonic));
    }
    return all;
}

double UniformPressure::step_to_border(const Body<double>& body, const Vec2<double>& velocity, double spin,
                                       const Vec2<double>& arm, double deceleration, double change,
                                       double along_rate) const {
    const double speed = std::hypot(velocity.x, velocity.y), rim = body.alpha * std::fabs(spin);
    if (sides_ == disk_sides) return std::max(shortest_across_border(deceleration), std::fabs(speed - rim) / change);
    // In the axes of the arm, and about the nearest side's normal.
    const Vec2<double> pivot =
        seen_from(arm, quarter_turned(Vec2<double>(std::copysign(1.0, spin) * velocity)));  // by α|S|
    if (sides_ == rod_sides) {
        const double past = std::max(0.0, std::fabs(pivot.x) / body.alpha - rim), off = std::fabs(pivot.y) / body.alpha;
        // At the rate of now, and as it may change where U and αS turn.
        const double rate = std::fabs(along_rate), rise = change * (change / (speed + rim) + std::fabs(spin));
        const double to_line = off > 0 ? 2 * off / (rate + std::sqrt(rate * rate + 2 * rise * off)) : 0;
        return std::max({shortest_across_rod(deceleration), past / change, to_line});
    }
    const double half = pi<double>() / sides_, angle = std::atan2(pivot.y, pivot.x) - half;
    const double off = angle - 2 * half * std::round(angle / (2 * half));
    return std::max(shortest_across_border(deceleration),
                    std::fabs(speed * std::cos(off) - rim * std::cos(half)) / change);
}

}  // namespace swirl
