#include "apps/studies/fits/plate.hpp"

#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/plane_vectors.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace swirl::studies {

namespace {

using analysis::Kink;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Kinks = std::span<const Kink>;

/// In units of R_p: how far off the plate all kinks that are none of its are counted.
constexpr double far_off = 0.1;

double distance_from(Kinks kinks, const FilmedScene& body, const Plate& plate) {
    double sum = 0;
    for (const Kink& kink : kinks) sum += std::min(std::abs(contact_on(body, plate, kink.place).gap), far_off);
    return sum / static_cast<double>(kinks.size());
}

/// What of the vertices' distances their errors don't explain, of the kinks that are near to the plate.
void measure_doubt(Plate& plate, Kinks kinks, const FilmNoise& noise, const FilmedScene& body) {
    std::vector<double> gaps, errors;
    for (const Kink& kink : kinks) {
        const Contact contact = contact_on(body, plate, kink.place);
        if (std::abs(contact.gap) > far_off) continue;
        gaps.push_back(contact.gap);
        errors.push_back(errors_of(kink, noise, body, contact).across);
    }
    if (gaps.empty()) return;
    plate.off_plate = scale_of(gaps);
    const double expected = scale_of(errors) * std::sqrt(analysis::median_square_of_one);
    plate.doubt = std::sqrt(std::max(0.0, plate.off_plate * plate.off_plate - expected * expected));
}

/// At most `most` of them, kept evenly.
std::vector<Kink> some_kinks(Kinks kinks, std::size_t most) {
    std::vector<Kink> some;
    for (std::size_t i = 0; i < std::min(most, kinks.size()); ++i)
        some.push_back(kinks[i * kinks.size() / std::min(most, kinks.size())]);
    return some;
}

/// The vertex that reaches farthest down y.
Vector2d lowest_vertex(const FilmedScene& body, double mark, const Vector3d& place) {
    Plate level;
    level.mark = mark;
    return place.head<2>() + contact_on(body, level, place).offset;
}

/// The plate through two points, the first of which is on it, too, if there is no second.
Plate plate_through(const Vector2d& a, const Vector2d& b, double mark) {
    Plate plate;
    plate.mark = mark;
    const double sense = b[0] < a[0] ? -1 : 1;
    if (a != b) plate.tilt = std::atan2(sense * (b[1] - a[1]), sense * (b[0] - a[0]));
    plate.height = plate.normal().dot(a);
    return plate;
}

Plate first_plate(Kinks all, const FilmedScene& body) {
    constexpr int marks = 24;
    constexpr std::size_t most = 100;
    constexpr double most_tilt = 0.6;
    const std::vector<Kink> kinks = some_kinks(all, most);
    const bool has_mark = body.sides == disk_sides || body.mark;
    Plate best;
    double least = analysis::infinity;
    for (int j = 0; j < (has_mark ? 1 : marks); ++j) {
        const double mark = body.mark.value_or(has_mark ? 0 : 2 * pi<double>() / body.sides * j / marks);
        std::vector<Vector2d> vertices;
        for (const Kink& kink : kinks) vertices.push_back(lowest_vertex(body, mark, kink.place));
        const auto look = [&](const Vector2d& a, const Vector2d& b) {
            const Plate plate = plate_through(a, b, mark);
            const double found =
                std::abs(plate.tilt) < most_tilt ? distance_from(kinks, body, plate) : analysis::infinity;
            if (found < least) least = found, best = plate;
        };
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            look(vertices[i], vertices[i]);
            look(vertices[i], vertices[(i + vertices.size() / 2) % vertices.size()]);
            look(vertices[i], vertices[(i + vertices.size() / 3) % vertices.size()]);
        }
    }
    return best;
}

using ByPlate = Eigen::Vector3d;  // by height, tilt and mark

/// One equation of a kink, over its standard error.
struct PlateEquation {
    double left = 0;
    ByPlate slopes = ByPlate::Zero();
};

struct PlateEquations {
    PlateEquation wall, momentum;
};

/// Tilt about the `middle` along the plate, so that height and tilt are apart.
PlateEquations plate_equations(const Kink& kink, double middle, const FilmNoise& noise, const FilmedScene& body,
                               const Plate& plate) {
    const Contact contact = contact_on(body, plate, kink.place);
    const KinkErrors errors = errors_of(kink, noise, body, contact);
    const double gap_error = std::hypot(errors.across, plate.doubt);
    PlateEquations equations;
    const Vector2d vertex = kink.place.head<2>() + contact.offset, along(-contact.normal[1], contact.normal[0]);
    equations.wall.left = contact.gap / gap_error;
    equations.wall.slopes << 1 / gap_error, (along.dot(vertex) - middle) / gap_error, 0;
    if (body.sides == disk_sides) return equations;
    if (!body.mark) equations.wall.slopes[2] = contact.normal.dot(turned(contact.offset)) / gap_error;
    if (!plate.by_momentum) return equations;
    const Vector2d change = kink.change.head<2>();
    const double momentum_error =
        std::hypot(std::sqrt(kink.change_share) * std::hypot(body.inertia * noise.angle, noise.place),
                   change.norm() * errors.turn);
    equations.momentum.left = (body.inertia * kink.change[2] - cross(contact.offset, change)) / momentum_error;
    if (!body.mark) equations.momentum.slopes[2] = contact.offset.dot(change) / momentum_error;
    return equations;
}

