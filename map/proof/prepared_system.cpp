#include "map/proof/prepared_system.hpp"

#include "map/proof/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::proof {

namespace {

constexpr double farthest_correction = 1e-8;  ///< a claim that is farther off is another cycle's, or none's
constexpr double slip_at_once = 1e-8;         ///< |u_t| before the impact below which both signs are enclosed

BallPoint<Ball> in_balls(const SectionPoint<double>& z) {
    return {Ball(z.psi), Ball(z.chi), Ball(z.vn), Ball(z.vt), Ball(z.spin)};
}

double wall_advance(const BallScene& scene, const SectionPoint<double>& z, double tau, const Branch& branch) {
    const BallStep<Ball> step =
        step_in_balls<Ball>(scene, {branch.vertex_step, ContactMode::frictionless, 0}, 0, in_balls(z), Ball(tau));
    // Where the contact's direction is near the cut of the arc tangent, it is counted from the other side.
    const double nu = intervals::middle(step.before.psi) - z.psi + tau;
    if (std::isfinite(nu)) return nu;
    const BallStep<Ball> other =
        step_in_balls<Ball>(scene, {branch.vertex_step, ContactMode::frictionless, 0}, 3.0, in_balls(z), Ball(tau));
    return intervals::middle(other.before.psi) - z.psi + tau;
}

void set_branches(CycleSystem& system, const CycleClaim& claim) {
    for (std::size_t i = 0; i < claim.points.size(); ++i) {
        system.itinerary.push_back(claim.itinerary[i]);
        system.advances.push_back(wall_advance(system.scene, claim.points[i], claim.times[i], claim.itinerary[i]));
        Branch& branch = system.itinerary.back();
        branch.slip = 0;
        const BallStep<Ball> step =
            step_in_balls<Ball>(system.scene, {branch.vertex_step, ContactMode::frictionless, 0}, system.advances[i],
                                in_balls(claim.points[i]), Ball(claim.times[i]));
        const double ut = intervals::middle(kinematics(system.scene, step.before).ut);
        const bool at_once = branch.mode == ContactMode::c_sticking && std::abs(ut) < slip_at_once;
        if (branch.mode != ContactMode::frictionless && !at_once) branch.slip = ut > 0 ? 1 : -1;
    }
}

/// Whole turns between the image's angles and the next point's.
void set_turns(CycleSystem& system, const BallVector& middle) {
    for (std::size_t i = 0; i < system.period(); ++i) {
        const BallStep<Ball> step = system.step(middle, i, nullptr);
        const BallPoint<Ball> next = system.point(middle, (i + 1) % system.period());
        const auto turns = [](const Ball& a, const Ball& b) {
            return static_cast<int>(std::lround(intervals::middle(a - b) / (2 * pi<double>())));
        };
        system.turns.push_back({turns(step.after.psi, next.psi), turns(step.after.chi, next.chi)});
    }
}

BallVector unknowns_of(const CycleSystem& system, const CycleClaim& claim) {
    BallVector unknowns;
    for (std::size_t i = 0; i < claim.points.size(); ++i) {
        const auto& z = claim.points[i];
        const std::array<double, 5> all{z.psi, z.chi, z.vn, z.vt, z.spin};
        for (const std::size_t index : system.active) unknowns.emplace_back(all[index]);
        unknowns.emplace_back(claim.times[i]);
    }
    if (system.form == FamilyForm::conserved) unknowns.emplace_back(0);
    return unknowns;
}

/// How far Newton's method moves the claim until rounding is reached.
double correct(PreparedSystem& prepared) {
    double moved = 0;
    for (int i = 0; i < 4; ++i) {
        const BallVector open = evaluate(prepared.system, prepared.middle).values;
        double longest = 0;
        for (std::size_t a = 0; a < open.size(); ++a) {
            double change = 0;
            for (std::size_t b = 0; b < open.size(); ++b) change += prepared.inverse(a, b) * intervals::middle(open[b]);
            longest = std::max(longest, std::abs(change));
            if (!(std::abs(change) < 1)) return change;
            prepared.middle[a] = Ball(intervals::middle(prepared.middle[a]) - change);
        }
        moved += longest;
        if (longest < 1e-16) break;
    }
    return moved;
}

void choose_form(CycleSystem& system, const CycleClaim& claim, const Scene<double>& scene) {
    system.active = {0, 1, 2, 3, 4};
    if (scene.is_disk()) system.active = {0, 2, 3, 4};
    if (scene.is_disk() && system.scene.frictionless) {
        system.active = {0, 2, 3};
        system.fixed_spin = claim.points.front().spin;
    }
    if (scene.restitution != 1) return;
    if (system.scene.frictionless) {
        system.form = FamilyForm::conserved;
        const auto gradient = conserved_gradient(system.scene, in_balls(claim.points.front()));
        for (std::size_t i = 0; i < 5; ++i) system.conserved_gradient[i] = intervals::middle(gradient[i]);
    } else if (scene.is_disk() && claim.points.size() == 1) {
        system.form = FamilyForm::symmetric;
    }
}

/// The phase condition with which the equations are better conditioned: S, or the first flight's time.
void choose_phase(PreparedSystem& prepared, const CycleClaim& claim) {
    CycleSystem& system = prepared.system;
    double best = std::numeric_limits<double>::infinity();
    std::optional<Phase> chosen;
    Eigen::MatrixXd inverse;
    for (const bool by_time : {false, true}) {
        if (!by_time && std::find(system.active.begin(), system.active.end(), spin_index) == system.active.end())
            continue;
        system.phase = Phase{by_time, by_time ? claim.times.front() : claim.points.front().spin};
        const Eigen::MatrixXd candidate = approximate_inverse(evaluate(system, prepared.middle));
        const double size = candidate.lpNorm<Eigen::Infinity>();
        if (!candidate.allFinite() || !(size < best * (by_time ? 0.01 : 1))) continue;  // S, if it does
        best = size;
        chosen = system.phase;
        inverse = candidate;
    }
    system.phase = chosen;
    if (chosen) prepared.inverse = inverse;
}

}  // namespace

