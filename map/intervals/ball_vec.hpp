// Vectors of the plane whose coordinates are balls.
#pragma once

#include "map/intervals/ball.hpp"

namespace swirl::intervals {

struct BallVec {
    Ball x, y;
};

inline BallVec operator+(const BallVec& a, const BallVec& b) {
    return {a.x + b.x, a.y + b.y};
}
inline BallVec operator-(const BallVec& a, const BallVec& b) {
    return {a.x - b.x, a.y - b.y};
}
inline BallVec operator*(const Ball& s, const BallVec& a) {
    return {s * a.x, s * a.y};
}
/// By a quarter turn.
inline BallVec turned(const BallVec& a) {
    return {-a.y, a.x};
}
inline Ball dot(const BallVec& a, const BallVec& b) {
    return a.x * b.x + a.y * b.y;
}
/// |a|², never negative.
inline Ball squared(const BallVec& a) {
    return square(a.x) + square(a.y);
}
/// (cos φ, sin φ).
inline BallVec cis(const Ball& angle) {
    const auto at = sine_cosine(angle);
    return {at.cosine, at.sine};
}

}  // namespace swirl::intervals
