#include "map/intervals/arb.hpp"
#include "map/proof_check/carried_piece.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::proof_check {

namespace {

using intervals::around;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::middle;
using intervals::upper;

/// x − y, angles to the nearest turn.
Balls difference(const CheckedChaos& chaos, const Balls& x, const std::vector<double>& y) {
    const Ball circle = Ball(2) * intervals::pi_ball();
    Balls d(y.size());
    for (std::size_t j = 0; j < y.size(); ++j) {
        d[j] = x[j] - Ball(y[j]);
        if (chaos.chart[j] >= 2) continue;
        const double turns = std::round(middle(d[j] / circle));
        if (std::isfinite(turns)) d[j] -= Ball(turns) * circle;
    }
    return d;
}

/// In a set's own axes.
Balls in_axes(const BallRows& inverse, const Balls& d) {
    Balls at(d.size());
    for (std::size_t j = 0; j < d.size(); ++j)
        for (std::size_t i = 0; i < d.size(); ++i) at[i].add_product(inverse[i][j], d[j]);
    return at;
}

struct Checker {
    const StatedChaos& chaos;
    const CheckedChaos& checked;
    const std::vector<BallRows>& inverses;
    const std::function<bool()>& stop;

    /// The piece's image in the axes of the covering's second set, and how much of each coordinate is due to which
    /// direction of q.
    struct Place {
        Balls at;
        std::vector<std::vector<double>> effects;  ///< coordinate, direction
        std::string open;
    };

    Place place_of(const StatedCovering& covering, const Carried& image) const {
        Place place;
        place.open = image.open;
        if (!place.open.empty()) return place;
        const BallRows& inverse = inverses[covering.to];
        const Balls away = difference(checked, image.middle, chaos.sets[covering.to].centre);
        const Ball either = around(0, 1), square = intervals::between(0, 1);
        const std::size_t n = away.size();
        for (std::size_t a = 0; a < n && checked.chart[a] < 2; ++a) {
            Ball angle = away[a];  // what turns by half a turn or more may have gone round the other way
            for (const BallRows* terms : {&image.slopes, &image.curves})
                for (const Ball& term : (*terms)[a]) angle.add_product(term, either);
            if (!is_positive(intervals::pi_ball() - abs(angle)))
                place.open = "an image is not shown to lie less than half a turn from the set that it is carried over";
        }
        place.at = in_axes(inverse, away);
        place.effects.assign(n, std::vector<double>(n, 0.0));
        const auto turned = [&](std::size_t i, const BallRows& rows, std::size_t column) {
            Ball sum;
            for (std::size_t a = 0; a < n; ++a) sum.add_product(inverse[i][a], rows[a][column]);
            return sum;
        };
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<double>& effects = place.effects[i];
            std::size_t pair = 0;
            for (std::size_t j = 0; j < n; ++j) {
                const Ball slope = turned(i, image.slopes, j);
                place.at[i].add_product(slope, either);
                effects[j] += upper(abs(slope));
                for (std::size_t k = j; k < n; ++k, ++pair) {
                    const Ball curve = turned(i, image.curves, pair);
                    place.at[i].add_product(curve, j == k ? square : either);
                    effects[j] += upper(abs(curve));
                    effects[k] += upper(abs(curve));
                }
            }
            if (!is_finite(place.at[i])) place.open = "the image of a piece is not bounded";
        }
        return place;
    }

    /// The direction in which a piece is halved: that which its image depends on most.
    static std::size_t direction_of(const CarriedPiece& piece, const StatedSet& set, const Carried& image,
                                    const Place& place, std::size_t row) {
        const std::size_t n = piece.low.size();
        std::size_t widest = 0;
        double best = -1;
        for (std::size_t j = 0; j < n; ++j) {
            double effect = 0;
            if (place.open.empty())
                effect = place.effects[row][j];
            else if (!image.effects.empty())
                effect = image.effects[j];
            else
                for (std::size_t a = 0; a < n; ++a)
                    effect += std::abs(set.matrix[a * n + j]) * (piece.high[j] - piece.low[j]);
            if (!(piece.high[j] > piece.low[j]) || effect <= best) continue;
            best = effect;
            widest = j;
        }
        return widest;
    }