void refine_plate(Kinks kinks, std::span<const double> weights, const FilmNoise& noise, const FilmedScene& body,
                  Plate& plate, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        double middle = 0;
        const Vector2d along(plate.normal()[1], -plate.normal()[0]);
        for (const Kink& kink : kinks) middle += along.dot(kink.place.head<2>()) / static_cast<double>(kinks.size());
        std::vector<PlateEquations> equations;
        std::vector<double> wall, momentum;
        for (const Kink& kink : kinks) {
            equations.push_back(plate_equations(kink, middle, noise, body, plate));
            wall.push_back(equations.back().wall.left), momentum.push_back(equations.back().momentum.left);
        }
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
        ByPlate right = ByPlate::Zero();
        const auto add = [&](const PlateEquation& equation, double scale, double counted) {
            const double square = equation.left * equation.left / (scale * scale);
            const double weight = counted * analysis::biweight(square, analysis::biweight_of_one) / (scale * scale);
            matrix += weight * equation.slopes * equation.slopes.transpose();
            right -= weight * equation.left * equation.slopes;
        };
        const double wall_scale = std::max(1.0, scale_of(wall)), momentum_scale = std::max(1.0, scale_of(momentum));
        for (std::size_t i = 0; i < kinks.size(); ++i) {
            const double counted = weights.empty() ? 1 : weights[i];
            add(equations[i].wall, wall_scale, counted);
            add(equations[i].momentum, momentum_scale, counted);
        }
        constexpr double unasked = 1e-9;  // steps that the kinks don't ask for are 0
        matrix.diagonal().array() += unasked * (1 + matrix.diagonal().maxCoeff());
        const ByPlate step = matrix.ldlt().solve(right);
        if (!step.allFinite()) return;
        // About the middle: what the tilt does to the height is that of the origin's distance from it.
        const double height = plate.height + step[0] - step[1] * middle;
        plate.tilt += step[1], plate.mark += step[2];
        plate.height = height;
    }
}

}  // namespace

Vector2d Plate::normal() const {
    return turned(direction(tilt));
}

Contact contact_on(const FilmedScene& body, const Plate& plate, const Vector3d& place) {
    const Vector2d down = -plate.normal();
    Contact contact;
    contact.normal = down;
    contact.wall.setZero();
    contact.curvature = 0;
    contact.doubt = plate.doubt;
    const double centre = down.dot(place.head<2>()) + plate.height;  // > 0: beyond the plate
    if (body.sides == disk_sides) {
        contact.offset = body.alpha * down;
        contact.gap = centre + body.alpha;
        contact.next_gap = -1;
        return contact;
    }
    const double period = 2 * pi<double>() / body.sides, first = place[2] + plate.mark;
    const double turns = (std::atan2(down[1], down[0]) - first) / period;
    const Vector2d offsets[2] = {body.alpha * direction(first + std::floor(turns) * period),
                                 body.alpha * direction(first + (std::floor(turns) + 1) * period)};
    const bool is_first = down.dot(offsets[0]) >= down.dot(offsets[1]);
    contact.offset = offsets[is_first ? 0 : 1];
    contact.gap = centre + down.dot(contact.offset);
    contact.next_gap = centre + down.dot(offsets[is_first ? 1 : 0]);
    return contact;
}

std::optional<Plate> fit_plate(Kinks kinks, const FilmNoise& noise, const FilmedScene& body, bool by_momentum) {
    if (kinks.size() < fewest_kinks) return std::nullopt;
    Plate plate = first_plate(kinks, body);
    plate.by_momentum = by_momentum;
    measure_doubt(plate, kinks, noise, body);
    return refined_plate(kinks, {}, noise, body, plate);
}

Plate refined_plate(Kinks kinks, std::span<const double> weights, const FilmNoise& noise, const FilmedScene& body,
                    const Plate& start) {
    constexpr int rounds = 6;
    Plate plate = start;
    refine_plate(kinks, weights, noise, body, plate, rounds);
    if (weights.empty()) measure_doubt(plate, kinks, noise, body);
    if (body.sides != disk_sides && !body.mark) plate.mark = std::remainder(plate.mark, 2 * pi<double>() / body.sides);
    return plate;
}

}  // namespace swirl::studies
