#include "analysis/fits/gravity.hpp"

#include "analysis/fits/robust.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

using Eigen::Vector2d;

using Places = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Of one arc: the places less their fall, A and B projected out, and the bend that a unit of g makes of them.
struct FallPart {
    Places left;
    Eigen::VectorXd bend;
};

FallPart part_of(std::span<const FilmFrame> frames, const Vector2d& gravity, double drag) {
    const auto count = static_cast<Eigen::Index>(frames.size());
    const double middle = (frames.front().time + frames.back().time) / 2;
    Eigen::VectorXd s(count);
    FallPart part{Places(count, 2), Eigen::VectorXd(count)};
    const UniformFall unit{{1, 0}, middle};
    for (Eigen::Index i = 0; i < count; ++i) {
        const FilmFrame& frame = frames[static_cast<std::size_t>(i)];
        s[i] = dragged_time(frame.time - middle, drag);
        part.bend[i] = unit.place(frame.time, drag)[0];
        part.left.row(i) = (frame.place - frames.front().place).head<2>().transpose();
    }
    part.left -= part.bend * gravity.transpose();
    s.array() -= s.mean();
    part.bend.array() -= part.bend.mean();
    part.bend -= s * (s.dot(part.bend) / s.squaredNorm());
    part.left.rowwise() -= part.left.colwise().mean().eval();
    part.left -= s * (s.transpose() * part.left / s.squaredNorm()).eval();
    return part;
}

/// Acceleration of a stretch of frames by least squares.
struct Acceleration {
    Vector2d value = Vector2d::Zero();
    bool is_smooth = false;  ///< y bends surely, and as a parabola does
};

Acceleration acceleration_of(std::span<const FilmFrame> frames, double noise) {
    constexpr double sure = 8, wide = 1.5, explained = 0.97;  // of a kink in the middle a parabola explains 15/16
    const FallPart part = part_of(frames, Vector2d::Zero(), 0);
    const double square = part.bend.squaredNorm();
    Acceleration found;
    found.value = part.left.transpose() * part.bend / square;
    const double all = part.left.col(1).squaredNorm(), bent = found.value[1] * found.value[1] * square;
    const double by_noise = std::pow(wide * noise, 2) * static_cast<double>(frames.size());
    found.is_smooth = bent > std::pow(sure * noise, 2) && (all - bent < by_noise || bent > explained * all);
    return found;
}

/// Stretches of so many frames that bend smoothly, none across a gap, each begun a quarter of it after the one before.
std::vector<Acceleration> stretches(const FilmArcs& film, std::size_t length) {
    std::vector<Acceleration> all;
    std::size_t begin = 0;
    const std::span<const FilmFrame> kept = film.kept;
    const auto take_until = [&](std::size_t end) {
        for (std::size_t i = begin; i + length <= end; i += std::max<std::size_t>(1, length / 4))
            if (const Acceleration found = acceleration_of(kept.subspan(i, length), film.place_noise); found.is_smooth)
                all.push_back(found);
        begin = end;
    };
    for (const FreeArc& arc : film.arcs)
        if (arc.after_gap) take_until(arc.first);
    take_until(kept.size());
    return all;
}

constexpr std::size_t least_stretch = 5;

/// As many frames as bend by many times their noise: straight pieces are cut where they bend by some.
std::size_t bent_length(const FilmArcs& straight) {
    std::vector<double> counts;
    for (const FreeArc& arc : straight.arcs)
        if (arc.count >= fewest_frames) counts.push_back(static_cast<double>(arc.count));
    constexpr auto least = static_cast<double>(least_stretch);
    return counts.empty() ? 0 : static_cast<std::size_t>(std::max(least, 2 * quantile(std::move(counts), 0.5)));
}

/// By g_x, g_y and γ: what an arc asks them to change by is the solution of matrix · change = asked.
struct FallEquations {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d asked = Eigen::Vector3d::Zero();
    double off = 0;  ///< squared length of the bend that is left, over Σ bend²: χ²(2) σ² of a free arc
};

