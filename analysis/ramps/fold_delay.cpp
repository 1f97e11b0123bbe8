#include "analysis/ramps/fold_delay.hpp"

#include <gsl/gsl_sf_airy.h>

#include <cmath>

namespace swirl::analysis {

namespace {

/// dx/ds = s + x².
double speed_at(double s) {
    const double x = gsl_sf_airy_Ai_deriv(-s, GSL_PREC_DOUBLE) / gsl_sf_airy_Ai(-s, GSL_PREC_DOUBLE);
    return s + x * x;
}

}  // namespace

double fold_delay(double a, double b, double step, double leave) {
    constexpr double long_before = -20;
    const double first_zero = -gsl_sf_airy_zero_Ai(1);
    const double scale = std::cbrt(step * step / std::abs(a * b));
    if (std::isinf(leave)) return first_zero * scale;
    const double speed = leave * std::cbrt(std::abs(b) / (a * a * step * step));
    if (speed_at(long_before) > speed) return nan;
    double low = long_before, high = first_zero;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (speed_at(middle) > speed ? high : low) = middle;
    }
    return low * scale;
}

}  // namespace swirl::analysis
