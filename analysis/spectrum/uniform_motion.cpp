#include "analysis/spectrum/uniform_motion.hpp"

#include "analysis/enum_name.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

/// sin(x)/x.
double sinc(double x) {
    return x == 0 ? 1 : std::sin(x) / x;
}

/// (sin x − x cos x)/x², by its series where the difference cancels.
double spherical_bessel_1(double x) {
    if (std::abs(x) > 0.1) return (std::sin(x) - x * std::cos(x)) / (x * x);
    const double s = x * x;
    return x / 3 * (1 - s / 10 * (1 - s / 28 * (1 - s / 54 * (1 - s / 88))));
}

}  // namespace

std::string_view name_of(Frame frame) {
    using enum Frame;
    return name_in<Frame>({{laboratory, "laboratory"}, {container, "container"}, {corotating, "corotating"}}, frame);
}

Frame frame_from_name(std::string_view word) {
    for (const Frame frame : {Frame::laboratory, Frame::container, Frame::corotating}) {
        if (name_of(frame) == word) return frame;
    }
    throw std::invalid_argument("frame = " + std::string(word) + ": must be laboratory, container or corotating");
}

Complex position_at(const UniformMotion& motion, double t, Frame frame, double swirl_radius) {
    const Complex z = motion.position + motion.velocity * (t - motion.time);
    if (frame == Frame::container) return z - std::polar(swirl_radius, t);
    if (frame == Frame::corotating) return z * std::polar(1.0, -t);
    return z;
}

Complex position_integral(const UniformMotion& motion, double a, double b, Frame frame, double swirl_radius) {
    // About the middle t_m of [a, b], of half length h: ∫ e^{±it} dt = 2h sinc(h) e^{±it_m} and
    // ∫ (t − t_m) e^{−it} dt = −2i h² j₁(h) e^{−it_m}.
    const double h = (b - a) / 2;
    const double middle = a + h;
    const Complex centre = motion.position + motion.velocity * (middle - motion.time);
    if (frame == Frame::laboratory) return 2 * h * centre;
    if (frame == Frame::container) return 2 * h * (centre - std::polar(swirl_radius * sinc(h), middle));
    const Complex drift = Complex(0, -2 * h * h * spherical_bessel_1(h)) * motion.velocity;
    return (2 * h * sinc(h) * centre + drift) * std::polar(1.0, -middle);
}

}  // namespace swirl::analysis
