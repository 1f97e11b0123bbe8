#include "apps/studies/fits/dish_motion.hpp"

#include "analysis/fits/robust.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace swirl::studies {

namespace {

using Eigen::Vector2d;
using Kinks = std::span<const analysis::Kink>;
using Gradient = Eigen::Matrix<double, 5, 1>;

Vector2d direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
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

/// Robust standard deviation about 0.
double scale_of(const std::vector<double>& values) {
    std::vector<double> squares;
    for (const double value : values) squares.push_back(value * value);
    return std::sqrt(analysis::quantile(squares, 0.5) / analysis::median_square_of_one);
}

/// One equation of a kink, over its standard error, and its slopes by origin, phase, rate (about `middle`) and mark.
struct Equation {
    double left = 0;
    Gradient slopes = Gradient::Zero();
};

struct KinkEquations {
    Equation wall, momentum;
};

double cross(const Vector2d& a, const Vector2d& b) {
    return a[0] * b[1] - a[1] * b[0];
}

Vector2d turned(const Vector2d& a) {
    return {-a[1], a[0]};
}

KinkEquations equations_of(const analysis::Kink& kink, double middle, const FilmNoise& noise, const FilmedScene& scene,
                           const DishMotion& dish) {
    const bool is_disk = scene.sides == disk_sides;
    const Contact contact = contact_at(scene, dish, kink.time, kink.place);
    const Vector2d by_phase = scene.beta * turned(direction(dish.rate * kink.time + dish.phase));
    const Vector2d change = kink.change.head<2>();
    const KinkErrors errors = errors_of(kink, noise, scene, dish, contact);
    const double gap_error = errors.across;
    const double momentum_error =
        std::hypot(std::sqrt(kink.change_share) * std::hypot(scene.inertia * noise.angle, scene.alpha * noise.place),
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

/// Gauss–Newton; steps that the kinks do not ask for (β = 0: the phase) are 0.
void refine(Kinks kinks, std::span<const double> weights, const FilmNoise& noise, const FilmedScene& scene,
            DishMotion& dish, int rounds) {
    const double middle = (kinks.front().time + kinks.back().time) / 2;
    const double half = std::max(1.0, (kinks.back().time - kinks.front().time) / 2);
    for (int round = 0; round < rounds; ++round) {
        std::vector<KinkEquations> equations;
        equations.reserve(kinks.size());
        for (const analysis::Kink& kink : kinks) equations.push_back(equations_of(kink, middle, noise, scene, dish));
        const EquationScales scales = scales_of(equations);
        Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
        Gradient right = Gradient::Zero();
        const auto add = [&](Equation equation, double scale, double counted) {
            equation.slopes[3] /= half;
            const double square = equation.left * equation.left / (scale * scale);
            const double weight = counted * analysis::biweight(square, analysis::biweight_of_one) / (scale * scale);
            normal += weight * equation.slopes * equation.slopes.transpose();
            right -= weight * equation.left * equation.slopes;
        };
        for (std::size_t i = 0; i < kinks.size(); ++i) {
            const double counted = weights.empty() ? 1 : weights[i];
            add(equations[i].wall, scales.wall, counted);
            add(equations[i].momentum, scales.momentum, counted);
        }
        constexpr double unasked = 1e-9;
        normal.diagonal().array() += unasked * (1 + normal.diagonal().maxCoeff());
        const Gradient step = normal.ldlt().solve(right);
        dish.origin += step.head<2>();
        dish.rate += step[3] / half;
        dish.phase += step[2] - step[3] / half * middle;
        dish.mark += step[4];
    }
}

}  // namespace

Eigen::Vector2d DishMotion::centre(const FilmedScene& scene, double time) const {
    return origin + scene.beta * direction(rate * time + phase);
}

Eigen::Vector2d DishMotion::velocity(const FilmedScene& scene, double time) const {
    const Vector2d along = direction(rate * time + phase);
    return scene.beta * rate * Vector2d(-along[1], along[0]);
}

Contact contact_at(const FilmedScene& scene, const DishMotion& dish, double time, const Eigen::Vector3d& place) {
    const Vector2d from_centre = place.head<2>() - dish.centre(scene, time);
    Contact contact;
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
                     const DishMotion& dish, const Contact& contact) {
    const double place = std::sqrt(kink.share), spin = scene.sides == disk_sides ? 0 : kink.drift[2];
    const double angle = scene.sides == disk_sides ? 0 : noise.angle;
    const Vector2d slip = kink.drift.head<2>() + spin * turned(contact.offset) - dish.velocity(scene, kink.time);
    const double turn = std::hypot(place * angle, spin * kink.error);
    const double vertex = place * std::hypot(noise.place, scene.alpha * angle);
    return {std::hypot(vertex, contact.normal.dot(slip) * kink.error), std::hypot(vertex, slip.norm() * kink.error),
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
