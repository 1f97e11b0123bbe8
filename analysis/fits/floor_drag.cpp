#include "analysis/fits/floor_drag.hpp"

#include "analysis/fits/robust.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

/// Of places of some 1, their rounding's.
constexpr double least_square = 1e-32;
/// Beyond, in 1/time, no film has arcs: all would be still after a frame.
constexpr double largest_drag = 100;

Complex amplitude(const FloorMotion& floor, double drag) {
    return drag * floor.radius / Complex(drag, floor.rate);
}

Complex amplitude_slope(const FloorMotion& floor, double drag) {
    const Complex below(drag, floor.rate);
    return Complex(0, floor.radius * floor.rate) / (below * below);
}

/// Subtracts what is even in s, in the sense of least squares; s has the mean 0.
void subtract_line(std::vector<Complex>& values, const std::vector<double>& s) {
    Complex sum = 0, products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        sum += values[i], products += s[i] * values[i];
        squares += s[i] * s[i];
    }
    for (std::size_t i = 0; i < s.size(); ++i)
        values[i] -= sum / static_cast<double>(s.size()) + products / squares * s[i];
}

/// What a part asks γ to change by is product/square, and its variance is σ²/square.
struct Bend {
    double product = 0, square = 0;
};

/// The dragged times of a part's frames, less their mean, and the places less what the floor carries.
struct FreePart {
    double middle = 0;  ///< in time
    std::vector<double> s;
    std::vector<Complex> places;
};

FreePart free_part(std::span<const FilmFrame> frames, const FloorMotion& floor, double drag) {
    const std::size_t count = frames.size();
    FreePart part;
    double mean = 0;
    for (const FilmFrame& frame : frames) part.middle += frame.time / static_cast<double>(count);
    for (const FilmFrame& frame : frames) {
        const Complex turn = std::polar(1.0, floor.rate * frame.time + floor.phase);
        part.s.push_back(dragged_time(frame.time - part.middle, drag));
        part.places.push_back(Complex(frame.place[0], frame.place[1]) - amplitude(floor, drag) * turn);
        mean += part.s.back() / static_cast<double>(count);
    }
    for (double& s : part.s) s -= mean;
    return part;
}

Bend bend_of(std::span<const FilmFrame> frames, const FloorMotion& floor, double drag) {
    constexpr double step = 1e-4;  // of γ, for the slope of s: its error is of the order of the square
    FreePart part = free_part(frames, floor, drag);
    const std::vector<double>& s = part.s;
    std::vector<Complex>& left = part.places;
    Complex velocity = 0;
    double squares = 0;
    for (std::size_t i = 0; i < s.size(); ++i) velocity += s[i] * left[i], squares += s[i] * s[i];
    velocity /= squares;
    std::vector<Complex> slope;
    for (const FilmFrame& frame : frames) {
        const double t = frame.time - part.middle;
        const Complex turn = std::polar(1.0, floor.rate * frame.time + floor.phase);
        slope.push_back(velocity * (dragged_time(t, drag + step) - dragged_time(t, drag - step)) / (2 * step) +
                        amplitude_slope(floor, drag) * turn);
    }
    subtract_line(left, s);
    subtract_line(slope, s);
    Bend bend;
    for (std::size_t i = 0; i < s.size(); ++i) {
        bend.product += (std::conj(slope[i]) * left[i]).real();
        bend.square += std::norm(slope[i]);
    }
    return bend;
}

/// Σ |residual|² of the places.
double squares_left(std::span<const FilmFrame> frames, const FloorMotion& floor, double drag) {
    FreePart part = free_part(frames, floor, drag);
    subtract_line(part.places, part.s);
    double sum = 0;
    for (const Complex& place : part.places) sum += std::norm(place);
    return sum;
}

std::span<const FilmFrame> frames_of(std::span<const FilmFrame> frames, const ArcPart& part) {
    return frames.subspan(part.first, part.last - part.first + 1);
}

