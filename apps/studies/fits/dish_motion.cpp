#include "apps/studies/fits/dish_motion.hpp"

#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/plane_vectors.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace swirl::studies {

namespace {

using Eigen::Vector2d;
using Kinks = std::span<const analysis::Kink>;
using Gradient = Eigen::Matrix<double, 6, 1>;

/// Of numbers about 1, whose squares neither overflow nor vanish; std::hypot takes five times as long.
double length_of(double a, double b) {
    return std::sqrt(a * a + b * b);
}

double period_of(const FilmedScene& scene) {
    return scene.sides == disk_sides ? 0 : 2 * pi<double>() / scene.sides;
}

std::vector<double> gaps_of(Kinks kinks, const FilmedScene& scene, const DishMotion& dish) {
    std::vector<double> gaps;
    for (const analysis::Kink& kink : kinks) gaps.push_back(contact_at(scene, dish, kink.time, kink.place).gap);
    return gaps;
}

/// Mean distance from the wall, none counted beyond a tenth of R_c.
double badness(Kinks kinks, const FilmedScene& scene, const DishMotion& dish) {
    double sum = 0;
    for (const double gap : gaps_of(kinks, scene, dish)) sum += std::min(std::abs(gap), 0.1);
    return sum / static_cast<double>(kinks.size());
}

/// One equation of a kink, over its standard error, and its slopes by origin, phase, rate (about `middle`), mark and α.
struct Equation {
    double left = 0;
    Gradient slopes = Gradient::Zero();
};

struct KinkEquations {
    Equation wall, momentum;
};

KinkEquations equations_of(const analysis::Kink& kink, double middle, const FilmNoise& noise, const FilmedScene& scene,
                           const DishMotion& dish) {
    const bool is_disk = scene.sides == disk_sides;
    const Contact contact = contact_at(scene, dish, kink.time, kink.place);
    const Vector2d by_phase = contact.wall / dish.rate;
    const Vector2d change = kink.change.head<2>();
    const KinkErrors errors = errors_of(kink, noise, scene, contact);
    const double gap_error = errors.across;
    const double momentum_error =
        length_of(std::sqrt(kink.change_share) * length_of(scene.inertia * noise.angle, scene.alpha * noise.place),
                  change.norm() * scene.alpha * errors.turn);
    KinkEquations equations;
    equations.wall.left = contact.gap / gap_error;
    // Of a disk the offset is that of the wall's normal, and tells nothing new.
    if (!is_disk)
        equations.momentum.left = (scene.inertia * kink.change[2] - cross(contact.offset, change)) / momentum_error;
    const auto add_centre = [&](Eigen::Index parameter, const Vector2d& moved) {  // of the dish's centre
        equations.wall.slopes[parameter] = -contact.normal.dot(moved) / gap_error;
    };
    add_centre(0, Vector2d::UnitX());
    add_centre(1, Vector2d::UnitY());
    add_centre(2, by_phase);
    add_centre(3, by_phase * (kink.time - middle));
    equations.wall.slopes[5] = contact.normal.dot(contact.offset) / (scene.alpha * gap_error);
    if (!is_disk)
        equations.momentum.slopes[5] =
            (2 * scene.inertia * kink.change[2] - cross(contact.offset, change)) / (scene.alpha * momentum_error);
    if (is_disk || scene.mark) return equations;
    equations.wall.slopes[4] = contact.normal.dot(turned(contact.offset)) / gap_error;
    equations.momentum.slopes[4] = contact.offset.dot(change) / momentum_error;
    return equations;
}

/// Robust scales of both kinds, never below that of the errors.
struct EquationScales {
    double wall, momentum;
};

EquationScales scales_of(const std::vector<KinkEquations>& equations) {
    std::vector<double> wall, momentum;
    for (const KinkEquations& one : equations) wall.push_back(one.wall.left), momentum.push_back(one.momentum.left);
    return {std::max(1.0, scale_of(wall)), std::max(1.0, scale_of(momentum))};
}

/// Times from the middle of the kinks, in halves of their span.
struct KinkSpan {
    double middle, half;
};

KinkSpan span_of(Kinks kinks) {
    const double begin = kinks.front().time, end = kinks.back().time;
    return {(begin + end) / 2, std::max(1.0, (end - begin) / 2)};
}

/// Of least squares, by all six parameters, the rate's in 1/half.
struct NormalEquations {
    double wall_scale = 1;
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Gradient right = Gradient::Zero();

