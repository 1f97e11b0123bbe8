#include "map/dry/rim_course.hpp"

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

}  // namespace

RimCourse::RimCourse(const RimScene<double>& scene, const RimMotion& motion, const ContactState<double>& start,
                     double most)
    : scene_(scene),
      motion_(motion),
      station_(rim_station(scene, motion, 0.0, {start.psi, start.ut, start.spin, 0, 0})) {
    const double along = along_wall(scene, start);
    stiff_ = 0.25 * scene.deceleration / scene.inertia_factor();
    scale_ = scene.body->beta + scene.deceleration + along * along * scene.body->inverse_inner;
    if (!scene.is_dish || motion.rolls() || start.ut != 0 || start.spin != 0) return;
    const Creep creep =
        creep_from_rest(scene, motion, start.psi, std::min(most, creep_lasts(scene, motion, start.psi)));
    station_ = rim_station(scene, motion, creep.time,
                           {start.psi - creep.time, creep.ut, creep.spin, 0.5 * creep.spin * creep.time, 0});
    end_spin();
}

/// Near ρν′ = 0, S = 0 the direction of the floor's friction turns within the time in which the disk comes there.
double RimCourse::longest() const {
    if (motion_.rests || detail::goes_in_line(scene_, motion_, station_.y[2])) return longest_step;
    const ContactState<double> z = contact_of(station_.y);
    const Body<double>& body = *scene_.body;
    const double across = scene_.is_dish ? 0 : body.beta * std::sin(z.psi);
    const double along = along_wall(scene_, z) + (scene_.is_dish ? 0 : body.beta * std::cos(z.psi));
    const double slip = std::hypot(across, along) + body.alpha * std::fabs(z.spin);
    const double change = std::fabs(station_.rate[1]) + 2 * body.alpha * std::fabs(station_.rate[2]) +
                          (scene_.is_dish ? 0 : body.beta) + stiff_;  // of a table as the wall turns
    const double to_stop =
        slip < longest_step * change ? std::max(detail::shortest_step, 0.5 * slip / change) : longest_step;
    // How |U| − α|S| changes now, and how much more until it would be 0 at jerks of the scale of accelerations.
    const double turning = station_.rate[0], spin_rate = body.alpha * station_.rate[2];
    const double along_rate =
        station_.rate[1] - spin_rate - (scene_.is_dish ? 0 : body.beta * std::sin(z.psi) * turning);
    const double across_rate = scene_.is_dish ? 0 : body.beta * std::cos(z.psi) * turning;
    const double speed = std::hypot(across, along), apart = std::fabs(speed - body.alpha * std::fabs(z.spin));
    const double slides = speed > 0 ? (across * across_rate + along * along_rate) / speed : 0;
    const double nears = std::fabs(slides - std::copysign(spin_rate, z.spin * station_.rate[2]));
    return std::min(
        {to_stop, longest_step,
         scene_.pressure->step_to_border(body, {across, along}, z.spin, {body.alpha, 0},
                                         nears + std::sqrt(2 * scale_ * (1 + std::fabs(turning)) * apart))});
}

void RimCourse::advance(double most) {
    const auto rate = [this](double, const RimPlace<double>& y) { return detail::rim_rate(scene_, motion_, y); };
    const double speed = 1 + std::fabs(station_.y[1]), spin = 1 + std::fabs(station_.y[2]);
    const RimPlace<double> tolerance{tolerance_of_step, tolerance_of_step * speed, tolerance_of_step * spin,
                                     tolerance_of_step * spin, tolerance_of_step * speed * speed};
    const auto taken = detail::step_within<5>(tolerance, rate, station_.time, station_.y, station_.rate,
                                              std::min({proposed_, longest(), most}));
    before_ = station_;
    step_ = taken.length;
    proposed_ = std::max(detail::shortest_step, taken.proposed);
    station_ = rim_station(scene_, motion_, before_.time + step_, taken.place);
    end_spin();
}

/// Along a wall without friction the floor alone turns the disk, less and less.
void RimCourse::end_spin() {
    double& spin = station_.y[2];
    if (scene_.mu != 0 || !scene_.is_dish || spin == 0 || scene_.body->alpha * std::fabs(spin) > least_spin) return;
    station_.y[1] -= scene_.body->alpha * spin;  // ρν′ stays
    spin = 0;
    motion_.heading = station_.y[1] < 0 ? -1 : 1;
    station_ = rim_station(scene_, motion_, station_.time, station_.y);
}

/// Hermite's cubic.
RimPlace<double> RimCourse::about(double h) const {
    const double t = h / step_, rest = 1 - t;
    RimPlace<double> y{};
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = rest * rest * ((1 + 2 * t) * before_.y[i] + h * before_.rate[i]) +
               t * t * ((3 - 2 * t) * station_.y[i] - rest * step_ * station_.rate[i]);
    return y;
}

RimCourse::Conditions RimCourse::conditions(const RimPlace<double>& y) const {
    Conditions values{};
    for (std::size_t i = 0; i < rim_conditions; ++i) values[i] = rim_condition(scene_, motion_, contact_of(y), i);
    return values;
}

double RimCourse::condition(double h, std::size_t which) const {
    return rim_condition(scene_, motion_, contact_of(after(h)), which);
}

double RimCourse::locate(std::size_t which, double from, double to) const {
    const auto value = [&](double h) { return condition(h, which); };
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

std::optional<RimCourse::Failure> RimCourse::failure() const {
    // Between stations places are first taken from the cubic through both. What is so near to zero that its error, of
    // fourth order, could hide a sign is looked at by the integration itself.
    const double turned = step_ * (1 + std::fabs(before_.rate[0]));
    const double near = scale_ * (0.05 * turned * turned * turned * turned + 1e-12);
    Conditions before = conditions(before_.y);
    double from = 0;
    for (int part = 1; part <= parts_per_step; ++part) {
        const double to = part == parts_per_step ? step_ : step_ * part / parts_per_step;
        Conditions now = conditions(part == parts_per_step ? station_.y : about(to));
        if (part < parts_per_step && *std::min_element(now.begin(), now.end()) < near) now = conditions(after(to));
        std::optional<Failure> first;
        const auto note = [&](std::size_t which, double failed) {
            const double time = locate(which, from, failed);
            if (!first || time < first->time) first = Failure{time, which};
        };
        for (std::size_t i = 0; i < rim_conditions; ++i) {
            if (now[i] < 0) {
                note(i, to);
                continue;
            }
            if (!(before[i] > 0)) continue;
            const double middle = rim_condition(scene_, motion_, contact_of(about(0.5 * (from + to))), i);
            if (lowest_of_parabola(before[i], middle, now[i]) > near) continue;
            if (middle >= std::min(before[i], now[i])) continue;
            std::uintmax_t iterations = 40;
            const auto lowest = boost::math::tools::brent_find_minima([&](double h) { return condition(h, i); }, from,
                                                                      to, 26, iterations);
            if (lowest.second < 0) note(i, lowest.first);
        }
        if (first) return first;
        before = now;
        from = to;
    }
    return {};
}

bool RimCourse::has_stopped() const {
    if (!scene_.is_dish || motion_.rolls()) return false;
    const ContactState<double> z = contact_of(station_.y);
    const double speed = std::fabs(along_wall(scene_, z)) + scene_.body->alpha * std::fabs(z.spin);
    return speed <= speed_left_at_stop(scene_.deceleration) && station_.time > 0 &&
           rest_on_rim(scene_, z.psi).reserve > 0;
}

}  // namespace swirl
