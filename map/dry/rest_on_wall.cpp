#include "map/dry/rest_on_wall.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace swirl {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The reserve of rest is known to less than this, of a_f.
constexpr double at_border = 1e-7;

bool is_at_rest(const DryWall<double>& wall, const ContactState<double>& z) {
    return wall.is_dish && z.ut == 0 && z.spin == 0;
}

/// Motions (V, ω) with w·V = 1: V = ŵ(1 + i across)/β, ω = turning/αβ.
struct Plane {
    double across, turning;
};

/// factors · (across, turning) ≤ limit
struct Bound {
    Plane factors;
    double limit;

    double value_at(const Plane& p) const { return factors.across * p.across + factors.turning * p.turning; }
};

/// What is looked at of a rest: the motions with w·V = 1 that the contacts do not hold back.
class Rest {
public:
    Rest(const DryWall<double>& wall, Support support, const ContactState<double>& z)
        : wall_(wall), body_(wall.contact.body), arm_(arm_on_wall(body_.alpha, support, z.chi)), pull_(cis(-z.psi)) {
        bound_by(arm_, {1, 0});
        if (support != Support::edge) return;
        const Vec2<double> other = cis(2 * wall.contact.half_chord);
        bound_by(body_.alpha * times(other, cis(wall.contact.widest_chi)), other);
    }

    /// ŵ, along n and t.
    const Vec2<double>& pull() const { return pull_; }

    /// ⟨|V + iωρ|⟩ and the means of its direction at V = ŵ(1 + i across), ω = turning/α.
    double mean_speed(const Plane& p) const {
        const MeanSlip<double> mean = mean_at(p);
        const Vec2<double> velocity = times(pull_, Vec2<double>{1, p.across});
        return dot(velocity, mean.direction) + p.turning / body_.alpha * mean.moment;
    }
    MeanSlip<double> mean_at(const Plane& p) const {
        return wall_.pressure->mean_slip(body_, times(pull_, Vec2<double>{1, p.across}), p.turning / body_.alpha, arm_);
    }

    /// Where the mean speed is least; nothing if the contacts hold every motion back.
    std::optional<Plane> slowest() const {
        const auto outside = [](const Bound& bound) { return bound.limit < 0; };
        if (std::none_of(bounds_.begin(), bounds_.end(), outside)) return Plane{0, 0};
        std::optional<Plane> best;
        double least = infinity;
        for (const Bound& bound : bounds_) {
            if (!outside(bound)) continue;
            const auto on = slowest_on(bound);
            if (!on) continue;
            const double speed = mean_speed(*on);
            if (speed < least) best = on, least = speed;
        }
        return best;
    }

private:
    /// u_n + sμu_t ≤ 0 at a contact, s = ±1.
    ///   normal  n of the contact, in the axes of the first one
    void bound_by(const Vec2<double>& arm, const Vec2<double>& normal) {
        for (const int s : {1, -1}) {
            const Vec2<double> along = normal + (s * wall_.contact.mu) * quarter_turned(normal);
            const Vec2<double> swept = quarter_turned(arm);
            bounds_.push_back(
                {{dot(quarter_turned(pull_), along), dot(swept, along) / body_.alpha}, -dot(pull_, along)});
            if (wall_.contact.mu == 0) break;
        }
    }

    /// On the line that a bound is, as far as the others let it.
    std::optional<Plane> slowest_on(const Bound& bound) const {
        const Plane& f = bound.factors;
        const double square = f.across * f.across + f.turning * f.turning;
        if (!(square > 0)) return {};
        const Plane foot{bound.limit * f.across / square, bound.limit * f.turning / square};
        const double length = std::sqrt(square);
        const Plane direction{-f.turning / length, f.across / length};
        const auto point = [&](double t) {
            return Plane{foot.across + t * direction.across, foot.turning + t * direction.turning};
        };
        double from = -infinity, to = infinity;
        for (const Bound& other : bounds_) {
            if (&other == &bound) continue;
            const double rate = other.factors.across * direction.across + other.factors.turning * direction.turning;
            const double room = other.limit - other.value_at(foot);
            if (rate > 0)
                to = std::min(to, room / rate);
            else if (rate < 0)
                from = std::max(from, room / rate);
            else if (room < 0)
                return {};
        }
        if (!(from <= to)) return {};
        // |across| and half of |turning| times ⟨|ρ|⟩/α are below the mean speed: no slower one is farther away.
        const double nearest = std::clamp(0.0, from, to);
        const double farthest = std::fabs(nearest) + mean_speed(point(nearest)) * (2 + 4 / wall_.pressure->distance());
        from = std::max(from, -farthest);
        to = std::min(to, farthest);
        const auto speed = [&](double t) { return mean_speed(point(t)); };
        std::uintmax_t iterations = 80;
        const auto inside = boost::math::tools::brent_find_minima(speed, from, to, 30, iterations);
        double best = inside.first, least = inside.second;
        for (const double end : {from, to})
            if (const double at = speed(end); at < least) best = end, least = at;
        return point(best);
    }

