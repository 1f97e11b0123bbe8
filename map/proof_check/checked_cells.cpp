#include "map/cells/plane_search.hpp"
#include "map/intervals/dual.hpp"
#include "map/intervals/unit_circle.hpp"
#include "map/proof_check/cell_motion.hpp"
#include "map/proof_check/impact_equations.hpp"
#include "map/proof_check/stated_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace swirl::proof_check {

namespace {

using cells::BranchStanding;
using cells::Doubt;
using cells::ParameterCell;
using cells::Ranged;
using intervals::contains_zero;
using intervals::Dual;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using Ranging = cells::Curving;
using intervals::upper;

/// The sets of solutions: contacts that stick, and those that slide with the slip's sign.
int slip_of(int set) {
    return set == 0 ? 0 : set == 1 ? 1 : -1;
}

double largest(const Ranged& x) {
    return std::max(std::abs(lower(x)), std::abs(upper(x)));
}

/// sin τ/τ and (1 − cos τ)/τ.
template <class T>
struct Turn {
    T sinc, versine;
};
template <std::size_t K>
Turn<intervals::Sloped<K>> turn_of(const intervals::Sloped<K>& tau) {
    return {sinc(tau), versine_rate(tau)};
}
template <std::size_t K>
Turn<intervals::Curved<K>> turn_of(const intervals::Curved<K>& tau) {
    return {sinc(tau), versine_rate(tau)};
}
template <class S>
Turn<Dual<2, S>> turn_of(const Dual<2, S>& tau) {
    const auto at = sine_cosine(tau);
    return {at.sine / tau, (Dual<2, S>(1) - at.cosine) / tau};
}

/// A fixed point of flight time τ whose contact is at ψ. The contact's place from the swirl's centre is
/// ρ cis(−χ) cis ψ₀, ρ = |1 + β cis ψ|: the body's centre lies on the same line, R = ρ − α from the swirl's, and the
/// impulse along it.
template <class S, class T>
struct Mode {
    T sine, cosine, radius;                  ///< of χ; R
    T before_n, before_t, after_n, after_t;  ///< velocities of the centre in the contact's axes
    T wall_n, wall_t;                        ///< velocity of the wall
    T rn, rt, p, q, b1, b2, b3;