/// Robust standard deviation of what the parts ask for, in units of the noise; 1 or more.
double scale_of(const std::vector<Bend>& bends, double noise) {
    std::vector<double> squares;
    for (const Bend& bend : bends) squares.push_back(bend.product * bend.product / (bend.square * noise * noise));
    return std::max(1.0, std::sqrt(quantile(std::move(squares), 0.5) / median_square_of_one));
}

/// Drags, and a floor that carries along with them, of pieces of arcs.
struct FreeFloor {
    Drags drags;
    FloorMotion floor;
};

/// Pieces without the frames at their ends, next to which may be an impact.
std::vector<ArcPart> pieces_of(const FilmArcs& film) {
    std::vector<ArcPart> pieces;
    for (const FreeArc& arc : film.arcs)
        if (arc.count >= fewest_bent + 2) pieces.push_back({arc.first + 1, arc.last - 1});
    return pieces;
}

/// Of a piece, by γ and the parts of K, whose own line is taken off: normal equations, and what is left.
struct PieceEquations {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double squares_a_freedom = 0;
};

PieceEquations equations_of(std::span<const FilmFrame> frames, double rate, double drag, Complex carried) {
    constexpr double step = 1e-4;  // of γ, for the slope of s: its error is of the order of the square
    const std::size_t count = frames.size();
    double middle = 0, mean = 0;
    for (const FilmFrame& frame : frames) middle += frame.time / static_cast<double>(count);
    std::vector<double> s;
    std::vector<Complex> left, turns, by_drag;
    for (const FilmFrame& frame : frames) {
        s.push_back(dragged_time(frame.time - middle, drag)), mean += s.back() / static_cast<double>(count);
        turns.push_back(std::polar(1.0, rate * frame.time));
        left.push_back(Complex(frame.place[0], frame.place[1]) - carried * turns.back());
    }
    Complex velocity = 0;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        s[i] -= mean;
        velocity += s[i] * left[i], squares += s[i] * s[i];
    }
    velocity /= squares;
    for (const FilmFrame& frame : frames) {
        const double t = frame.time - middle;
        by_drag.push_back(velocity * (dragged_time(t, drag + step) - dragged_time(t, drag - step)) / (2 * step));
    }
    for (std::vector<Complex>* values : {&left, &turns, &by_drag}) subtract_line(*values, s);
    PieceEquations piece;
    for (std::size_t i = 0; i < count; ++i) {
        Eigen::Matrix<double, 2, 3> slopes;
        slopes << by_drag[i].real(), turns[i].real(), -turns[i].imag(), by_drag[i].imag(), turns[i].imag(),
            turns[i].real();
        const Eigen::Vector2d residual(left[i].real(), left[i].imag());
        piece.matrix += slopes.transpose() * slopes;
        piece.right += slopes.transpose() * residual;
        piece.squares_a_freedom += residual.squaredNorm() / (2 * static_cast<double>(count) - 4);
    }
    return piece;
}

/// γ and K by all pieces, and γ_r, where these tell them.
std::optional<FreeFloor> free_floor(const FilmArcs& film, double rate) {
    constexpr int most_rounds = 30;
    constexpr double settled = 1e-10;
    const std::vector<ArcPart> pieces = pieces_of(film);
    if (pieces.size() < fewest_parts) return std::nullopt;
    double drag = 0;
    Complex carried = 0;
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<PieceEquations> equations;
        std::vector<double> squares;
        for (const ArcPart& piece : pieces) {
            equations.push_back(equations_of(frames_of(film.kept, piece), rate, drag, carried));
            squares.push_back(equations.back().squares_a_freedom);
        }
        const double usual = std::max(quantile(std::move(squares), 0.5), least_square);
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (const PieceEquations& piece : equations) {
            const double weight = biweight(piece.squares_a_freedom / usual, biweight_of_one);
            matrix += weight * piece.matrix, right += weight * piece.right;
        }
        if (rate == 0) matrix.bottomRows<2>().setZero(), matrix.rightCols<2>().setZero(), right.tail<2>().setZero();
        constexpr double unasked = 1e-12;  // of a direction that the pieces do not tell
        matrix.diagonal().array() += unasked * matrix.diagonal().maxCoeff();
        const Eigen::Vector3d change = matrix.ldlt().solve(right);
        drag += change[0], carried += Complex(change[1], change[2]);
        if (!(std::abs(drag) < largest_drag)) return std::nullopt;
        if (change.norm() < settled) break;
    }
    FreeFloor found;
    found.drags.places = drag;
    const double spin = fit_spin_drag(film.kept, pieces, film.angle_noise).value;
    found.drags.angle = std::isnan(spin) ? drag : spin;
    const Complex part = drag / Complex(drag, rate);  // of the floor's radius
    if (rate != 0 && drag != 0)
        found.floor = {std::abs(carried) / std::abs(part), rate, std::arg(carried) - std::arg(part)};
    return found;
}

}  // namespace

