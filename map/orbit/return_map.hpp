// The return map: from one impact to the next, through chatter and sustained contact where there is any.
#pragma once

#include "map/collision_map.hpp"
#include "map/contact/contact_phase.hpp"
#include "map/contact/release.hpp"
#include "map/map_list.hpp"
#include "map/orbit/outcome.hpp"
#include "map/orbit/speed_limits.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace swirl {

/// From just after an impact to just after the next.
template <class T>
struct ReturnStep {
    Outcome outcome = Outcome::completed;  ///< completed: `collision` is the next impact
    Collision<T> collision;  ///< its flight_time, normal and vertex_step are those of the whole return step
    T turned{};              ///< ∫ S dt on the way
    T contact_work{};        ///< ∫ f (u_t − 1) dt: what friction in contact and the end of chatter added to J
    std::vector<ContactSegment> contacts;
};

// What a flight of a map is beside its collision; a map over a floor that drags has its own (dragged_return.hpp).

/// ∫ S dt of the flight that begins with `start`, a Flight or the state after an impact.
template <class Map, class Start, class T>
[[gnu::always_inline]] inline T turned_in_flight(const Map&, const Start& start, const T& time) {
    return start.spin * time;
}

/// Does the map have polygons with rounded corners (map/corners)? They are not followed in contact.
template <class Map>
inline constexpr bool has_round_corners = requires {
    Map::has_round_corners;
};

/// The flight after an impact.
template <class Map, class T>
[[gnu::always_inline]] inline Flight<T> flight_after(const Map& map, const PostImpactState<T>& post_impact) {
    if constexpr (has_round_corners<Map>)
        return map.flight_after(post_impact);
    else
        return flight_from(map.body(), post_impact);
}

/// Does the map have a floor with dry friction (map/dry)?
template <class Map>
inline constexpr bool has_dry_floor = requires {
    Map::has_dry_floor;
};

// What contact of a map is; over a floor with dry friction it is one of its own (dry_return.hpp).

/// `may_chatter` after an impact: false is sure.
template <class Map, class T>
[[gnu::always_inline]] inline bool may_come_to_contact(const Map&, const ContactScene<T>& contact,
                                                       const PostImpactState<T>& post_impact) {
    return may_chatter(contact, post_impact);
}

template <class Map, class T>
ChatterCompletion<T> completion_after(const Map&, const ContactScene<T>& contact,
                                      const PostImpactState<T>& post_impact) {
    return chatter_completion(contact, post_impact);
}

template <class Map, class T>
ContactPhase<T> phase_from(const Map&, const ContactScene<T>& contact, const ChatterCompletion<T>& completion,
                           double horizon, const ContactSink& sink = {}, long most_steps = most_contact_steps) {
    return follow_contact(contact, completion, horizon, sink, most_steps);
}

/// How an orbit ends that meets the wall no more.
template <class Map>
Outcome ending_without_contact(const Map&) {
    return Outcome::no_contact;
}

/// The first impact after a release; nothing where the flight can't be begun so (`contact_after_release`).
template <class Map, class T>
std::optional<Collision<T>> collision_after_release(const Map& map, const Flight<T>& flight) {
    const auto contact = contact_after_release<Map::shape>(map.body(), flight);
    if (!contact) return {};
    Collision<T> collision;
    if (contact->outcome == FirstContactOutcome::contact)
        map.strike(flight, contact->at, contact->arm, contact->vertex, collision);
    collision.outcome = contact->outcome;
    collision.steps = contact->steps;
    collision.vertex_step = contact->vertex;
    collision.simultaneous = contact->simultaneous;
    return collision;
}

/// How many power series a return step took in contact.
template <class T>
long contact_steps(const ReturnStep<T>& step) {
    long steps = 0;
    for (const ContactSegment& segment : step.contacts) steps += segment.steps;
    return steps;
}

