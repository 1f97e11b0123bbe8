#include "analysis/fits/free_arcs.hpp"

#include "analysis/fits/robust.hpp"
#include "analysis/within_period.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace swirl::analysis {

namespace {

using Eigen::Vector3d;

/// Frames that count, the angle unwound.
struct Track {
    std::vector<double> times;
    std::vector<Vector3d> places;
    std::vector<bool> after_gap;
    double step = nan;  ///< median, of the times
    Drags drags;
};

/// Adds what the floor carries and the fall (sign 1), or takes them off (−1).
void carry(Track& track, const FloorMotion& floor, const UniformFall& fall, double sign) {
    if (track.drags.places != 0)
        for (std::size_t i = 0; i < track.times.size(); ++i)
            track.places[i] += sign * floor.carried(track.times[i], track.drags.places);
    if (fall.any())
        for (std::size_t i = 0; i < track.times.size(); ++i)
            track.places[i] += sign * fall.place(track.times[i], track.drags.places);
}

Track track_of(std::span<const FilmFrame> frames, double period) {
    Track track;
    std::vector<double> steps;
    for (const FilmFrame& frame : frames) {
        if (!frame.place.allFinite()) continue;
        if (!track.times.empty()) steps.push_back(frame.time - track.times.back());
        track.times.push_back(frame.time);
        track.places.push_back(frame.place);
    }
    track.step = quantile(steps, 0.5);
    track.after_gap.assign(track.times.size(), false);
    double rate = 0;
    for (std::size_t i = 1; i < track.times.size(); ++i) {
        const double step = steps[i - 1], before = track.places[i - 1][2];
        const double usual = step > 1.5 * track.step ? rate * step : 0;
        const double turn = usual + within_period(track.places[i][2] - before - usual, period);
        track.places[i][2] = before + turn;
        rate = turn / step;
        track.after_gap[i] = step > longest_gap * track.step;
    }
    return track;
}

/// Sums over the frames from `first` on, relative to it.
struct Sums {
    std::size_t first = 0;
    double cost_before = 0;  ///< of the lines that end there
    double count = 0;
    Vector3d t = Vector3d::Zero(), tt = Vector3d::Zero();
    Vector3d z = Vector3d::Zero(), zt = Vector3d::Zero(), zz = Vector3d::Zero();