    const DryWall<double>& wall_;
    const Body<double>& body_;
    Vec2<double> arm_, pull_;
    std::vector<Bound> bounds_;
};

/// A motion from rest, and the growth of (u_t, αS) in it.
struct FromRest {
    DryMotion motion;
    double growth;
};

/// Without friction of the wall nothing turns a disk.
std::optional<FromRest> slide_from_rest(const DryWall<double>& wall, const ContactState<double>& z) {
    const double pull = -wall.contact.body.beta * std::sin(z.psi), growth = std::fabs(pull) - wall.deceleration;
    if (!(growth > 0)) return {};
    return FromRest{{Support::rim, ContactMotion::sliding_forward, false, pull < 0 ? -1.0 : 1.0, 0}, growth};
}

/// A slip from rest: u_t′ : αS′ as u_t : αS, the ratio on which the floor's push depends, and to which ratios beside it
/// come.
std::optional<FromRest> slip_from_rest(const DryWall<double>& wall, Support support, const ContactState<double>& z,
                                       ContactMotion kind) {
    const double mu = wall.contact.mu;
    if (mu == 0 && support == Support::rim) return slide_from_rest(wall, z);
    struct Begin {
        double across, growth;  ///< of (u_t, αS) across their direction and along it
        bool is_pressed;
    };
    const ContactState<double> still{z.psi, z.chi, 0, 0};
    const auto motion_at_angle = [&](double angle) {
        return DryMotion{support, kind, false, std::cos(angle), std::sin(angle)};
    };
    const auto begin = [&](const DryMotion& motion) {
        const Reaction<double> r = reaction_over(wall, motion, still);
        const double turning = wall.contact.body.alpha * r.spin_rate;
        return Begin{motion.slipping * turning - motion.turning * r.ut_rate,
                     motion.slipping * r.ut_rate + motion.turning * turning, r.normal >= 0 && r.stiffness > 0};
    };
    const auto across = [&](double angle) { return begin(motion_at_angle(angle)).across; };
    // Forward u_t > 0; without friction it may be either.
    constexpr int parts = 48;
    const double half = pi<double>() / 2, first = kind == ContactMotion::sliding_backward ? half : -half;
    const double whole = mu == 0 ? 2 * pi<double>() : pi<double>();
    constexpr double apart = 1e-9;  // from the ends, at which it sticks
    std::vector<double> ends;
    for (int k = 0; k <= parts; ++k) ends.push_back(first + whole * k / parts);
    if (mu > 0) ends.front() += apart, ends.back() -= apart;
    for (int k = 0; k < parts; ++k) {
        const double low = ends[static_cast<std::size_t>(k)], high = ends[static_cast<std::size_t>(k) + 1];
        const double before = across(low), after = across(high);
        if (!(before >= 0 && after < 0)) continue;  // else ratios beside it move away from it
        double root = low;
        if (before > 0) {
            std::uintmax_t iterations = 80;
            root = boost::math::tools::toms748_solve(across, low, high, before, after,
                                                     boost::math::tools::eps_tolerance<double>(50), iterations)
                       .first;
        }
        const DryMotion motion = motion_at_angle(root);
        const Begin at = begin(motion);
        if (at.growth > 0 && at.is_pressed) return FromRest{motion, at.growth};
    }
    return {};
}

std::optional<FromRest> slip_from_rest(const DryWall<double>& wall, Support support, const ContactState<double>& z) {
    const auto forward = slip_from_rest(wall, support, z, ContactMotion::sliding_forward);
    if (forward || wall.contact.mu == 0) return forward;
    return slip_from_rest(wall, support, z, ContactMotion::sliding_backward);
}

