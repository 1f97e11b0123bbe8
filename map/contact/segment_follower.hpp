// The pieces of a phase of contact once more in Jets, whatever moves the body in them. Internal to what differentiates
// contact.
#pragma once

#include "map/contact/chatter_completion.hpp"
#include "map/contact/contact_phase.hpp"
#include "map/contact/strike.hpp"

#include <cstddef>

namespace swirl::contact_detail {

/// The derivatives of `z` at the values that the phase has.
template <class J>
ContactState<J> with_values(ContactState<J> z, const ContactState<double>& at) {
    z.psi.a = at.psi;
    z.chi.a = at.chi;
    z.ut.a = at.ut;
    z.spin.a = at.spin;
    return z;
}

/// A vertex (rim) that sticks: friction stops a neighbour that slips, by impulses that leave u_n at zero. Which way it
/// slips does not matter: B₂p + B₃q = 0, B₃p + B₁q = −u_t.
template <class J>
ContactState<J> stopped(const ContactScene<J>& scene, Support support, ContactState<J> z) {
    const J slip = z.ut;
    z.ut = J(0);
    if (support == Support::edge) return z;
    const ContactKinematics<J> at = contact_kinematics(scene.body, post_impact_state(scene, z));
    const J q = -slip / (at.b1() - at.b3() * at.b3() / at.b2()), p = -at.b3() * q / at.b2();
    z.spin += (at.rn * q + at.rt * p) * scene.body.inverse_inertia;
    return z;
}

/// Follows the pieces of a phase.
///
/// What moves the body, `Pieces`, has
///     ContactState<J> end_of(const ContactSegment&, bool first_lifts, const ContactState<J>& from)     at its event
///     bool ends_second_chatter(const ContactSegment& last)
template <class J, class Pieces>
struct SegmentFollower {
    const ContactScene<J>& scene;
    Pieces& pieces;
    ContactState<J> z;
    int vertex_step = 0;

    /// To the other vertex of the edge, where it is another: one number up or down.
    void change_vertex(int to) {
        if (to == vertex_step) return;
        const J side(to > vertex_step ? 1 : -1);
        z.psi += side * J(2) * scene.half_chord;
        z.chi = side * scene.widest_chi;
        vertex_step = to;
    }

    void put_neighbour_at_wall() { z.chi = z.chi.a > 0 ? scene.widest_chi : J(-scene.widest_chi); }

    /// A piece, with its last event; `next` is the piece after it, if there is one.
    void follow(const ContactSegment& piece, const ContactSegment* next) {
        change_vertex(piece.vertex_step);
        z = with_values(z, piece.from);
        const bool lasts = piece.end > piece.start;
        if (lasts && piece.motion == ContactMotion::sticking) z = stopped(scene, piece.support, z);
        const bool first_lifts = next && next->vertex_step != piece.vertex_step;
        if (lasts || piece.finish == ContactEvent::strike)
            z = with_values(pieces.end_of(piece, first_lifts, z), piece.to);
        if (piece.finish == ContactEvent::stick) z.ut = J(0);
        if (piece.finish == ContactEvent::strike && next) settle(*next);
    }

    /// The neighbour strikes and rests on the wall: the next piece begins on their edge.
    void settle(const ContactSegment& next) {
        const int struck = vertex_step + (z.chi.a > 0 ? -1 : 1);
        vertex_step = next.vertex_step;
        put_neighbour_at_wall();
        const Strike<J> rest = strike_in_contact(scene, post_impact_state(scene, z), true);
        ChatterCompletion<J> on;
        on.support = Support::edge;
        on.vertex_step = next.vertex_step - struck;
        on.state = with_values(on.state, next.from);
        z = landed_like(scene, rest.after, on, rest.after);
    }

    PostImpactState<J> finish(const ContactPhase<double>& phase) {
        Strike<J> strike;
        if (phase.finish == ContactEvent::strike) {
            const ContactSegment& last = phase.segments.back();
            const bool plastic = last.steps > 0 && pieces.ends_second_chatter(last);
            put_neighbour_at_wall();
            return strike_in_contact(scene, post_impact_state(scene, z), plastic).after;
        }
        change_vertex(phase.vertex_step);
        PostImpactState<J> end = post_impact_state(scene, z);
        if (phase.finish == ContactEvent::jam) jam_once(scene, end, strike);
        return end;
    }

    /// The post-impact state at the end of the phase.
    PostImpactState<J> follow(const ContactPhase<double>& phase) {
        for (std::size_t i = 0; i < phase.segments.size(); ++i)
            follow(phase.segments[i], i + 1 < phase.segments.size() ? &phase.segments[i + 1] : nullptr);
        return finish(phase);
    }
};

}  // namespace swirl::contact_detail
