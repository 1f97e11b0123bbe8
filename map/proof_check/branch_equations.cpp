#include "map/proof_check/branch_equations.hpp"

#include "map/intervals/unit_circle.hpp"
#include "map/proof_check/checked_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace swirl::proof_check {

namespace {

constexpr std::size_t time_place = 5, next_place = 6;
using intervals::is_negative;
using intervals::is_positive;
using intervals::RunningMatrix;

void demand(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
}

/// One of the scene's numbers by its name; null: no such name.
template <class S>
S* number_named(SceneOver<S>& scene, S& kappa, const std::string& name) {
    return name == "alpha"            ? &scene.alpha
           : name == "beta"           ? &scene.beta
           : name == "mu"             ? &scene.mu
           : name == "restitution"    ? &scene.restitution
           : name == "inertia-factor" ? &kappa
                                      : nullptr;
}

template <class S>
SceneOver<S> scene_with(const StatedScene& exact, const Ball& exact_kappa, const std::string& name, const S& value) {
    const auto number = [](const Ball& x) {
        if constexpr (std::is_same_v<S, RunningGradient>)
            return S(Running(x));
        else if constexpr (std::is_same_v<S, SecondGradient>)
            return S(Gradient(x));
        else
            return S(x);
    };
    SceneOver<S> scene{number(exact.alpha),   number(exact.beta), number(exact.mu), number(exact.restitution), S{},
                       number(exact.spacing), exact.sides,        exact.law};
    S kappa = number(exact_kappa);
    *number_named(scene, kappa, name) = value;
    scene.inertia = kappa * square(scene.alpha);
    return scene;
}

Timed timed_of(const Running& x) {
    Timed result(x.mid);
    result.by[0] = x.by[0];
    result.rest = intervals::detail::at_least(std::abs(x.two[0]) + x.rest);
    return result;
}

/// X with A X = B, by Gauss' elimination; nothing where a pivot may be 0.
std::optional<RunningMatrix> solved(RunningMatrix a, RunningMatrix b) {
    const std::size_t n = a.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(a[i][k].mid) > std::abs(a[best][k].mid)) best = i;
        std::swap(a[k], a[best]);
        std::swap(b[k], b[best]);
        if (contains_zero(a[k][k])) return std::nullopt;
        const Running over = Running(1) / a[k][k];
        for (Running& x : a[k]) x = over * x;
        for (Running& x : b[k]) x = over * x;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const Running factor = a[i][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
            for (std::size_t j = 0; j < b[i].size(); ++j) b[i][j] -= factor * b[k][j];
        }
    }
    return b;
}

/// A step's variables, each with the derivative of its derivative.
StepVariablesOver<Gradient> second_variables(const std::array<Gradient, scene_variable>& x) {
    const auto at = [&x](std::size_t i) { return SecondGradient(x[i], i); };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9), at(10)};
}

}  // namespace

BranchEquations::BranchEquations(const StatedBranch& branch)
    : scene_(scene_of(branch.cycle)), steps_(branch.cycle.steps), parameter_(branch.parameter) {
    const StatedCycle& cycle = branch.cycle;
    demand(!steps_.empty() && !branch.boxes.empty(), "a branch without steps or boxes");
    require_itinerary(cycle);
    demand(cycle.law == "poisson" || cycle.law == "newton" || cycle.law == "stronge", "its law is none");
    kappa_ = scene_.inertia / square(scene_.alpha);
    demand(number_named(scene_, kappa_, parameter_) != nullptr, "its parameter is none of the scene's numbers");
    const bool mu = parameter_ == "mu", e = parameter_ == "restitution";
    const double least_mu = mu ? branch.from : cycle.mu, most_e = e ? branch.to : cycle.restitution;
    demand(branch.from <= branch.to && branch.from >= 0 && (parameter_ != "alpha" || branch.to < 1) && most_e <= 1,
           "its parameter leaves its range");
    demand(!(most_e == 1 && (cycle.sides == 0 || least_mu == 0)) && !(cycle.sides == 0 && least_mu == 0),
           "cycles come in families there");
    kept_ = cycle.sides == 0 ? std::vector<std::size_t>{0, 2, 3, 4} : std::vector<std::size_t>{0, 1, 2, 3, 4};
    for (const StatedBox& box : branch.boxes) {
        demand(box.middle.size() == unknowns() && box.running < unknowns(), "a box has another number of unknowns");
        demand(box.low < box.high && box.within > 0, "a box has no width");
    }
}