/// The body turns about the vertex (rolls on the rim), which friction holds.
std::optional<DryMotion> turn_from_rest(const DryWall<double>& wall, Support support, const ContactState<double>& z) {
    if (!(wall.contact.mu > 0)) return {};
    for (const double turning : {1.0, -1.0}) {
        const DryMotion motion{support, ContactMotion::sticking, false, 0, turning};
        const Reaction<double> r = reaction_over(wall, motion, z);
        if (r.reserve >= 0 && r.normal >= 0 && turning * r.spin_rate > 0) return motion;
    }
    return {};
}

std::optional<DryMotion> slide_on_edge_from_rest(const DryWall<double>& wall, const ContactState<double>& z) {
    for (const double turning : {1.0, -1.0}) {
        const auto kind =
            turning > 0 || wall.contact.mu == 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
        const DryMotion motion{Support::edge, kind, false, turning, turning};
        const Reaction<double> r = reaction_over(wall, motion, z);
        if (r.stiffness > 0 && r.normal >= 0 && r.second >= 0 && turning * r.spin_rate > 0) return motion;
    }
    return {};
}

/// The swirl pulls the vertex off the wall. (And β > a_f, else the floor would hold it.)
bool is_pulled_off(const ContactState<double>& z) {
    return std::cos(z.psi) <= 0;
}

/// An edge that leaves the wall with one of its vertices.
///   begins  contact does: at a vertex that in free flight would not leave
std::optional<DryChoice> lift_from_rest(const DryWall<double>& wall, const ContactState<double>& edge, int vertex_step,
                                        bool begins) {
    for (const int step : {0, 1}) {
        const ContactState<double> z = step == 0 ? edge : other_end(wall.contact, edge);
        if (begins && is_pulled_off(z)) continue;
        const auto choice = [&](const DryMotion& motion) -> std::optional<DryChoice> {
            const Reaction<double> r = reaction_over(wall, motion, z);
            const double turning = r.spin_rate - r.ut_rate;  // χ″: away from |χ| = χ_m
            if (!((step == 0 ? turning : -turning) > 0)) return {};
            return DryChoice{{true, Support::vertex, motion.motion, z, vertex_step + step}, motion};
        };
        if (const auto turns = turn_from_rest(wall, Support::vertex, z))
            if (const auto lifts = choice(*turns)) return lifts;
        if (const auto slips = slip_from_rest(wall, Support::vertex, z))
            if (const auto lifts = choice(slips->motion)) return lifts;
    }
    return {};
}

/// As `choose_motion`, an edge whose contact begins has as few vertices as it can.
DryChoice from_rest(const DryWall<double>& wall, Support support, const ContactState<double>& z, int vertex_step,
                    ContactEvent before) {
    const bool begins = before == ContactEvent::landing || before == ContactEvent::strike;
    DryChoice stays{{true, support, ContactMotion::sticking, z, vertex_step}, {support}};
    stays.motion.rests = true;
    if (begins && support == Support::edge && wall.contact.body.beta > wall.deceleration)
        if (const auto lifts = lift_from_rest(wall, z, vertex_step, true)) return *lifts;
    const double reserve = rest_reserve(wall, support, z);
    if (before != ContactEvent::slip && reserve >= 0) return stays;
    DryChoice leaves = stays;
    leaves.choice.stays = false;
    if (support != Support::edge) {
        if (is_pulled_off(z)) return leaves;
        if (const auto turns = turn_from_rest(wall, support, z)) return {stays.choice, *turns};
        if (const auto slips = slip_from_rest(wall, support, z)) {
            stays.choice.motion = slips->motion.motion;
            return {stays.choice, slips->motion};
        }
    } else {
        if (is_pulled_off(z) && is_pulled_off(other_end(wall.contact, z))) return leaves;
        if (const auto slides = slide_on_edge_from_rest(wall, z)) {
            stays.choice.motion = slides->motion;
            return {stays.choice, *slides};
        }
        if (const auto lifts = lift_from_rest(wall, z, vertex_step, false)) return *lifts;
    }
    // Within rounding of the border it rests on, until what follows surely begins.
    if (std::fabs(reserve) < at_border * wall.deceleration) return stays;
    leaves.choice.resolved = false;
    return leaves;
}

}  // namespace

