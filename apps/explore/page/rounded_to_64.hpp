// The number in which the map's tables of rotations are worked out where `long double` is not x86's: 64 bits, so that
// the tables, and with them every orbit, are the bits of the native program.
#pragma once

#include "map/numbers/vec2.hpp"

namespace swirl {

/// A long double of 113 bits, rounded to 64 after each operation. Rounded twice, it differs from x86's number where the
/// 113 bits end in a tie of the 64: one time in 2⁴⁸.
class RoundedTo64 {
public:
    constexpr RoundedTo64() = default;
    constexpr RoundedTo64(long double number) : number_(rounded(number)) {}
    constexpr explicit operator double() const { return static_cast<double>(number_); }

    friend constexpr RoundedTo64 operator+(RoundedTo64 a, RoundedTo64 b) { return {a.number_ + b.number_}; }
    friend constexpr RoundedTo64 operator-(RoundedTo64 a, RoundedTo64 b) { return {a.number_ - b.number_}; }
    friend constexpr RoundedTo64 operator*(RoundedTo64 a, RoundedTo64 b) { return {a.number_ * b.number_}; }
    friend constexpr RoundedTo64 operator/(RoundedTo64 a, RoundedTo64 b) { return {a.number_ / b.number_}; }
    constexpr RoundedTo64 operator-() const { return {-number_}; }
    constexpr RoundedTo64& operator+=(RoundedTo64 other) { return *this = *this + other; }
    constexpr RoundedTo64& operator*=(RoundedTo64 other) { return *this = *this * other; }

private:
    /// The upper 64 of 113 bits, to nearest (Dekker 1971).
    static constexpr long double rounded(long double number) {
        const long double shifted = 0x1.0000000000008p49L * number;  // 2⁴⁹ + 1
        return shifted - (shifted - number);
    }

    long double number_ = 0;
};

}  // namespace swirl
