#include "map/proof/clear_flight.hpp"

#include "map/intervals/ball_vec.hpp"
#include "map/proof/words.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::proof {

namespace {

using intervals::BallVec;
using intervals::between;
using intervals::exact_middle;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::square;
using intervals::upper;

/// A flight in the axes of the impact that began it.
struct BallFlight {
    const BallScene& scene;
    const BallPoint<Ball>& z;
    BallVec position, velocity;  ///< P₀ and V, from the swirl's centre
    Ball tau;
    int arriving;
    double end;  ///< no earlier than τ

    /// The swirl's arm, and the centre's position and velocity in the container.
    struct Moment {
        Ball t;
        BallVec arm, centre, motion;
    };
    Moment at(const Ball& t) const {
        const BallVec arm = scene.beta * cis(t - z.psi);
        return {t, arm, position + t * velocity - arm, velocity - turned(arm)};
    }
    /// g, g′ and g″ of vertex k (of the disk: its centre's).
    struct Gap {
        Ball value, rate, curvature;
    };
    Gap gap(const Moment& m, int k) const {
        BallVec x = m.centre, v = m.motion, a = m.arm;
        Ball reach = square(Ball(1) - scene.alpha);
        if (!scene.is_disk()) {
            const BallVec offset = scene.alpha * cis(z.chi + z.spin * m.t + scene.spacing * Ball(k));
            x = x + offset;
            v = v + z.spin * turned(offset);
            a = a - square(z.spin) * offset;
            reach = Ball(1);
        }
        return {squared(x) - reach, Ball(2) * dot(x, v), Ball(2) * (squared(v) + dot(x, a))};
    }
};

BallFlight flight_of(const BallScene& scene, const BallPoint<Ball>& z, const Ball& tau, int arriving) {
    const BallVec position = BallVec{Ball(1), Ball(0)} - scene.alpha * cis(z.chi) + scene.beta * cis(-z.psi);
    return {scene, z, position, {z.vn, z.vt}, tau, arriving, upper(tau)};
}

/// A piece of time, with the flight at its middle and over all of it.
struct Piece {
    double from, to;
    Ball away;  ///< t − middle
    BallFlight::Moment middle, all;
};

Piece piece_of(const BallFlight& flight, double from, double to) {
    const Ball all = between(from, to), middle(0.5 * (from + to));
    Piece piece{from, to, all - middle, flight.at(middle), flight.at(all)};
    // By the mean value theorem: narrower than the flight evaluated over the piece.
    piece.all.centre = piece.middle.centre + BallVec{piece.all.motion.x * piece.away, piece.all.motion.y * piece.away};
    return piece;
}

/// The numbers of the vertices that can be outside in a piece, as a range of integers; none: any.
struct Candidates {
    long first = 0, last = -1;
};

/// |X + a|² = |X|² + α² + 2α|X| cos φ ≥ 1 needs cos φ ≥ (1 − α² − |X|²)/(2α|X|), φ the vertex's direction from X's.
std::optional<Candidates> candidates_of(const BallFlight& flight, const Piece& piece) {
    const BallScene& scene = flight.scene;
    const double farthest = upper(sqrt(squared(piece.all.centre)));
    if (!(farthest > 0)) return std::nullopt;
    const Ball least =
        (Ball(1) - square(scene.alpha) - square(Ball(farthest))) / (Ball(2) * scene.alpha * Ball(farthest));
    const double cosine = lower(least);
    if (!(cosine > -1)) return std::nullopt;
    if (cosine >= 1) return Candidates{};
    const Ball half_width = acos(Ball(cosine));
    const BallVec about{exact_middle(piece.middle.centre.x), exact_middle(piece.middle.centre.y)};
    const BallVec& all = piece.all.centre;
    const Ball along = dot(about, all), across = about.x * all.y - about.y * all.x;
    if (!is_positive(along)) return std::nullopt;
    const Ball direction = atan2(about.y, about.x) + atan2(across, along);
    const Ball places = (direction - flight.z.chi - flight.z.spin * piece.all.t) / scene.spacing;
    const Ball half = half_width / scene.spacing;
    const double low = std::ceil(lower(places - half)), high = std::floor(upper(places + half));
    if (!(high - low < 1e9)) return std::nullopt;
    return Candidates{static_cast<long>(low), static_cast<long>(high)};
}

/// True if the vertex is proven inside on the whole piece, but for its contact at an end.
bool is_clear(const BallFlight& flight, const Piece& piece, int k) {
    const BallFlight::Gap middle = flight.gap(piece.middle, k), all = flight.gap(piece.all, k);
    const Ball rate = middle.rate + all.curvature * piece.away;
    if (k == 0 && piece.from == 0) return is_negative(rate);
    if (k == flight.arriving && piece.to >= lower(flight.tau)) return is_positive(rate);
    return is_negative(middle.value + middle.rate * piece.away + Ball(0.5) * all.curvature * square(piece.away));
}

/// A gap that is positive before the flight's end, for all of the box.
std::string outside(const BallFlight& flight, const Piece& piece, int k) {
    if (!(0.5 * (piece.from + piece.to) < lower(flight.tau))) return {};
    const Ball value = flight.gap(piece.middle, k).value;
    if (!is_positive(value)) return {};
    const std::string who = flight.scene.is_disk() ? "the disk" : words("vertex %d", k);
    return words("%s is outside at t = %.6g: its gap is %.3g or more, not negative", who.c_str(),
                 0.5 * (piece.from + piece.to), lower(value));
}

constexpr long most_vertices = 6;  ///< of a piece; more of them: it is halved

struct PieceSight {
    bool clear = false;
    std::string refuted, doubtful;
};

PieceSight look(const BallFlight& flight, const Piece& piece) {
    if (flight.scene.is_disk()) {
        if (is_clear(flight, piece, 0)) return {true, {}, {}};
        return {false, outside(flight, piece, 0), "the disk"};
    }
    if (is_negative(squared(piece.all.centre) - square(Ball(1) - flight.scene.alpha))) return {true, {}, {}};
    const auto range = candidates_of(flight, piece);
    if (!range || range->last - range->first >= most_vertices) return {false, {}, "more vertices than are looked at"};
    PieceSight sight{true, {}, {}};
    for (long k = range->first; k <= range->last && sight.clear; ++k) {
        const int n = flight.scene.sides, vertex = static_cast<int>(((k % n) + n) % n);
        if (is_clear(flight, piece, vertex)) continue;
        sight = {false, outside(flight, piece, vertex), words("vertex %d", vertex)};
    }
    return sight;
}

}  // namespace

