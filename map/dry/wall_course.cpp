#include "map/dry/wall_course.hpp"

#include "map/contact/contact_jets.hpp"
#include "map/dry/dry_flight.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace swirl {

namespace {

constexpr double tolerance_of_step = 1e-14;
/// αS below it is none: far below what a step is known to.
constexpr double least_spin = 1e-18;
constexpr int parts_per_step = 8;

/// Where a parabola through values at 0, ½ and 1 is lowest between them, if it is below both ends.
double lowest_of_parabola(double start, double middle, double end) {
    const double bend = 2 * (start + end - 2 * middle), slope = 4 * middle - 3 * start - end;
    if (!(bend > 0) || slope >= 0 || -slope >= 2 * bend) return std::min(start, end);
    return start - slope * slope / (4 * bend);
}

/// U against the floor in the axes n and t, and S, with their rates along a motion.
struct Sliding {
    Vec2<double> velocity, velocity_rate;
    double spin, spin_rate;
    Vec2<double> arm;
};

Sliding sliding_at(const DryWall<double>& wall, const DryMotion& motion, const DryStation<double>& station) {
    using InTime = ContactJet<1>;
    const auto moving = [&](std::size_t i) {
        InTime value(station.y[i]);
        value.v[0] = station.rate[i];
        return value;
    };
    const Body<double>& body = wall.contact.body;
    const InTime psi = moving(0), chi = moving(1), ut = moving(2), spin = moving(3), alpha(body.alpha);
    const Vec2<InTime> arm = arm_on_wall(alpha, motion.support, chi);
    Vec2<InTime> slip = centre_on_wall_rate(arm, ut, spin);
    if (!wall.is_dish) slip = slip + dish_rate(InTime(body.beta), Vec2<InTime>{cos(psi), sin(psi)});
    return {{slip.x.a, slip.y.a}, {slip.x.v[0], slip.y.v[0]}, spin.a, spin.v[0], {arm.x.a, arm.y.a}};
}

}  // namespace

WallCourse::WallCourse(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& start,
                       double most)
    : wall_(wall),
      motion_(motion),
      station_(dry_station(wall, motion, 0.0, {start.psi, start.chi, start.ut, start.spin, 0, 0})) {
    const Body<double>& body = wall.contact.body;
    stiff_ = 0.25 * wall.deceleration * body.alpha * body.alpha * body.inverse_inertia;
    const double rim = body.alpha * std::fabs(start.spin);
    const double along = motion.support == Support::rim ? start.ut - body.alpha * start.spin : start.ut;
    scale_ = body.beta + wall.deceleration * (1 + body.alpha * body.alpha * body.inverse_inertia) +
             rim * std::fabs(start.spin) + along * along * (motion.support == Support::rim ? body.inverse_inner : 1);
    if (!creeps(wall, motion, start)) return;
    const Creep creep = creep_from_rest(wall, motion, start, std::min(most, creep_lasts(wall, motion, start)));
    station_ = dry_station(wall, motion, creep.time,
                           {creep.state.psi, creep.state.chi, creep.state.ut, creep.state.spin, creep.turned, 0});
    end_spin();
}

