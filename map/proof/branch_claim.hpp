// What is claimed of a branch of cycles along one parameter, and what a proof says of it: plain numbers.
#pragma once

#include "map/model/parameter.hpp"
#include "map/proof/claim.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::proof {

/// A cycle to begin at, and the range of the parameter in which its branch is to be followed.
struct BranchClaim {
    Scene<double> scene;  ///< of the cycle
    CycleClaim cycle;
    Parameter parameter = Parameter::alpha;
    double low = 0, high = 0;
};

/// One box of a branch. The unknowns are, step by step, ψ, χ, v_n, v_t, S (of a disk without χ) and the flight's time,
/// then the parameter. For every value of the unknown number `running` in [low, high] there is a cycle with the
/// branch's word, continuous in it, whose other unknowns lie within `within` of `middle`.
struct BranchBox {
    std::size_t running = 0;
    double low = 0, high = 0;
    std::vector<double> middle;
    double within = 0;
    bool decided = false;  ///< no multiplier lies on the unit circle, for all of the box
    int outside = 0, inside = 0;
    double parameter_low = 0, parameter_high = 0;   ///< the cycles' parameters lie between
    double parameter_begin = 0, parameter_end = 0;  ///< where the box is entered and left
    double length = 0;  ///< of the curve, in units of the range for the parameter and of max(1, |x|) for the others

    ProvenStability stability() const {
        if (!decided) return ProvenStability::undecided;
        return outside == 0  ? ProvenStability::attracting
               : inside == 0 ? ProvenStability::repelling
                             : ProvenStability::saddle;
    }
};

/// Why a branch goes no farther.
enum class BranchEndKind {
    range,         ///< the parameter's range ends
    closed,        ///< it is back where it began
    contact_mode,  ///< an impact leaves its contact mode
    clearance,     ///< another vertex touches
    period,        ///< its points are not proven to be different ones
    equations,     ///< no box is mapped into itself
    stopped,       ///< by a stop, or after too many boxes
};
std::string_view name_of(BranchEndKind kind);

struct BranchEnd {
    BranchEndKind kind = BranchEndKind::range;
    std::string reason;   ///< which inequality fails; empty: none does
    bool proven = false;  ///< the branch ends for certain with its parameter between the two
    double parameter_low = 0, parameter_high = 0;
};

enum class SpecialKind { fold, flip, neimark_sacker, change };
std::string_view name_of(SpecialKind kind);

/// A change of the number of multipliers outside the unit circle. That the number changes between the parameters is
/// proven. `proven`: so is the point of this kind (map/intervals/bifurcation_point.hpp says what that holds), which is
/// a cycle of the branch. Otherwise the kind is the likely one, `change` where none is.
struct SpecialPoint {
    SpecialKind kind = SpecialKind::change;
    bool proven = false;
    int outside_before = 0, outside_after = 0;
    double parameter_low = 0, parameter_high = 0;  ///< of the point; where it is not proven, of the boxes
    std::vector<double> middle;                    ///< of a proven one: its unknowns lie within `within` of these
    double within = 0;
    double angle_low = 0, angle_high = 0;  ///< of a proven Neimark–Sacker point: the multipliers are e^{±iθ}
    std::size_t first = 0, last = 0;       ///< boxes first … last − 1, whose stability is not decided
};

struct BranchProof {
    std::string reason;  ///< why nothing was proven; empty: something was
    std::vector<Branch> itinerary;
    std::vector<BranchBox> boxes;  ///< from one end to the other, each with the next of one curve
    std::array<BranchEnd, 2> ends;
    std::vector<SpecialPoint> special;  ///< in the boxes' order
    double from = 0, to = 0;  ///< the cycles' parameters reach from one to the other, within the range that was asked

    bool proven() const { return !boxes.empty(); }
};

}  // namespace swirl::proof
