#include "map/dry/dry_contact.hpp"

#include "map/dragged/dragged_flight.hpp"
#include "map/dry/riding.hpp"
#include "map/first_contact/conservative_advancement.hpp"
#include "map/first_contact/vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace swirl {

namespace {

using detail::Candidate;
using detail::NearestTwo;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_stations = 20'000;
constexpr int most_looks = 100'000;
/// A disk that leaves the wall from rest against the floor falls by rounding only within shorter times.
constexpr double least_fall = 1e-6;

/// Bounds from a moment on, for a time: |X′|, |X″|, |S|, |S′|, and with them g″ from above.
struct Bounds {
    double drift, spin;
    double centre_second, vertex_second;
};

Bounds bounds_from(const DryFlight<double>& flight, const DryMoment<double>& moment, double time) {
    const Body<double>& body = *flight.body;
    const double a = flight.deceleration, second = flight.start.beta + a;
    Bounds bounds;
    bounds.drift = detail::magnitude(moment.at.drift) + second * time;
    bounds.spin = std::fabs(moment.spin);  // friction never turns faster
    const double spin_rate = a * flight.pressure->distance() * body.alpha * body.inverse_inertia;
    const double rim = bounds.drift + body.alpha * bounds.spin;
    bounds.centre_second = 2 * (bounds.drift * bounds.drift + body.outer * second);
    bounds.vertex_second = 2 * (rim * rim + second + body.alpha * (bounds.spin * bounds.spin + spin_rate));
    return bounds;
}

/// No contact within it: the first root of g + g′h + ½Mh².
double safe_step(double value, double rate, double second) {
    const double inside = std::min(value, 0.0);
    const double root = std::sqrt(rate * rate - 2 * second * inside);
    if (rate >= 0) return rate + root > 0 ? -2 * inside / (rate + root) : infinity;
    return (root - rate) / second;
}

double centre_rate(const Instant<double>& at) {
    return 2 * dot(at.centre, at.drift);
}

void look_at(const DryFlight<double>& flight, const DryMoment<double>& moment, Candidate<double>& vertex) {
    const Body<double>& body = *flight.body;
    const Instant<double>& at = moment.at;
    vertex.arm = body.turned_to_vertex(at.arm, vertex.vertex);
    const Vec2<double> x = at.centre + vertex.arm;
    const Vec2<double> rate = at.drift + moment.spin * quarter_turned(vertex.arm);
    vertex.gap = {vertex_value(body, flight.start, at, vertex.arm, vertex.vertex), 2 * dot(x, rate), 0, 0};
}

void look_around(const DryFlight<double>& flight, const DryMoment<double>& moment, NearestTwo<double>& pair) {
    const Body<double>& body = *flight.body;
    pair.first.arm = body.turned_to_vertex(moment.at.arm, pair.first.vertex);
    detail::turn_to_nearest(body, moment.at.centre, moment.at.arm, pair.first);
    look_at(flight, moment, pair.first);
    const int side = cross(pair.first.arm, moment.at.centre) >= 0 ? 1 : -1;
    pair.second.vertex = body.vertex_number(pair.first.vertex + side);
    look_at(flight, moment, pair.second);
}

/// At the wall as nearly as its place or the time can say.
bool is_at_wall(const Gap<double>& gap, double time) {
    return gap.rate > 0 && (gap.value >= -2 * epsilon<double>() || -gap.value <= epsilon<double>() * time * gap.rate);
}

/// Searches from wall to wall, station by station.
template <Shape shape>
class Search {
public:
    explicit Search(const DryFlight<double>& flight) : flight_(flight), body_(*flight.body), course_(flight) {}

    DryContact find() {
        result_.moment = moment_at(course_.station(), 0);
        if (!flight_.start.struck) return find_from_here();
        Gap<double> gap = struck_gap_at_start(flight_);
        if (detail::stays(body_, flight_.start, gap)) return ended(FirstContactOutcome::sustained);
        // What rounding alone has given a velocity leaves as after a release.
        return gap.rate < -detail::rate_rounding(body_, flight_.start) ? find_from_here() : find_after_release();
    }

    DryContact find_after_release() {
        result_.moment = moment_at(course_.station(), 0);
        if (course_.has_stopped()) return stopped();
        if (strikes_at_once()) return result_;
        const bool from_rest = is_at_rest();
        do course_.advance();
        while (from_rest && course_.station().time < least_fall && !course_.has_stopped());
        if (course_.has_stopped() && course_.station().time < least_fall) return stopped();  // but for rounding at once
        double clear = std::min(course_.step(), neighbours_last());
        for (int halvings = 0; !falls_until(clear); clear *= 0.5)
            if (++halvings > 60) return ended(FirstContactOutcome::unresolved);
        result_.moment = moment_at(course_.before(), clear);
        return meets_wall_on_step(clear) ? result_ : find_from_here();
    }

private:
    DryContact find_from_here() {
        for (int stations = 0; stations < most_stations; ++stations) {
            if (course_.has_stopped()) return stopped();
            if (rides(flight_, result_.moment)) return ended(FirstContactOutcome::no_contact);
            course_.advance();
            if (meets_wall_on_step()) return result_;
            if (result_.found.steps > most_looks) break;
        }
        return ended(FirstContactOutcome::unresolved);
    }

