#include "map/proof_check/branch_equations.hpp"
#include "map/proof_check/stated_branch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::proof_check {

namespace {

using intervals::curve_piece;
using intervals::CurvePiece;
using intervals::lies_on;
using intervals::lower;
using intervals::upper;

constexpr double overlap_share = 1e-3;  ///< of the halves of a box, and where the points lie that boxes have in common
constexpr int most_halvings = 10;

class BranchCheck {
public:
    BranchCheck(const StatedBranch& branch, const std::function<bool()>& stop)
        : branch_(branch), equations_(branch), stop_(stop) {}

    std::string run() {
        for (const StatedSpecial& special : branch_.special)
            if (std::string failed = take_special(special); !failed.empty())
                return "special point " + std::to_string(special_.size() + 1) + ": " + failed;
        std::vector<CurvePiece> before;
        for (std::size_t i = 0; i < branch_.boxes.size(); ++i) {
            if (stop_()) return "the check was stopped";
            std::vector<CurvePiece> pieces;
            const StatedBox& box = branch_.boxes[i];
            std::string failed = cover(box, box.low, box.high, 0, pieces);
            if (failed.empty() && i > 0 && !are_joined(before, pieces))
                failed = "it is not shown to be of one curve with the box before";
            if (!failed.empty()) return "box " + std::to_string(i + 1) + ": " + failed;
            see_special(i, pieces);
            before = std::move(pieces);
        }
        for (std::size_t i = 0; i < special_.size(); ++i)
            if (!seen_[i]) return "special point " + std::to_string(i + 1) + ": it is not shown to lie in its boxes";
        if (!(least_ <= branch_.from)) return "its parameter is not shown to come down to where it is said to";
        if (!(most_ >= branch_.to)) return "its parameter is not shown to come up to where it is said to";
        return {};
    }

private:
    intervals::CurveSystem system() const {
        return [this](const std::vector<Running>& unknowns) { return equations_.at(unknowns); };
    }

    /// The point is enclosed again. @return what of its statement fails
    std::string take_special(const StatedSpecial& stated) {
        using intervals::BifurcationKind;
        const bool is_pair = stated.kind == "neimark-sacker";
        if (stated.middle.size() != equations_.unknowns() || !(stated.within > 0 && stated.within < 1e-6))
            return "it has another number of unknowns, or no place";
        if (stated.kind != "fold" && stated.kind != "flip" && !is_pair) return "its kind is none";
        if (!equations_.is_smooth()) return "slip stops at once: there is no second derivative";
        const auto twice = [this](const intervals::BallVector& at) { return equations_.twice_at(at); };
        const auto kind = is_pair                 ? BifurcationKind::neimark_sacker
                          : stated.kind == "fold" ? BifurcationKind::fold
                                                  : BifurcationKind::flip;
        const auto point = intervals::bifurcation_point(twice, kind, stated.middle);
        if (!point) return "no " + stated.kind + " point is shown to be there";
        for (std::size_t i = 0; i < stated.middle.size(); ++i)
            if (!(upper(abs(point->unknowns[i] - Ball(stated.middle[i]))) <= stated.within))
                return "it does not lie where it is said to";
        if (!(lower(point->unknowns.back()) >= stated.low && upper(point->unknowns.back()) <= stated.high))
            return "its parameter is another";
        if (is_pair && !(lower(point->angle) >= stated.angle_low && upper(point->angle) <= stated.angle_high))
            return "its multipliers have another angle";
        special_.push_back(point->unknowns);
        seen_.push_back(false);
        return {};
    }

    /// Which of the special points lie on a box's pieces.
    void see_special(std::size_t box, const std::vector<CurvePiece>& pieces) {
        for (std::size_t i = 0; i < special_.size(); ++i) {
            if (box < branch_.special[i].first || box >= branch_.special[i].last) continue;
            for (const CurvePiece& piece : pieces)
                if (lies_on(piece, intervals::as_point(special_[i], piece.running))) seen_[i] = true;
        }
    }

