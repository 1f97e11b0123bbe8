// A plane of two parameters, in cells on which the number of fixed points and the stability of each are proven to be
// the same throughout, and a cover of the rest, in plain numbers: map/proof/README.md, "Cells".
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace swirl::cells {

/// A rectangle of two parameters.
struct ParameterCell {
    std::array<double, 2> low{}, high{};

    double middle(std::size_t i) const { return 0.5 * low[i] + 0.5 * high[i]; }
};

/// What is not certain of a cell.
enum class Doubt {
    none,
    equations,       ///< a solution is not excluded, or not enclosed
    longest_flight,  ///< a flight may be longer than is asked for
    contact_mode,    ///< an inequality of an impact is not certain
    clearance,       ///< another vertex may touch earlier
    stability,       ///< a multiplier may be on the unit circle
    not_looked_at,   ///< a stop came before
};
inline std::string_view name_of(Doubt doubt) {
    static constexpr std::string_view names[] = {"none",      "equations", "longest-flight", "contact-mode",
                                                 "clearance", "stability", "not-looked-at"};
    return names[static_cast<std::size_t>(doubt)];
}

/// A cell of the plane. `proven`: for every pair of parameters in it there are exactly `fixed_points` fixed points with
/// impacts and no longer flight than is asked for, and so many of each stability.
struct PlaneCell {
    std::array<double, 2> low{}, high{};
    int depth = 0;  ///< how often the plane was halved
    bool proven = false;
    int fixed_points = 0;
    int attracting = 0, saddles = 0, repelling = 0;
    Doubt doubt = Doubt::none;  ///< of a cell that is not proven

    static PlaneCell not_looked_at(const ParameterCell& cell, int depth) {
        return {cell.low, cell.high, depth, false, 0, 0, 0, 0, Doubt::not_looked_at};
    }
};

/// What a depth took.
struct DepthCost {
    std::size_t cells = 0;
    double seconds = 0;  ///< of a core
};

struct PlanePiece {
    std::vector<PlaneCell> cells;  ///< in the order of the halves; together they are the piece
    std::vector<DepthCost> costs;  ///< by depth
};

struct PlaneLimits {
    std::array<double, 2> least{};  ///< no side is halved below it
    int depth = 0;                  ///< of the piece itself
};

}  // namespace swirl::cells
