#include "map/dry/wall_contact.hpp"

#include "map/contact/contact_follower.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace swirl {

namespace {

/// A rest is taken so much longer than it is held, so that what follows surely begins: by as much earlier all that
/// comes after would be, and its velocities differ by the square of it.
constexpr double beyond_rest = 1e-9;

/// How long the body rests: from ψ on ψ′ = −1.
///   looks  is added how often the forces of rest were looked at
double rest_lasts(const DryWall<double>& wall, Support support, const ContactState<double>& z, double longest,
                  long& looks) {
    constexpr int parts = 64;
    const auto reserve = [&](double time) {
        ++looks;
        return rest_reserve(wall, support, {z.psi - time, z.chi, 0, 0});
    };
    double from = 0;
    for (int k = 1; k <= parts && from < longest; ++k) {
        const double to = 2 * pi<double>() * k / parts;
        const double after = reserve(to);
        if (after < 0) {
            const double before = reserve(from);
            if (!(before > 0)) return std::min(longest, from + beyond_rest);
            std::uintmax_t iterations = 60;
            const double time =
                boost::math::tools::toms748_solve(reserve, from, to, before, after,
                                                  boost::math::tools::eps_tolerance<double>(48), iterations)
                    .second;
            return std::min(longest, time + beyond_rest);
        }
        from = to;
    }
    return longest;  // at any ψ, or beyond the horizon
}

/// A neighbour on the wall that strikes before it can be seen to leave it: it approaches, or leaves so slowly that the
/// forces bring it back within the rounding of χ. Nothing where it does neither.
std::optional<ContactEnd<double>> strike_at_once(const DryWall<double>& wall, const DryMotion& motion,
                                                 const ContactState<double>& z) {
    if (motion.support != Support::vertex || motion.rests) return {};
    if (wall.contact.widest_chi - std::fabs(z.chi) > chatter_tolerance<double>()) return {};
    const Reaction<double> r = reaction_over(wall, motion, z);
    const double side = z.chi < 0 ? -1 : 1, leaves = side * (z.ut - z.spin), back = side * (r.spin_rate - r.ut_rate);
    const double rounding = 64 * epsilon<double>() * (1 + std::fabs(z.ut) + std::fabs(z.spin));
    ContactEnd<double> end;
    end.event = ContactEvent::strike;
    end.state = z;
    end.state.chi = side * wall.contact.widest_chi;
    end.steps = 1;
    if (leaves < -rounding) return end;
    // An edge that has just ceased to hold lifts with χ″ = 0 (`motion_of_edge`).
    const double margin = stick_margin(scene_at(wall, motion, z), z) / wall.contact.body.alpha;
    if (std::fabs(leaves) <= rounding && std::fabs(back) <= margin) return {};
    if (!(back > 0) || leaves * leaves > 2 * back * chatter_tolerance<double>()) return {};
    const double time = 2 * std::max(0.0, leaves) / back;
    end.state.psi += (z.ut - 1) * time;
    end.state.ut += r.ut_rate * time;
    end.state.spin += r.spin_rate * time;
    end.sums = {time, z.spin * time, r.friction * (z.ut - 1) * time};
    return end;
}

/// What moves the body in a piece.
class DryMotions {
public:
    explicit DryMotions(const DryWall<double>& wall) : wall_(wall) {}

    MotionChoice<double> choose(const MotionChoice<double>& at, ContactEvent before) {
        const DryChoice next = choose_dry_motion(wall_, at.support, at.state, at.vertex_step, before);
        motion_ = next.motion;
        return next.choice;
    }
    ContactEnd<double> run(const MotionChoice<double>& choice, double duration, const ContactSink& sink,
                           long most_steps, const ContactSums<double>& before) const {
        return motion_.rests ? rest(choice.state, duration, sink, before)
                             : move(choice.state, duration, sink, most_steps, before);
    }
    bool ends_second_chatter(const MotionChoice<double>& choice, const ContactState<double>& z) const {
        const DryMotion motion = motion_at(choice.support, choice.motion, wall_.contact.body.alpha, z);
        return contact_detail::ends_second_chatter(scene_at(wall_, motion, z), choice.motion, z);
    }
    ChatterCompletion<double> completion(const PostImpactState<double>& post_impact) const {
        return dry_completion(wall_, post_impact);
    }

private:
    void show(const ContactSink& sink, const ContactSums<double>& before, double time,
              const DryPlace<double>& y) const {
        sink({before.time + time, before.turned + y[4], before.work + y[5]}, motion_.support, motion_.motion,
             contact_of(y));
    }

