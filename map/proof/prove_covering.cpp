#include "map/intervals/arb.hpp"
#include "map/proof/section_image.hpp"
#include "map/proof/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::proof {

namespace {

using intervals::around;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::middle;
using intervals::upper;

constexpr std::size_t psi_index = 0, chi_index = 1;

/// a − b of the chart's coordinates, angles to the nearest turn.
BallVector difference(const std::vector<std::size_t>& chart, const BallVector& a, const BallVector& b) {
    BallVector d;
    const Ball turn = Ball(2) * intervals::pi_ball();
    for (std::size_t i = 0; i < chart.size(); ++i) {
        d.push_back(a[i] - b[i]);
        if (chart[i] != psi_index && chart[i] != chi_index) continue;
        const double turns = std::round(middle(d.back()) / (2 * pi<double>()));
        if (std::isfinite(turns) && turns != 0) d.back() -= Ball(turns) * turn;
    }
    return d;
}

BallVector times(const BallMatrix& a, const BallVector& x) {
    BallVector y(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j) y[i].add_product(a[i][j], x[j]);
    return y;
}

BallMatrix times(const BallMatrix& a, const BallMatrix& b) {
    BallMatrix c(a.size(), BallVector(b.front().size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < c[i].size(); ++j)
            for (std::size_t k = 0; k < b.size(); ++k) c[i][j].add_product(a[i][k], b[k][j]);
    return c;
}

/// Where a piece's image lies in a set's own coordinates, and how much of that is due to each direction of q.
struct Landing {
    std::string open;
    BallVector at;
    std::vector<std::vector<double>> effects;  ///< coordinate, direction
};

Landing landing_of(const SectionFlights& flights, const BallSet& from, const BallSet& to, const UnitPiece& piece,
                   const CoveringClaim& link) {
    const SectionImage image = image_of(flights, from, piece, link.branch, link.time);
    Landing landing;
    landing.open = image.open;
    if (!landing.open.empty()) return landing;
    const BallVector away = difference(flights.chart, image.middle, to.centre);
    landing.at = times(to.inverse, away);
    const BallMatrix slopes = times(to.inverse, image.slopes), curves = times(to.inverse, image.curves);
    const std::size_t n = landing.at.size();
    const Ball either = around(0, 1), square = intervals::between(0, 1);
    for (std::size_t i = 0; i < n && flights.chart[i] <= chi_index; ++i) {
        Ball angle = away[i];
        for (const BallMatrix* terms : {&image.slopes, &image.curves})
            for (const Ball& term : (*terms)[i]) angle.add_product(term, either);
        if (!is_positive(intervals::pi_ball() - abs(angle)))
            landing.open = "the image of a piece is not certain to lie less than half a turn from the other set";
    }
    for (std::size_t i = 0; i < n; ++i) {
        landing.effects.emplace_back(n);
        std::size_t pair = 0;
        for (std::size_t j = 0; j < n; ++j) {
            landing.at[i].add_product(slopes[i][j], either);
            landing.effects[i][j] += upper(abs(slopes[i][j]));
            for (std::size_t k = j; k < n; ++k, ++pair) {
                landing.at[i].add_product(curves[i][pair], j == k ? square : either);
                landing.effects[i][j] += upper(abs(curves[i][pair]));
                landing.effects[i][k] += upper(abs(curves[i][pair]));
            }
        }
        if (!is_finite(landing.at[i])) landing.open = "the image of a piece is not bounded";
    }
    return landing;
}

/// Certainly beyond one end of a set's stretched direction: its sign; else 0.
int beyond_end(const Ball& x) {
    return is_positive(x - Ball(1)) ? 1 : is_negative(x + Ball(1)) ? -1 : 0;
}

/// A contracted coordinate that is not certainly within the set; 0: all are.
std::size_t loose_side(const BallVector& at) {
    for (std::size_t i = 1; i < at.size(); ++i)
        if (!is_negative(abs(at[i]) - Ball(1))) return i;
    return 0;
}

/// The halves in the direction that matters most: of the set where nothing is known of the image, else of the
/// coordinate that is not certain.
std::pair<UnitPiece, UnitPiece> halves(const UnitPiece& piece, const BallSet& from, const Landing& landing,
                                       std::size_t row) {
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t j = 0; j < piece.low.size(); ++j) {
        double effect = 0;
        if (landing.open.empty())
            effect = piece.high[j] > piece.low[j] ? landing.effects[row][j] : -1;
        else
            for (const BallVector& line : from.matrix)
                effect += std::abs(middle(line[j])) * (piece.high[j] - piece.low[j]);
        if (effect > most) {
            most = effect;
            widest = j;
        }
    }
    const double cut = 0.5 * (piece.low[widest] + piece.high[widest]);
    std::pair<UnitPiece, UnitPiece> both{piece, piece};
    both.first.high[widest] = cut;
    both.second.low[widest] = cut;
    return both;
}

struct Search {
    const SectionFlights& flights;
    const BallSet &from, &to;
    const CoveringClaim& link;
    int most_pieces;
    CoveringProof& proof;