    void add(const Vector3d& times, const Vector3d& place) {
        count += 1, t += times, tt += times.cwiseProduct(times);
        z += place, zt += place.cwiseProduct(times), zz += place.cwiseProduct(place);
    }
    /// Summed squares of the residuals of x, y and θ.
    Vector3d squares() const {
        if (count < 3) return Vector3d::Zero();
        const Vector3d spread = tt - t.cwiseProduct(t) / count;
        const Vector3d slope = zt - z.cwiseProduct(t / count);
        return (zz - z.cwiseProduct(z) / count - slope.cwiseProduct(slope).cwiseQuotient(spread)).cwiseMax(0);
    }
};

/// First frames of the lines.
std::vector<std::size_t> divide(const Track& track, const Vector3d& weights) {
    const std::size_t count = track.times.size();
    std::vector<double> best(count + 1, 0.0);
    std::vector<std::size_t> start(count + 1, 0);
    std::vector<Sums> open;
    for (std::size_t end = 1; end <= count; ++end) {
        const std::size_t i = end - 1;
        if (track.after_gap[i]) open.clear();
        open.emplace_back();
        open.back().first = i, open.back().cost_before = best[i];
        best[end] = infinity;
        std::vector<double> costs;
        for (Sums& sums : open) {
            sums.add(dragged_times(track.times[i] - track.times[sums.first], track.drags),
                     track.places[i] - track.places[sums.first]);
            costs.push_back(sums.cost_before + sums.squares().dot(weights));
            if (costs.back() + cost_of_arc < best[end]) best[end] = costs.back() + cost_of_arc, start[end] = sums.first;
        }
        std::size_t kept = 0;
        for (std::size_t k = 0; k < open.size(); ++k)
            if (costs[k] <= best[end]) open[kept++] = open[k];
        open.resize(kept);
    }
    std::vector<std::size_t> firsts;
    for (std::size_t end = count; end > 0; end = start[end]) firsts.push_back(start[end]);
    std::reverse(firsts.begin(), firsts.end());
    return firsts;
}

FreeArc line_through(const Track& track, std::size_t first, std::size_t last) {
    FreeArc arc;
    arc.first = first, arc.last = last, arc.count = last - first + 1;
    arc.start = track.times[first], arc.end = track.times[last];
    arc.after_gap = track.after_gap[first];
    const double count = static_cast<double>(arc.count);
    double sum = 0;
    Vector3d places = Vector3d::Zero();
    for (std::size_t i = first; i <= last; ++i) {
        sum += track.times[i] - arc.start;
        places += track.places[i] - track.places[first];
    }
    arc.mean_time = arc.start + sum / count;
    arc.middle = track.places[first] + places / count;
    arc.spread.setZero();
    if (track.drags.any()) {
        Vector3d lag = Vector3d::Zero();
        arc.drags = track.drags;
        for (std::size_t i = first; i <= last; ++i) lag += arc.since(track.times[i]);
        arc.lag = lag / count;
    }
    Vector3d products = Vector3d::Zero();
    for (std::size_t i = first; i <= last; ++i) {
        const Vector3d t = arc.since(track.times[i]);
        arc.spread += t.cwiseProduct(t);
        products += t.cwiseProduct(track.places[i] - arc.middle);
    }
    if (arc.count > 1) arc.velocity = products.cwiseQuotient(arc.spread);
    arc.squares = arc.angle_squares = 0;
    for (std::size_t i = first; i <= last && arc.count > 1; ++i) {
        const Vector3d residual = track.places[i] - arc.at(track.times[i]);
        arc.squares += residual.head<2>().squaredNorm();
        arc.angle_squares += residual[2] * residual[2];
    }
    return arc;
}

std::vector<FreeArc> lines_of(const Track& track, const std::vector<std::size_t>& firsts) {
    std::vector<FreeArc> arcs;
    for (std::size_t k = 0; k < firsts.size(); ++k)
        arcs.push_back(
            line_through(track, firsts[k], k + 1 < firsts.size() ? firsts[k + 1] - 1 : track.times.size() - 1));
    return arcs;
}

/// Sums of squares of lengths of some 1 are rounded to 10⁻¹⁶: no noise is below this.
constexpr double least_noise = 1e-7;

/// How far frames lie off the line of their neighbours: a lower quantile, in σ.
Vector3d first_noise(const Track& track) {
    constexpr double share = 0.2, at_share = 0.2533;  // |normal| is below 0.2533 σ with chance 0.2
    std::array<std::vector<double>, 3> off;
    for (std::size_t i = 1; i + 1 < track.times.size(); ++i) {
        const double a = (track.times[i + 1] - track.times[i]) / (track.times[i + 1] - track.times[i - 1]);
        const Vector3d middle = a * track.places[i - 1] + (1 - a) * track.places[i + 1];
        const double sigma = std::sqrt(1 + a * a + (1 - a) * (1 - a));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            off[k].push_back(std::abs(track.places[i][axis] - middle[axis]) / sigma);
        }
    }
    Vector3d noise;
    for (std::size_t k = 0; k < 3; ++k) noise[static_cast<Eigen::Index>(k)] = quantile(off[k], share) / at_share;
    noise[0] = noise[1] = (noise[0] + noise[1]) / 2;
    return noise.cwiseMax(least_noise);
}