FallEquations equations_of(std::span<const FilmFrame> frames, const Vector2d& gravity, double drag) {
    constexpr double step = 1e-4;  // of γ, times its time: its error is of the order of the square
    const double by = step / (frames.back().time - frames.front().time);
    const FallPart part = part_of(frames, gravity, drag);
    const Places slope =
        (part_of(frames, gravity, drag + by).left - part_of(frames, gravity, drag - by).left) / (2 * by);
    const Vector2d bent = part.left.transpose() * part.bend;
    const double square = part.bend.squaredNorm();
    FallEquations equations;
    equations.off = bent.squaredNorm() / square;
    equations.matrix(0, 0) = equations.matrix(1, 1) = square;
    equations.matrix.block<2, 1>(0, 2) = -slope.transpose() * part.bend;
    equations.matrix.block<1, 2>(2, 0) = equations.matrix.block<2, 1>(0, 2).transpose();
    equations.matrix(2, 2) = slope.squaredNorm();
    equations.asked.head<2>() = bent;
    equations.asked[2] = -slope.cwiseProduct(part.left).sum();
    return equations;
}

/// Which of the three are looked for.
struct Wanted {
    bool gravity = true, drag = true;
};

struct Solved {
    Eigen::Vector3d value = Eigen::Vector3d::Constant(nan);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    std::size_t arcs = 0;
};

Eigen::Matrix3d without(Eigen::Matrix3d matrix, const Wanted& wanted) {
    const bool kept[3] = {wanted.gravity, wanted.gravity, wanted.drag};
    for (Eigen::Index k = 0; k < 3; ++k)
        if (!kept[k]) matrix.row(k).setZero(), matrix.col(k).setZero(), matrix(k, k) = 1;
    return matrix;
}

/// From the arcs' own model.
std::optional<Solved> solve_fall(const FilmArcs& film, const std::vector<ArcPart>& parts, const Wanted& wanted) {
    constexpr int rounds = 20;
    const std::span<const FilmFrame> kept = film.kept;
    const double variance = film.place_noise * film.place_noise;
    Solved solved;
    solved.value << film.fall.gravity, wanted.drag ? film.drags.places : 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<FallEquations> all;
        std::vector<double> within;  // arcs that are cut off a rolling body lie far off
        for (const ArcPart& part : parts) {
            all.push_back(equations_of(kept.subspan(part.first, part.last - part.first + 1), solved.value.head<2>(),
                                       solved.value[2]));
            constexpr double far = 1e3;
            if (all.back().off < far * variance) within.push_back(all.back().off / variance);
        }
        if (within.size() < fewest_falling) return std::nullopt;
        constexpr double median_of_two = 1.386294;  // of χ² with 2 degrees of freedom
        const double scale = std::max(1.0, std::sqrt(quantile(std::move(within), 0.5) / median_of_two));
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero(), scatter = Eigen::Matrix3d::Zero();
        Eigen::Vector3d asked = Eigen::Vector3d::Zero();
        solved.arcs = 0;
        for (const FallEquations& one : all) {
            const double weight = biweight(one.off / (scale * scale * variance), biweight_of_three);
            if (weight > 0) ++solved.arcs;
            matrix += weight * one.matrix, asked += weight * one.asked;
            scatter += weight * weight * one.asked * one.asked.transpose();
        }
        if (solved.arcs < fewest_falling) return std::nullopt;
        for (Eigen::Index k = 0; k < 3; ++k)
            if (k < 2 ? !wanted.gravity : !wanted.drag) asked[k] = 0;
        const Eigen::Matrix3d inverse = without(matrix, wanted).inverse();
        const Eigen::Vector3d step = inverse * asked;
        if (!step.allFinite()) return std::nullopt;
        solved.value += step;
        const Eigen::Matrix3d by_noise = variance * inverse, by_scatter = inverse * scatter * inverse;
        const double longer = of_few(solved.arcs);
        solved.covariance = longer * longer * (by_scatter.trace() > by_noise.trace() ? by_scatter : by_noise);
        for (Eigen::Index k = 0; k < 3; ++k)
            if (k < 2 ? !wanted.gravity : !wanted.drag)
                solved.covariance.row(k).setZero(), solved.covariance.col(k).setZero();
    }
    return solved;
}

/// Arcs without the frames next to their ends, which may be on either.
std::vector<ArcPart> inner_parts(const FilmArcs& film, const std::vector<bool>& counts) {
    std::vector<ArcPart> parts;
    for (std::size_t k = 0; k < film.arcs.size(); ++k) {
        const FreeArc& arc = film.arcs[k];
        if ((counts.empty() || counts[k]) && arc.last >= arc.first + fewest_falling_frames + 1)
            parts.push_back({arc.first + 1, arc.last - 1});
    }
    return parts;
}

