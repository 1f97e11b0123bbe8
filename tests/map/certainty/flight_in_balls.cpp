#include "tests/map/certainty/flight_in_balls.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::tests {

namespace {

using intervals::between;
using intervals::is_negative;
using intervals::middle;
using intervals::square;

BallVec times(const BallVec& a, const BallVec& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
BallVec exactly(const Vec2<double>& v) {
    return {Ball(v.x), Ball(v.y)};
}

/// Rounded up, however the sum of the doubles rounds: they are few and positive.
double a_little_more(double x) {
    return x * (1 + 0x1p-45);
}

}  // namespace

FlightInBalls::FlightInBalls(const Scene<double>& scene, const Flight<double>& flight)
    : sides_(scene.sides),
      struck_(flight.struck),
      alpha_(scene.alpha),
      spin_double_(flight.spin),
      spin_(flight.spin),
      reach_(scene.is_disk() ? 1 - scene.alpha : 1.0),
      centre_(exactly(flight.centre)),
      velocity_(exactly(flight.velocity)),
      swirl_(Ball(flight.beta) * exactly(flight.phase)) {
    const double speed = std::hypot(flight.velocity.x, flight.velocity.y);
    centre_fastest_ = a_little_more(speed + flight.beta);
    fastest_ = centre_fastest_;
    if (scene.is_disk()) return;
    fastest_ = a_little_more(centre_fastest_ + std::fabs(flight.spin) * scene.alpha);
    arm_angle_ = std::atan2(flight.arm.y, flight.arm.x);
    arms_[0] = exactly(flight.arm);
}

const BallVec& FlightInBalls::arm_of(int k) const {
    const auto known = arms_.find(k);
    if (known != arms_.end()) return known->second;
    const Ball angle = Ball(2 * k) * intervals::pi_ball() / Ball(sides_);
    return arms_[k] = times(arms_.at(0), cis(angle));
}

FlightInBalls::Moment FlightInBalls::at(const Ball& time) const {
    const BallVec turn = cis(time);
    Moment moment;
    moment.swirl = times(swirl_, turn);
    moment.moved = time * velocity_ - (moment.swirl - swirl_);
    moment.drift = velocity_ - turned(moment.swirl);
    if (sides_ != disk_sides) moment.spun = cis(spin_ * time);
    return moment;
}

FlightInBalls::Moment FlightInBalls::over(double from, double to, double middle_time, const Moment& at_middle) const {
    const Ball all = between(from, to);
    Moment moment = at(all);
    moment.moved = at_middle.moved + (all - Ball(middle_time)) * moment.drift;
    return moment;
}

BallVec FlightInBalls::place(const Moment& moment, int k) const {
    if (sides_ == disk_sides) return centre_ + moment.moved;
    const BallVec arm = times(arm_of(k), moment.spun);
    if (struck_ && k == 0) return BallVec{Ball(1), Ball(0)} + (moment.moved + (arm - arm_of(0)));
    return (centre_ + moment.moved) + arm;
}

FlightInBalls::Gap FlightInBalls::gap(const Moment& moment, int k) const {
    const BallVec x = place(moment, k);
    BallVec rate = moment.drift, curvature = moment.swirl;
    if (sides_ != disk_sides) {
        const BallVec turning = spin_ * turned(times(arm_of(k), moment.spun));
        rate = rate + turning;
        curvature = curvature + spin_ * turned(turning);
    }
    return {squared(x) - square(reach_), Ball(2) * dot(x, rate), Ball(2) * (squared(rate) + dot(x, curvature))};
}

bool FlightInBalls::is_far_inside(const Moment& at_middle, int k, double half) const {
    const double speed = sides_ == disk_sides ? centre_fastest_ : fastest_;
    return is_negative(sqrt(squared(place(at_middle, k))) + Ball(speed) * Ball(half) - reach_);
}

bool FlightInBalls::all_far_inside(const Moment& at_middle, double half) const {
    if (sides_ == disk_sides) return is_far_inside(at_middle, 0, half);
    const Ball distance = sqrt(squared(centre_ + at_middle.moved));
    return is_negative(distance + Ball(a_little_more(alpha_)) + Ball(centre_fastest_) * Ball(half) - Ball(1));
}

std::optional<std::vector<int>> FlightInBalls::perhaps_at_wall(double middle_time, const Moment& at_middle, double half,
                                                               int most) const {
    if (sides_ == disk_sides) return std::vector<int>{0};
    // (1 − vh)² ≤ |X|² + α² + 2α|X| cos φ, φ the vertex's direction from X's. Doubles, with 10⁻⁹ to spare.
    constexpr double spare = 1e-9;
    const BallVec centre = centre_ + at_middle.moved;
    const double x = middle(centre.x), y = middle(centre.y), distance = std::hypot(x, y);
    const double needed = std::max(0.0, 1 - fastest_ * half);
    const double cosine =
        (needed * needed - alpha_ * alpha_ - distance * distance - spare) / std::max(2 * alpha_ * distance, 1e-300);
    const double spacing = 2 * M_PI / sides_;
    const double width =
        cosine <= -1 ? 4 : (cosine >= 1 ? 0 : std::acos(cosine)) + spare * (1 + fastest_ * middle_time);
    const double towards = (std::atan2(y, x) - arm_angle_ - spin_double_ * middle_time) / spacing;
    const double first = std::ceil(towards - width / spacing), last = std::floor(towards + width / spacing);
    std::vector<int> found;
    if (cosine >= 1) return found;
    if (last - first + 1 >= sides_) {
        if (sides_ > most) return std::nullopt;
        for (int k = 0; k < sides_; ++k) found.push_back(k);
        return found;
    }
    if (last - first >= most) return std::nullopt;
    for (double k = first; k <= last; ++k) {
        const double reduced = k - std::floor(k / sides_) * sides_;
        found.push_back(static_cast<int>(reduced) % sides_);
    }
    return found;
}

}  // namespace swirl::tests