    void add(Equation equation, double half, double scale, double counted) {
        equation.slopes[3] /= half;
        const double square = equation.left * equation.left / (scale * scale);
        const double weight = counted * analysis::biweight(square, analysis::biweight_of_one) / (scale * scale);
        matrix += weight * equation.slopes * equation.slopes.transpose();
        right -= weight * equation.left * equation.slopes;
    }
    /// The inverse of the matrix; steps that the kinks do not ask for (β = 0: the phase) are 0.
    Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver() {
        constexpr double unasked = 1e-9;
        matrix.diagonal().array() += unasked * (1 + matrix.diagonal().maxCoeff());
        return Eigen::LDLT<Eigen::Matrix<double, 6, 6>>(matrix);
    }
};

/// Without weights each kink counts once.
NormalEquations normal_equations(Kinks kinks, std::span<const double> weights, const FilmNoise& noise,
                                 const FilmedScene& scene, const DishMotion& dish) {
    const auto [middle, half] = span_of(kinks);
    std::vector<KinkEquations> equations;
    equations.reserve(kinks.size());
    for (const analysis::Kink& kink : kinks) equations.push_back(equations_of(kink, middle, noise, scene, dish));
    const EquationScales scales = scales_of(equations);
    NormalEquations normal;
    normal.wall_scale = scales.wall;
    for (std::size_t i = 0; i < kinks.size(); ++i) {
        const double counted = weights.empty() ? 1 : weights[i];
        normal.add(equations[i].wall, half, scales.wall, counted);
        normal.add(equations[i].momentum, half, scales.momentum, counted);
    }
    return normal;
}

/// All but α.
void take_step(DishMotion& dish, const Gradient& step, const KinkSpan& span) {
    dish.origin += step.head<2>();
    dish.rate += step[3] / span.half;
    dish.phase += step[2] - step[3] / span.half * span.middle;
    dish.mark += step[4];
}

/// The squared differences of neighbours are those of independent numbers (von Neumann's ratio, 4 standard errors).
bool are_independent(const std::vector<double>& values) {
    double mean = 0, squares = 0, differences = 0;
    const auto count = static_cast<double>(values.size());
    for (const double value : values) mean += value / count;
    for (std::size_t i = 0; i < values.size(); ++i) {
        squares += (values[i] - mean) * (values[i] - mean);
        if (i > 0) differences += (values[i] - values[i - 1]) * (values[i] - values[i - 1]);
    }
    return differences > 2 * squares * (1 - 4 / std::sqrt(count));
}

/// How widely frames scatter about the wall, in units of their errors: 1 or more, less only if they scatter as noise.
double scatter_of_frames(Kinks frames, const FilmNoise& noise, const FilmedScene& scene, const DishMotion& dish) {
    const std::vector<double> gaps = gaps_of(frames, scene, dish);
    std::vector<double> values;
    for (std::size_t i = 0; i < frames.size(); ++i)
        values.push_back(
            gaps[i] /
            errors_of(frames[i], noise, scene, contact_at(scene, dish, frames[i].time, frames[i].place)).across);
    const double scatter = scale_of(values);
    return are_independent(gaps) ? scatter : std::max(1.0, scatter);
}

/// Gauss–Newton, α as given.
void refine(Kinks kinks, std::span<const double> weights, const FilmNoise& noise, const FilmedScene& scene,
            DishMotion& dish, int rounds) {
    const KinkSpan span = span_of(kinks);
    for (int round = 0; round < rounds; ++round) {
        NormalEquations normal = normal_equations(kinks, weights, noise, scene, dish);
        normal.matrix.row(5).setZero(), normal.matrix.col(5).setZero();
        normal.right[5] = 0;
        take_step(dish, normal.solver().solve(normal.right), span);
    }
}

}  // namespace

Eigen::Vector2d DishMotion::centre(const FilmedScene& scene, double time) const {
    return origin + scene.beta * direction(rate * time + phase);
}

Contact contact_at(const FilmedScene& scene, const DishMotion& dish, double time, const Eigen::Vector3d& place) {
    const Vector2d towards = direction(dish.rate * time + dish.phase);
    const Vector2d from_centre = place.head<2>() - dish.origin - scene.beta * towards;
    Contact contact;
    contact.wall = scene.beta * dish.rate * turned(towards);
    if (scene.sides == disk_sides) {
        const double distance = from_centre.norm();
        contact.normal = from_centre / distance;
        contact.offset = scene.alpha * contact.normal;
        contact.gap = distance + scene.alpha - 1;
        contact.next_gap = -1;
        return contact;
    }
    // The vertex nearest to the outward direction, and the one on its other side, reach farthest.
    const double period = period_of(scene), outward = std::atan2(from_centre[1], from_centre[0]);
    const double first = place[2] + dish.mark;
    const double turns = (outward - first) / period;
    contact.gap = contact.next_gap = -analysis::infinity;
    for (const double index : {std::floor(turns), std::floor(turns) + 1}) {
        const Vector2d offset = scene.alpha * direction(first + index * period);
        const Vector2d vertex = from_centre + offset;
        const double gap = vertex.norm() - 1;
        if (gap > contact.gap) {
            contact.next_gap = contact.gap;
            contact.gap = gap, contact.offset = offset, contact.normal = vertex.normalized();
        } else {
            contact.next_gap = gap;
        }
    }
    return contact;
}