PreparedSystem prepared_system(const Scene<double>& scene, const CycleClaim& claim) {
    PreparedSystem prepared;
    CycleSystem& system = prepared.system;
    system.scene = ball_scene(scene);
    choose_form(system, claim, scene);
    set_branches(system, claim);
    prepared.middle = unknowns_of(system, claim);
    set_turns(system, prepared.middle);
    if (system.form == FamilyForm::isolated)
        prepared.inverse = approximate_inverse(evaluate(system, prepared.middle));
    else
        choose_phase(prepared, claim);
    if (prepared.inverse.size() == 0 || !prepared.inverse.allFinite()) {
        prepared.reason = "the equations' derivative cannot be inverted there: a family that is not known, or a fold";
        return prepared;
    }
    const double moved = correct(prepared);
    if (!(std::abs(moved) <= farthest_correction)) {
        prepared.reason = words("no cycle with this word there: Newton's method moves the point by %.3g, more than %g",
                                std::abs(moved), farthest_correction);
        return prepared;
    }
    const Eigen::MatrixXd inverse = approximate_inverse(evaluate(system, prepared.middle));
    if (inverse.allFinite()) prepared.inverse = inverse;
    return prepared;
}

KrawczykBox krawczyk_box(const PreparedSystem& prepared) {
    const intervals::BallSystem system = [&](const BallVector& box) { return evaluate(prepared.system, box); };
    double excess = std::numeric_limits<double>::infinity(), tried = 0;
    for (const double radius : {1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15}) {
        std::vector<double> radii;
        for (const Ball& x : prepared.middle) radii.push_back(radius * std::max(1.0, std::abs(intervals::middle(x))));
        BallVector box = intervals::boxes(prepared.middle, radii);
        const BallVector image = intervals::krawczyk_image(system, prepared.middle, box, prepared.inverse);
        if (intervals::lies_inside(image, box)) return {std::move(box), {}};
        double farthest = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const double reach = intervals::upper(abs(image[i] - prepared.middle[i])) / radii[i];
            farthest = std::isnan(reach) ? std::numeric_limits<double>::infinity() : std::max(farthest, reach);
        }
        if (!(farthest < excess)) continue;
        excess = farthest;
        tried = radius;
    }
    if (!(excess < std::numeric_limits<double>::infinity()))
        return {{}, "Krawczyk's operator maps no box into itself: the image of each is without bounds"};
    return {{},
            words("Krawczyk's operator maps no box into itself: best is one of half-width %.0e, whose image reaches "
                  "%.3g times as far",
                  tried, excess)};
}

}  // namespace swirl::proof
