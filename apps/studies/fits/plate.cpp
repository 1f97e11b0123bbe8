#include "apps/studies/fits/plate.hpp"

#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/plane_vectors.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

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
        vertices.reserve(kinks.size());
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

using ByPlate = Eigen::Vector4d;  // by height, tilt, mark and the body's size

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
    equations.wall.slopes << 1 / gap_error, (along.dot(vertex) - middle) / gap_error, 0,
        contact.normal.dot(contact.offset) / (body.alpha * gap_error);
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

/// Standard errors of the size, in units of how the kinks scatter where that is more than theirs.
struct Refined {
    double size_error = analysis::infinity;
    bool settled = false;
};

/// Gauss–Newton; the body's size (α) as well, or not.
Refined refine_plate(Kinks kinks, std::span<const double> weights, const FilmNoise& noise, FilmedScene& body,
                     Plate& plate, int rounds, bool with_size = false) {
    constexpr double settled = 0.01;  // of the size's error
    Refined refined;
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
        Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
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
        if (!with_size) matrix.row(3).setZero(), matrix.col(3).setZero(), right[3] = 0;
        constexpr double unasked = 1e-9;  // steps that the kinks don't ask for are 0
        matrix.diagonal().array() += unasked * (1 + matrix.diagonal().maxCoeff());
        const Eigen::LDLT<Eigen::Matrix4d> solver(matrix);
        const ByPlate step = solver.solve(right);
        if (!step.allFinite()) return {};
        const Eigen::Matrix4d covariance = solver.solve(Eigen::Matrix4d::Identity());
        plate.errors = covariance.block<2, 2>(1, 1);
        if (body.sides == disk_sides || body.mark) plate.errors.row(1).setZero(), plate.errors.col(1).setZero();
        refined.size_error = std::sqrt(covariance(3, 3));
        // About the middle: what the tilt does to the height is that of the origin's distance from it.
        const double height = plate.height + step[0] - step[1] * middle;
        plate.tilt += step[1], plate.mark += step[2];
        plate.height = height;
        body.alpha += step[3];
        refined.settled = std::abs(step[3]) < settled * refined.size_error;
    }
    return refined;
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
    FilmedScene same = body;
    refine_plate(kinks, weights, noise, same, plate, rounds);
    if (weights.empty()) measure_doubt(plate, kinks, noise, body);
    if (body.sides != disk_sides && !body.mark) plate.mark = std::remainder(plate.mark, 2 * pi<double>() / body.sides);
    return plate;
}

namespace {

/// Straight through three kinks: y = height + tilt x + size cos φ, φ the angle from straight down to the lowest vertex.
/// That holds on tilted plates, too, with the mark less the tilt and all over the tilt's cosine.
struct Heights {
    std::vector<Eigen::Vector3d> rows;  // (1, x, cos φ)
    std::vector<double> y;

    Heights(Kinks kinks, const FilmedScene& body, double mark) {
        Plate level;
        level.mark = mark;
        for (const Kink& kink : kinks) {
            const Vector2d vertex = contact_on(body, level, kink.place).offset;
            rows.emplace_back(1, kink.place[0], -vertex[1] / body.alpha), y.push_back(kink.place[1]);
        }
    }
    /// (height, tilt, size) through three of them.
    Eigen::Vector3d through(std::size_t a, std::size_t b, std::size_t c) const {
        Eigen::Matrix3d matrix;
        matrix << rows[a].transpose(), rows[b].transpose(), rows[c].transpose();
        return matrix.inverse() * Eigen::Vector3d(y[a], y[b], y[c]);
    }
    double distance(const Eigen::Vector3d& line, double far) const {
        double sum = 0;
        for (std::size_t i = 0; i < y.size(); ++i) sum += std::min(std::abs(y[i] - rows[i].dot(line)), far);
        return sum / static_cast<double>(y.size());
    }
};

struct SizedPlate {
    Plate plate;
    double size = analysis::nan;
};

/// From the heights of the centre at the kinks, whatever the size that was given.
SizedPlate first_sized_plate(Kinks all, const FilmedScene& body) {
    constexpr int grid = 48;
    constexpr std::size_t most = 60;
    constexpr double most_tilt = 0.6, largest = 10;
    const std::vector<Kink> kinks = some_kinks(all, most);
    const std::size_t count = kinks.size();
    std::vector<double> marks;
    marks.reserve(grid);
    for (int j = 0; j < grid; ++j) marks.push_back(2 * pi<double>() / body.sides * j / grid);
    if (body.mark) marks = {*body.mark};
    SizedPlate best;
    double least = analysis::infinity;
    for (const double mark : marks) {
        const Heights heights(kinks, body, mark);
        const auto look = [&](std::size_t a, std::size_t b, std::size_t c) {
            const Eigen::Vector3d line = heights.through(a % count, b % count, c % count);
            if (!line.allFinite() || !(line[2] > 0 && line[2] < largest) || std::abs(line[1]) > most_tilt) return;
            const double found = heights.distance(line, far_off * std::min(1.0, line[2])) / std::min(1.0, line[2]);
            if (found >= least) return;
            least = found;
            best.plate.tilt = std::atan(line[1]);
            const double cosine = std::cos(best.plate.tilt);
            best.plate.height = line[0] * cosine, best.size = line[2] * cosine;
            best.plate.mark = body.mark ? mark : mark + best.plate.tilt;
        };
        for (std::size_t i = 0; i < count; ++i) {
            look(i, i + count / 3, i + 2 * count / 3);
            look(i, i + count / 2, i + count / 5);
            look(i, i + 1, i + count / 2);
            look(i, i + 1, i + 2);
        }
    }
    return best;
}

double scatter_off(Kinks kinks, const FilmedScene& body, const Plate& plate) {
    std::vector<double> gaps;
    for (const Kink& kink : kinks) gaps.push_back(contact_on(body, plate, kink.place).gap);
    return scale_of(gaps);
}

}  // namespace

std::optional<BodyOnPlate> body_on_plate(Kinks kinks, const FilmNoise& noise, const FilmedScene& body) {
    constexpr int rounds = 20;
    if (kinks.size() < fewest_kinks) return std::nullopt;
    FilmedScene sized = body;
    BodyOnPlate found;
    found.sides = body.sides, found.kinks = kinks.size();
    if (body.sides == disk_sides) {
        found.plate = first_plate(kinks, body);
        found.plate.by_momentum = false;
        refine_plate(kinks, {}, noise, sized, found.plate, rounds);
    } else {
        const SizedPlate start = first_sized_plate(kinks, body);
        if (!(start.size > 0)) return std::nullopt;
        found.plate = start.plate, sized.alpha = start.size;
        found.plate.by_momentum = false;
        Refined refined;
        for (int pass = 0; pass < 2; ++pass) {  // the start is as coarse as its grid, and its doubt no body's
            measure_doubt(found.plate, kinks, noise, sized);
            refined = refine_plate(kinks, {}, noise, sized, found.plate, rounds, true);
        }
        if (!(refined.settled && sized.alpha > 0)) return std::nullopt;
        found.size = sized.alpha, found.error = refined.size_error;
    }
    found.scatter = scatter_off(kinks, sized, found.plate);
    std::vector<double> errors;
    for (const Kink& kink : kinks)
        errors.push_back(errors_of(kink, noise, sized, contact_on(sized, found.plate, kink.place)).across);
    found.expected = scale_of(errors) * std::sqrt(analysis::median_square_of_one);
    return found;
}

}  // namespace swirl::studies
