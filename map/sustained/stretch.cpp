#include "map/sustained/stretch.hpp"

#include "map/sustained/contact_series.hpp"

namespace swirl {

namespace {

/// The body's centre while it stands on the wall: β w + n − α r, of a disk β w + (1 − α) n.
Vec2<double> standing_centre(const ContactScene& scene, const ContactState& state, double t) {
    const Vec2<double> swirl = cis(t);
    const Vec2<double> n = times(swirl, cis(state.psi));
    const Vec2<double> r = scene.is_disk() ? n : times(n, cis(state.chi));
    return scene.body.beta * swirl + (n - scene.body.alpha * r);
}

}  // namespace

Moment moment_at(const ContactScene& scene, const Stretch& stretch, double t) {
    const double later = t - stretch.start;
    if (!stretch.in_contact) {
        const double lasts = stretch.end - stretch.start;
        const double share = lasts > 0 ? later / lasts : 0;
        const double turned = stretch.spin * later;
        return {stretch.from + share * (stretch.to - stretch.from), stretch.angle + turned, stretch.spin, turned};
    }
    const ContactSeries series = contact_series(scene, stretch.support, stretch.motion, stretch.state);
    ContactState state = stretch.state;
    state.psi += change_at(series.psi, later);
    state.chi += change_at(series.chi, later);
    state.spin += change_at(series.spin, later);
    const double turned = change_at(series.turned, later);
    return {standing_centre(scene, state, t), stretch.angle + turned, state.spin, turned};
}

StretchCutter::StretchCutter(const Scene<double>& scene)
    // The law plays no part between impacts.
    : scene_(contact_scene(make_body(scene), scene.mu, scene.restitution, ImpactRule::poisson)) {}

ContactSink StretchCutter::sink() {
    return [this](const ContactSums& sums, Support support, ContactMotion motion, const ContactState& state) {
        looks_.push_back({sums, support, motion, state});
    };
}

Vec2<double> StretchCutter::centre_in_contact(const ContactState& state, double t) const {
    return standing_centre(scene_, state, t);
}

void StretchCutter::add_contacts(const std::vector<ContactSegment>& segments) {
    const double began = time_, angle = angle_;
    double turned = 0;
    auto look = looks_.begin();
    for (const ContactSegment& segment : segments) {
        Stretch piece;
        piece.in_contact = true;
        piece.support = segment.support;
        piece.motion = segment.motion;
        piece.state = segment.from;
        piece.start = began + segment.start;
        piece.angle = angle + turned;
        for (; look != looks_.end() && look->sums.time < segment.end; ++look) {
            if (!(look->sums.time > segment.start)) continue;
            piece.end = began + look->sums.time;
            stretches_.push_back(piece);
            piece.start = piece.end;
            piece.state = look->state;
            piece.angle = angle + look->sums.turned;
        }
        piece.end = began + segment.end;
        stretches_.push_back(piece);
        turned += segment.turned;
        time_ = piece.end;
        angle_ = angle + turned;
        spin_ = segment.to.spin;
        place_ = standing_centre(scene_, segment.to, time_);
    }
}

void StretchCutter::add_flight(double until, const Vec2<double>& place) {
    if (until > time_) {
        Stretch flight;
        flight.start = time_;
        flight.end = until;
        flight.angle = angle_;
        flight.spin = spin_;
        flight.from = place_;
        flight.to = place;
        stretches_.push_back(flight);
    }
    time_ = until;
    place_ = place;
}

}  // namespace swirl