/// Near U = 0, S = 0 the direction of the floor's friction turns within the time in which the body comes there.
double WallCourse::longest() const {
    const double turning = 1 + std::fabs(station_.rate[0]) + std::fabs(station_.y[3]);
    const double most = std::min(longest_step, 2 * longest_step / turning);
    if (motion_.rests || goes_in_line(wall_, motion_, station_.y[3])) return most;
    const Body<double>& body = wall_.contact.body;
    const Sliding at = sliding_at(wall_, motion_, station_);
    const double speed = std::hypot(at.velocity.x, at.velocity.y), rim = body.alpha * std::fabs(at.spin);
    const double slides = std::hypot(at.velocity_rate.x, at.velocity_rate.y),
                 spins = body.alpha * std::fabs(at.spin_rate);
    const double change = slides + spins + stiff_;
    const double to_stop = speed + rim < longest_step * change
                               ? std::max(detail::shortest_step, 0.5 * (speed + rim) / change)
                               : longest_step;
    // The border passes at the rate of |U| − α|S| now, and of how U turns in the body's axes, and how much faster until
    // then at jerks of the scale of accelerations.
    const double slows = speed > 0 ? dot(at.velocity, at.velocity_rate) / speed : 0;
    const double apart = std::fabs(speed - rim);
    double nears = std::fabs(slows - std::copysign(body.alpha * at.spin_rate, at.spin * at.spin_rate));
    double along_rate = 0;
    if (motion_.support != Support::rim) {
        const double swings = motion_.support == Support::vertex ? station_.rate[1] : 0;
        nears += speed * std::fabs(swings) + slides;
        along_rate = (dot(at.velocity_rate, at.arm) + swings * dot(at.velocity, quarter_turned(at.arm))) / body.alpha;
    }
    return std::min({to_stop, most,
                     wall_.pressure->step_to_border(body, at.velocity, at.spin, at.arm, wall_.deceleration,
                                                    nears + std::sqrt(2 * scale_ * turning * apart), along_rate)});
}

void WallCourse::advance(double most) {
    const auto rate = [this](double, const DryPlace<double>& y) { return detail::dry_rate(wall_, motion_, y); };
    const double speed = 1 + std::fabs(station_.y[2]), spin = 1 + std::fabs(station_.y[3]);
    const DryPlace<double> tolerance{tolerance_of_step,         tolerance_of_step,
                                     tolerance_of_step * speed, tolerance_of_step * spin,
                                     tolerance_of_step * spin,  tolerance_of_step * speed * speed};
    const auto taken = detail::step_within<6>(tolerance, rate, station_.time, station_.y, station_.rate,
                                              std::min({proposed_, longest(), most}));
    before_ = station_;
    step_ = taken.length;
    proposed_ = std::max(detail::shortest_step, taken.proposed);
    station_ = dry_station(wall_, motion_, before_.time + step_, taken.place);
    end_spin();
}

/// Along a wall without friction the floor alone turns a disk, less and less.
void WallCourse::end_spin() {
    double& spin = station_.y[3];
    const double alpha = wall_.contact.body.alpha;
    if (motion_.support != Support::rim || wall_.contact.mu != 0 || !wall_.is_dish || spin == 0 ||
        alpha * std::fabs(spin) > least_spin)
        return;
    station_.y[2] -= alpha * spin;  // ρν′ stays
    spin = 0;
    motion_.slipping = station_.y[2] < 0 ? -1 : 1;
    motion_.turning = 0;
    station_ = dry_station(wall_, motion_, station_.time, station_.y);
}

/// Hermite's cubic.
DryPlace<double> WallCourse::about(double h) const {
    const double t = h / step_, rest = 1 - t;
    DryPlace<double> y{};
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = rest * rest * ((1 + 2 * t) * before_.y[i] + h * before_.rate[i]) +
               t * t * ((3 - 2 * t) * station_.y[i] - rest * step_ * station_.rate[i]);
    return y;
}

contact_detail::Conditions<double> WallCourse::events(const ContactScene<double>& pushed,
                                                      const ContactState<double>& z) const {
    return contact_detail::conditions_of<double>({pushed, motion_.support, motion_.motion},
                                                 {{z.psi, z.chi, z.ut, z.spin, 0, 0}, {}});
}

