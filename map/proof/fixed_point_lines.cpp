#include "map/proof/fixed_point_lines.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::proof {

namespace {

using intervals::Dual;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::square;
using intervals::upper;
using Value = Dual<2>;

/// (1 − cos τ)/τ, also at 0.
Ball versine_rate(const Ball& tau) {
    const Ball half = Ball(0.5) * tau;
    return half * square(intervals::sinc(half));
}

/// sin χ_m = sin(π/N − asin(α sin(π/N))): beyond it a neighbour is outside.
Ball largest_sine(const BallScene& scene) {
    const Ball half = Ball(0.5) * scene.spacing;
    return sine_cosine(half - asin(scene.alpha * sine_cosine(half).sine)).sine;
}

/// A start of the flight at 0: no solution where 1 − S has a sign and |j| < 1.
bool is_before_first(const Ball& one_less_spin, const BallScene& scene, const Ball& tau) {
    if (lower(tau) > 0 || (!is_positive(one_less_spin) && !is_negative(one_less_spin))) return false;
    return upper(abs(Ball(upper(tau)) * one_less_spin / scene.spacing)) < 1;
}

FixedPointSet sticking(const BallScene& scene, double max_time, bool elastic) {
    FixedPointSet set;
    set.problem.unknowns = 2;
    set.problem.evaluate = [&scene, elastic](const Ball& tau, const Ball& phi) -> PlaneProblem::Values {
        const auto at = steady_in_balls<Value>(scene, Value::variable(tau, 0), Value::variable(phi, 1));
        return {sticking_law(scene, at, elastic), sticking_steps(scene, at)};
    };
    set.problem.excluded = [&scene, elastic](const Ball& tau, const Ball& phi) {
        const auto at = steady_in_balls<Ball>(scene, tau, phi);
        if (is_negative(at.radius) || is_positive(at.slope - scene.mu)) return true;
        const Ball push = at.radius * versine_rate(tau), delta = deficit(scene, at, elastic);
        const Ball law = elastic ? push * (at.s + delta * square(at.c)) - Ball(1)
                                 : push * (square(at.s) + delta * square(at.c)) - at.s;
        if (is_positive(law) || is_negative(law)) return true;
        const Ball spin = at.w - at.radius * intervals::sinc(tau) - at.s / at.c * (at.s - push);
        return is_before_first(Ball(1) - spin / scene.alpha, scene, tau);
    };
    const Ball steepest = scene.mu / sqrt(Ball(1) + square(scene.mu));
    const double largest = std::min(upper(largest_sine(scene)), upper(steepest));
    const double pi_up = upper(intervals::pi_ball());
    if (upper(scene.beta) <= largest) {
        set.start = {{{0, -0.5 * pi_up}, {max_time, 0.5 * pi_up}}, {{0, 0.5 * pi_up}, {max_time, 1.5 * pi_up}}};
    } else {
        const double reach =
            std::min(0.5 * pi_up, upper(asin(Ball(std::min(1.0, largest / lower(scene.beta) * (1 + 1e-15))))));
        set.start = {{{0, -reach}, {max_time, reach}}, {{0, pi_up - reach}, {max_time, pi_up + reach}}};
    }
    return set;
}

/// A line in τ with fixed sin χ and w.
FixedPointSet line(const BallScene& scene, FixedPointSet::Kind kind, const Ball& sine, const Ball& width,
                   double max_time) {
    FixedPointSet set;
    set.kind = kind;
    set.sine = sine;
    set.width = width;
    set.problem.unknowns = 1;
    set.start = {{{0, 0}, {max_time, 0}}};
    const Ball c = sqrt(Ball(1) - square(sine)), radius = c - scene.alpha + width;
    const bool slides = kind == FixedPointSet::Kind::sliding;
    set.problem.evaluate = [&scene, sine, width, c, radius, slides](const Ball& tau,
                                                                    const Ball&) -> PlaneProblem::Values {
        SteadyInBalls<Value> at;
        at.tau = Value::variable(tau, 0);
        at.s = Value(sine);
        at.w = Value(width);
        at.c = Value(c);
        at.radius = Value(radius);
        const auto half = sine_cosine(Ball(0.5) * at.tau);
        at.versine = Ball(2) * (half.sine * half.sine);
        at.sine = sine_cosine(at.tau).sine;
        return {Value(), slides ? sliding_steps(scene, at) : sticking_steps(scene, at)};
    };
    set.problem.excluded = [&scene, sine, width, c, radius, slides](const Ball& tau, const Ball&) {
        if (!is_positive(radius)) return is_negative(radius);
        if (lower(tau) > 0) return false;
        if (!slides)
            return is_before_first(Ball(1) - (width - radius * intervals::sinc(tau)) / scene.alpha, scene, tau);
        // (1 − S)/τ = (R/(αs)) (½ c sinc²(τ/2) (1 − e)/(1 + e) − s (1 − sinc τ)/τ), 0 < (1 − sinc τ)/τ² ≤ 1/6
        const Ball lost = (Ball(1) - scene.restitution) / (Ball(1) + scene.restitution);
        const Ball first = Ball(0.5) * c * square(intervals::sinc(Ball(0.5) * tau)) * lost;
        const Ball second = sine * tau * intervals::between(0, 1.0 / 6 * (1 + 1e-15));
        const Ball rate = radius / (scene.alpha * sine) * (first - second);
        const bool signed_rate = is_positive(rate) || is_negative(rate) || intervals::is_exact_zero(lost);
        return signed_rate && upper(abs(rate * square(Ball(upper(tau))) / scene.spacing)) < 1;
    };
    return set;
}

/// β cis φ = w − i s; on the other side of the cut of the arc tangent where w < 0.
Ball phi_from(const Ball& s, const Ball& w) {
    return is_positive(w) ? atan2(-s, w) : intervals::pi_ball() - atan2(-s, -w);
}

}  // namespace