KinkErrors errors_of(const analysis::Kink& kink, const FilmNoise& noise, const FilmedScene& scene,
                     const Contact& contact) {
    const double place = std::sqrt(kink.share), spin = scene.sides == disk_sides ? 0 : kink.drift[2];
    const double angle = scene.sides == disk_sides ? 0 : noise.angle;
    const Vector2d slip = kink.drift.head<2>() + spin * turned(contact.offset) - contact.wall;
    const double turn = length_of(place * angle, spin * kink.error);
    const double vertex = place * length_of(noise.place, scene.alpha * angle);
    return {length_of(vertex, contact.normal.dot(slip) * kink.error), length_of(vertex, slip.norm() * kink.error),
            turn};
}

std::optional<DishMotion> fit_dish(Kinks kinks, const FilmNoise& noise, const FilmedScene& scene,
                                   const Eigen::Vector2d& origin) {
    if (kinks.size() < fewest_kinks) return std::nullopt;
    constexpr int phases = 36, marks = 12, rounds = 12;
    constexpr std::size_t first_kinks = 60, kept = 6;
    std::size_t count = std::min(first_kinks, kinks.size());
    std::vector<std::pair<double, DishMotion>> starts;
    const bool has_mark = scene.sides == disk_sides || scene.mark;
    for (int i = 0; i < phases; ++i)
        for (int j = 0; j < (has_mark ? 1 : marks); ++j) {
            DishMotion dish;
            dish.origin = origin;
            dish.phase = 2 * pi<double>() * i / phases;
            dish.mark = scene.mark.value_or(period_of(scene) * j / marks);
            starts.emplace_back(badness(kinks.first(count), scene, dish), dish);
        }
    std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    DishMotion best;
    double least = analysis::infinity;
    for (std::size_t k = 0; k < kept; ++k) {
        DishMotion dish = starts[k].second;
        refine(kinks.first(count), {}, noise, scene, dish, rounds);
        const double found = badness(kinks.first(count), scene, dish);
        if (found < least) least = found, best = dish;
    }
    while (count < kinks.size()) {
        count = std::min(2 * count, kinks.size());
        refine(kinks.first(count), {}, noise, scene, best, rounds);
    }
    return refined_dish(kinks, {}, noise, scene, best);
}

std::optional<SizeFit> size_on_wall(Kinks kinks, const FilmNoise& noise, const FilmedScene& scene,
                                    const DishMotion& start, OnWall what) {
    constexpr int most_rounds = 30;
    constexpr double settled = 0.01;         // of the error
    constexpr double most_error = 0.004;     // beyond, a few kinks of contact that lasts have been fitted
    constexpr double most_wall_scale = 1.5;  // of impacts it is 1; kinks of contact that lasts lie off any wall
    if (kinks.size() < fewest_kinks) return std::nullopt;
    const double shape = scene.inertia / (scene.alpha * scene.alpha);
    const KinkSpan span = span_of(kinks);
    FilmedScene sized = scene;
    DishMotion dish = start;
    for (int round = 0; round < most_rounds; ++round) {
        NormalEquations normal = normal_equations(kinks, {}, noise, sized, dish);
        const auto solver = normal.solver();
        const Gradient step = solver.solve(normal.right);
        double error = std::sqrt(solver.solve(Gradient::Unit(5))[5]);
        take_step(dish, step, span);
        sized.alpha += step[5];
        sized.inertia = shape * sized.alpha * sized.alpha;
        if (!(sized.alpha > 0 && sized.alpha < 1 && std::isfinite(error))) return std::nullopt;
        if (std::abs(step[5]) > settled * error) continue;
        if (what == OnWall::frames) error *= std::min(1.0, scatter_of_frames(kinks, noise, sized, dish));
        if (normal.wall_scale > most_wall_scale || error > most_error) return std::nullopt;
        return SizeFit{sized.alpha, error};
    }
    return std::nullopt;
}

DishMotion refined_dish(Kinks kinks, std::span<const double> weights, const FilmNoise& noise, const FilmedScene& scene,
                        const DishMotion& start) {
    constexpr int rounds = 4;
    DishMotion dish = start;
    refine(kinks, weights, noise, scene, dish, rounds);
    dish.phase = std::remainder(dish.phase, 2 * pi<double>());
    if (period_of(scene) > 0 && !scene.mark) dish.mark = std::remainder(dish.mark, period_of(scene));
    dish.off_wall = scale_of(gaps_of(kinks, scene, dish));
    return dish;
}

}  // namespace swirl::studies