    DryContact ended(FirstContactOutcome outcome) {
        result_.found.outcome = outcome;
        return result_;
    }

    /// A body that has stopped on a dish goes along with it for ever; on a table it waits for the wall.
    DryContact stopped() {
        if (flight_.is_dish) return ended(FirstContactOutcome::no_contact);
        result_.has_stopped = true;
        return result_;
    }

    DryMoment<double> moment_at(const Station<double>& station, double later) const {
        if (later == 0) return dry_moment<shape>(flight_, station.time, station.y);
        return dry_moment<shape>(flight_, station.time + later, slowing_after(flight_, station, later));
    }

    /// Against the floor, but for rounding.
    bool is_at_rest() const {
        const Flight<double>& start = flight_.start;
        const double sliding = detail::magnitude(detail::against_floor(flight_, start.velocity, start.phase));
        const double rounding = 64 * epsilon<double>() * (start.beta + detail::magnitude(start.velocity));
        return sliding <= rounding && body_.alpha * std::fabs(start.spin) <= rounding;
    }

    /// At the release: the neighbour of the vertex that leaves is at the wall and approaches.
    bool strikes_at_once() {
        if constexpr (shape == Shape::polygon) {
            return a_vertex_strikes();
        } else {
            return false;
        }
    }

    /// For so long none but the vertex that leaves and its neighbours comes near the wall.
    double neighbours_last() const {
        if constexpr (shape == Shape::disk) {
            return infinity;
        } else {
            return two_are_enough(bounds_from(flight_, result_.moment, course_.step()));
        }
    }

    /// Does the gap of what leaves the wall fall on the last step until then?
    bool falls_until(double later) const {
        constexpr int moments = 10;
        Gaps before = course_.before().time > 0 ? gaps_at(moment_at(course_.before(), 0)) : Gaps{};
        for (int k = 1; k <= moments; ++k) {
            const Gaps gaps = gaps_at(moment_at(course_.before(), later * k / moments));
            for (std::size_t i = 0; i < gaps.size(); ++i)
                if (!(gaps[i] < before[i])) return false;
            before = gaps;
        }
        return true;
    }

    /// Of a disk g; of a polygon those of the vertex that leaves and of its neighbours, of which one that was not on
    /// the wall has −τ as long as it is inside.
    using Gaps = std::array<double, shape == Shape::disk ? 1 : 3>;

    Gaps gaps_at(const DryMoment<double>& moment) const {
        if constexpr (shape == Shape::disk) {
            return {centre_value(body_, flight_.start, moment.at)};
        } else {
            const int vertices[] = {0, 1, body_.sides - 1};
            Gaps gaps{};
            for (std::size_t i = 0; i < gaps.size(); ++i) {
                // By what it has moved: ½|x|² grows by x₀·Δ + ½|Δ|².
                const Vec2<double> start =
                    flight_.start.centre + body_.turned_to_vertex(flight_.start.arm, vertices[i]);
                const Vec2<double> moved = moment.at.moved + body_.turned_to_vertex(moment.at.arm_moved, vertices[i]);
                const double change = dot(start, moved) + 0.5 * dot(moved, moved);
                const double begin = 0.5 * (dot(start, start) - 1);
                const bool was_on_wall = i == 0 || (begin > -1e-12 && !approaches(start, vertices[i]));
                const bool is_inside = begin + change < 0;
                gaps[i] = was_on_wall ? change : is_inside ? -moment.at.time : infinity;
            }
            return gaps;
        }
    }

    /// Does a vertex come towards the wall at the start?
    bool approaches(const Vec2<double>& place, int vertex) const {
        const Vec2<double> arm = body_.turned_to_vertex(flight_.start.arm, vertex);
        const Vec2<double> drift = flight_.start.velocity - quarter_turned(flight_.start.beta * flight_.start.phase);
        const Vec2<double> rate = drift + flight_.start.spin * quarter_turned(arm);
        return 2 * dot(place, rate) > detail::rate_rounding(body_, flight_.start);
    }

    /// Between the last two stations, from so long after the first.
    bool meets_wall_on_step(double later = 0) {
        const Station<double>& from = course_.before();
        const double whole = course_.step();
        while (true) {  // ends: contact, the next station, or too many looks
            if (++result_.found.steps > most_looks) return false;
            const double step = step_from_moment(whole - later);
            if (result_.found.outcome == FirstContactOutcome::contact) return true;
            if (!(step < whole - later)) break;
            later += step;
            result_.moment = moment_at(from, later);
        }
        result_.moment = moment_at(course_.station(), 0);
        return false;
    }