/// Did the body rest on an edge on the way? Then only ψ changed, ψ′ = −1, until the ψ at which the scene's numbers
/// alone end such a rest: the state after it is the same whatever was before, and DF = 0.
template <class T>
bool has_rested(const ReturnStep<T>& step) {
    return std::any_of(step.contacts.begin(), step.contacts.end(), [](const ContactSegment& segment) {
        return segment.support == Support::edge && segment.motion == ContactMotion::sticking &&
               segment.end > segment.start;
    });
}

/// How long contact may last without an impact before the orbit ends as `in_contact`, in 1/ω_s. A body that moves so
/// fast in contact that it is not followed so long (`most_contact_steps`) ends as `contact_cut`.
inline constexpr double contact_horizon = 1000;

/// F with sustained contact. For e = 1 it is the collision map itself, with one exception: where friction holds a
/// polygon's vertex its normal velocity may fall with every impact (Poisson, Stronge: B₃ couples it to friction), and
/// once it is below rounding the orbit goes on in contact. For a disk or a frictionless body |u_n| is conserved at e =
/// 1, so that there is no contact. Contact is integrated in T, as flights are.
template <class Map>
class ReturnMap {
public:
    using T = typename Map::Number;
    static constexpr Shape shape = Map::shape;

    /// The map must outlive it.
    explicit ReturnMap(const Map& map) : map_(map) {
        const auto& s = map.scene();
        if constexpr (has_round_corners<Map>) return;
        sums_chatter_ = s.restitution < T(1);
        const bool keeps_speed = shape == Shape::disk || Map::rule == ImpactRule::frictionless;
        if (!has_dry_floor<Map> && !sums_chatter_ && keeps_speed) return;
        contact_ = contact_scene(map.body(), s, Map::rule);
    }

    const Map& map() const { return map_; }
    /// What contact needs of the scene, but for a floor with dry friction; only for e < 1, or a polygon with friction.
    const ContactScene<T>& contact() const { return *contact_; }

    /// The first impact of a flight in the laboratory.
    ReturnStep<T> advance(const Flight<T>& flight) const;

    /// From just after an impact.
    ///   horizon  for how long contact without an impact is followed
    ///   sink     is called with the motion in contact
    ReturnStep<T> advance(const PostImpactState<T>& post_impact, double horizon = contact_horizon,
                          const ContactSink& sink = {}) const;

    /// A return step from the end of one, in place: for long orbits. If what is returned is not `completed`,
    /// `collision.after` is what it was, `contacts` are those after that impact, and all else is meaningless.
    Outcome advance(ReturnStep<T>& return_step, double horizon = contact_horizon, const ContactSink& sink = {}) const {
        return advance_by(return_step, horizon, sink,
                          [this](Collision<T>& collision) { map_.advance(collision.after, collision); });
    }

    /// `advance`, bit for bit, of a step in which no search from the circle's return is known to find anything
    /// (`map/batch`): without these searches.
    Outcome advance_undecided(ReturnStep<T>& return_step) const {
        return advance_by(return_step, contact_horizon, {}, [this](Collision<T>& collision) {
            map_.advance_without_return(flight_from(map_.body(), collision.after), collision);
        });
    }

    /// The chatter completion (support and state) just after an impact from which `advance` led through contact.
    ChatterCompletion<T> completion(const PostImpactState<T>& post_impact) const;

    /// The return step from a landing on; `post_impact` is the state after the impact before it.
    ReturnStep<T> advance_in_contact(const PostImpactState<T>& post_impact, const ChatterCompletion<T>& completion,
                                     double horizon = contact_horizon, const ContactSink& sink = {},
                                     long most_steps = most_contact_steps) const;

private:
    /// In place; `fly` makes the collision after `collision.after`.
    template <class Fly>
    [[gnu::always_inline]] inline Outcome advance_by(ReturnStep<T>& return_step, double horizon,
                                                     const ContactSink& sink, const Fly& fly) const;

    /// A step of no duration and no impulse: iterating F would repeat it without end.
    bool changes_nothing(const Collision<T>& c) const {
        return (contact_ || has_round_corners<Map>)&&c.flight_time == T(0) && c.impulse.normal == T(0);
    }

    static bool is_no_number(const Collision<T>& c) { return is_out_of_range(c.after, c.impulse.normal); }