/// From lines of many frames, which few parameters have bent to their noise.
Vector3d noise_on(const std::vector<FreeArc>& arcs, const Vector3d& otherwise) {
    for (const std::size_t fewest : {std::size_t{6}, std::size_t{4}}) {
        double freedom = 0, squares = 0, angle_squares = 0;
        for (const FreeArc& arc : arcs) {
            if (arc.count < fewest) continue;
            freedom += static_cast<double>(arc.count) - 2;
            squares += arc.squares, angle_squares += arc.angle_squares;
        }
        constexpr double enough = 30;
        if (freedom < enough) continue;
        const double place = std::sqrt(squares / (2 * freedom));
        return Vector3d(place, place, std::sqrt(angle_squares / freedom)).cwiseMax(least_noise);
    }
    return otherwise;
}

Eigen::Matrix3d noise_of_body(const Track& track, const std::vector<FreeArc>& arcs, const Vector3d& otherwise) {
    constexpr std::size_t fewest = 6;  // few parameters have bent longer lines to their noise
    constexpr double enough = 30;
    double freedom = 0;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const FreeArc& arc : arcs) {
        if (arc.count < fewest) continue;
        freedom += static_cast<double>(arc.count) - 2;
        for (std::size_t i = arc.first; i <= arc.last; ++i) {
            Vector3d residual = track.places[i] - arc.at(track.times[i]);
            residual.head<2>() = Eigen::Rotation2Dd(-track.places[i][2]) * Eigen::Vector2d(residual.head<2>());
            sum += residual * residual.transpose();
        }
    }
    if (freedom < enough) return otherwise.cwiseAbs2().asDiagonal();
    return sum / freedom + least_noise * least_noise * Eigen::Matrix3d::Identity();
}

/// One or two frames off a line that goes on behind them.
std::vector<bool> outliers_of(const Track& track, const std::vector<FreeArc>& arcs, const Vector3d& noise) {
    std::vector<bool> off(track.times.size(), false);
    for (std::size_t k = 1; k + 1 < arcs.size(); ++k) {
        const FreeArc &before = arcs[k - 1], &after = arcs[k + 1];
        if (arcs[k].count > 2 || before.count < 3 || after.count < 3 || arcs[k].after_gap || after.after_gap) continue;
        const double time = arcs[k].mean_time;
        const double place = std::sqrt(before.share(time) + after.share(time));
        const Vector3d speed = (before.spread.cwiseInverse() + after.spread.cwiseInverse()).cwiseSqrt();
        const Vector3d apart = (before.at(time) - after.at(time)).cwiseQuotient(noise) / place;
        const Vector3d turned =
            (before.velocity_at(time) - after.velocity_at(time)).cwiseQuotient(noise.cwiseProduct(speed));
        constexpr double one_line = 22.5, off_line = 25;  // χ²(6) beyond which lies 1 in 1000; χ²(3) and the line's own
        if (apart.squaredNorm() + turned.squaredNorm() > one_line) continue;
        for (std::size_t i = arcs[k].first; i <= arcs[k].last; ++i) {  // a short line may hold one that is not off
            const Vector3d middle = (before.at(track.times[i]) + after.at(track.times[i])) / 2;
            off[i] = (track.places[i] - middle).cwiseQuotient(noise).squaredNorm() > off_line;
        }
    }
    return off;
}

std::size_t remove_frames(Track& track, const std::vector<bool>& off) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
        if (off[i]) continue;
        track.times[kept] = track.times[i], track.places[kept] = track.places[i];
        track.after_gap[kept++] = track.after_gap[i];
    }
    const std::size_t removed = off.size() - kept;
    track.times.resize(kept), track.places.resize(kept), track.after_gap.resize(kept);
    return removed;
}

std::complex<double> carried_by(const FloorMotion& floor, double time, double drag) {
    return drag * floor.radius / std::complex<double>(drag, floor.rate) *
           std::polar(1.0, floor.rate * time + floor.phase);
}

}  // namespace

Vector3d FloorMotion::carried(double time, double drag) const {
    if (drag == 0) return Vector3d::Zero();
    const std::complex<double> place = carried_by(*this, time, drag);
    return {place.real(), place.imag(), 0};
}