SceneOver<RunningGradient> BranchEquations::scene_at(const Running& parameter) const {
    return scene_with<RunningGradient>(scene_, kappa_, parameter_, RunningGradient(parameter, scene_variable));
}

template <class S>
StepVariablesOver<S> BranchEquations::variables_of(const std::vector<S>& unknowns, std::size_t i) const {
    std::array<GradientOver<S>, 11> g;
    const std::size_t to = (i + 1) % steps_.size();
    for (std::size_t a = 0; a < kept_.size(); ++a) {
        g[kept_[a]] = GradientOver<S>(unknowns[i * width() + a], kept_[a]);
        g[next_place + kept_[a]] = GradientOver<S>(unknowns[to * width() + a], next_place + kept_[a]);
    }
    g[time_place] = GradientOver<S>(unknowns[(i + 1) * width() - 1], time_place);
    return {g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10]};
}

template <class S>
std::vector<const GradientOver<S>*> BranchEquations::equations_of(const StepEquationsOver<S>& all) const {
    std::vector<const GradientOver<S>*> list{&all.position_x, &all.position_y, &all.friction, &all.restitution,
                                             &all.spin};
    if (!scene_.disk()) list.push_back(&all.turn);
    return list;
}

intervals::CurveLinearisation BranchEquations::at(const std::vector<Running>& unknowns) const {
    intervals::CurveLinearisation result;
    const auto scene = scene_at(unknowns.back());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const auto all = step_equations(scene, steps_[i], variables_of(unknowns, i), nullptr);
        const std::size_t to = (i + 1) % steps_.size();
        for (const RunningGradient* equation : equations_of(all)) {
            std::vector<std::pair<std::size_t, Running>> row;
            for (std::size_t a = 0; a < kept_.size(); ++a) {
                row.emplace_back(i * width() + a, equation->d[kept_[a]]);
                row.emplace_back(to * width() + a, equation->d[next_place + kept_[a]]);
            }
            row.emplace_back((i + 1) * width() - 1, equation->d[time_place]);
            row.emplace_back(unknowns.size() - 1, equation->d[scene_variable]);
            result.values.push_back(equation->f);
            result.rows.push_back(std::move(row));
        }
    }
    return result;
}

bool BranchEquations::is_smooth() const {
    return std::all_of(steps_.begin(), steps_.end(),
                       [](const StatedStep& step) { return step.slip != 0 || step.contact_mode == "frictionless"; });
}

intervals::SecondOrder BranchEquations::twice_at(const intervals::BallVector& unknowns) const {
    using Place = std::array<std::size_t, 2>;  // of a step's variables, of the cycle's unknowns
    intervals::SecondOrder result;
    const auto scene = scene_with<SecondGradient>(
        scene_, kappa_, parameter_, SecondGradient(Gradient(unknowns.back(), scene_variable), scene_variable));
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::size_t to = (i + 1) % steps_.size();
        std::vector<Place> places{{time_place, (i + 1) * width() - 1}, {scene_variable, unknowns.size() - 1}};
        for (std::size_t a = 0; a < kept_.size(); ++a) {
            places.push_back({kept_[a], i * width() + a});
            places.push_back({next_place + kept_[a], to * width() + a});
        }
        std::array<Gradient, scene_variable> local;
        for (const auto& [place, column] : places)
            if (place != scene_variable) local[place] = Gradient(unknowns[column], place);
        const auto all = step_equations(scene, steps_[i], second_variables(local), nullptr);
        for (const SecondGradient* equation : equations_of(all)) {
            std::vector<intervals::DependentEntry> row;
            for (const auto& [place, column] : places) {
                const bool is_next = place >= next_place && place != scene_variable;
                intervals::DependentEntry entry{column, is_next && to == 0, equation->d[place].f, {}};
                for (const auto& [other, other_column] : places)
                    entry.by.emplace_back(other_column, equation->d[place].d[other]);
                row.push_back(std::move(entry));
            }
            result.values.push_back(equation->f.f);
            result.rows.push_back(std::move(row));
        }
    }
    return result;
}