    ContactEnd<double> rest(const ContactState<double>& from, double duration, const ContactSink& sink,
                            const ContactSums<double>& before) const {
        constexpr long steps_per_look = 4;  // in means over the body's area
        long looks = 0;
        const double lasts = rest_lasts(wall_, motion_.support, from, duration, looks);
        const auto place = [&](double time) { return DryPlace<double>{from.psi - time, from.chi, 0, 0, 0, 0}; };
        if (sink) {
            for (double time = WallCourse::longest_step; time < lasts; time += WallCourse::longest_step)
                show(sink, before, time, place(time));
            show(sink, before, lasts, place(lasts));
        }
        return {lasts < duration ? ContactEvent::slip : ContactEvent::horizon,
                contact_of(place(lasts)),
                {lasts, 0, 0},
                false,
                steps_per_look * looks};
    }

    void show_step(const ContactSink& sink, const ContactSums<double>& before, const WallCourse& course,
                   double h) const {
        constexpr int parts = 4;
        for (int part = 1; part < parts; ++part)
            show(sink, before, course.before().time + h * part / parts,
                 dry_place_after(wall_, course.motion(), course.before(), h * part / parts));
    }

    /// Until something ends the motion.
    ContactEnd<double> move(const ContactState<double>& from, double duration, const ContactSink& sink, long most_steps,
                            const ContactSums<double>& before) const {
        if (const auto struck = strike_at_once(wall_, motion_, from)) return *struck;
        WallCourse course(wall_, motion_, from, duration);
        ContactEnd<double> end;
        const auto finish = [&](ContactEvent event, double time, const DryPlace<double>& y) {
            end.event = event;
            end.state = contact_of(y);
            if (event == ContactEvent::stick || motion_.sticks()) end.state.ut = 0;
            end.sums = {time, y[4], y[5]};
            if (sink) show(sink, before, time, y);
            return end;
        };
        const auto finish_at_rest = [&](double time, const DryPlace<double>& y) {
            finish(ContactEvent::stick, time, y);
            end.state.ut = end.state.spin = 0;
            return end;
        };
        while (course.station().time < duration && end.steps < most_steps) {
            course.advance(duration - course.station().time);
            ++end.steps;
            if (const auto failure = course.failure()) {
                if (sink) show_step(sink, before, course, failure->time);
                const DryPlace<double> y =
                    failure->time == 0 ? course.before().y
                                       : dry_place_after(wall_, course.motion(), course.before(), failure->time);
                const double time = course.before().time + failure->time;
                end.first_lifts = failure->first_lifts;
                return failure->at_rest ? finish_at_rest(time, y) : finish(failure->event, time, y);
            }
            if (sink) show_step(sink, before, course, course.step());
            if (course.has_stopped()) return finish_at_rest(course.station().time, course.station().y);
            if (sink) show(sink, before, course.station().time, course.station().y);
            if (!std::isfinite(course.station().y[2] + course.station().y[3])) break;
        }
        return finish(ContactEvent::horizon, course.station().time, course.station().y);
    }

    const DryWall<double>& wall_;
    DryMotion motion_;
};

}  // namespace

ContactPhase<double> follow_dry_contact(const DryWall<double>& wall, const ChatterCompletion<double>& completion,
                                        double horizon, const ContactSink& sink, long most_steps) {
    DryMotions motions(wall);
    contact_detail::Follower<double, DryMotions> follower{wall.contact, motions, sink, {}};
    return follower.follow_from(completion, horizon, most_steps);
}

ChatterCompletion<double> dry_completion(const DryWall<double>& wall, const PostImpactState<double>& post_impact) {
    return chatter_completion(scene_at(wall, post_impact), post_impact);
}

}  // namespace swirl