    Mode(const SceneOver<S>& scene, const T& tau, const T& psi) {
        const auto at = sine_cosine(psi);
        const T along = scene.beta * at.cosine + S(1), across = scene.beta * at.sine;
        const T rho = sqrt(along * along + across * across);
        sine = S(-1) * (across / rho);
        cosine = along / rho;
        radius = rho - T(scene.alpha);
        const Turn<T> turn = turn_of(tau);
        after_n = S(-1) * (radius * (cosine * turn.versine + sine * turn.sinc));
        after_t = radius * (cosine * turn.sinc - sine * turn.versine);
        before_n = radius * (cosine * turn.versine - sine * turn.sinc);
        before_t = radius * (sine * turn.versine + cosine * turn.sinc);
        wall_n = across;
        wall_t = scene.beta * at.cosine;
        rn = scene.alpha * cosine;
        rt = scene.alpha * sine;
        p = S(2) * (radius * cosine * turn.versine);
        q = S(-2) * (radius * sine * turn.versine);
        const S lightness = S(1) / scene.inertia;
        b1 = lightness * (rn * rn) + S(1);
        b2 = lightness * (rt * rt) + S(1);
        b3 = lightness * (rn * rt);
    }
};

/// An impact that sticks in the end, slip of sign s before: what restitution leaves, 0 where the law holds. At the
/// change from slip that stops early to late both forms are the same, and so are those of both signs where slip is 0.
template <class S, class T>
T left_by_law(const SceneOver<S>& scene, const Mode<S, T>& at, const T& un, const T& un_after, const T& ut, int s) {
    const S push = S(s) * scene.mu;
    const T c = at.b2 - push * at.b3, slow = scene.mu * at.b1 - S(s) * at.b3;
    const T stop = S(s) * ut / slow, f = at.b2 - at.b3 * at.b3 / at.b1, at_stop = c * stop - un;
    const S e2 = square(scene.restitution);
    T early, late;
    if (scene.law == "newton") return un_after + scene.restitution * un;
    if (scene.law == "stronge") {
        early = un_after * un_after - e2 * (f * (un - at_stop) * stop + at_stop * at_stop);
        late = f * (at_stop * at_stop) / c + (un_after * un_after - at_stop * at_stop) - e2 * (f * (un * un) / c);
    } else {
        const T half = S(1) / (S(1) + scene.restitution) * at.p;
        early = half - stop + at_stop / f;
        late = half - un / c;
    }
    const auto& order = value_of(at_stop);
    if (is_negative(order)) return early;
    return is_positive(order) ? late : hull(early, late);
}

/// The two equations in (τ, ψ): what the law leaves, or of a contact that slides tan χ − sμ times its denominators; and
/// Nτ(1 − S)/2π.
template <class S, class T>
std::pair<T, T> equations_of(const SceneOver<S>& scene, int set, const T& tau, const T& psi) {
    const Mode<S, T> at(scene, tau, psi);
    const auto steps = [&](const T& spin) { return S(1) / scene.spacing * (tau - tau * spin); };
    if (set != 0) {
        const S push = S(slip_of(set)) * scene.mu;
        // q = −sμp, q/p = −tan χ
        const T f = push * (T(S(1)) + at.wall_t) + at.wall_n;
        const T c = at.b2 - push * at.b3;
        const T spin = (at.before_n - at.wall_n - S(1) / (S(1) + scene.restitution) * (at.p * c)) / at.rt;
        return {f, steps(spin)};
    }
    const T spin = (at.wall_t - at.after_t) / at.rn;  // u_t = 0 after
    const T un = at.before_n - spin * at.rt - at.wall_n, un_after = at.after_n - spin * at.rt - at.wall_n;
    const T ut = -at.q;  // u_t is 0 after
    const auto& slips = value_of(ut);
    if (is_positive(slips)) return {left_by_law(scene, at, un, un_after, ut, 1), steps(spin)};
    if (is_negative(slips)) return {left_by_law(scene, at, un, un_after, ut, -1), steps(spin)};
    return {hull(left_by_law(scene, at, un, un_after, ut, 1), left_by_law(scene, at, un, un_after, ut, -1)),
            steps(spin)};
}

template <class S>
S parameter_of(const ParameterCell& cell, std::size_t i, std::size_t first, bool at_middle) {
    return at_middle ? S(cell.middle(i)) : S::variable(cell.low[i], cell.high[i], first + i);
}

/// The scene over a cell. @throws std::invalid_argument for a name that is no parameter
template <class S>
SceneOver<S> scene_over(const StatedPlane& plane, const ParameterCell& cell, std::size_t first,
                        bool at_middle = false) {
    StatedCycle inside = plane.scene;  // numbers in range in place of the plane's
    const auto number = [](StatedCycle& of, const std::string& name) -> double& {
        if (name == "alpha") return of.alpha;
        if (name == "beta") return of.beta;
        if (name == "mu") return of.mu;
        if (name == "restitution") return of.restitution;
        if (name == "inertia-factor") return of.inertia_factor;
        throw std::invalid_argument("its plane has a parameter that is none");
    };
    for (std::size_t i = 0; i < 2; ++i) number(inside, plane.names[i]) = cell.middle(i);
    const StatedScene exact = scene_of(inside);
    SceneOver<S> scene;
    scene.sides = exact.sides;
    scene.law = exact.law;
    scene.spacing = S(exact.spacing);
    scene.alpha = S(exact.alpha);
    scene.beta = S(exact.beta);
    scene.mu = S(exact.mu);
    scene.restitution = S(exact.restitution);
    S kappa(exact.inertia / intervals::square(exact.alpha));
    for (std::size_t i = 0; i < 2; ++i) {
        const S value = parameter_of<S>(cell, i, first, at_middle);
        const std::string& name = plane.names[i];
        S& place = name == "alpha"         ? scene.alpha
                   : name == "beta"        ? scene.beta
                   : name == "mu"          ? scene.mu
                   : name == "restitution" ? scene.restitution
                                           : kappa;
        place = value;
    }
    scene.inertia = kappa * square(scene.alpha);
    return scene;
}

using TwoSlopes = Dual<2, Ranged>;

class CheckedCell : public cells::CellEquations {
public:
    CheckedCell(const StatedPlane& plane, const ParameterCell& cell)
        : CellEquations(cell),
          plane_(plane),
          over_(scene_over<Ranged>(plane, cell, 2)),
          middle_(scene_over<Ranged>(plane, cell, 2, true)),
          curving_(scene_over<Ranging>(plane, cell, 0)) {}

