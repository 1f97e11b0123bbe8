#include "map/orbit/trajectory_segment.hpp"

#include "map/contact/contact_series.hpp"

#include <cmath>
#include <stdexcept>

namespace swirl {

namespace {

/// The body's centre on the wall: β w + n − α r, of a disk β w + (1 − α) n; in R_c.
Vec2<double> centre_on_wall(const ContactScene<double>& scene, const ContactState<double>& state, double t) {
    const Vec2<double> swirl = cis(t);
    const Vec2<double> n = times(swirl, cis(state.psi));
    const Vec2<double> r = scene.is_disk() ? n : times(n, cis(state.chi));
    const Vec2<double> own = scene.body.beta * swirl + (n - scene.body.alpha * r);
    return scene.body.corner == 0 ? own : scene.body.unit * own;
}

/// In flight over a floor that drags: the lab's P = P₀ + U D(τ) + (w − h w₀)-part, (1 − h) w₀ E(τ), with U from where
/// the flight ends.
Moment moment_over_floor(const ContactScene<double>& scene, const TrajectorySegment& segment, double later,
                         double lasts) {
    const FloorDrag<double>& floor = segment.floor;
    const Vec2<double> start = scene.body.beta * cis(segment.start);
    const auto carried = [&](double time) {
        return times(Vec2<double>{1 - floor.response.x, -floor.response.y}, times(start, cis_minus_one(time)));
    };
    const double whole = decayed_time(floor.drag, lasts);
    const double share = whole > 0 ? decayed_time(floor.drag, later) / whole : 0;
    const double turned = segment.spin * decayed_time(floor.spin_drag, later);
    return {segment.from + (carried(later) + share * ((segment.to - segment.from) - carried(lasts))),
            segment.angle + turned, segment.spin * std::exp(-floor.spin_drag * later), turned};
}

}  // namespace

Moment moment_at(const ContactScene<double>& scene, const TrajectorySegment& segment, double t) {
    const double later = t - segment.start;
    if (!segment.in_contact) {
        const double lasts = segment.end - segment.start;
        if (segment.path) {
            const BentFlight::Place place = segment.path->at(later);
            return {place.centre, segment.angle + place.turned, place.spin, place.turned};
        }
        if (segment.floor.drags()) return moment_over_floor(scene, segment, later, lasts);
        const double share = lasts > 0 ? later / lasts : 0;
        const double turned = segment.spin * later;
        return {segment.from + share * (segment.to - segment.from), segment.angle + turned, segment.spin, turned};
    }
    if (segment.bent) {
        const ContactPlace place = segment.bent(segment.support, segment.motion, segment.state, later);
        return {centre_on_wall(scene, place.state, t),
                segment.angle + place.turned,
                place.state.spin,
                place.turned,
                place.normal,
                place.friction,
                place.state.ut};
    }
    const ContactSeries<double> series = contact_series(scene, segment.support, segment.motion, segment.state);
    ContactState<double> state = segment.state;
    state.psi += change_at(series.psi, later);
    state.chi += change_at(series.chi, later);
    state.spin += change_at(series.spin, later);
    const double turned = change_at(series.turned, later);
    return {centre_on_wall(scene, state, t),
            segment.angle + turned,
            state.spin,
            turned,
            value_at(series.normal, later) + value_at(series.second, later),
            value_at(series.friction, later),
            state.ut + change_at(series.ut, later)};
}

TrajectorySegmenter::TrajectorySegmenter(const Scene<double>& scene)
    // The law plays no part between impacts.
    : scene_(contact_scene(make_body(scene), scene, ImpactRule::poisson)),
      floor_(floor_drag(scene)),
      has_dry_floor_(scene.has_dry_floor()) {}

ContactSink TrajectorySegmenter::sink() {
    return [this](const ContactSums<double>& sums, Support support, ContactMotion motion,
                  const ContactState<double>& state) {
        looks_.push_back({sums, support, motion, state});
    };
}

Vec2<double> TrajectorySegmenter::centre_in_contact(const ContactState<double>& state, double t) const {
    return centre_on_wall(scene_, state, t);
}

void TrajectorySegmenter::add_contacts(const std::vector<ContactSegment>& segments) {
    const double began = time_, angle = angle_;
    double turned = 0;
    auto look = looks_.begin();
    for (const ContactSegment& segment : segments) {
        TrajectorySegment piece;
        piece.in_contact = true;
        piece.support = segment.support;
        piece.motion = segment.motion;
        piece.state = segment.from;
        piece.bent = bent_.contact;
        piece.start = began + segment.start;
        piece.angle = angle + turned;
        for (; look != looks_.end() && look->sums.time < segment.end; ++look) {
            if (!(look->sums.time > segment.start)) continue;
            piece.end = began + look->sums.time;
            trajectory_.push_back(piece);
            piece.start = piece.end;
            piece.state = look->state;
            piece.angle = angle + look->sums.turned;
        }
        piece.end = began + segment.end;
        trajectory_.push_back(piece);
        turned += segment.turned;
        time_ = piece.end;
        angle_ = angle + turned;
        spin_ = segment.to.spin;
        position_ = centre_on_wall(scene_, segment.to, time_);
        const PostImpactState<double> leaving = post_impact_state(scene_, segment.to);
        velocity_ = times(cis(time_), times(leaving.psi, Vec2<double>{leaving.vn, leaving.vt}));
    }
}

void TrajectorySegmenter::add_flight(double until, const Vec2<double>& position) {
    if (until > time_) {
        TrajectorySegment flight;
        flight.start = time_;
        flight.end = until;
        flight.angle = angle_;
        flight.spin = spin_;
        flight.from = position_;
        flight.to = position;
        flight.floor = floor_;
        if (bent_.flight)
            flight.path = bent_.flight({time_, position_, velocity_, angle_, spin_}, until - time_);
        else if (has_dry_floor_)
            throw std::logic_error("flights over a floor with dry friction are asked for as straight ones");
        trajectory_.push_back(flight);
    }
    time_ = until;
    position_ = position;
}

}  // namespace swirl
