#include "map/intervals/eigenvalue_discs.hpp"
#include "map/proof_check/check_flight.hpp"
#include "map/proof_check/checked_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace swirl::proof_check {

namespace {

using intervals::Disc;

std::string check_steps(const CheckedSystem& system, const Balls& box) {
    for (std::size_t i = 0; i < system.steps.size(); ++i) {
        const StepVariables at = system.variables_of(box, i);
        std::vector<Inequality> inequalities;
        step_equations(system.scene, system.steps[i], at, &inequalities);
        char text[200];
        for (const Inequality& wanted : inequalities) {
            if (is_positive(wanted.value)) continue;
            std::snprintf(text, sizeof text, "impact %zu: %s does not hold: it is %.3g at least", i + 1,
                          wanted.name.c_str(), intervals::lower(wanted.value));
            return text;
        }
        const FlightBox flight{at.psi.f, at.chi.f, at.vn.f, at.vt.f, at.spin.f, at.tau.f};
        const std::string open = open_vertex(system.scene, flight, system.steps[i].vertex_step);
        if (!open.empty()) return "flight " + std::to_string(i + 1) + ": " + open;
    }
    return {};
}

std::string check_points_differ(const CheckedSystem& system, const Balls& box) {
    const StepVariables first = system.variables_of(box, 0);
    for (std::size_t i = 1; i < system.steps.size(); ++i) {
        const StepVariables other = system.variables_of(box, i);
        bool apart = false;
        for (const auto& [a, b] : {std::pair{&first.vn, &other.vn}, {&first.vt, &other.vt}, {&first.spin, &other.spin}})
            apart = apart || !overlap(a->f, b->f);
        for (const auto& [a, b] : {std::pair{&first.psi, &other.psi}, {&first.chi, &other.chi}}) {
            const auto d = intervals::sine_cosine(a->f - b->f);
            apart = apart || !contains_zero(d.sine) || !contains_zero(d.cosine - Ball(1));
        }
        if (!apart)
            return "its period is not shown to be the smallest: points 1 and " + std::to_string(i + 1) + " may be one";
    }
    return {};
}

std::string check_shortage(const CheckedSystem& system, const Balls& box) {
    if (system.shortage == Shortage::symmetric &&
        contains_zero(intervals::sine_cosine(Ball(0.5) * box[system.width() - 1]).sine))
        return "its flight may take whole turns of the swirl";
    if (system.shortage != Shortage::conserved) return {};
    const StepVariables at = system.variables_of(box, 0);
    std::array<Ball, 5> z{at.psi.f, at.chi.f, at.vn.f, at.vt.f, at.spin.f};
    const Ball back = hull(Ball(0), -box.back());
    for (const std::size_t index : system.kept) z[index] += back * Ball(system.direction[index]);
    const auto gradient = gradient_of_energy(system.scene, z);
    Ball rise;
    for (const std::size_t index : system.kept) rise.add_product(gradient[index], Ball(system.direction[index]));
    return is_positive(rise) ? "" : "J may not rise along its gradient";
}

/// Its own enclosures of the multipliers, from DF over what Krawczyk's operator makes of the box.
std::vector<Disc> multipliers_of(const CheckedSystem& system, const Balls& cycle) {
    std::vector<Balls> all;
    for (std::size_t i = 0; i < system.steps.size(); ++i) {
        const std::vector<Balls> one = derivative_of_step(system, cycle, i);
        if (one.empty()) return {};
        if (i == 0) {
            all = one;
            continue;
        }
        std::vector<Balls> product(one.size(), Balls(one.size()));
        for (std::size_t a = 0; a < one.size(); ++a)
            for (std::size_t b = 0; b < one.size(); ++b)
                for (std::size_t c = 0; c < one.size(); ++c) product[a][b].add_product(one[a][c], all[c][b]);
        all = std::move(product);
    }
    return intervals::eigenvalue_discs_by_arb(all);
}

bool is_exactly(const StatedCycle::Disc& disc, double value) {
    return disc.re == value && disc.im == 0 && disc.radius == 0;
}

std::string check_multipliers(const CheckedSystem& system, const StatedCycle& cycle, const Balls& box) {
    std::vector<Disc> own = multipliers_of(system, box);
    if (own.empty()) return "its multipliers could not be enclosed";
    if (system.kept.size() == 3) own.push_back({1, 0, 0});
    if (own.size() != cycle.multipliers.size()) return "it states another number of multipliers than there are";
    bool sticks = false;
    for (const StatedStep& step : cycle.steps)
        sticks = sticks || step.contact_mode.find("sticking") != std::string::npos;
    std::vector<bool> taken(own.size(), false);
    for (const auto& stated : cycle.multipliers) {
        // An exact 0 or 1 is known from the impact's rank or the family: its disc is to hold that one alone.
        const bool known = (is_exactly(stated, 0) && sticks) || (is_exactly(stated, 1) && cycle.phase);
        std::size_t match = own.size(), near = 0;
        bool own_is_exact = false;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const double apart = std::hypot(stated.re - own[i].re, stated.im - own[i].im);
            const bool fits = known ? apart <= own[i].radius : (apart + own[i].radius) * (1 + 1e-12) <= stated.radius;
            if (known && fits) ++near;
            if (!fits || taken[i] || own_is_exact) continue;
            match = i;
            own_is_exact = known && own[i].radius == 0;
        }
        if (match == own.size() || (known && near != 1 && !own_is_exact)) {
            char text[120];
            std::snprintf(text, sizeof text, "the multiplier %.9g %+.9gi is not in its disc", stated.re, stated.im);
            return text;
        }
        taken[match] = true;
    }
    return {};
}

std::string check_stability(const StatedCycle& cycle) {
    std::size_t inside = 0, outside = 0, one = 0;
    for (const auto& disc : cycle.multipliers) {
        const double size = std::hypot(disc.re, disc.im);
        if (is_exactly(disc, 1)) {
            ++one;
            continue;
        }
        if ((size + disc.radius) * (1 + 1e-15) < 1) ++inside;
        if ((size - disc.radius) * (1 - 1e-15) > 1) ++outside;
    }
    const std::size_t n = cycle.multipliers.size();
    const std::string& word = cycle.stability;
    const bool holds = word == "attracting"  ? inside == n
                       : word == "repelling" ? outside == n
                       : word == "saddle"    ? inside > 0 && outside > 0
                       : word == "neutral"   ? one > 0 && one + inside == n
                                             : word == "undecided";
    return holds ? "" : "its multipliers do not say that it is " + word;
}

}  // namespace

std::string what_fails(const StatedCycle& cycle) {
    const CheckedSystem system = checked_system(cycle);
    const Balls box = stated_box(system);
    Balls image;
    if (!holds_one_solution(system, stated_middle(system), box, image))
        return "its box is not shown to hold one solution: Krawczyk's operator does not map it into itself";
    if (const std::string failed = check_steps(system, box); !failed.empty()) return failed;
    if (const std::string failed = check_points_differ(system, box); !failed.empty()) return failed;
    if (const std::string failed = check_shortage(system, box); !failed.empty()) return failed;
    for (int i = 0; i < 4; ++i) {  // the solution, ever closer
        Balls middle, closer;
        for (const Ball& x : image) middle.push_back(intervals::exact_middle(x));
        if (!holds_one_solution(system, middle, image, closer)) break;
        image = closer;
    }
    if (const std::string failed = check_multipliers(system, cycle, image); !failed.empty()) return failed;
    return check_stability(cycle);
}

}  // namespace swirl::proof_check
