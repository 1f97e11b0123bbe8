#include "analysis/fits/floor_drag.hpp"

#include "analysis/fits/robust.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

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

Bend bend_of(std::span<const FilmFrame> frames, const FloorMotion& floor, double drag) {
    constexpr double step = 1e-4;  // of γ, for the slope of s: its error is of the order of the square
    const std::size_t count = frames.size();
    double middle = 0, mean = 0;
    for (const FilmFrame& frame : frames) middle += frame.time / static_cast<double>(count);
    std::vector<double> s(count);
    for (std::size_t i = 0; i < count; ++i) {
        s[i] = dragged_time(frames[i].time - middle, drag);
        mean += s[i] / static_cast<double>(count);
    }
    std::vector<Complex> left(count), slope(count);
    Complex velocity = 0;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = frames[i].time - middle;
        const Complex turn = std::polar(1.0, floor.rate * frames[i].time + floor.phase);
        s[i] -= mean;
        left[i] = Complex(frames[i].place[0], frames[i].place[1]) - amplitude(floor, drag) * turn;
        velocity += s[i] * left[i], squares += s[i] * s[i];
        slope[i] = (dragged_time(t, drag + step) - dragged_time(t, drag - step)) / (2 * step);
    }
    velocity /= squares;
    for (std::size_t i = 0; i < count; ++i) {
        const Complex turn = std::polar(1.0, floor.rate * frames[i].time + floor.phase);
        slope[i] = velocity * slope[i] + amplitude_slope(floor, drag) * turn;
    }
    subtract_line(left, s);
    subtract_line(slope, s);
    Bend bend;
    for (std::size_t i = 0; i < count; ++i) {
        bend.product += (std::conj(slope[i]) * left[i]).real();
        bend.square += std::norm(slope[i]);
    }
    return bend;
}

/// Robust standard deviation of what the parts ask for, in units of the noise; 1 or more.
double scale_of(const std::vector<Bend>& bends, double noise) {
    std::vector<double> squares;
    for (const Bend& bend : bends) squares.push_back(bend.product * bend.product / (bend.square * noise * noise));
    return std::max(1.0, std::sqrt(quantile(std::move(squares), 0.5) / median_square_of_one));
}

}  // namespace

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
    constexpr int most_rounds = 30;
    constexpr double settled = 1e-3;  // of the error
    double drag = 0;
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Bend> bends;
        for (const ArcPart& part : parts)
            bends.push_back(bend_of(frames.subspan(part.first, part.last - part.first + 1), floor, drag));
        const double scale = scale_of(bends, noise);
        double product = 0, square = 0, scatter = 0;
        for (const Bend& bend : bends) {
            const double off = bend.product / (scale * noise);
            const double weight = biweight(off * off / bend.square, biweight_of_one);
            product += weight * bend.product, square += weight * bend.square;
            scatter += weight * weight * bend.product * bend.product;
        }
        const double change = product / square,
                     error = std::max(noise / std::sqrt(square), std::sqrt(scatter) / square);
        drag += change;
        if (!std::isfinite(drag)) return fit;
        if (std::abs(change) > settled * error) continue;
        fit.value = drag, fit.error = error;
        return fit;
    }
    return fit;
}

DraggedArcs settled_drag(std::span<const FilmFrame> frames, double period, const FilmArcs& straight,
                         const FloorMotion& floor, const PartsOf& parts_of) {
    constexpr int rounds = 8;
    constexpr double settled = 0.3;  // of the error: less moves no interval by much
    DraggedArcs found{{}, straight};
    FilmArcs& film = found.arcs;
    const auto fit = [&] { found.drag = fit_drag(film.kept, parts_of(film), floor, film.place_noise); };
    fit();
    const Eigen::Vector3d noise(film.place_noise, film.place_noise, film.angle_noise);
    for (const double factor :
         {3.0, 10.0, 30.0}) {  // bent arcs of little noise are cut into pieces too short for a fit
        if (std::isfinite(found.drag.value)) break;
        film = fit_arcs(frames, period, {0, floor, factor * noise});
        fit();
    }
    for (int round = 0; round < rounds; ++round) {
        if (!(std::abs(found.drag.value - film.drag) > settled * found.drag.error)) break;
        film = fit_arcs(frames, period, {found.drag.value, floor, Eigen::Vector3d::Zero()});
        fit();
    }
    film = std::isfinite(found.drag.value) ? with_drag(film, found.drag.value) : straight;
    return found;
}

double cost_of(const FilmArcs& film, double place_noise, double angle_noise) {
    double cost = cost_of_arc * static_cast<double>(film.arcs.size() + film.outliers);
    for (const FreeArc& arc : film.arcs)
        cost += arc.squares / (place_noise * place_noise) + arc.angle_squares / (angle_noise * angle_noise);
    return cost;
}

}  // namespace swirl::analysis