Vector3d FloorMotion::carried_velocity(double time, double drag) const {
    if (drag == 0) return Vector3d::Zero();
    const std::complex<double> place = carried_by(*this, time, drag);
    return {-rate * place.imag(), rate * place.real(), 0};
}

Vector3d UniformFall::place(double time, double drag) const {
    constexpr double small = 1e-4;  // below, the difference of both times loses digits
    const double t = time - from;
    const double share =
        std::abs(drag * t) < small ? t * t / 2 * (1 - drag * t / 3) : (t - dragged_time(t, drag)) / drag;
    return {share * gravity[0], share * gravity[1], 0};
}

Vector3d UniformFall::velocity(double time, double drag) const {
    const double share = dragged_time(time - from, drag);
    return {share * gravity[0], share * gravity[1], 0};
}

FilmArcs fit_arcs(std::span<const FilmFrame> frames, double period, const ArcOptions& options) {
    Track track = track_of(frames, period);
    track.drags = options.drags;
    carry(track, options.floor, options.fall, -1);
    FilmArcs film;
    film.drags = options.drags, film.floor = options.floor, film.fall = options.fall;
    film.least_noise = options.least_noise;
    film.frames = track.times.size();
    if (film.frames < 3) return film;
    Vector3d noise = first_noise(track).cwiseMax(options.least_noise);
    constexpr int rounds = 3;  // of the noise, that settles to a few in a hundred
    for (int round = 0; round < rounds; ++round) {
        const Vector3d dividing = noise.cwiseMax(options.division_noise);
        const Vector3d weights = dividing.cwiseProduct(dividing).cwiseInverse();
        film.arcs = lines_of(track, divide(track, weights));
        noise = noise_on(film.arcs, noise).cwiseMax(options.least_noise);
        if (round + 1 < rounds)
            film.outliers +=
                remove_frames(track, outliers_of(track, film.arcs, noise.cwiseMax(options.division_noise)));
    }
    film.place_noise = noise[0], film.angle_noise = noise[2];
    film.noise = noise_of_body(track, film.arcs, noise);
    carry(track, options.floor, options.fall, 1);
    for (std::size_t i = 0; i < track.times.size(); ++i) film.kept.push_back({track.times[i], track.places[i]});
    return film;
}

double cost_of_division(const FilmArcs& film, double place_noise, double angle_noise) {
    double squares = 0, angle_squares = 0;
    for (const FreeArc& arc : film.arcs) squares += arc.squares, angle_squares += arc.angle_squares;
    return cost_of_arc * static_cast<double>(film.arcs.size() + film.outliers) + squares / (place_noise * place_noise) +
           angle_squares / (angle_noise * angle_noise);
}

namespace {

/// The frames that count, as the film's lines have them.
Track track_of(const FilmArcs& film) {
    Track track;
    track.drags = film.drags;
    track.after_gap.assign(film.kept.size(), false);
    for (const FilmFrame& frame : film.kept) track.times.push_back(frame.time), track.places.push_back(frame.place);
    carry(track, film.floor, film.fall, -1);
    return track;
}

}  // namespace

FilmArcs with_drags(const FilmArcs& film, const Drags& drags) {
    return with_fall(film, film.fall.gravity, drags);
}

FilmArcs with_fall(const FilmArcs& film, const Eigen::Vector2d& gravity, const Drags& drags) {
    FilmArcs other = film;
    other.fall.gravity = gravity, other.drags = drags;
    const Track track = track_of(other);
    for (FreeArc& arc : other.arcs) {
        const bool after_gap = arc.after_gap;
        arc = line_through(track, arc.first, arc.last);
        arc.after_gap = after_gap;
    }
    return other;
}