    /// Every piece of a box of q satisfies `holds`, after halving; else why not.
    template <class Holds>
    std::string everywhere(const StatedCovering& covering, double first_low, double first_high,
                           const Holds& holds) const {
        constexpr int most = 6000;
        const std::size_t n = checked.chart.size();
        const StatedSet& set = chaos.sets[covering.from];
        Eigen::VectorXd guess(checked.kept.size() + 1);
        for (std::size_t a = 0; a < checked.kept.size(); ++a)
            guess[static_cast<Eigen::Index>(a)] = covering.image[checked.kept[a]];
        guess[guess.size() - 1] = covering.time;
        std::vector<CarriedPiece> waiting{{std::vector<double>(n, -1), std::vector<double>(n, 1), guess}};
        waiting.front().low[0] = first_low;
        waiting.front().high[0] = first_high;
        for (int looked = 1; !waiting.empty(); ++looked) {
            if (stop && stop()) return "it was stopped";
            const CarriedPiece piece = std::move(waiting.back());
            waiting.pop_back();
            const Carried image = carried(checked, set, covering, piece);
            const Place place = place_of(covering, image);
            std::string why = place.open;
            std::size_t row = 0;
            if (why.empty() && holds(place.at, row, why)) continue;
            if (looked >= most) return why + ", after 6000 pieces";
            const std::size_t widest = direction_of(piece, set, image, place, row);
            const double cut = 0.5 * (piece.low[widest] + piece.high[widest]);
            if (!(piece.high[widest] - piece.low[widest] > 1e-12)) return why + ": on a piece of no width";
            CarriedPiece one = piece, other = piece;
            one.high[widest] = cut;
            other.low[widest] = cut;
            if (image.found.size() != 0) one.guess = other.guess = image.found;
            waiting.push_back(std::move(other));
            waiting.push_back(std::move(one));
        }
        return {};
    }

    static int side_of(const Ball& x) { return is_positive(x - Ball(1)) ? 1 : is_negative(x + Ball(1)) ? -1 : 0; }

    std::string exits(const StatedCovering& covering) const {
        int ends[2] = {0, 0};
        for (const int side : {0, 1}) {
            int& end = ends[side];
            const auto beyond = [&end](const Balls& at, std::size_t&, std::string& why) {
                const int now = side_of(at[0]);
                if (now != 0 && (end == 0 || end == now)) {
                    end = now;
                    return true;
                }
                char text[160];
                std::snprintf(text, sizeof text, "an exit's image is not shown to lie beyond an end: %.6g to %.6g",
                              lower(at[0]), upper(at[0]));
                why = text;
                return false;
            };
            const double q = side == 0 ? -1 : 1;
            if (const std::string why = everywhere(covering, q, q, beyond); !why.empty()) return why;
        }
        return ends[0] * ends[1] == -1 ? "" : "both exits lie beyond the same end";
    }

    std::string inside(const StatedCovering& covering) const {
        return everywhere(covering, -1, 1, [](const Balls& at, std::size_t& row, std::string& why) {
            if (side_of(at[0]) != 0) return true;
            for (std::size_t i = 1; i < at.size(); ++i) {
                if (is_positive(Ball(1) - abs(at[i]))) continue;
                row = i;
                char text[160];
                std::snprintf(text, sizeof text, "coordinate %zu of the image is not shown to lie within: %.6g to %.6g",
                              i, lower(at[i]), upper(at[i]));
                why = text;
                return false;
            }
            return true;
        });
    }