    void end_if_nothing_changes(ReturnStep<T>& return_step) const {
        if (return_step.outcome == Outcome::completed && changes_nothing(return_step.collision))
            return_step.outcome = Outcome::unresolved;
    }
    static void end_before_no_number(ReturnStep<T>& return_step) {
        if (return_step.outcome != Outcome::completed || !is_no_number(return_step.collision)) return;
        return_step.outcome = Outcome::diverged;
        return_step.collision = Collision<T>{};
    }

    /// The contact state where the search found `sustained` but `chatter_completion` did not: both within rounding of
    /// the border between leaving and staying.
    ChatterCompletion<T> held(const PostImpactState<T>& post_impact) const {
        ChatterCompletion<T> completion;
        completion.support = shape == Shape::disk ? Support::rim : Support::vertex;
        completion.state = contact_state(*contact_, post_impact);
        return completion;
    }

    Outcome outcome_of(FirstContactOutcome outcome) const {
        switch (outcome) {
            case FirstContactOutcome::contact:
                return Outcome::completed;
            case FirstContactOutcome::no_contact:
                return ending_without_contact(map_);
            case FirstContactOutcome::sustained:
                if constexpr (has_round_corners<Map>) return Outcome::contact_of_corner;
                return contact_ ? Outcome::unresolved : Outcome::resting;
            case FirstContactOutcome::unresolved:
                return Outcome::unresolved;
        }
        return Outcome::unresolved;
    }

    /// The first impact after a release.
    Collision<T> fly_off(const Flight<T>& flight) const;

    ReturnStep<T> after_contact(const PostImpactState<T>& post_impact, const ContactPhase<T>& phase) const;

    /// As `after_contact`, with the work, and the names of what is no step.
    ReturnStep<T> ended_contact(const PostImpactState<T>& post_impact, const ContactPhase<T>& phase,
                                const T& work) const {
        ReturnStep<T> return_step = after_contact(post_impact, phase);
        return_step.contact_work = work;
        end_if_nothing_changes(return_step);
        end_before_no_number(return_step);
        return return_step;
    }

    const Map& map_;
    std::optional<ContactScene<T>> contact_;
    bool sums_chatter_ = false;  ///< e < 1: chatter is looked for after every impact
};

template <class Map>
auto ReturnMap<Map>::advance(const Flight<T>& flight) const -> ReturnStep<T> {
    ReturnStep<T> return_step;
    map_.advance(flight, return_step.collision);
    return_step.turned = turned_in_flight(map_, flight, return_step.collision.flight_time);
    return_step.outcome = outcome_of(return_step.collision.outcome);
    end_before_no_number(return_step);
    return return_step;
}

template <class Map>
auto ReturnMap<Map>::advance(const PostImpactState<T>& post_impact, double horizon, const ContactSink& sink) const
    -> ReturnStep<T> {
    if (sums_chatter_ && may_come_to_contact(map_, *contact_, post_impact))
        if (const ChatterCompletion<T> completion = completion_after(map_, *contact_, post_impact);
            completion.in_contact || completion.struck)
            return advance_in_contact(post_impact, completion, horizon, sink);
    ReturnStep<T> return_step = advance(flight_after(map_, post_impact));
    if (contact_ && return_step.collision.outcome == FirstContactOutcome::sustained)
        return advance_in_contact(post_impact, held(post_impact), horizon, sink);
    end_if_nothing_changes(return_step);
    return return_step;
}

template <class Map>
template <class Fly>
auto ReturnMap<Map>::advance_by(ReturnStep<T>& return_step, double horizon, const ContactSink& sink,
                                const Fly& fly) const -> Outcome {
    Collision<T>& collision = return_step.collision;
    const PostImpactState<T> post_impact = collision.after;
    if (!sums_chatter_ || !may_come_to_contact(map_, *contact_, post_impact)) [[likely]] {
        fly(collision);
        if (collision.outcome == FirstContactOutcome::contact && !changes_nothing(collision) &&
            !is_no_number(collision)) [[likely]] {
            return_step.turned = turned_in_flight(map_, post_impact, collision.flight_time);
            return_step.contact_work = T(0);
            return_step.contacts.clear();
            return return_step.outcome = Outcome::completed;
        }
        collision.after = post_impact;
    }
    ReturnStep<T> next = advance(post_impact, horizon, sink);
    if (next.outcome != Outcome::completed) {
        return_step.contacts = std::move(next.contacts);
        return next.outcome;
    }
    return_step = std::move(next);
    return Outcome::completed;
}