std::string BranchEquations::doubtful_impact(const std::vector<Running>& unknowns) const {
    const auto scene = scene_at(unknowns.back());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        std::vector<Inequality> inequalities;
        step_equations(scene, steps_[i], variables_of(unknowns, i), &inequalities);
        for (const Inequality& wanted : inequalities)
            if (!is_positive(wanted.value))
                return "impact " + std::to_string(i + 1) + ": " + wanted.name + " is not certain";
    }
    return {};
}

std::string BranchEquations::doubtful_flight(const std::vector<Running>& unknowns) const {
    const auto scene = scene_with<Timed>(scene_, kappa_, parameter_, timed_of(unknowns.back()));
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const auto at = variables_of(unknowns, i);
        const MotionStart<Timed> z{timed_of(at.psi.f), timed_of(at.chi.f), timed_of(at.vn.f), timed_of(at.vt.f),
                                   timed_of(at.spin.f)};
        if (!(intervals::lower(at.tau.f) > 0)) return "a flight's time is not positive";
        if (sight_of_flight(scene, z, timed_of(at.tau.f), steps_[i].vertex_step, 0x1p-16, 6000) != FlightSight::clear)
            return "flight " + std::to_string(i + 1) + ": a vertex is not shown to be inside";
    }
    return {};
}

bool BranchEquations::differ(const std::vector<Running>& unknowns, std::size_t i) const {
    for (std::size_t a = 0; a < kept_.size(); ++a) {
        const Running apart = unknowns[a] - unknowns[i * width() + a];
        const bool is_angle = kept_[a] < 2;
        if (is_angle ? !contains_zero(sine_cosine(apart).cosine - Running(1)) : !contains_zero(apart)) return true;
    }
    return false;
}

bool BranchEquations::is_in_range(const Running& parameter) const {
    constexpr double rounding = 1e-9;  // boxes reach a little beyond a range that ends at a bound
    const bool positive = parameter_ == "alpha" || parameter_ == "inertia-factor";
    const double least = intervals::lower(parameter), most = intervals::upper(parameter);
    if (positive ? !(least > 0) : !(least >= -rounding)) return false;
    if (parameter_ == "alpha") return most < 1;
    return parameter_ != "restitution" || most <= 1 + rounding;
}

std::string BranchEquations::doubt(const std::vector<Running>& unknowns) const {
    if (!is_in_range(unknowns.back())) return "its parameter leaves the range that scenes have";
    if (std::string open = doubtful_impact(unknowns); !open.empty()) return open;
    if (std::string open = doubtful_flight(unknowns); !open.empty()) return open;
    for (std::size_t i = 1; i < steps_.size(); ++i)
        if (!differ(unknowns, i)) return "points 1 and " + std::to_string(i + 1) + " may be one";
    return {};
}

std::optional<int> BranchEquations::multipliers_inside(const std::vector<Running>& unknowns) const {
    const auto scene = scene_at(unknowns.back());
    RunningMatrix all;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const auto equations = step_equations(scene, steps_[i], variables_of(unknowns, i), nullptr);
        RunningMatrix by_this, by_next, by_next_and_time;
        for (const RunningGradient* equation : equations_of(equations)) {
            by_this.emplace_back();
            by_next.emplace_back();
            for (const std::size_t index : kept_) {
                by_this.back().push_back(equation->d[index]);
                by_next.back().push_back(equation->d[next_place + index]);
            }
            by_next_and_time.push_back(by_next.back());
            by_next_and_time.back().push_back(equation->d[time_place]);
            if (steps_.size() > 1) continue;
            by_this.back().push_back(equation->d[time_place]);
            by_next.back().emplace_back(0);
        }
        // Of a fixed point (∂_z E + λ ∂_z′E, ∂_τ E), singular at each multiplier; of others −DF of the step.
        if (steps_.size() == 1) return zeros_inside(with_second_variable(by_this), with_second_variable(by_next));
        auto step = solved(by_next_and_time, by_this);
        if (!step) return std::nullopt;
        step->pop_back();
        for (auto& row : *step)
            for (Running& x : row) x = -x;
        all = i == 0 ? *step : intervals::product(*step, all);
    }
    RunningMatrix identity(all.size(), std::vector<Running>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) identity[i][i] = Running(-1);
    return zeros_inside(with_second_variable(all), with_second_variable(identity));
}

}  // namespace swirl::proof_check