FilmArcs end_pieces(const FilmArcs& film, std::size_t longest) {
    FilmArcs other = film;
    const Track track = track_of(film);
    other.arcs.clear();
    const auto add = [&](std::size_t first, std::size_t last, bool after_gap) {
        other.arcs.push_back(line_through(track, first, last));
        other.arcs.back().after_gap = after_gap;
    };
    for (const FreeArc& arc : film.arcs) {
        const std::size_t trimmed = arc.count < fewest_trimmed ? 0 : 1, first = arc.first + trimmed,
                          last = arc.last - trimmed;
        if (last - first + 1 <= longest) {
            add(first, last, arc.after_gap);
        } else {
            add(first, first + longest - 1, arc.after_gap);
            add(last - longest + 1, last, true);
        }
    }
    return other;
}

FilmArcs with_noise_of(const FilmArcs& film, const std::vector<bool>& counts) {
    std::vector<FreeArc> some;
    for (std::size_t k = 0; k < film.arcs.size(); ++k)
        if (counts[k]) some.push_back(film.arcs[k]);
    const Vector3d before(film.place_noise, film.place_noise, film.angle_noise);
    const Vector3d noise = noise_on(some, before).cwiseMax(film.least_noise);
    FilmArcs other = film;
    other.place_noise = noise[0], other.angle_noise = noise[2];
    other.noise = noise_of_body(track_of(film), some, noise);
    return other;
}

Kink kink_between(const FilmArcs& film, const FreeArc& before, const FreeArc& after) {
    const Vector3d noise(film.place_noise, film.place_noise, film.angle_noise);
    const double middle = (before.end + after.start) / 2;
    const auto apart = [&](double time) -> Vector3d { return (before.at(time) - after.at(time)).cwiseQuotient(noise); };
    Kink kink;
    kink.earliest = before.end, kink.latest = after.start;
    Vector3d bend = (before.velocity_at(middle) - after.velocity_at(middle)).cwiseQuotient(noise);
    kink.time = middle - apart(middle).dot(bend) / bend.squaredNorm();  // the distance is linear in the time
    if (film.drags.any()) {                                             // nearly
        bend = (before.velocity_at(kink.time) - after.velocity_at(kink.time)).cwiseQuotient(noise);
        kink.time -= apart(kink.time).dot(bend) / bend.squaredNorm();
    }
    const double a = before.share(kink.time), b = after.share(kink.time);
    kink.error = std::sqrt((a + b) / bend.squaredNorm());
    const Vector3d off = apart(kink.time);
    kink.distance = off.squaredNorm() / (a + b);
    constexpr double of_noise = 1.386294;  // median of χ² with 2 degrees of freedom
    kink.apart_for = (off.squaredNorm() - of_noise * (a + b)) / bend.squaredNorm();
    if (film.impact_time > 0) {
        const Vector3d lasting = film.impact_time * bend;
        kink.distance = off.cwiseAbs2().cwiseQuotient((lasting.cwiseAbs2().array() + a + b).matrix()).sum();
        kink.error = std::hypot(kink.error, film.impact_time);
    }
    kink.velocity_before = film.velocity_on(before, kink.time);
    kink.velocity_after = film.velocity_on(after, kink.time);
    kink.place = (film.place_on(before, kink.time) / a + film.place_on(after, kink.time) / b) / (1 / a + 1 / b);
    kink.share = 1 / (1 / a + 1 / b);
    kink.change = kink.velocity_after - kink.velocity_before;
    kink.drift = (kink.velocity_before / a + kink.velocity_after / b) / (1 / a + 1 / b);
    kink.change_share = before.velocity_share(kink.time) + after.velocity_share(kink.time);
    return kink;
}

std::vector<Kink> kinks_of(const FilmArcs& film) {
    std::vector<Kink> kinks;
    for (std::size_t k = 0; k + 1 < film.arcs.size(); ++k) {
        const FreeArc &before = film.arcs[k], &after = film.arcs[k + 1];
        if (before.count < fewest_frames || after.count < fewest_frames || after.after_gap) continue;
        kinks.push_back(kink_between(film, before, after));
        kinks.back().before = k;
    }
    return kinks;
}

}  // namespace swirl::analysis