    /// Halves pieces until `holds` is true of each. False: `proof.reason` says why.
    template <class Holds>
    bool all(const UnitPiece& whole, const char* what, const Holds& holds) {
        std::vector<UnitPiece> waiting{whole};
        while (!waiting.empty()) {
            const UnitPiece piece = std::move(waiting.back());
            waiting.pop_back();
            ++proof.pieces;
            const Landing landing = landing_of(flights, from, to, piece, link);
            std::size_t row = 0;
            std::string why = landing.open;
            if (why.empty() && holds(landing.at, row, why)) continue;
            if (proof.pieces >= most_pieces) {
                proof.reason = words("%s: %s; after %d pieces", what, why.c_str(), proof.pieces);
                return false;
            }
            auto [one, other] = halves(piece, from, landing, row);
            waiting.push_back(std::move(other));
            waiting.push_back(std::move(one));
        }
        return true;
    }

    /// The face q_0 = ±1 lies beyond one end: its sign; 0: not shown.
    int face(double side) {
        const std::size_t n = from.dimension();
        UnitPiece whole{std::vector<double>(n, -1), std::vector<double>(n, 1)};
        whole.low[0] = whole.high[0] = side;
        int end = 0;
        const bool done = all(whole, "an exit face", [&](const BallVector& at, std::size_t&, std::string& why) {
            const int now = beyond_end(at[0]);
            if (now != 0 && (end == 0 || now == end)) {
                end = now;
                return true;
            }
            why = words("its image reaches %.6g ... %.6g, beyond one of the ends -1 and 1 was to be shown",
                        lower(at[0]), upper(at[0]));
            return false;
        });
        return done ? end : 0;
    }

    bool body() {
        const std::size_t n = from.dimension();
        const UnitPiece whole{std::vector<double>(n, -1), std::vector<double>(n, 1)};
        return all(whole, "the set's image", [](const BallVector& at, std::size_t& row, std::string& why) {
            if (beyond_end(at[0]) != 0) return true;
            row = loose_side(at);
            if (row == 0) return true;
            why = words("contracted coordinate %zu reaches %.6g ... %.6g, within -1 and 1 was to be shown", row,
                        lower(at[row]), upper(at[row]));
            return false;
        });
    }
};

}  // namespace

std::vector<std::size_t> section_chart(const Scene<double>& scene) {
    if (!scene.is_disk()) return {0, 1, 2, 3, 4};
    if (scene.mu == 0) return {0, 3};
    return {0, 2, 3, 4};
}

void require_chart(const Scene<double>& scene) {
    without_floor(scene, "a proof of chaos");
    without_tangential_restitution(scene, "a proof of chaos");
    without_rod(scene, "a proof of chaos");
    without_rounding(scene, "a proof of chaos");
    if (scene.mu != 0) return;
    if (scene.restitution < 1)
        throw std::invalid_argument(
            "without friction and with restitution < 1 every motion dies out: there is no chaos");
    if (!scene.is_disk())
        throw std::invalid_argument(
            "J of a polygon without friction at restitution 1 is conserved: its levels are not looked at; mu > 0, or a "
            "disk, is wanted");
}

