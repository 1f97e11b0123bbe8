#include "map/orbit/dry_path.hpp"

#include "map/dry/dry_map.hpp"
#include "map/dry/wall_course.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace swirl {

namespace {

/// What the flights and contacts of a scene share.
struct Surroundings {
    UniformPressure pressure;
    DryWall<double> wall;

    explicit Surroundings(const Scene<double>& scene)
        : pressure(scene.sides),
          // The law plays no part between impacts.
          wall{contact_scene(make_body(detail::over_smooth_floor(scene)), scene.mu, scene.restitution,
                             ImpactRule::poisson),
               &pressure, scene.floor_deceleration(), scene.floor == Floor::dish} {}
};

/// A flight with the stations of its integration.
class DryPath final : public BentFlight {
public:
    DryPath(std::shared_ptr<const Surroundings> around, const FlightBegin& begin, double lasts);
    Place at(double later) const override;

private:
    std::shared_ptr<const Surroundings> around_;  ///< to which the flight refers
    DryFlight<double> flight_;
    std::vector<Station<double>> stations_;
    bool has_stopped_ = false;
};

DryPath::DryPath(std::shared_ptr<const Surroundings> around, const FlightBegin& begin, double lasts)
    : around_(std::move(around)) {
    const Body<double>& body = around_->wall.contact.body;
    Flight<double> start;
    start.phase = cis(begin.time);
    start.beta = body.beta;
    start.centre = begin.centre - start.beta * start.phase;
    start.velocity = begin.velocity;
    start.arm = body.alpha * cis(begin.angle);
    start.spin = begin.spin;
    flight_ = {start, &body, &around_->pressure, around_->wall.deceleration, around_->wall.is_dish};
    DryCourse course(flight_);
    stations_.push_back(course.station());
    while (!course.has_stopped() && course.station().time < lasts) {
        course.advance();
        stations_.push_back(course.station());
    }
    has_stopped_ = course.has_stopped();
}

BentFlight::Place DryPath::at(double later) const {
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

ContactPlace contact_after(const Surroundings& around, Support support, ContactMotion kind,
                           const ContactState<double>& from, double later) {
    const DryWall<double>& wall = around.wall;
    const DryMotion motion = dry_motion_at(wall, support, kind, from);
    WallCourse course(wall, motion, from, later);
    while (course.station().time < later) course.advance(later - course.station().time);
    const DryPlace<double>& y = course.station().y;
    const ContactState<double> state = contact_of(y);
    if (motion.rests) {
        const HeldAtRest held = held_at_rest(wall, support, state);
        return {state, 0, held.normal, held.friction};
    }
    const Reaction<double> r = reaction_over(wall, course.motion(), state);
    return {state, y[4], r.normal + r.second, r.friction};
}

}  // namespace

BentPaths dry_paths(const Scene<double>& scene) {
    if (!scene.has_dry_floor()) return {};
    const auto around = std::make_shared<const Surroundings>(scene);
    BentPaths paths;
    paths.flight = [around](const FlightBegin& begin, double lasts) {
        return std::make_shared<const DryPath>(around, begin, lasts);
    };
    paths.contact = [around](Support support, ContactMotion motion, const ContactState<double>& from, double later) {
        return contact_after(*around, support, motion, from, later);
    };
    return paths;
}

}  // namespace swirl
