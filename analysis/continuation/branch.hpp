// A branch of cycles over one parameter (or a family along itself), with its special points.
#pragma once

#include "analysis/continuation/normal_form.hpp"
#include "analysis/cycles/curve.hpp"
#include "analysis/cycles/cycle.hpp"

#include <complex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::analysis {

enum class SpecialKind {
    fold,            ///< the branch turns back: a multiplier is 1
    flip,            ///< a multiplier is −1
    neimark_sacker,  ///< a pair e^{±iθ}
    branch_point,    ///< another branch crosses
    border,          ///< a border of the map: named by the application
};
std::string_view name(SpecialKind kind);

enum class BranchEnd {
    range,          ///< the parameter reached the end of its range
    closed,         ///< the branch came back to where it began
    border,         ///< a border of the map behind which no cycle was found to go on
    not_converged,  ///< no cycle was found to go on, though the map does
    most_points,    ///< as many points as were asked for
    halved,         ///< it met the flip of a cycle of half its period, behind which it repeats itself
    switched,       ///< it begins at a special point of another branch
    family,         ///< from there on the solutions are no curve over the parameter, but a family at one value of it
    stopped,        ///< interrupted
};
std::string_view name(BranchEnd end);

/// A cycle of the branch.
struct BranchPoint {
    CurvePoint at;
    std::vector<std::complex<double>> multipliers;  ///< by falling modulus
    int index = 0;                                  ///< how many lie outside the unit circle
    Stability stability = Stability::stable;
    double mean = 0;  ///< time mean of the observable
};

/// A special point (SpecialKind), located on the branch.
struct SpecialPoint {
    SpecialKind kind = SpecialKind::fold;
    std::string border;  ///< its name, for a border
    BranchPoint cycle;
    std::vector<std::int64_t> word_before;  ///< of a border: on the side of the branch's earlier points …
    std::vector<std::int64_t> word_after;   ///< … and of its later ones; empty if the map ends there
    bool goes_on = true;                    ///< false: no cycle was found behind the border
    bool located = true;                    ///< false: known only to lie between two points of the branch
    std::optional<NormalForm> normal_form;
    std::size_t after = 0;  ///< between branch points `after` and `after` + 1
};

struct Branch {
    std::vector<BranchPoint> points;     ///< in order, from one end to the other
    std::vector<SpecialPoint> special;   ///< in the same order
    BranchEnd begin = BranchEnd::range;  ///< why it ends there
    BranchEnd end = BranchEnd::range;
    int parent = -1;          ///< the branch it was switched from, in a list of branches
    int parent_special = -1;  ///< and that branch's special point

    std::size_t period() const { return points.empty() ? 0 : points.front().at.points.size(); }
};

BranchPoint branch_point_at(const CurvePoint& at);

/// Makes `back`, which was walked the other way from the same point, the first part of `forth`.
void put_before(Branch back, Branch& forth);

}  // namespace swirl::analysis