    /// Pieces of the curve, one after another, over [low, high] of the box. @return why there are none
    std::string cover(const StatedBox& box, double low, double high, int halvings, std::vector<CurvePiece>& pieces) {
        std::string failed = "Krawczyk's operator does not map a box into itself";
        const auto piece = curve_piece(system(), guess(box, 0.5 * (low + high)), box.running, low, high);
        if (piece) failed = what_is_open(box, *piece);
        if (piece && failed.empty()) {
            see_parameters(*piece);
            pieces.push_back(*piece);
            return {};
        }
        if (halvings == most_halvings) return failed;
        const double middle = 0.5 * (low + high), more = overlap_share * (high - low);
        std::vector<CurvePiece> first, second;
        failed = cover(box, low, middle + more, halvings + 1, first);
        if (failed.empty()) failed = cover(box, middle - more, high, halvings + 1, second);
        if (!failed.empty()) return failed;
        const auto point = curve_piece(system(), guess(box, middle), box.running, middle, middle);
        if (!point || !lies_on(first.back(), *point) || !lies_on(second.front(), *point))
            return "its halves are not shown to be of one curve";
        pieces.insert(pieces.end(), first.begin(), first.end());
        pieces.insert(pieces.end(), second.begin(), second.end());
        return {};
    }

    /// Along the tangent in the box's middle.
    std::vector<double> guess(const StatedBox& box, double at) const {
        std::vector<double> point = box.middle;
        const std::vector<double> direction = intervals::direction_at(system(), point, box.running);
        for (std::size_t i = 0; i < direction.size(); ++i) point[i] += (at - box.middle[box.running]) * direction[i];
        point[box.running] = at;
        return point;
    }

    std::string what_is_open(const StatedBox& box, const CurvePiece& piece) const {
        const std::vector<Running> all = tube(piece, piece.near);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (i != box.running && !(largest(all[i] - Running(box.middle[i])) <= box.within))
                return "its cycles are not shown to lie as near its middle as is said";
        if (std::string open = equations_.doubt(all); !open.empty()) return open;
        if (!box.decided) return {};
        const auto inside = equations_.multipliers_inside(all);
        if (!inside) return "its multipliers are not shown to lie off the unit circle";
        const auto total = static_cast<int>(equations_.multipliers());
        if (*inside != box.inside || total - *inside != box.outside)
            return "it states another number of multipliers inside the unit circle than there are";
        return {};
    }

    /// The points of the curve at a piece's ends.
    void see_parameters(const CurvePiece& piece) {
        const std::vector<Running> all = tube(piece, piece.near);
        const Running& p = all.back();
        for (const double e : {-1.0, 1.0}) {
            Running at(p.mid);
            at += Running(e * p.by[0]);
            at += p.two[0] == 0 ? Running() : Running(p.two[0]);
            at.rest = intervals::detail::at_least(at.rest + p.rest);
            see_parameter(at);
        }
    }
    void see_parameter(const Running& p) {
        least_ = std::min(least_, upper(p));
        most_ = std::max(most_, lower(p));
    }

    /// A point near an end of one lies on a piece of either.
    bool are_joined(const std::vector<CurvePiece>& a, const std::vector<CurvePiece>& b) {
        const auto on = [](const std::vector<CurvePiece>& pieces, const CurvePiece& point) {
            return std::any_of(pieces.begin(), pieces.end(),
                               [&](const CurvePiece& piece) { return lies_on(piece, point); });
        };
        for (const auto* pieces : {&a, &b})
            for (const CurvePiece& piece : {pieces->front(), pieces->back()})
                for (const double share : {-1 + 2 * overlap_share, 1 - 2 * overlap_share}) {
                    const std::vector<Running> all = tube(piece, piece.near);
                    std::vector<double> point;
                    for (const Running& x : all) point.push_back(x.mid + share * (x.by[0] + share * x.two[0]));
                    const double s = point[piece.running];
                    const auto found = curve_piece(system(), point, piece.running, s, s);
                    if (!found || !on(a, *found) || !on(b, *found)) continue;
                    see_parameter(tube(*found, found->near).back());
                    return true;
                }
        return false;
    }

    const StatedBranch& branch_;
    BranchEquations equations_;
    const std::function<bool()>& stop_;
    std::vector<intervals::BallVector> special_;  ///< enclosed
    std::vector<bool> seen_;                      ///< on a piece of one of their boxes
    double least_ = std::numeric_limits<double>::infinity(), most_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::string what_fails(const StatedBranch& branch, const std::function<bool()>& stop) {
    return BranchCheck(branch, stop).run();
}

}  // namespace swirl::proof_check