std::vector<FixedPointSet> fixed_point_sets(const BallScene& scene, double max_time) {
    const bool elastic = intervals::is_exact_zero(scene.restitution - Ball(1));
    std::vector<FixedPointSet> sets{sticking(scene, max_time, elastic)};
    using Kind = FixedPointSet::Kind;
    if (elastic)
        for (const Ball& width : {scene.beta, -scene.beta})
            sets.push_back(line(scene, Kind::straight, Ball(0), width, max_time));
    const Ball steep = scene.mu / sqrt(Ball(1) + square(scene.mu));
    const Ball left = square(scene.beta) - square(steep);
    if (is_positive(steep - largest_sine(scene)) || is_negative(left)) return sets;
    if (intervals::contains_zero(left)) {
        const double most = upper(sqrt(Ball(upper(left))));
        for (const int sign : {1, -1}) {
            sets.push_back(line(scene, Kind::sliding, Ball(sign) * steep, intervals::between(-most, most), max_time));
            sets.back().open = "the two branches that slip meet: beta is mu/sqrt(1 + mu^2)";
        }
        return sets;
    }
    for (const int sign : {1, -1})
        for (const int branch : {1, -1})
            sets.push_back(line(scene, Kind::sliding, Ball(sign) * steep, Ball(branch) * sqrt(left), max_time));
    return sets;
}

Ball slip_along(const BallScene& scene, const FixedPointSet& set, const BallPoint<Ball>& z) {
    const Ball ut = kinematics(scene, z).ut;
    return is_positive(set.sine) ? ut : -ut;
}

Ball phi_on_line(const FixedPointSet& line) {
    return phi_from(line.sine, line.width);
}

BallPoint<Ball> fixed_point_of(const BallScene& scene, const FixedPointSet& set, const PlaneSolution& solution) {
    Ball s = set.sine, w = set.width;
    if (set.kind == FixedPointSet::Kind::sticking) {
        const auto direction = sine_cosine(solution.phi);
        s = -(scene.beta * direction.sine);
        w = scene.beta * direction.cosine;
    }
    const Ball chi = asin(s), c = sqrt(Ball(1) - square(s)), radius = c - scene.alpha + w;
    const Ball half = Ball(0.5) * solution.tau, speed = radius * intervals::sinc(half);
    const auto along = sine_cosine(chi + half);
    const Ball phi = phi_from(s, w);
    const Ball spin = Ball(1) - scene.spacing * Ball(static_cast<double>(solution.j)) / solution.tau;
    return {phi - chi, chi, -(speed * along.sine), speed * along.cosine, spin};
}

std::vector<ContactMode> modes_of(const BallScene& scene, const FixedPointSet& set, const PlaneSolution& solution) {
    if (set.kind == FixedPointSet::Kind::sliding) return {ContactMode::sliding};
    if (set.kind == FixedPointSet::Kind::straight) return {ContactMode::c_sticking};
    // C at the kink is p (ε − D (1 − k)): slip stops early where that is negative.
    const auto at = steady_in_balls<Ball>(scene, solution.tau, solution.phi);
    const bool elastic = intervals::is_exact_zero(scene.restitution - Ball(1));
    const Ball delta = deficit(scene, at, elastic), one(1);
    const Ball epsilon = Ball(0.5) * (one - (elastic ? at.s * delta : delta));
    const Ball d = square(at.s) / (scene.kappa + square(at.c));
    const Ball order = epsilon - (one + d) * (one - stop_share(scene, at));
    if (is_negative(order)) return {ContactMode::c_sticking};
    if (is_positive(order)) return {ContactMode::r_sticking};
    return {ContactMode::c_sticking, ContactMode::r_sticking};
}

}  // namespace swirl::proof
