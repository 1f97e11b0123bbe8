#include "map/orbit/dry_path.hpp"

#include <algorithm>

namespace swirl {

DryPath::DryPath(const Scene<double>& scene, const FlightBegin& begin, double lasts)
    : body_(make_body(detail::over_smooth_floor(scene))),
      pressure_(std::make_shared<const UniformPressure>(scene.sides)) {
    Flight<double> start;
    start.phase = cis(begin.time);
    start.beta = body_.beta;
    start.centre = begin.centre - start.beta * start.phase;
    start.velocity = begin.velocity;
    start.arm = body_.alpha * cis(begin.angle);
    start.spin = begin.spin;
    flight_ = {start, &body_, pressure_.get(), scene.floor_deceleration(), scene.floor == Floor::dish};
    DryCourse course(flight_);
    stations_.push_back(course.station());
    while (!course.has_stopped() && course.station().time < lasts) {
        course.advance();
        stations_.push_back(course.station());
    }
    has_stopped_ = course.has_stopped();
}

DryPath::Place DryPath::at(double later) const {
    const auto after = std::upper_bound(stations_.begin(), stations_.end(), later,
                                        [](double time, const Station<double>& at) { return time < at.time; });
    const Station<double>& before = after == stations_.begin() ? *after : *(after - 1);
    const bool rests = has_stopped_ && after == stations_.end();
    const double since = rests ? 0 : later - before.time;
    const Slowing<double> y = since == 0 ? before.y : slowing_after(flight_, before, since);
    const DryMoment<double> moment = dry_moment<Shape::disk>(flight_, before.time + since, y);
    // Where it rests it stays in the dish, or in the laboratory.
    const Vec2<double> swirl = rests && flight_.is_dish
                                   ? flight_.start.beta * turned(flight_.start.phase, cis_minus_one(later))
                                   : moment.at.swirl;
    return {moment.at.centre + swirl, rests ? 0 : moment.spin, moment.turned};
}

BendFlight dry_paths(const Scene<double>& scene) {
    if (!scene.has_dry_floor()) return {};
    return [scene](const FlightBegin& begin, double lasts) {
        return std::make_shared<const DryPath>(scene, begin, lasts);
    };
}

}  // namespace swirl
