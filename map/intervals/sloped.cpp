#include "map/intervals/sloped.hpp"

namespace swirl::intervals::detail {

AtPoint at_point(const Ball& x) {
    if (!is_finite(x)) return {0, std::numeric_limits<double>::infinity()};
    const double value = middle(x);
    return {value, upper(abs(x - Ball(value)))};
}

SineCosineAtPoint sine_cosine_at(double x) {
    if (!std::isfinite(x)) return {{0, 1}, {0, 1}};
    const SineCosine at = sine_cosine(Ball(x));
    return {at_point(at.sine), at_point(at.cosine)};
}

AtPoint direction_at(double y, double x) {
    Ball angle;
    arb_atan2(angle.raw(), Ball(y).raw(), Ball(x).raw(), ball_precision);
    return at_point(angle);
}

namespace {

constexpr double small = 1e-6;  // below it the closed forms lose their digits, above it at most 24 of 38 (k = 2: 18)

}  // namespace

AtPoint cosine_moment_at(double x, int k) {
    const Ball t(x);
    if (k == 0) return at_point(sinc(t));
    if (std::abs(x) < small) return {1.0 / (k + 1), 1e-16 + 0.25 * x * x};  // 1/(k + 1) − x²/(2(k + 3)) + …
    const SineCosine at = sine_cosine(t);
    if (k == 2) return at_point(((square(t) - Ball(2)) * at.sine + Ball(2) * t * at.cosine) / (square(t) * t));
    return at_point((t * at.sine + at.cosine - Ball(1)) / square(t));
}

AtPoint sine_moment_at(double x, int k) {
    const Ball t(x);
    if (k == 0) {
        const Ball half = Ball(0.5) * t;
        return at_point(half * square(sinc(half)));
    }
    // x/(k + 2) − x³/(6(k + 4)) + …
    if (std::abs(x) < small) return {x / (k + 2), 1e-15 * std::abs(x) + std::abs(x) * x * x};
    const SineCosine at = sine_cosine(t);
    if (k == 2)
        return at_point((Ball(2) * t * at.sine + (Ball(2) - square(t)) * at.cosine - Ball(2)) / (square(t) * t));
    return at_point((at.sine - t * at.cosine) / square(t));
}

}  // namespace swirl::intervals::detail