    bool are_apart(std::size_t i, std::size_t j) const {
        const StatedSet &own = chaos.sets[i], &other = chaos.sets[j];
        const std::size_t n = own.centre.size();
        Balls centre;
        for (const double x : other.centre) centre.emplace_back(x);
        const Balls at = in_axes(inverses[i], difference(checked, centre, own.centre));
        for (std::size_t a = 0; a < n; ++a) {
            Ball reach(1);
            for (std::size_t k = 0; k < n; ++k) {
                Ball entry;
                for (std::size_t b = 0; b < n; ++b) entry.add_product(inverses[i][a][b], Ball(other.matrix[b * n + k]));
                reach += abs(entry);
            }
            if (is_positive(abs(at[a]) - reach)) return true;
        }
        return false;
    }
};

/// A v ≥ growth v, and entropy ≤ log growth.
std::string check_growth(const StatedChaos& chaos) {
    const std::size_t n = chaos.sets.size();
    bool any = false;
    Balls open(n);
    for (const StatedCovering& covering : chaos.coverings) open[covering.from] += Ball(chaos.sets[covering.to].weight);
    for (std::size_t i = 0; i < n; ++i) {
        const double weight = chaos.sets[i].weight;
        if (!(weight >= 0) || !std::isfinite(weight)) return "a weight is negative, or no number";
        any = any || weight > 0;
        open[i] -= Ball(chaos.growth) * Ball(weight);
        if (weight > 0 && !(lower(open[i]) >= 0))
            return "the transition matrix times the weights is not shown to be as many times the weights as stated";
    }
    if (!any || !(chaos.growth > 1)) return "it shows no growth";
    Ball logarithm;
    arb_log(logarithm.raw(), Ball(chaos.growth).raw(), intervals::ball_precision);
    return lower(logarithm) >= chaos.entropy && chaos.entropy > 0
               ? ""
               : "the entropy is not shown to be as large as stated, or is none";
}

std::string about(const StatedCovering& covering, const std::string& why) {
    return "sets " + std::to_string(covering.from + 1) + " and " + std::to_string(covering.to + 1) + ": " + why;
}

}  // namespace

std::string what_fails(const StatedChaos& chaos, const std::function<bool()>& stop) {
    StatedCycle word = chaos.scene;
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (const StatedCovering& covering : chaos.coverings) {
        if (covering.from >= chaos.sets.size() || covering.to >= chaos.sets.size())
            return "a covering is of a set that is not there";
        if (!pairs.emplace(covering.from, covering.to).second) return "a covering is stated twice";
        StatedStep step;
        step.vertex_step = covering.vertex_step;
        step.contact_mode = covering.contact_mode;
        const std::string& mode = covering.contact_mode;
        step.slip = mode == "frictionless" || mode == "c-sticking" ? 0 : 1;
        word.steps.push_back(step);
    }
    require_itinerary(word);
    if (const std::string why = check_growth(chaos); !why.empty()) return why;
    const CheckedChaos checked = checked_chaos(chaos);
    std::vector<BallRows> inverses;
    for (const StatedSet& set : chaos.sets) {
        inverses.push_back(inverse_of(set));
        if (inverses.back().empty()) return "a set's matrix has no inverse";
        const std::size_t n = set.centre.size();
        for (std::size_t a = 0; a < n && checked.chart[a] < 2; ++a) {
            Ball extent;
            for (std::size_t j = 0; j < n; ++j) extent += abs(Ball(set.matrix[a * n + j]));
            if (!is_positive(Ball(1) - extent)) return "a set is wider than one radian";
        }
    }
    const Checker checker{chaos, checked, inverses, stop};
    for (const StatedCovering& one : chaos.coverings)
        for (const StatedCovering& other : chaos.coverings)
            if (one.from == other.from && one.to < other.to && !checker.are_apart(one.to, other.to) &&
                !checker.are_apart(other.to, one.to))
                return "sets " + std::to_string(one.to + 1) + " and " + std::to_string(other.to + 1) +
                       ", which one is carried over, may have a common point";
    for (const StatedCovering& covering : chaos.coverings)
        if (const std::string why = checker.exits(covering); !why.empty()) return about(covering, why);
    for (const StatedCovering& covering : chaos.coverings)
        if (const std::string why = checker.inside(covering); !why.empty()) return about(covering, why);
    return {};
}

}  // namespace swirl::proof_check