    cells::Equations values(int set, const Ranged& tau, const Ranged& x) const override {
        const auto at = equations_of<Ranged, Ranged>(over_, set, tau, x);
        return {at.first, at.second};
    }
    cells::CurvedEquations curved(int set, const Ranging& tau, const Ranging& x) const override {
        const auto at = equations_of<Ranging, Ranging>(curving_, set, tau, x);
        return {at.first, at.second};
    }
    cells::LinearEquations linear(int set, const Ranged& tau, const Ranged& x, bool at_middle) const override {
        const auto at = equations_of<Ranged, TwoSlopes>(at_middle ? middle_ : over_, set, TwoSlopes::variable(tau, 0),
                                                        TwoSlopes::variable(x, 1));
        return {at.first.value, at.second.value, {at.first.by, at.second.by}};
    }
    bool is_excluded(int set, const Ranged& tau, const Ranged& x) const override;
    bool is_met_earlier(int set, long j, const Ranged& tau, const Ranged& x) const override {
        (void)set;
        return is_outside_at_a_moment(over_, start_of(over_, j, tau, x), tau, j);
    }
    BranchStanding standing_of(const cells::SolutionBranch& branch) const override;

private:
    /// ψ, χ, v_n, v_t, S after the impact.
    template <class S>
    static MotionStart<S> start_of(const SceneOver<S>& scene, long j, const S& tau, const S& psi) {
        const Mode<S, S> at(scene, tau, psi);
        const S spin = S(1) - scene.spacing * S(static_cast<double>(j)) / tau;
        return {psi, atan2(at.sine, at.cosine), at.after_n, at.after_t, spin};
    }

    const StatedPlane& plane_;
    SceneOver<Ranged> over_, middle_;
    SceneOver<Ranging> curving_;
};

bool CheckedCell::is_excluded(int set, const Ranged& tau, const Ranged& x) const {
    const auto at = sine_cosine(x);
    const Ranged along = over_.beta * at.cosine + Ranged(1), across = over_.beta * at.sine;
    if (is_negative(along)) return true;  // |χ| > π/2
    const Ranged grip = square(over_.mu * along) - square(across);
    if (set == 0 && is_negative(grip)) return true;  // friction would have to be more than μ times the impulse
    const Ranged rho = sqrt(square(along) + square(across));
    if (is_negative(rho - over_.alpha)) return true;
    // A neighbour is outside while the vertex is on the wall.
    const Ranged cosine = along / rho, sine = -(across / rho);
    const auto next = sine_cosine(over_.spacing);
    for (const int way : {1, -1}) {
        const Ranged s = Ranged(way) * next.sine;
        const Ranged turned_x = cosine * next.cosine - sine * s, turned_y = sine * next.cosine + cosine * s;
        const Ranged place_x = Ranged(1) + over_.alpha * (turned_x - cosine), place_y = over_.alpha * (turned_y - sine);
        if (is_positive(square(place_x) + square(place_y) - Ranged(1))) return true;
    }
    if (lower(tau) > 0) return false;
    // A flight that begins at 0: no whole number but 0, and not that where S is not 1.
    const Mode<Ranged, Ranged> mode(over_, tau, x);
    Ranged rate;  // 1 − S, or of a contact that slides (1 − S)/τ
    Ranged power = tau;
    if (set == 0) {
        rate = Ranged(1) - (mode.wall_t - mode.after_t) / mode.rn;
    } else {
        // (S − 1) r_t = R (cos χ (1 − cos τ)/τ (1 − 2/(1 + e)) + sin χ (1 − sin τ/τ)), 0 ≤ 1 − sin τ/τ ≤ τ²/6
        const Ranged half = sinc(Ranged(0.5) * tau), one_and_e = Ranged(1) + over_.restitution;
        const Ranged sixth = Ranged(intervals::between(0, 1.0 / 6 * (1 + 1e-15)));
        const Ranged inner =
            mode.cosine * Ranged(0.5) * square(half) * (Ranged(1) - Ranged(2) / one_and_e) + mode.sine * tau * sixth;
        rate = -(mode.radius * inner / mode.rt);
        power = square(tau);
    }
    return (is_positive(rate) || is_negative(rate)) && largest(power * rate / over_.spacing) < 1;
}

/// How many multipliers lie inside the unit circle: (∂z + λ ∂z′, ∂τ) of the linearised equations is singular at each.
std::optional<int> multipliers_inside(const StepEquationsOver<Ranging>& all) {
    constexpr std::size_t states = 5, time_variable = 5, next = 6;
    intervals::CurvedMatrix a, b;
    for (const GradientOver<Ranging>* row :
         {&all.position_x, &all.position_y, &all.friction, &all.restitution, &all.turn, &all.spin}) {
        a.emplace_back(states + 1);
        b.emplace_back(states + 1);
        for (std::size_t k = 0; k < states; ++k) {
            a.back()[k] = row->d[k];
            b.back()[k] = row->d[next + k];
        }
        a.back()[states] = row->d[time_variable];
    }
    return intervals::zeros_inside(a, b);
}

/// The itinerary of a solution, if its inequalities are certain; `none`: one is violated for all p.
struct ItinerarySight {
    std::optional<StatedStep> itinerary;
    bool none = false;

