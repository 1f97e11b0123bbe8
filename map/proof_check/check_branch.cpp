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
        std::vector<CurvePiece> before;
        for (std::size_t i = 0; i < branch_.boxes.size(); ++i) {
            if (stop_()) return "the check was stopped";
            std::vector<CurvePiece> pieces;
            const StatedBox& box = branch_.boxes[i];
            std::string failed = cover(box, box.low, box.high, 0, pieces);
            if (failed.empty() && i > 0 && !are_joined(before, pieces))
                failed = "it is not shown to be of one curve with the box before";
            if (!failed.empty()) return "box " + std::to_string(i + 1) + ": " + failed;
            before = std::move(pieces);
        }
        if (!(least_ <= branch_.from)) return "its parameter is not shown to come down to where it is said to";
        if (!(most_ >= branch_.to)) return "its parameter is not shown to come up to where it is said to";
        return {};
    }

private:
    intervals::CurveSystem system() const {
        return [this](const std::vector<Running>& unknowns) { return equations_.at(unknowns); };
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
    double least_ = std::numeric_limits<double>::infinity(), most_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::string what_fails(const StatedBranch& branch, const std::function<bool()>& stop) {
    return BranchCheck(branch, stop).run();
}

}  // namespace swirl::proof_check