double of_few(std::size_t parts) {
    return 1 + (sure_drag * sure_drag + 1) / (4 * (static_cast<double>(parts) - 1));
}

std::vector<ArcPart> parts_between(const FilmArcs& film, std::span<const Kink> kinks) {
    constexpr double sure = 4;  // standard errors
    std::vector<ArcPart> parts;
    for (std::size_t k = 0; k + 1 < kinks.size(); ++k) {
        if (kinks[k + 1].before != kinks[k].before + 1) continue;
        const FreeArc& arc = film.arcs[kinks[k + 1].before];
        ArcPart part{arc.first, arc.last};
        const double begin = kinks[k].time + sure * kinks[k].error;
        const double end = kinks[k + 1].time - sure * kinks[k + 1].error;
        while (part.first < part.last && film.kept[part.first].time <= begin) ++part.first;
        while (part.last > part.first && film.kept[part.last].time >= end) --part.last;
        if (part.last + 1 >= part.first + fewest_bent) parts.push_back(part);
    }
    return parts;
}

DragFit fit_drag(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, const FloorMotion& floor,
                 double noise) {
    DragFit fit;
    fit.parts = parts.size();
    if (parts.size() < fewest_parts) return fit;
    constexpr int most_rounds = 100;  // of a wrong floor it falls slowly
    constexpr double settled = 1e-3;  // of the error
    double drag = 0;
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Bend> bends;
        for (const ArcPart& part : parts) bends.push_back(bend_of(frames_of(frames, part), floor, drag));
        const double scale = scale_of(bends, noise);
        double product = 0, square = 0, scatter = 0;
        for (const Bend& bend : bends) {
            const double off = bend.product / (scale * noise);
            const double weight = biweight(off * off / bend.square, biweight_of_one);
            product += weight * bend.product, square += weight * bend.square;
            scatter += weight * weight * bend.product * bend.product;
        }
        const double change = product / square,
                     error = of_few(parts.size()) * std::max(noise / std::sqrt(square), std::sqrt(scatter) / square);
        drag += change;
        if (!std::isfinite(drag)) return fit;
        if (std::abs(change) > settled * error) continue;
        fit.value = drag, fit.error = error;
        return fit;
    }
    return fit;
}

DragFit fit_spin_drag(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, double noise) {
    std::vector<FilmFrame> turns(frames.begin(), frames.end());
    for (FilmFrame& frame : turns) frame.place = {frame.place[2], 0, 0};
    DragFit fit = fit_drag(turns, parts, {0, 1, 0}, noise);  // as places on a line, on a floor that stands still
    std::vector<double> times;
    for (const ArcPart& part : parts) times.push_back(frames[part.last].time - frames[part.first].time);
    if (!(fit.error * quantile(std::move(times), 0.5) < widest_spin_drag)) fit.value = fit.error = nan;
    return fit;
}

Drags DraggedArcs::values() const {
    return {drag.value, std::isnan(spin.value) ? drag.value : spin.value};
}