/// Parts whose places fall freely, for the angle's sake.
std::vector<ArcPart> falling_parts(const FilmArcs& film, const std::vector<ArcPart>& parts, const FallModel& model) {
    constexpr double most = 20;  // of χ²(2): 5 in 100,000
    std::vector<ArcPart> falling;
    for (const ArcPart& part : parts) {
        const std::span<const FilmFrame> kept = film.kept;
        const FallPart left =
            part_of(kept.subspan(part.first, part.last - part.first + 1), model.gravity, model.drags.places);
        const double off = (left.left.transpose() * left.bend).squaredNorm() / left.bend.squaredNorm();
        if (off < most * film.place_noise * film.place_noise) falling.push_back(part);
    }
    return falling;
}

}  // namespace

std::optional<Vector2d> first_gravity(const FilmArcs& straight) {
    constexpr double near = 0.1;  // of g: a drag and noise change it by about as much
    std::vector<Acceleration> all;
    const std::size_t usual = bent_length(straight);
    // Down to the shortest: of a precise film what is straight for long lies still, and what falls is cut to pairs.
    for (std::size_t length = 2 * usual; length >= least_stretch; length = 3 * length / 4) {
        const std::vector<Acceleration> some = stretches(straight, length);
        all.insert(all.end(), some.begin(), some.end());
    }
    std::sort(all.begin(), all.end(),
              [](const Acceleration& a, const Acceleration& b) { return a.value[1] < b.value[1]; });
    std::size_t most = 0, begin = 0;  // of stretches from one on that share its acceleration
    for (std::size_t i = 0, end = 0; i < all.size(); ++i) {
        const double room = 2 * near * std::abs(all[i].value[1]);
        end = std::max(end, i);
        while (end < all.size() && all[end].value[1] - all[i].value[1] < room) ++end;
        if (end - i > most) most = end - i, begin = i;
    }
    if (most == 0) return std::nullopt;
    std::vector<double> x, y;
    for (std::size_t i = begin; i < begin + most; ++i) x.push_back(all[i].value[0]), y.push_back(all[i].value[1]);
    return Vector2d(quantile(std::move(x), 0.5), quantile(std::move(y), 0.5));
}

std::optional<FallFit> fit_fall(const FilmArcs& film, bool is_given, const std::vector<bool>& counts) {
    const std::vector<ArcPart> parts = inner_parts(film, counts);
    FallFit fit;
    const std::optional<Solved> dragged = solve_fall(film, parts, {!is_given, true});
    std::optional<Solved> found = dragged;
    if (dragged) {
        fit.drag.value = dragged->value[2], fit.drag.error = std::sqrt(dragged->covariance(2, 2));
        fit.drag.parts = dragged->arcs;
    }
    const bool drags = fit.drag.surely_drags();
    if (!drags) found = solve_fall(film, parts, {!is_given, false});
    if (!found) return std::nullopt;
    fit.arcs = found->arcs;
    fit.model.gravity = found->value.head<2>();
    fit.error = found->covariance.diagonal().head<2>().cwiseSqrt();
    if (drags) fit.model.drags.places = fit.drag.value;
    fit.spin = fit_spin_drag(film.kept, falling_parts(film, parts, fit.model), film.angle_noise);
    if (fit.spin.surely_drags()) fit.model.drags.angle = fit.spin.value;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(found->covariance);
    for (Eigen::Index k = 0; k < 3; ++k) {
        const Eigen::Vector3d step = std::sqrt(std::max(0.0, axes.eigenvalues()[k])) * axes.eigenvectors().col(k);
        if (step == Eigen::Vector3d::Zero()) continue;
        FallModel moved = fit.model;
        moved.gravity += step.head<2>(), moved.drags.places += step[2];
        fit.moved.push_back(moved);
    }
    if (fit.model.drags.angle != 0) {
        fit.moved.push_back(fit.model);
        fit.moved.back().drags.angle += fit.spin.error;
    }
    return fit;
}

std::vector<bool> falling_arcs(const FilmArcs& film) {
    constexpr double sure = 4, other = 1.0 / 3, at_rest = 0.7;  // of g, which a body at rest is off by
    std::vector<bool> falls;
    for (const FreeArc& arc : film.arcs) {
        const std::span<const FilmFrame> kept = film.kept;
        if (arc.count < fewest_frames) {
            falls.push_back(true);
            continue;
        }
        const FallPart part =
            part_of(kept.subspan(arc.first, arc.last - arc.first + 1), film.fall.gravity, film.drags.places);
        const double square = part.bend.squaredNorm(), off = (part.left.transpose() * part.bend).norm() / square;
        const double gravity = film.fall.gravity.norm(), noise = sure * film.place_noise / std::sqrt(square);
        falls.push_back(off < std::max(other * gravity, std::min(at_rest * gravity, noise)));
    }
    return falls;
}

