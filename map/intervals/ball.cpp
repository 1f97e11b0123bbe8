#include "map/intervals/ball.hpp"

#include <charconv>
#include <stdexcept>

namespace swirl::intervals {

namespace {

/// What a function of Arb makes of some balls.
template <class Function, class... Balls>
Ball by(Function* function, const Balls&... x) {
    Ball result;
    function(result.raw(), x.raw()..., ball_precision);
    return result;
}

double bound(const Ball& x, void (*get)(arf_t, const arb_t, slong), arf_rnd_t rounding) {
    arf_t value;
    arf_init(value);
    get(value, x.raw(), 64);
    const double result = arf_get_d(value, rounding);
    arf_clear(value);
    return result;
}

}  // namespace

Ball between(double low, double high) {
    Ball result;
    arf_t a, b;
    arf_init(a);
    arf_init(b);
    arf_set_d(a, low);
    arf_set_d(b, high);
    arb_set_interval_arf(result.raw(), a, b, ball_precision);
    arf_clear(a);
    arf_clear(b);
    return result;
}

Ball around(double middle, double radius) {
    Ball result(middle);
    arf_t r;
    arf_init(r);
    arf_set_d(r, radius);
    arb_add_error_arf(result.raw(), r);
    arf_clear(r);
    return result;
}

Ball decimal(const std::string& text) {
    Ball result;
    // Digits, a point and an exponent only: Arb's reader also takes intervals, whose width would be the user's word.
    const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
    const char* end = text.data() + text.size();
    double value = 0;
    const bool plain = text.find_first_not_of("0123456789+-.eE") == std::string::npos &&
                       std::from_chars(begin, end, value).ptr == end && begin != end;
    if (!plain || arb_set_str(result.raw(), text.c_str(), ball_precision) != 0 || !is_finite(result))
        throw std::invalid_argument("'" + text + "' is not a decimal number");
    return result;
}

Ball decimal(double value) {
    char digits[32];  // the longest has 24
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    return decimal(std::string(digits, end));
}

Ball pi_ball() {
    return by(arb_const_pi);
}
Ball hull(const Ball& a, const Ball& b) {
    return by(arb_union, a, b);
}
Ball sqrt(const Ball& x) {
    return by(arb_sqrt, x);
}
Ball acos(const Ball& x) {
    return by(arb_acos, x);
}
Ball asin(const Ball& x) {
    return by(arb_asin, x);
}

Ball abs(const Ball& x) {
    Ball result;
    arb_abs(result.raw(), x.raw());
    return result;
}

Ball square(const Ball& x) {
    return by(arb_sqr, x);
}
Ball atan2(const Ball& y, const Ball& x) {
    return by(arb_atan2, y, x);
}
Ball sinc(const Ball& x) {
    return by(arb_sinc, x);
}

SineCosine sine_cosine(const Ball& x) {
    SineCosine result;
    arb_sin_cos(result.sine.raw(), result.cosine.raw(), x.raw(), ball_precision);
    return result;
}

Ball intersection(const Ball& a, const Ball& b) {
    return by(arb_intersection, a, b);
}

double lower(const Ball& x) {
    return bound(x, arb_get_lbound_arf, ARF_RND_FLOOR);
}
double upper(const Ball& x) {
    return bound(x, arb_get_ubound_arf, ARF_RND_CEIL);
}

double middle(const Ball& x) {
    return arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR);
}

Ball exact_middle(const Ball& x) {
    Ball result;
    arb_get_mid_arb(result.raw(), x.raw());
    return result;
}

double radius(const Ball& x) {
    arf_t value;
    arf_init(value);
    arf_set_mag(value, arb_radref(x.raw()));
    const double result = arf_get_d(value, ARF_RND_CEIL);
    arf_clear(value);
    return result;
}

}  // namespace swirl::intervals
