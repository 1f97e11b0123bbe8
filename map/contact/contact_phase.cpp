#include "map/contact/contact_phase.hpp"

#include "map/contact/contact_follower.hpp"
#include "map/contact/contact_watch.hpp"
#include "map/contact/motion_choice.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

namespace swirl {

namespace {

/// Over a floor that does not rub: power series.
template <class T>
struct SmoothMotions {
    const ContactScene<T>& scene;

    MotionChoice<T> choose(const MotionChoice<T>& at, ContactEvent before) const {
        return choose_motion(scene, at.support, at.state, at.vertex_step, before);
    }
    ContactEnd<T> run(const MotionChoice<T>& choice, const T& duration, const ContactSink& sink, long most_steps,
                      const ContactSums<T>& before) const {
        return run_contact(scene, choice.support, choice.motion, choice.state, duration, sink, most_steps, before);
    }
    bool ends_second_chatter(const MotionChoice<T>& choice, const ContactState<T>& z) const {
        return contact_detail::ends_second_chatter(scene, choice.motion, z);
    }
    ChatterCompletion<T> completion(const PostImpactState<T>& post_impact) const {
        return chatter_completion(scene, post_impact);
    }
};

}  // namespace

template <class T>
ContactPhase<T> follow_contact(const ContactScene<T>& scene, const ChatterCompletion<T>& completion, double horizon,
                               const ContactSink& sink, long most_steps) {
    SmoothMotions<T> motions{scene};
    contact_detail::Follower<T, SmoothMotions<T>> follower{scene, motions, sink, {}};
    return follower.follow_from(completion, horizon, most_steps);
}

template <class T>
ContactPhase<T> struck_at_once(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    const ContactSink unseen;
    SmoothMotions<T> motions{scene};
    contact_detail::Follower<T, SmoothMotions<T>> follower{scene, motions, unseen, {}};
    const ContactState<T> state = contact_state(scene, post_impact);
    ContactSegment segment;
    segment.from = segment.to = in_double(state);
    segment.finish = ContactEvent::strike;
    follower.phase.segments.push_back(segment);
    follower.strike(state, 0, false);
    return follower.phase;
}

#define SWIRL_COMPILE_CONTACT_PHASE(T)                                                                   \
    template ContactPhase<T> follow_contact(const ContactScene<T>&, const ChatterCompletion<T>&, double, \
                                            const ContactSink&, long);                                   \
    template ContactPhase<T> struck_at_once(const ContactScene<T>&, const PostImpactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CONTACT_PHASE)

}  // namespace swirl