    bool needs(const Ranging& x) {
        none = none || is_negative(x);
        return is_positive(x);
    }
};

ItinerarySight itinerary_of(const SceneOver<Ranging>& scene, int set, const MotionStart<Ranging>& z, const Ranging& tau,
                            const Ranging& psi, int arriving) {
    const Mode<Ranging, Ranging> at(scene, tau, psi);
    ItinerarySight sight;
    StatedStep itinerary;
    itinerary.vertex_step = arriving;
    itinerary.slip = slip_of(set);
    itinerary.contact_mode = "sliding";
    const Ranging un = at.before_n - z.spin * at.rt - at.wall_n, un_after = at.after_n - z.spin * at.rt - at.wall_n;
    if (!sight.needs(at.p) || !sight.needs(un) || !sight.needs(-un_after)) return sight;
    if (set != 0) {
        const Ranging ut_after = at.after_t + z.spin * at.rn - at.wall_t;
        const Ranging c = at.b2 - Ranging(itinerary.slip) * scene.mu * at.b3;
        if (sight.needs(Ranging(itinerary.slip) * ut_after) && sight.needs(c)) sight.itinerary = itinerary;
        return sight;
    }
    const Ranging ut = -at.q;
    if (!sight.needs(scene.mu * at.cosine - abs(at.sine)) || contains_zero(ut)) return sight;
    itinerary.slip = is_positive(ut) ? 1 : -1;
    const Ranging c = at.b2 - Ranging(itinerary.slip) * scene.mu * at.b3;
    const Ranging slow = scene.mu * at.b1 - Ranging(itinerary.slip) * at.b3;
    const Ranging stop = Ranging(itinerary.slip) * ut / slow, at_stop = c * stop - un;
    if (!sight.needs(slow) || !sight.needs(scene.mu * at.b1 - abs(at.b3)) || !sight.needs(at.p - stop) ||
        contains_zero(at_stop))
        return sight;
    const bool early = is_negative(at_stop);
    if (!early && !sight.needs(c)) return sight;
    itinerary.contact_mode = early ? "c-sticking" : "r-sticking";
    sight.itinerary = itinerary;
    return sight;
}

BranchStanding CheckedCell::standing_of(const cells::SolutionBranch& branch) const {
    const Ranging tau = cells::on_curved_branch(cell(), branch, 0, branch.close[0]);
    const Ranging psi = cells::on_curved_branch(cell(), branch, 1, branch.close[1]);
    if (lower(tau) > plane_.max_time) return BranchStanding::no_fixed_point();
    const auto scene = scene_over<Ranging>(plane_, cell(), 0);
    const MotionStart<Ranging> z = start_of(scene, branch.j, tau, psi);
    const int arriving = static_cast<int>(((branch.j % scene.sides) + scene.sides) % scene.sides);
    const ItinerarySight sight = itinerary_of(scene, branch.set, z, tau, psi, arriving);
    if (sight.none) return BranchStanding::no_fixed_point();
    bool impact = false;
    StepEquationsOver<Ranging> equations;
    if (sight.itinerary) {
        using G = GradientOver<Ranging>;
        const StepVariablesOver<Ranging> at{G(z.psi, 0), G(z.chi, 1), G(z.vn, 2), G(z.vt, 3), G(z.spin, 4), G(tau, 5),
                                            G(z.psi, 6), G(z.chi, 7), G(z.vn, 8), G(z.vt, 9), G(z.spin, 10)};
        equations = step_equations(scene, *sight.itinerary, at, nullptr);
        impact = true;
        for (const G* open : {&equations.position_x, &equations.position_y, &equations.turn, &equations.spin,
                              &equations.friction, &equations.restitution})
            impact = impact && contains_zero(open->f);  // else the solution is none of the map's equations
    }
    const auto timed = scene_over<Timed>(plane_, cell(), 0);
    const auto timed_tau = cells::on_branch<Timed>(cell(), branch, 0, 0, branch.near[0]);
    const auto timed_psi = cells::on_branch<Timed>(cell(), branch, 1, 0, branch.near[1]);
    const FlightSight flight =
        sight_of_flight(timed, start_of(timed, branch.j, timed_tau, timed_psi), timed_tau, branch.j);
    if (flight == FlightSight::outside) return BranchStanding::no_fixed_point();
    if (!(upper(tau) <= plane_.max_time)) return BranchStanding::doubtful(Doubt::longest_flight);
    if (!impact) return BranchStanding::doubtful(Doubt::contact_mode);
    if (flight != FlightSight::clear) return BranchStanding::doubtful(Doubt::clearance);
    const auto inside = multipliers_inside(equations);
    if (!inside) return BranchStanding::doubtful(Doubt::stability);
    return BranchStanding::fixed_point(5 - *inside, *inside);
}

}  // namespace

