// Real balls: midpoint and radius, every operation enclosed (Arb; Johansson, IEEE Trans. Comput. 66 (2017) 1281).
//
// A Ball stands for a set of real numbers. The result of an operation holds every result for members of its operands.
// Comparisons say what is certain of all members. Midpoints have 128 bits, which fit into Arb's numbers themselves, so
// that no operation asks for memory.
#pragma once

#include "map/intervals/arb.hpp"

#include <string>
#include <utility>

namespace swirl::intervals {

inline constexpr slong ball_precision = 128;  ///< bits of midpoints

class Ball {
public:
    Ball() { arb_init(x_); }
    /// Exactly this number.
    explicit Ball(double value) : Ball() { arb_set_d(x_, value); }
    explicit Ball(int value) : Ball() { arb_set_si(x_, value); }
    Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
    Ball(Ball&& other) noexcept : Ball() { arb_swap(x_, other.x_); }
    Ball& operator=(const Ball& other) {
        arb_set(x_, other.x_);
        return *this;
    }
    Ball& operator=(Ball&& other) noexcept {
        arb_swap(x_, other.x_);
        return *this;
    }
    ~Ball() { arb_clear(x_); }

    arb_ptr raw() { return x_; }
    arb_srcptr raw() const { return x_; }

    Ball& operator+=(const Ball& b) {
        arb_add(x_, x_, b.x_, ball_precision);
        return *this;
    }
    Ball& operator-=(const Ball& b) {
        arb_sub(x_, x_, b.x_, ball_precision);
        return *this;
    }
    Ball& operator*=(const Ball& b) {
        arb_mul(x_, x_, b.x_, ball_precision);
        return *this;
    }
    Ball& operator/=(const Ball& b) {
        arb_div(x_, x_, b.x_, ball_precision);
        return *this;
    }
    /// Adds a·b.
    void add_product(const Ball& a, const Ball& b) { arb_addmul(x_, a.x_, b.x_, ball_precision); }

private:
    arb_t x_;
};

inline Ball operator+(Ball a, const Ball& b) {
    return std::move(a += b);
}
inline Ball operator-(Ball a, const Ball& b) {
    return std::move(a -= b);
}
inline Ball operator*(Ball a, const Ball& b) {
    return std::move(a *= b);
}
inline Ball operator/(Ball a, const Ball& b) {
    return std::move(a /= b);
}
inline Ball operator-(Ball a) {
    arb_neg(a.raw(), a.raw());
    return a;
}

/// The ball that holds every number between `low` and `high`.
Ball between(double low, double high);
/// Midpoint and radius, both exact.
Ball around(double middle, double radius);
/// The number that a decimal says, however many digits it has. @throws std::invalid_argument if it is none
Ball decimal(const std::string& text);
/// The shortest decimal that reads back to the double: what a user means who writes 0.4.
Ball decimal(double value);
Ball pi_ball();
/// The smallest ball with all of both.
Ball hull(const Ball& a, const Ball& b);

Ball sqrt(const Ball& x);
Ball acos(const Ball& x);
Ball asin(const Ball& x);
Ball abs(const Ball& x);
Ball square(const Ball& x);
/// The angle of (x, y), for balls that do not meet the negative x-axis.
Ball atan2(const Ball& y, const Ball& x);
/// sin x / x, 1 at 0.
Ball sinc(const Ball& x);
struct SineCosine {
    Ball sine, cosine;
};
SineCosine sine_cosine(const Ball& x);

/// Certain of all members.
inline bool is_positive(const Ball& x) {
    return arb_is_positive(x.raw()) != 0;
}
inline bool is_negative(const Ball& x) {
    return arb_is_negative(x.raw()) != 0;
}
inline bool is_finite(const Ball& x) {
    return arb_is_finite(x.raw()) != 0;
}
inline bool is_exact_zero(const Ball& x) {
    return arb_is_zero(x.raw()) != 0;
}
/// True if all of `inner` lies strictly inside of `outer`.
inline bool contains_interior(const Ball& outer, const Ball& inner) {
    return arb_contains_interior(outer.raw(), inner.raw()) != 0;
}
inline bool contains(const Ball& outer, const Ball& inner) {
    return arb_contains(outer.raw(), inner.raw()) != 0;
}
inline bool contains_zero(const Ball& x) {
    return arb_contains_zero(x.raw()) != 0;
}
inline bool overlap(const Ball& a, const Ball& b) {
    return arb_overlaps(a.raw(), b.raw()) != 0;
}
/// What both have in common; they overlap.
Ball intersection(const Ball& a, const Ball& b);

/// Doubles that are certainly no larger, no smaller.
double lower(const Ball& x);
double upper(const Ball& x);
/// The midpoint, as a double, and as a ball without radius.
double middle(const Ball& x);
Ball exact_middle(const Ball& x);
/// The radius, rounded up.
double radius(const Ball& x);
/// All values of an enclosed number of any sort, as a ball.
inline const Ball& values_of(const Ball& x) {
    return x;
}

}  // namespace swirl::intervals