DraggedArcs settled_drag(std::span<const FilmFrame> frames, double period, const FilmArcs& start,
                         const FloorMotion& floor, const PartsOf& parts_of) {
    constexpr int rounds = 8;
    constexpr double settled = 0.3;  // of the error: less moves no interval by much
    const FilmArcs first =
        start.drags.any() ? fit_arcs(frames, period, {start.drags, floor, start.least_noise}) : start;
    DraggedArcs found{{}, {}, first};
    FilmArcs& film = found.arcs;
    const auto fit = [&] {
        const std::vector<ArcPart> parts = parts_of(film);
        found.drag = fit_drag(film.kept, parts, floor, film.place_noise);
        found.spin = fit_spin_drag(film.kept, parts, film.angle_noise);
    };
    const auto moved = [&](const DragFit& one, double now) { return std::abs(one.value - now) > settled * one.error; };
    fit();
    const Eigen::Vector3d noise(film.place_noise, film.place_noise, film.angle_noise);
    for (const double factor :
         {3.0, 10.0, 30.0}) {  // bent arcs of little noise are cut into pieces too short for a fit
        if (std::isfinite(found.drag.value)) break;
        film = fit_arcs(frames, period, {{}, floor, factor * noise});
        fit();
    }
    for (int round = 0; round < rounds && std::isfinite(found.drag.value); ++round) {
        if (!moved(found.drag, film.drags.places) && !moved(found.spin, film.drags.angle)) break;
        film = fit_arcs(frames, period, {found.values(), floor, start.least_noise});
        fit();
    }
    film = std::isfinite(found.drag.value) ? with_drags(film, found.values()) : first;
    return found;
}

std::optional<FilmArcs> bent_arcs(std::span<const FilmFrame> frames, double period, const FilmArcs& straight,
                                  double rate) {
    constexpr int most_rounds = 20;
    const auto cost_of = [&](const FilmArcs& film) {
        return cost_of_division(film, straight.place_noise, straight.angle_noise);
    };
    for (const double factor : {1.0, 3.0, 10.0, 30.0, 100.0}) {
        const Eigen::Vector3d noise =
            factor * Eigen::Vector3d(straight.place_noise, straight.place_noise, straight.angle_noise);
        FilmArcs film = factor == 1 ? straight : fit_arcs(frames, period, {{}, {}, noise});
        std::optional<FilmArcs> best;
        double least = cost_of(straight) - cost_of_arc, before = infinity;
        for (int round = 0; round < most_rounds; ++round) {
            const std::optional<FreeFloor> found = free_floor(film, rate);
            if (!found) break;
            film = fit_arcs(frames, period, {found->drags, found->floor, straight.least_noise});
            const double cost = cost_of(film);
            if (cost < least) best = film, least = cost;
            if (!(cost < before - cost_of_arc)) break;
            before = cost;
        }
        if (best) return best;
    }
    return std::nullopt;
}

double floor_worse_by(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, const FloorMotion& floor,
                      const FloorMotion& other, double noise) {
    const double drag = fit_drag(frames, parts, floor, noise).value,
                 other_drag = fit_drag(frames, parts, other, noise).value;
    if (std::isnan(drag) || std::isnan(other_drag)) return nan;
    struct Misfit {
        double freedom, here, there;
        double least() const { return std::min(here, there); }
    };
    std::vector<Misfit> misfits;
    std::vector<double> shares;
    for (const ArcPart& part : parts) {
        const auto seen = frames_of(frames, part);
        misfits.push_back({2 * static_cast<double>(seen.size()) - 4, squares_left(seen, floor, drag),
                           squares_left(seen, other, other_drag)});
        shares.push_back(misfits.back().least() / misfits.back().freedom);
    }
    const double variance = std::max(noise * noise, quantile(std::move(shares), 0.5));
    double worse = 0;
    for (const Misfit& misfit : misfits) {
        constexpr double reach = 4;  // standard deviations of χ², which is √(2 · freedom)
        const double most = misfit.freedom + reach * std::sqrt(2 * misfit.freedom) + reach * reach;
        if (misfit.least() < most * variance) worse += (misfit.here - misfit.there) / variance;
    }
    return worse;
}

}  // namespace swirl::analysis