template <class Map>
auto ReturnMap<Map>::completion(const PostImpactState<T>& post_impact) const -> ChatterCompletion<T> {
    if (!sums_chatter_) return held(post_impact);
    const ChatterCompletion<T> completion = completion_after(map_, *contact_, post_impact);
    return completion.in_contact ? completion : held(post_impact);
}

template <class Map>
auto ReturnMap<Map>::advance_in_contact(const PostImpactState<T>& post_impact, const ChatterCompletion<T>& completion,
                                        double horizon, const ContactSink& sink, long most_steps) const
    -> ReturnStep<T> {
    const ContactPhase<T> phase = completion.struck
                                      ? struck_at_once(*contact_, post_impact)
                                      : phase_from(map_, *contact_, completion, horizon, sink, most_steps);
    return ended_contact(post_impact, phase, T(phase.sums.work + completion.jacobi));
}

template <class Map>
auto ReturnMap<Map>::fly_off(const Flight<T>& flight) const -> Collision<T> {
    const std::optional<Collision<T>> collision = collision_after_release(map_, flight);
    return collision ? *collision : map_.advance(flight);
}

template <class Map>
auto ReturnMap<Map>::after_contact(const PostImpactState<T>& post_impact, const ContactPhase<T>& phase) const
    -> ReturnStep<T> {
    ReturnStep<T> return_step;
    PostImpactState<T> end = phase.strike.after;  // after turns by Δψ and from vertex to vertex
    end.psi = renormalised(end.psi);
    end.chi = renormalised(end.chi);
    Collision<T>& collision = return_step.collision;
    T flight_time{}, flight_turned{};
    Vec2<T> flight_normal{T(1), T(0)};
    if (!phase.resolved) {
        return_step.outcome = Outcome::unresolved;
    } else if (phase.finish == ContactEvent::horizon) {
        return_step.outcome = phase.cut ? Outcome::contact_cut : Outcome::in_contact;
    } else if (phase.finish == ContactEvent::release) {
        PostImpactState<T> leaving = end;  // a release has u_n = 0
        leaving.vn = leaving.vn - contact_kinematics(map_.body(), leaving).un;
        const Flight<T> flight = flight_from(map_.body(), leaving);
        collision = fly_off(flight);
        flight_time = collision.flight_time;
        flight_turned = turned_in_flight(map_, flight, flight_time);
        flight_normal = collision.normal;
        return_step.outcome = outcome_of(collision.outcome);
    } else {
        collision.outcome = FirstContactOutcome::contact;
        collision.impulse = phase.strike.impulse;
        collision.jacobi_restitution = phase.strike.jacobi_restitution;
        collision.jacobi_friction = phase.strike.jacobi_friction;
    }
    if (phase.finish != ContactEvent::release) collision.after = end;
    // The whole return step: arg n has gone on by Δψ + t in contact, and by the flight's own turn after it.
    const T& duration = phase.sums.time;
    const Vec2<T> advance = times(seen_from(post_impact.psi, end.psi), cis(duration));
    collision.normal = times(advance, flight_normal);
    collision.flight_time = duration + flight_time;
    if constexpr (shape == Shape::polygon)
        collision.vertex_step =
            map_.body().vertex_number(static_cast<long long>(collision.vertex_step) + phase.vertex_step);
    return_step.turned = phase.sums.turned + flight_turned;
    return_step.contacts = phase.segments;
    return return_step;
}

// Compiled once, in return_map_in_*.cpp.
SWIRL_EVERY_MAP(SWIRL_DECLARE_RETURN_MAP, double)
SWIRL_EVERY_MAP(SWIRL_DECLARE_RETURN_MAP, long double)

}  // namespace swirl