HeldAtRest held_at_rest(const DryWall<double>& wall, Support support, const ContactState<double>& z) {
    const Body<double>& body = wall.contact.body;
    const double beta = body.beta;
    HeldAtRest held;
    if (beta == 0) return held;
    const Rest rest(wall, support, z);
    Vec2<double> push{0, 0};  // of the floor, and its torque
    double torque = 0;
    if (const auto slowest = rest.slowest()) {
        held.least = beta / rest.mean_speed(*slowest);
        const MeanSlip<double> mean = rest.mean_at(*slowest);
        push = -held.least * mean.direction;
        torque = -held.least * mean.moment;
    }
    const Vec2<double> force = -1.0 * (beta * rest.pull() + push);  // the wall's
    if (support != Support::edge) {
        held.normal = -force.x;
        held.friction = force.y;
        return held;
    }
    // Along the direction of the edge's middle; Σf by the torque about the dish's centre.
    const Vec2<double> in_middle = seen_from(cis(wall.contact.half_chord), force);
    held.friction = body.outer * in_middle.y - torque;
    held.normal = edge_normals(wall.contact, in_middle, held.friction)
                      .nearest_to(-in_middle.x / std::cos(wall.contact.half_chord));
    return held;
}

DryChoice choose_dry_motion(const DryWall<double>& wall, Support support, const ContactState<double>& state,
                            int vertex_step, ContactEvent before) {
    if (is_at_rest(wall, state)) return from_rest(wall, support, state, vertex_step, before);
    const double alpha = wall.contact.body.alpha;
    const DryMotion moving = motion_at(support, ContactMotion::sliding_forward, alpha, state);
    const MotionChoice<double> choice =
        choose_motion(scene_at(wall, moving, state), support, state, vertex_step, before);
    return {choice, motion_at(choice.support, choice.motion, alpha, choice.state)};
}

Creep creep_from_rest(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& z,
                      double time) {
    DryMotion last = motion;
    const auto growth = [&](double later) {
        const auto slip = slip_from_rest(wall, motion.support, {z.psi - later, z.chi, 0, 0}, motion.motion);
        if (slip) last = slip->motion;
        return slip ? slip->growth : 0.0;
    };
    double size = 0;
    if (time > 0) size = boost::math::quadrature::gauss<double, 7>::integrate(growth, 0.0, time);
    growth(time);
    Creep creep;
    creep.time = time;
    ContactState<double>& state = creep.state;
    state.ut = size * last.slipping;
    state.spin = size * last.turning / wall.contact.body.alpha;
    creep.turned = 0.5 * state.spin * time;
    const bool on_vertex = motion.support == Support::vertex;
    const double along =
        on_vertex ? state.ut : (state.ut - wall.contact.body.alpha * state.spin) * wall.contact.body.inverse_inner;
    state.psi = z.psi - time + 0.5 * along * time;
    state.chi = on_vertex ? z.chi + 0.5 * (state.spin - state.ut) * time : z.chi;
    return creep;
}

double creep_lasts(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& z) {
    constexpr double soon = 1e-4;  // in which the growth's rate hardly changes, nor is lost in rounding
    const auto growth = [&](double later) {
        const auto slip = slip_from_rest(wall, motion.support, {z.psi - later, z.chi, 0, 0}, motion.motion);
        return slip ? slip->growth : 0.0;
    };
    const double size = 1e-6 * wall.deceleration, now = growth(0), rate = std::max(0.0, (growth(soon) - now) / soon);
    const double sum = now + std::sqrt(now * now + 2 * rate * size);  // now t + ½ rate t² = size
    constexpr double longest = 0.01;  // in which ψ, and with it the growth's rate, hardly changes
    return sum > 0 ? std::min(2 * size / sum, longest) : longest;
}

DryMotion dry_motion_at(const DryWall<double>& wall, Support support, ContactMotion motion,
                        const ContactState<double>& z) {
    if (is_at_rest(wall, z)) {
        if (motion != ContactMotion::sticking && support != Support::edge)
            if (const auto slip = slip_from_rest(wall, support, z, motion)) return slip->motion;
        if (rest_reserve(wall, support, z) >= 0 || (motion == ContactMotion::sticking && support == Support::edge)) {
            DryMotion rest{support};
            rest.rests = true;
            return rest;
        }
        if (support == Support::edge)
            if (const auto slides = slide_on_edge_from_rest(wall, z)) return *slides;
        if (const auto turns = turn_from_rest(wall, support, z)) return *turns;
    }
    return motion_at(support, motion, wall.contact.body.alpha, z);
}

}  // namespace swirl