CoveringProof prove_covering(const Scene<double>& scene, const ChaosClaim& claim, const CoveringClaim& link,
                             int most_pieces) {
    CoveringProof proof;
    const SectionFlights flights(scene, claim);
    const BallSet from = ball_set(claim.sets[link.from]), to = ball_set(claim.sets[link.to]);
    if (!from.invertible || !to.invertible) {
        proof.reason = "a set has no inside: its matrix is singular";
        return proof;
    }
    Search search{flights, from, to, link, most_pieces, proof};
    const int low = search.face(-1), high = low == 0 ? 0 : search.face(1);
    if (low != 0 && high == low) proof.reason = "both exit faces lie beyond the same end";
    proof.proven = low != 0 && high == -low && search.body();
    return proof;
}

std::string common_point(const Scene<double>& scene, const ChaosClaim& claim, std::size_t i, std::size_t j) {
    const std::vector<std::size_t> chart = section_chart(scene);
    const BallSet sets[] = {ball_set(claim.sets[i]), ball_set(claim.sets[j])};
    const BallVector whole(chart.size(), around(0, 1));
    for (const BallSet& set : sets) {
        if (!set.invertible) return "a set has no inside: its matrix is singular";
        for (std::size_t a = 0; a < chart.size(); ++a) {  // so that one turn alone is to be looked at
            Ball extent;
            for (const Ball& entry : set.matrix[a]) extent += abs(entry);
            if (chart[a] <= chi_index && !is_negative(extent - Ball(1))) return "a set is wider than one radian";
        }
    }
    for (const int side : {0, 1}) {
        const BallSet &own = sets[side], &other = sets[1 - side];
        BallVector at = times(own.inverse, difference(chart, other.centre, own.centre));
        const BallVector reach = times(times(own.inverse, other.matrix), whole);
        for (std::size_t a = 0; a < at.size(); ++a)
            if (beyond_end(at[a] + reach[a]) != 0) return {};
    }
    return words("sets %zu and %zu may have a common point", i + 1, j + 1);
}

GrowthBound growth_bound(std::size_t sets, const std::vector<std::pair<std::size_t, std::size_t>>& links) {
    GrowthBound bound;
    const auto applied = [&](const std::vector<double>& v) {
        std::vector<double> image(sets, 0.0);
        for (const auto& [from, to] : links) image[from] += v[to];
        return image;
    };
    std::vector<double> v(sets, 1.0);
    for (int i = 0; i < 20'000; ++i) {  // of A + 1, whose largest eigenvalue is alone on its circle
        const std::vector<double> image = applied(v);
        double most = 0;
        for (std::size_t k = 0; k < sets; ++k) most = std::max(most, v[k] += image[k]);
        for (double& x : v) x = x > 1e-30 * most ? x / most : 0;
    }
    const std::vector<double> image = applied(v);
    double least = 0;
    bool any = false;
    for (std::size_t k = 0; k < sets; ++k)
        if (image[k] == 0) v[k] = 0;  // leads nowhere
    std::vector<Ball> enclosed(sets);
    for (const auto& [from, to] : links) enclosed[from] += Ball(v[to]);
    for (std::size_t k = 0; k < sets; ++k) {
        if (v[k] == 0) continue;
        const double ratio = lower(enclosed[k] / Ball(v[k]));
        least = any ? std::min(least, ratio) : ratio;
        any = true;
    }
    bound.weights = std::move(v);
    least = lower(Ball(least) * Ball(1 - 0x1p-40));  // so that a check in other roundings agrees
    bound.growth = least;
    if (!(least > 1)) return bound;
    Ball entropy;
    arb_log(entropy.raw(), Ball(least).raw(), intervals::ball_precision);
    bound.entropy = lower(entropy);
    return bound;
}

}  // namespace swirl::proof