namespace {

/// Of one axis.
struct Bends {
    std::vector<double> squares, expected, ratios;  ///< of accelerations, of their errors, and these of one another

    void add(const FilmArcs& film, const FreeArc& arc, Eigen::Index axis, double noise) {
        double bend = 0, bent = 0, mean = 0, slope = 0;
        const auto half_square = [&](std::size_t i) { return std::pow(film.kept[i].time - arc.mean_time, 2) / 2; };
        for (std::size_t i = arc.first; i <= arc.last; ++i) {
            mean += half_square(i) / static_cast<double>(arc.count);
            slope += half_square(i) * arc.since(film.kept[i].time)[axis] / arc.spread[axis];
        }
        for (std::size_t i = arc.first; i <= arc.last; ++i) {
            const double time = film.kept[i].time, left = half_square(i) - mean - slope * arc.since(time)[axis];
            bend += left * left, bent += left * (film.kept[i].place - film.place_on(arc, time))[axis];
        }
        squares.push_back(std::pow(bent / bend, 2));
        expected.push_back(noise * noise / bend);
        ratios.push_back(squares.back() / expected.back());
    }
    double beyond_noise() const {
        constexpr double surely = 3, of_scale = 1.17;  // a robust scale of n has the error 1.17/√(2n)
        if (ratios.size() < fewest_falling_frames) return 0;
        const double scale = std::sqrt(quantile(ratios, 0.5) / median_square_of_one);
        if (scale < 1 + surely * of_scale / std::sqrt(2 * static_cast<double>(ratios.size()))) return 0;
        return std::sqrt(std::max(0.0, quantile(squares, 0.5) / median_square_of_one - quantile(expected, 0.5)));
    }
};

}  // namespace

Eigen::Vector3d unmodelled_accelerations(const FilmArcs& film, const std::vector<bool>& counts) {
    Bends of_places, of_angle;
    for (std::size_t k = 0; k < film.arcs.size(); ++k) {
        const FreeArc& arc = film.arcs[k];
        if (!counts[k] || arc.count < fewest_falling_frames) continue;
        for (const Eigen::Index axis : {0, 1}) of_places.add(film, arc, axis, film.place_noise);
        of_angle.add(film, arc, 2, film.angle_noise);
    }
    const double places = of_places.beyond_noise();
    return {places, places, of_angle.beyond_noise()};
}

std::optional<FallingArcs> settled_fall(std::span<const FilmFrame> frames, double period,
                                        const FallSettings& settings) {
    FallModel model = settings.start.value_or(FallModel{});
    if (settings.gravity) {
        model.gravity = *settings.gravity;
    } else if (!settings.start) {
        const std::optional<Vector2d> start = first_gravity(fit_arcs(frames, period, {{}, {}, settings.least_noise}));
        if (!start) return std::nullopt;
        model.gravity = *start;
    }
    constexpr int rounds = 6;
    constexpr double settled = 0.3;  // of the error
    FallingArcs found;
    for (int round = 0; round < rounds; ++round) {
        found.arcs = fit_arcs(
            frames, period,
            {model.drags, {}, settings.least_noise, {model.gravity, frames.front().time}, settings.division_noise});
        const std::optional<FallFit> fit = fit_fall(found.arcs, settings.gravity.has_value());
        if (!fit) return std::nullopt;
        const Vector2d moved = (fit->model.gravity - model.gravity).cwiseAbs() - settled * fit->error;
        const auto stays = [](double now, double then, const DragFit& drag) {
            return now == then || std::abs(now - then) < settled * drag.error;
        };
        const bool is_settled = moved.maxCoeff() <= 0 &&
                                stays(fit->model.drags.places, model.drags.places, fit->drag) &&
                                stays(fit->model.drags.angle, model.drags.angle, fit->spin);
        found.fall = *fit, model = fit->model;
        if (is_settled) break;
    }
    found.arcs = with_fall(found.arcs, model.gravity, model.drags);
    return found;
}

}  // namespace swirl::analysis
