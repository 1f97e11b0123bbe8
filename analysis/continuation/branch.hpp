// A branch of cycles over one parameter (or a family along itself), with its special points.
#pragma once

#include "analysis/continuation/normal_form.hpp"
#include "analysis/curves/walk.hpp"
#include "analysis/cycles/cycle.hpp"

#include <complex>
#include <cstddef>
#include <cstdint>
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
std::string_view name_of(SpecialKind kind);

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
    std::vector<std::int64_t> itinerary_before;  ///< of a border: on the side of the branch's earlier points …
    std::vector<std::int64_t> itinerary_after;   ///< … and of its later ones; empty if the map ends there
    bool goes_on = true;                         ///< false: no cycle was found behind the border
    bool located = true;                         ///< false: known only to lie between two points of the branch
    std::optional<NormalForm> normal_form;
    std::size_t after = 0;  ///< between branch points `after` and `after` + 1
};

struct Branch {
    std::vector<BranchPoint> points;    ///< in order, from one end to the other
    std::vector<SpecialPoint> special;  ///< in the same order
    CurveEnd begin = CurveEnd::range;   ///< why it ends there
    CurveEnd end = CurveEnd::range;
    int parent = -1;          ///< the branch it was switched from, in a list of branches
    int parent_special = -1;  ///< and that branch's special point

    std::size_t period() const { return points.empty() ? 0 : points.front().at.shooting.period; }
};

BranchPoint branch_point_at(const CurvePoint& at);

void turn(BranchPoint& point);
void turn(SpecialPoint& special);

/// The branch's cycle at p that is `points`, cyclic shifts included, to 10⁻⁶.
/// Cost: one root of the parameter along each step that passes p and is near the points.
std::optional<BranchPoint> find_on_branch(const ShootingMap& map, const Branch& branch, double p,
                                          const CyclePoints& points);

}  // namespace swirl::analysis
