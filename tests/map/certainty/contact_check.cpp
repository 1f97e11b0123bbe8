#include "tests/map/certainty/contact_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace swirl::tests {

namespace {

using intervals::around;
using intervals::between;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::upper;

constexpr double eps = 0x1p-52;
constexpr long most_pieces = 200'000;
constexpr int most_vertices = 12;  ///< of a piece; more of them: it is halved
constexpr int no_vertex = -1;

struct Piece {
    double from, to, middle, half;
    FlightInBalls::Moment at_middle;
};

Piece piece_of(const FlightInBalls& flight, double from, double to) {
    const double middle = from + 0.5 * (to - from);
    // One step upwards: never less than the exact half.
    const double half = std::nextafter(std::max(to - middle, middle - from), 1e300);
    return {from, to, middle, half, flight.at(Ball(middle))};
}

/// True if g < `allowed` of vertex k is proven on the whole piece.
bool is_inside(const FlightInBalls& flight, const Piece& piece, int k, double allowed, double& seen_at_middle) {
    seen_at_middle = -1;
    if (flight.is_far_inside(piece.at_middle, k, piece.half)) return true;
    const auto at_middle = flight.gap(piece.at_middle, k);
    const auto all = flight.gap(flight.over(piece.from, piece.to, piece.middle, piece.at_middle), k);
    const Ball away = around(0, piece.half);
    const Ball most(allowed);
    const double curvature = upper(all.curvature);
    if (is_negative(at_middle.value + at_middle.rate * away +
                    Ball(0.5 * std::max(curvature, 0.0)) * square(Ball(piece.half)) - most))
        return true;
    // Concave: below the top of the parabola through its middle.
    if (curvature < 0 && is_negative(at_middle.value - square(at_middle.rate) / Ball(2 * curvature) - most))
        return true;
    // Monotonic: below the value at an end. The vertex that has struck begins from zero exactly.
    const Ball rate = at_middle.rate + all.curvature * away;
    if (is_negative(rate)) {
        if (piece.from == 0 && k == 0 && flight.begins_on_the_wall()) return true;
        if (is_negative(flight.gap(flight.at(Ball(piece.from)), k).value - most)) return true;
    }
    if (is_positive(rate) && is_negative(flight.gap(flight.at(Ball(piece.to)), k).value - most)) return true;
    seen_at_middle = lower(at_middle.value);
    return false;
}

struct Look {
    Seen seen = Seen::proven;
    int vertex = no_vertex;
    double depth = 0, where = 0;
    long pieces = 0;
};

/// Proves that g < `allowed` of all vertices but `except` on [from, to], or finds one that is not.
Look look(const FlightInBalls& flight, double from, double to, int except, double allowed) {
    Look result;
    const double shortest = std::max(1e-30, 1e-14 * (to - from) * 1e-8);
    std::vector<std::pair<double, double>> waiting{{from, to}};
    while (!waiting.empty()) {
        const auto [start, end] = waiting.back();
        waiting.pop_back();
        const Piece piece = piece_of(flight, start, end);
        ++result.pieces;
        if (flight.all_far_inside(piece.at_middle, piece.half)) continue;
        bool clear = true;
        const auto vertices = flight.perhaps_at_wall(piece.middle, piece.at_middle, piece.half, most_vertices);
        if (!vertices) clear = false;
        for (std::size_t i = 0; clear && i < vertices->size(); ++i) {
            const int k = (*vertices)[i];
            double seen = 0;
            if (k == except || is_inside(flight, piece, k, allowed, seen)) continue;
            clear = false;
            result.vertex = k;
            if (seen > allowed) {
                result.seen = Seen::refuted;
                result.depth = seen;
                result.where = piece.middle;
                return result;
            }
        }
        if (clear) continue;
        if (result.pieces > most_pieces || end - start < shortest || !(start < piece.middle && piece.middle < end)) {
            result.seen = Seen::undecided;
            result.where = start;
            return result;
        }
        waiting.emplace_back(piece.middle, end);
        waiting.emplace_back(start, piece.middle);
    }
    result.vertex = no_vertex;
    return result;
}

void take_over(const Look& look, Check& check) {
    check.seen = look.seen;
    check.vertex = look.vertex;
    check.depth = look.depth;
    check.where = look.where;
    check.pieces += look.pieces;
}

/// Nothing outside on [0, end]: exactly, else but for rounding.
bool is_clear(const FlightInBalls& flight, double end, Check& check) {
    check.seen = Seen::proven;
    if (!(end > 0)) return true;
    const Look exact = look(flight, 0, end, no_vertex, 0);
    take_over(exact, check);
    if (exact.seen == Seen::proven) return true;
    const Look rounded = look(flight, 0, end, no_vertex, rounding_depth(1 + flight.way(end)));
    if (rounded.seen == Seen::proven) {
        check.pieces += rounded.pieces;
        check.seen = exact.seen == Seen::refuted ? Seen::graze : Seen::undecided;
    } else {
        take_over(rounded, check);
    }
    return false;
}

/// The time from `time` to the root of vertex k near it, by Newton's step over a bracket where g′ > 0.
Ball time_to_root(const FlightInBalls& flight, int k, double time, const Ball& rate) {
    return -(flight.gap(flight.at(Ball(time)), k).value / rate);
}

Ball rate_over(const FlightInBalls& flight, int k, double from, double to) {
    const double middle = from + 0.5 * (to - from);
    const auto at_middle = flight.at(Ball(middle));
    const auto all = flight.gap(flight.over(from, to, middle, at_middle), k);
    return flight.gap(at_middle, k).rate + all.curvature * (between(from, to) - Ball(middle));
}

/// Who strikes first in the bracket about the claimed time, in which `striking` has one root.
void compare_roots(const FlightInBalls& flight, int striking, double time, double before, double after, Check& check) {
    const Ball root = time_to_root(flight, striking, time, rate_over(flight, striking, before, after));
    const auto at = flight.at(Ball(time));
    const auto others = flight.perhaps_at_wall(time, at, after - before, flight.sides());
    for (const int k : *others) {
        if (k == striking) continue;
        const Piece piece = piece_of(flight, before, after);
        double seen = 0;
        if (is_inside(flight, piece, k, 0, seen)) continue;
        check.vertex = k;
        const Ball rate = rate_over(flight, k, before, after);
        const Ball apart = is_positive(rate) ? time_to_root(flight, k, time, rate) - root : Ball(0);
        check.apart = intervals::middle(apart);
        check.where = time;
        check.seen = is_positive(apart) ? Seen::tie : is_negative(apart) ? Seen::swapped : Seen::undecided;
        if (check.seen != Seen::tie) return;
    }
}

/// `way`: that the rounding of the striking vertex' gap is relative to.
Check check_within(const FlightInBalls& flight, int striking, double time, double way) {
    Check check;
    const auto claimed = flight.gap(flight.at(Ball(time)), striking);
    const double depth = rounding_depth(way), rate = lower(claimed.rate);
    // Where the vertex turns so soon that the wall's rounding is wider than its approach, there is no root to bracket.
    const double slack = rate > 0 ? depth / rate + 16 * eps * time : time;
    const double curvature = std::max(std::fabs(lower(claimed.curvature)), std::fabs(upper(claimed.curvature)));
    if (!(slack * curvature <= 0.25 * rate)) {
        const double about = std::min(0.5 * time, std::sqrt(4 * depth / std::max(curvature, 1e-300)) + 16 * eps * time);
        if (is_clear(flight, time - about, check)) check.seen = Seen::tangent;
        if (!(std::fabs(intervals::middle(claimed.value)) <= 2 * depth)) check.seen = Seen::refuted;
        if (check.vertex == no_vertex) check.vertex = striking;
        return check;
    }
    const double before = std::max(time - slack, 0.0), after = time + slack;
    const Ball bracket = rate_over(flight, striking, before, after);
    const bool comes = before == 0 || is_negative(flight.gap(flight.at(Ball(before)), striking).value);
    const bool goes = is_positive(bracket) && is_positive(flight.gap(flight.at(Ball(after)), striking).value);
    if (!comes || !goes) {
        check.seen = Seen::refuted;
        check.vertex = striking;
        check.where = comes ? after : before;
        return check;
    }
    if (!is_clear(flight, before, check)) return check;
    const double late = std::fabs(intervals::middle(time_to_root(flight, striking, time, bracket)));
    check.late = late / (eps * (way / rate + time));
    if (flight.sides() != disk_sides) compare_roots(flight, striking, time, before, after, check);
    return check;
}

}  // namespace

Check check_contact(const Scene<double>& scene, const Flight<double>& given, const FirstContact<double>& contact) {
    const FlightInBalls flight(scene, given);
    const double time = contact.at.time, moved = flight.way(time);
    // The vertex that has struck is known by what it has moved, however short its hop.
    const bool again = given.struck && contact.vertex == 0;
    const Check check = check_within(flight, contact.vertex, time, again ? moved : 1 + moved);
    if (check.seen != Seen::refuted || check.vertex != contact.vertex) return check;
    Check wider = check_within(flight, contact.vertex, time, (1 + given.beta) * (1 + moved));
    if (wider.seen != Seen::refuted) wider.seen = Seen::coarse;
    return wider;
}

Check check_none(const Scene<double>& scene, const Flight<double>& given, double end) {
    const FlightInBalls flight(scene, given);
    Check check;
    is_clear(flight, end, check);
    return check;
}

}  // namespace swirl::tests