    /// A step from the moment that touches nothing, or the contact there.
    double step_from_moment(double left) {
        const Bounds bounds = bounds_from(flight_, result_.moment, left);
        if constexpr (shape == Shape::disk)
            return step_of_disk(bounds);
        else
            return step_of_polygon(bounds);
    }

    double step_of_disk(const Bounds& bounds) {
        const Instant<double>& at = result_.moment.at;
        const Gap<double> gap{centre_value(body_, flight_.start, at), centre_rate(at), 0, 0};
        if (at.time > 0 && is_at_wall(gap, at.time)) {
            result_.found.outcome = FirstContactOutcome::contact;
            result_.found.arm = (body_.alpha / body_.inner) * at.centre;
            return 0;
        }
        return step_at_least(safe_step(gap.value, gap.rate, bounds.centre_second));
    }

    double step_of_polygon(const Bounds& bounds) {
        const Instant<double>& at = result_.moment.at;
        const double value = centre_value(body_, flight_.start, at);
        const double ring = 0.25 * (body_.outer * body_.outer - body_.inner * body_.inner);
        const double by_circle = safe_step(value, centre_rate(at), bounds.centre_second);
        if (value < -ring) return step_at_least(by_circle);
        if (a_vertex_strikes()) return 0;
        const double limit = two_are_enough(bounds);
        const double step = std::min(safe_step(pair_.first.gap.value, pair_.first.gap.rate, bounds.vertex_second),
                                     safe_step(pair_.second.gap.value, pair_.second.gap.rate, bounds.vertex_second));
        return step_at_least(std::max(std::min(step, limit), value < 0 ? by_circle : 0));  // both are safe
    }

    /// At the moment one of the two nearest vertices is on the wall, and approaches.
    bool a_vertex_strikes() {
        look_around(flight_, result_.moment, pair_);
        if (!at_wall(pair_.first) && !at_wall(pair_.second)) return false;
        result_.found.at.time = result_.moment.at.time;
        detail::choose(pair_, 1.0, result_.found);
        return true;
    }

    /// For how long none but the two nearest vertices can come to the wall (bounds.hpp), with the bounds of this step.
    double two_are_enough(const Bounds& bounds) const {
        const double distance = detail::magnitude(result_.moment.at.centre);
        return std::min(0.5 * body_.spacing / (bounds.spin + 2 * bounds.drift / distance),
                        distance / (2 * bounds.drift));
    }

    /// Not the vertex that leaves from there at the start.
    bool at_wall(const Candidate<double>& vertex) const {
        const double time = result_.moment.at.time;
        if (time == 0 && flight_.start.struck)
            return vertex.vertex != 0 && vertex.gap.value >= 0 &&
                   vertex.gap.rate > detail::rate_rounding(body_, flight_.start);
        return is_at_wall(vertex.gap, time);
    }

    /// What is shorter than the time's rounding would not move on.
    double step_at_least(double step) const {
        return std::max(step, std::max(epsilon<double>() * result_.moment.at.time, 1e-300));
    }

    const DryFlight<double>& flight_;
    const Body<double>& body_;
    DryCourse course_;
    NearestTwo<double> pair_;
    DryContact result_;
};

}  // namespace

Gap<double> struck_gap_at_start(const DryFlight<double>& flight) {
    const Flight<double>& start = flight.start;
    const Slowing<double> rate = detail::slowing_rate(flight, 0.0, Slowing<double>{});
    const Vec2<double> swirl = start.beta * start.phase;
    const Vec2<double> drift = start.velocity - quarter_turned(swirl);
    const Vec2<double> second = swirl + Vec2<double>{rate[2], rate[3]};
    if (flight.body->sides == disk_sides)
        return {0, 2 * dot(start.centre, drift), 2 * (dot(drift, drift) + dot(start.centre, second)), 0};
    const Vec2<double> across = quarter_turned(start.arm);
    const Vec2<double> x_rate = drift + start.spin * across;
    const Vec2<double> x_second = second + rate[5] * across - start.spin * start.spin * start.arm;
    return {0, 2 * x_rate.x, 2 * (dot(x_rate, x_rate) + x_second.x), 0};
}

template <Shape shape>
DryContact first_contact(const DryFlight<double>& flight) {
    return Search<shape>(flight).find();
}

template <Shape shape>
DryContact first_contact_after_release(const DryFlight<double>& flight) {
    return Search<shape>(flight).find_after_release();
}

template DryContact first_contact<Shape::disk>(const DryFlight<double>&);
template DryContact first_contact<Shape::polygon>(const DryFlight<double>&);
template DryContact first_contact_after_release<Shape::disk>(const DryFlight<double>&);
template DryContact first_contact_after_release<Shape::polygon>(const DryFlight<double>&);

}  // namespace swirl