std::string what_fails(const StatedPlane& plane, const std::function<bool()>& stop) {
    const auto range = [&](const char* name, double own) {
        for (std::size_t i = 0; i < 2; ++i)
            if (plane.names[i] == name) return std::pair(plane.plane.low[i], plane.plane.high[i]);
        return std::pair(own, own);
    };
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::invalid_argument(what);
    };
    require(plane.names[0] != plane.names[1], "its plane has one parameter twice");
    require(plane.scene.law == "poisson" || plane.scene.law == "newton" || plane.scene.law == "stronge",
            "its law is none");
    require(plane.scene.sides >= 3, "cells are of polygons");
    require(plane.max_time > 0 && plane.max_time <= 1000, "its longest flight is out of range");
    const auto [alpha_low, alpha_high] = range("alpha", plane.scene.alpha);
    const auto [e_low, e_high] = range("restitution", plane.scene.restitution);
    require(alpha_low > 0 && alpha_high < 1 && e_low >= 0 && e_high < 1 && range("beta", plane.scene.beta).first > 0 &&
                range("mu", plane.scene.mu).first > 0 && range("inertia-factor", plane.scene.inertia_factor).first > 0,
            "a number of its scene or plane is outside its range");
    for (std::size_t i = 0; i < 2; ++i) require(plane.plane.low[i] < plane.plane.high[i], "its plane is no rectangle");
    cells::PlaneProblem problem;
    problem.over = [&plane](const ParameterCell& cell) { return std::make_unique<CheckedCell>(plane, cell); };
    const double pi_up = upper(intervals::pi_ball());
    for (const int set : {0, 1, 2})
        for (const double from : {-1.0, 0.0})
            problem.unknowns.push_back({set, {0, from * pi_up}, {plane.max_time, (from + 1) * pi_up}});
    return cells::what_fails(problem, plane.plane, plane.proven, stop);
}

}  // namespace swirl::proof_check