WallCourse::Conditions WallCourse::conditions(const DryPlace<double>& y) const {
    Conditions values{};
    const ContactState<double> z = contact_of(y);
    const ContactScene<double> pushed = scene_at(wall_, motion_, z);
    const auto found = events(pushed, z);
    for (std::size_t i = 0; i < found.size(); ++i) values[i] = found[i].value;
    if (motion_.sticks()) values[contact_detail::hold_condition] -= stick_margin(pushed, z);  // μλ − |f| itself
    const bool in_line = !motion_.rests && goes_in_line(wall_, motion_, z.spin);
    const bool turns = motion_.support == Support::edge || motion_.sticks();
    values[line_condition] = !in_line ? 1
                             : turns  ? std::copysign(1, motion_.turning) * z.spin
                                      : std::copysign(1, motion_.slipping) * z.ut;
    return values;
}

double WallCourse::locate(std::size_t which, double from, double to) const {
    const auto value = [&](double h) { return conditions(after(h))[which]; };
    double before = value(from);
    const double after_it = value(to);
    for (int halving = 1; !(before > 0); ++halving) {  // it may start at zero, rise, and fall again
        if (halving > 60) return from;
        const double nearer = from + std::ldexp(to - from, -halving);
        before = value(nearer);
        if (before > 0) from = nearer;
    }
    std::uintmax_t iterations = 80;
    return boost::math::tools::toms748_solve(value, from, to, before, after_it,
                                             boost::math::tools::eps_tolerance<double>(51), iterations)
        .second;
}

std::optional<WallCourse::Failure> WallCourse::failure() const {
    // Between stations places are first taken from the cubic through both. What is so near to zero that its error, of
    // fourth order, could hide a sign is looked at by the integration itself.
    const double turned = step_ * (1 + std::fabs(before_.rate[0]) + std::fabs(before_.y[3]));
    const double near = scale_ * (0.05 * turned * turned * turned * turned + 1e-12);
    Conditions before = conditions(before_.y);
    double from = 0;
    for (int part = 1; part <= parts_per_step; ++part) {
        const double to = part == parts_per_step ? step_ : step_ * part / parts_per_step;
        Conditions now = conditions(part == parts_per_step ? station_.y : about(to));
        if (part < parts_per_step && *std::min_element(now.begin(), now.end()) < near) now = conditions(after(to));
        std::optional<double> first;
        std::optional<Conditions> middle;
        std::size_t which = 0;
        const auto note = [&](std::size_t i, double failed) {
            const double time = locate(i, from, failed);
            if (!first || time < *first) first = time, which = i;
        };
        for (std::size_t i = 0; i < dry_conditions; ++i) {
            if (now[i] < 0) {
                note(i, to);
                continue;
            }
            if (!(before[i] > 0)) continue;
            if (!middle) middle = conditions(about(0.5 * (from + to)));
            const double between = (*middle)[i];
            if (lowest_of_parabola(before[i], between, now[i]) > near) continue;
            if (between >= std::min(before[i], now[i])) continue;
            std::uintmax_t iterations = 40;
            const auto lowest = boost::math::tools::brent_find_minima([&](double h) { return conditions(after(h))[i]; },
                                                                      from, to, 26, iterations);
            if (lowest.second < 0) note(i, lowest.first);
        }
        if (first) {
            if (which == line_condition) return Failure{*first, ContactEvent::stick, false, true};
            const ContactState<double> z = contact_of(after(*first));
            const auto event = events(scene_at(wall_, motion_, z), z)[which];
            const bool in_line = goes_in_line(wall_, motion_, before_.y[3]) && !motion_.sticks();
            return Failure{*first, event.event, event.first_lifts, in_line && event.event == ContactEvent::stick};
        }
        before = now;
        from = to;
    }
    return {};
}

bool WallCourse::has_stopped() const {
    if (!wall_.is_dish || motion_.rests || goes_in_line(wall_, motion_, station_.y[3])) return false;
    const ContactState<double> z = contact_of(station_.y);
    const double speed = std::fabs(z.ut) + wall_.contact.body.alpha * std::fabs(z.spin);
    return speed <= speed_left_at_stop(wall_.deceleration) && station_.time > 0 &&
           rest_reserve(wall_, motion_.support, z) > 0;
}

}  // namespace swirl