Clearance clear_flight(const BallScene& scene, const BallPoint<Ball>& z, const Ball& tau, int arriving,
                       int most_pieces) {
    const BallFlight flight = flight_of(scene, z, tau, arriving);
    Clearance clearance;
    const Ball leaves = flight.gap(flight.at(Ball(0)), 0).rate;
    if (!is_negative(leaves)) {
        clearance.verdict = is_positive(leaves) ? Verdict::refuted : Verdict::undecided;
        clearance.reason = words("it does not leave the wall for certain: u_n after the impact lies in %.3g ... %.3g",
                                 0.5 * lower(leaves), 0.5 * upper(leaves));
        return clearance;
    }
    const double shortest = std::ldexp(flight.end, -40);
    std::vector<std::pair<double, double>> waiting{{0.0, flight.end}};
    while (!waiting.empty()) {
        const auto [from, to] = waiting.back();
        waiting.pop_back();
        const Piece piece = piece_of(flight, from, to);
        const PieceSight sight = look(flight, piece);
        if (sight.clear) continue;
        if (!sight.refuted.empty()) return {Verdict::refuted, sight.refuted, clearance.pieces};
        if (++clearance.pieces > most_pieces || to - from < shortest) {
            clearance.reason = words("%s is not proven inside between t = %.9g and %.9g, after %d pieces of time",
                                     sight.doubtful.c_str(), from, to, clearance.pieces);
            return clearance;
        }
        const double middle = 0.5 * (from + to);
        waiting.emplace_back(middle, to);
        waiting.emplace_back(from, middle);
    }
    clearance.verdict = Verdict::proven;
    return clearance;
}

}  // namespace swirl::proof
