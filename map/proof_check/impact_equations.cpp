#include "map/proof_check/impact_equations.hpp"

#include "map/intervals/curved.hpp"

#include <cmath>
#include <stdexcept>

namespace swirl::proof_check {

using intervals::decimal;
using intervals::square;

StatedScene scene_of(const StatedCycle& cycle) {
    if (cycle.sides != 0 && (cycle.sides < 3 || cycle.sides > 1'000'000))
        throw std::invalid_argument("its number of sides is outside 3 to 1000000");
    const bool in_range = cycle.alpha > 0 && cycle.alpha < 1 && cycle.beta >= 0 && cycle.mu >= 0 &&
                          cycle.restitution >= 0 && cycle.restitution <= 1 && cycle.inertia_factor > 0;
    if (!in_range) throw std::invalid_argument("a number of its scene is outside its range");
    StatedScene scene;
    scene.sides = cycle.sides;
    scene.law = cycle.law;
    scene.alpha = decimal(cycle.alpha);
    scene.beta = decimal(cycle.beta);
    scene.mu = decimal(cycle.mu);
    scene.restitution = decimal(cycle.restitution);
    Ball kappa = decimal(cycle.inertia_factor);
    if (cycle.sides != 0) scene.spacing = Ball(2) * intervals::pi_ball() / Ball(cycle.sides);
    if (cycle.uniform_lamina) {
        const Ball uniform =
            cycle.sides == 0 ? Ball(0.5) : (Ball(2) + intervals::sine_cosine(scene.spacing).cosine) / Ball(6);
        if (!(intervals::upper(abs(uniform - kappa)) < 1e-15))
            throw std::invalid_argument("its inertia factor is not that of the uniform lamina");
        kappa = uniform;
    }
    scene.inertia = kappa * square(scene.alpha);
    return scene;
}

namespace {

/// Velocities of the contact before and after, the impulse, and what the arm makes of it.
template <class S>
struct Contact {
    GradientOver<S> p, q, un, ut, un_after, ut_after, b1, b2, b3, rn, rt;
};

template <class S, class N>
Contact<S> contact_of(const SceneOver<N>& scene, const StepVariablesOver<S>& at) {
    const GradientOver<S> turn = at.psi - at.next_psi - at.tau;  // from the axes before to those of the impact
    const GradientOver<S> c = cosine(turn), s = sine(turn);
    const GradientOver<S> vn = c * at.vn - s * at.vt, vt = s * at.vn + c * at.vt;
    Contact<S> contact;
    contact.p = vn - at.next_vn;
    contact.q = at.next_vt - vt;
    contact.rn = scene.alpha * cosine(at.next_chi);
    contact.rt = scene.alpha * sine(at.next_chi);
    const GradientOver<S> wall_n = scene.beta * sine(at.next_psi), wall_t = scene.beta * cosine(at.next_psi);
    contact.un = vn - at.spin * contact.rt - wall_n;
    contact.ut = vt + at.spin * contact.rn - wall_t;
    contact.un_after = at.next_vn - at.next_spin * contact.rt - wall_n;
    contact.ut_after = at.next_vt + at.next_spin * contact.rn - wall_t;
    const N lightness = N(S(1)) / scene.inertia;
    contact.b1 = S(1) + lightness * (contact.rn * contact.rn);
    contact.b2 = S(1) + lightness * (contact.rt * contact.rt);
    contact.b3 = lightness * (contact.rn * contact.rt);
    return contact;
}

template <class S>
struct Pair {
    GradientOver<S> friction, restitution;
};

using Inequalities = std::vector<Inequality>;

template <class S>
void want(Inequalities* list, const char* name, const S& value) {
    if (list != nullptr) list->push_back({name, values_of(value)});
}

/// An impact during which the slip of sign s stops at p_k: C(p) has slope c before and f beyond.
template <class S, class N>
Pair<S> stopping(const SceneOver<N>& scene, const Contact<S>& at, bool sticks, bool early, int s, Inequalities* list) {
    const N push = S(s) * scene.mu;
    const GradientOver<S> c = at.b2 - push * at.b3, slow = scene.mu * at.b1 - S(s) * at.b3;
    const GradientOver<S> stop = S(s) * at.ut / slow;
    const GradientOver<S> beyond = sticks ? S(-1) * (at.b3 * at.b3 / at.b1) : push * at.b3;
    const GradientOver<S> f = at.b2 + beyond;
    const GradientOver<S> at_stop = c * stop - at.un;  // C there
    want(list, "mu B1 - s B3 > 0", slow.f);
    want(list, early ? "C < 0 where slip stops" : "C > 0 where slip stops", early ? -at_stop.f : at_stop.f);
    want(list, "p > p_k", at.p.f - stop.f);
    want(list, "f > 0", f.f);
    if (!early) want(list, "c > 0", c.f);
    const S grip = scalar_of(scene.mu) * at.b1.f, pull = abs(at.b3.f);
    want(list, sticks ? "mu B1 > |B3|" : "|B3| > mu B1", sticks ? grip - pull : pull - grip);
    Pair<S> pair;
    pair.friction = sticks ? at.ut_after : at.q - push * (at.p - S(2) * stop);
    const N e2 = square(scene.restitution);
    if (scene.law == "newton") {
        pair.restitution = at.un_after + scene.restitution * at.un;
    } else if (scene.law == "stronge") {
        const GradientOver<S> end2 = at.un_after * at.un_after, stop2 = at_stop * at_stop;
        pair.restitution = early ? end2 - e2 * (f * (at.un - at_stop) * stop + stop2)
                                 : f * stop2 + c * (end2 - stop2) - e2 * (f * at.un * at.un);
    } else {
        const GradientOver<S> compression = N(S(1)) / (S(1) + scene.restitution) * at.p;
        pair.restitution = early ? f * (compression - stop) + c * stop - at.un : c * compression - at.un;
    }
    return pair;
}

template <class S, class N>
Pair<S> law_of(const SceneOver<N>& scene, const StatedStep& step, const Contact<S>& at, Inequalities* list) {
    const N bounce = S(1) + scene.restitution;
    want(list, "u_n before the impact > 0", at.un.f);
    want(list, "u_n after the impact < 0", -at.un_after.f);
    if (step.contact_mode == "frictionless") return {at.q, at.p * at.b2 - bounce * at.un};
    const int s = step.slip;
    if (s != 0) want(list, "s u_t before the impact > 0", S(s) * at.ut.f);
    if (step.contact_mode == "sliding") {
        const GradientOver<S> c = at.b2 - (S(s) * scene.mu) * at.b3;
        want(list, "s u_t after the impact > 0", S(s) * at.ut_after.f);
        want(list, "c > 0", c.f);
        return {at.q + (S(s) * scene.mu) * at.p, at.p * c - bounce * at.un};
    }
    const bool sticks = step.contact_mode == "c-sticking" || step.contact_mode == "r-sticking";
    const bool early = step.contact_mode == "c-sticking" || step.contact_mode == "c-reversed";
    if (s != 0) return stopping(scene, at, sticks, early, s, list);
    const Pair<S> a = stopping(scene, at, sticks, early, 1, list), b = stopping(scene, at, sticks, early, -1, list);
    return {either(a.friction, b.friction), either(a.restitution, b.restitution)};
}

}  // namespace

template <class S, class N>
StepEquationsOver<S> step_equations(const SceneOver<N>& scene, const StatedStep& step, const StepVariablesOver<S>& at,
                                    std::vector<Inequality>* inequalities) {
    const GradientOver<S> corner = at.psi + at.chi, next_corner = at.next_psi + at.next_chi;
    const GradientOver<S> c = cosine(at.psi), s = sine(at.psi);
    const GradientOver<S> x = scene.beta + (c - scene.alpha * cosine(corner)) + (c * at.vn - s * at.vt) * at.tau;
    const GradientOver<S> y = s - scene.alpha * sine(corner) + (s * at.vn + c * at.vt) * at.tau;
    const GradientOver<S> next_x = scene.beta + (cosine(at.next_psi) - scene.alpha * cosine(next_corner));
    const GradientOver<S> next_y = sine(at.next_psi) - scene.alpha * sine(next_corner);
    const GradientOver<S> ct = cosine(at.tau), st = sine(at.tau);
    StepEquationsOver<S> equations;
    equations.position_x = x - (ct * next_x - st * next_y);
    equations.position_y = y - (st * next_x + ct * next_y);
    equations.turn = S(step.vertex_step) * scene.spacing + (corner + at.spin * at.tau - next_corner - at.tau);
    const S circle = S(2) * S(intervals::pi_ball());
    const double turns = std::round(intervals::middle(values_of(equations.turn.f / circle)));
    if (std::isfinite(turns)) equations.turn = -(S(turns) * circle) + equations.turn;
    const Contact<S> contact = contact_of(scene, at);
    equations.spin = scene.inertia * (at.next_spin - at.spin) - (contact.rn * contact.q + contact.rt * contact.p);
    const Pair<S> pair = law_of(scene, step, contact, inequalities);
    equations.friction = pair.friction;
    equations.restitution = pair.restitution;
    return equations;
}

template StepEquationsOver<Ball> step_equations(const SceneOver<Ball>&, const StatedStep&,
                                                const StepVariablesOver<Ball>&, std::vector<Inequality>*);
template StepEquationsOver<Gradient> step_equations(const SceneOver<SecondGradient>&, const StatedStep&,
                                                    const StepVariablesOver<Gradient>&, std::vector<Inequality>*);
template StepEquationsOver<intervals::Curved<2>> step_equations(const SceneOver<intervals::Curved<2>>&,
                                                                const StatedStep&,
                                                                const StepVariablesOver<intervals::Curved<2>>&,
                                                                std::vector<Inequality>*);
template StepEquationsOver<intervals::Curved<4>> step_equations(const SceneOver<intervals::Curved<4>>&,
                                                                const StatedStep&,
                                                                const StepVariablesOver<intervals::Curved<4>>&,
                                                                std::vector<Inequality>*);
template StepEquationsOver<intervals::Curved<5>> step_equations(const SceneOver<intervals::Curved<5>>&,
                                                                const StatedStep&,
                                                                const StepVariablesOver<intervals::Curved<5>>&,
                                                                std::vector<Inequality>*);
template StepEquationsOver<intervals::Curved<1>> step_equations(const SceneOver<GradientOver<intervals::Curved<1>>>&,
                                                                const StatedStep&,
                                                                const StepVariablesOver<intervals::Curved<1>>&,
                                                                std::vector<Inequality>*);

}  // namespace swirl::proof_check
