#include "map/dry/rim_contact.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swirl {

namespace {

/// After more consecutive pieces of zero duration contact is called unresolved.
constexpr int most_idle_pieces = 50;
constexpr std::size_t most_pieces = 100'000;
/// A rest is taken so much longer than it is held, so that what follows surely begins: by as much earlier all that
/// comes after would be, and its velocities differ by the square of it.
constexpr double beyond_rest = 1e-9;

/// How long the disk rests: from ψ on ψ′ = −1.
double rest_lasts(const RimScene<double>& scene, double psi, double longest) {
    constexpr int parts = 64;
    const auto reserve = [&](double time) { return rest_on_rim(scene, psi - time).reserve; };
    double from = 0;
    for (int k = 1; k <= parts; ++k) {
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
    return longest;  // at any ψ
}

class Follower {
public:
    Follower(const RimScene<double>& scene, double horizon, const ContactSink& sink, long most_steps)
        : scene_(scene), sink_(sink), horizon_(horizon), steps_left_(most_steps) {}

    ContactPhase<double> follow(ContactState<double> z) {
        ContactEvent begin = ContactEvent::landing;
        int idle = 0;
        while (true) {  // ends at: a release, the horizon, too many steps or pieces
            const RimChoice choice = choose_rim_motion(scene_, z, begin == ContactEvent::slip);
            phase_.resolved = choice.is_consistent;
            if (!choice.stays) return finish(ContactEvent::release, z);
            if (!(phase_.sums.time < horizon_) || steps_left_ <= 0 || phase_.segments.size() >= most_pieces)
                return finish(ContactEvent::horizon, z);
            const double before = phase_.sums.time;
            begin = choice.motion.rests ? rest(choice.motion, z, begin) : move(choice.motion, z, begin);
            if (begin == ContactEvent::release || begin == ContactEvent::horizon) return finish(begin, z);
            idle = phase_.sums.time > before ? 0 : idle + 1;
            if (idle < most_idle_pieces) continue;
            phase_.resolved = false;
            return finish(ContactEvent::horizon, z);
        }
    }

private:
    ContactPhase<double> finish(ContactEvent event, const ContactState<double>& z) {
        phase_.finish = event;
        phase_.strike.after = leaving_rim(scene_, z);
        phase_.cut = phase_.resolved && event == ContactEvent::horizon && phase_.sums.time < horizon_ * (1 - 1e-12);
        return phase_;
    }

    void add(const RimMotion& motion, ContactEvent begin, ContactEvent end, const ContactState<double>& from,
             const ContactState<double>& to, const ContactSums<double>& sums, long steps) {
        ContactSegment segment;
        segment.start = phase_.sums.time;
        phase_.sums.time += sums.time;
        phase_.sums.turned += sums.turned;
        phase_.sums.work += sums.work;
        steps_left_ -= steps;
        segment.end = phase_.sums.time;
        segment.support = Support::rim;
        segment.motion = motion.motion;
        segment.begin = begin;
        segment.finish = end;
        segment.from = from;
        segment.to = to;
        segment.turned = sums.turned;
        segment.work = sums.work;
        segment.steps = steps;
        phase_.segments.push_back(segment);
    }

    void show(const RimMotion& motion, double time, const RimPlace<double>& y) const {
        const ContactSums<double>& sums = phase_.sums;
        sink_({sums.time + time, sums.turned + y[3], sums.work + y[4]}, Support::rim, motion.motion, contact_of(y));
    }

    ContactEvent rest(const RimMotion& motion, ContactState<double>& z, ContactEvent begin) {
        const double left = horizon_ - phase_.sums.time, lasts = rest_lasts(scene_, z.psi, left);
        const ContactState<double> from = z;
        if (sink_)
            for (double time = RimCourse::longest_step; time < lasts; time += RimCourse::longest_step)
                show(motion, time, {from.psi - time, 0, 0, 0, 0});
        z.psi -= lasts;
        if (sink_) show(motion, lasts, {z.psi, 0, 0, 0, 0});
        const ContactEvent end = lasts < left ? ContactEvent::slip : ContactEvent::horizon;
        add(motion, begin, end, from, z, {lasts, 0, 0}, 1);
        return end;
    }

    void show_step(const RimCourse& course, double h) const {
        constexpr int parts = 4;
        for (int part = 1; part < parts; ++part)
            show(course.motion(), course.before().time + h * part / parts,
                 rim_place_after(scene_, course.motion(), course.before(), h * part / parts));
    }

    /// Until something ends the motion; z is then where.
    ContactEvent move(const RimMotion& motion, ContactState<double>& z, ContactEvent begin) {
        const ContactState<double> from = z;
        const double left = horizon_ - phase_.sums.time;
        RimCourse course(scene_, motion, z, left);
        long steps = 0;
        const auto end = [&](ContactEvent event, double time, const RimPlace<double>& y) {
            z = contact_of(y);
            if (event == ContactEvent::stick || motion.rolls()) z.ut = 0;
            if (sink_) show(motion, time, y);
            add(motion, begin, event, from, z, {time, y[3], y[4]}, steps);
            return event;
        };
        while (course.station().time < left && steps < steps_left_) {
            course.advance(left - course.station().time);
            ++steps;
            if (const auto failure = course.failure()) {
                if (sink_) show_step(course, failure->time);
                const RimPlace<double> y =
                    failure->time == 0 ? course.before().y
                                       : rim_place_after(scene_, course.motion(), course.before(), failure->time);
                const ContactEvent event =
                    end(rim_event(course.motion(), failure->which), course.before().time + failure->time, y);
                if (failure->which == 2) z.ut = z.spin = 0;
                return event;
            }
            if (sink_) show_step(course, course.step());
            if (course.has_stopped()) {
                const ContactEvent event = end(ContactEvent::stick, course.station().time, course.station().y);
                z.ut = z.spin = 0;
                return event;
            }
            if (sink_) show(motion, course.station().time, course.station().y);
            if (!std::isfinite(course.station().y[1] + course.station().y[2])) break;
        }
        return end(ContactEvent::horizon, course.station().time, course.station().y);
    }

    const RimScene<double>& scene_;
    const ContactSink& sink_;
    double horizon_;
    long steps_left_;
    ContactPhase<double> phase_;
};

}  // namespace

ContactPhase<double> follow_rim(const RimScene<double>& scene, const PostImpactState<double>& post_impact,
                                double horizon, const ContactSink& sink, long most_steps) {
    const ContactState<double> landing = landing_on_rim(scene, post_impact);
    const ContactKinematics<double> before = contact_kinematics(*scene.body, post_impact);
    ContactPhase<double> phase = Follower(scene, horizon, sink, most_steps).follow(landing);
    if (phase.segments.empty()) return phase;
    const double p = before.un, q = (landing.ut - before.ut) / before.b1();  // what removes u_n
    phase.segments.front().landing_jacobi = -0.5 * p * before.un + q * (0.5 * (before.ut + landing.ut) - 1);
    phase.sums.work += phase.segments.front().landing_jacobi;
    return phase;
}

}  // namespace swirl
