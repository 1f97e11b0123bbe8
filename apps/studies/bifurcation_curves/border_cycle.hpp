// A cycle on a border of the map: its itinerary, and what touches the wall besides its impacts.
#pragma once

#include "analysis/boundaries/boundary.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// What is the case on flight 0 of the cycle, which is numbered so. Each is one curve in the plane:
enum class Touch {
    grazing,       ///< a vertex touches within the flight: g(t*) = 0, g′(t*) = 0
    two_vertices,  ///< another vertex is on the wall as the flight ends: g(τ) = 0
    no_flight,     ///< the flight takes no time: another vertex was on the wall as it began
    slip_ends,     ///< slip stops just as the impact at the flight's end does: p_k = p_end
    slip_late,     ///< … just as compression ends: C(p_k) = 0
    slip_held,     ///< friction just holds what has stopped: |B₃| = μB₁
};
/// grazing, two-vertices, or stick-slip.
std::string_view name_of(Touch touch);
/// Is it a kind of curve on a border that is followed?
bool is_on_border(std::string_view kind);
/// Each by a name of its own, in the enumerators' order.
inline constexpr std::array touch_names = {"grazing",   "two-vertices", "no-flight",
                                           "slip-ends", "slip-late",    "slip-held"};

/// A vanishing impact, u_n → 0, is grazing of the vertex that strikes: the cycle without it.
struct BorderCycle {
    Touch touch = Touch::grazing;
    int vertex = 0;         ///< that touches, counted from the one that struck before flight 0
    double touch_time = 0;  ///< t*, of grazing
    analysis::CyclePoints points;
    std::vector<double> times;  ///< of the flights
    std::vector<int> vertices;  ///< that strike at their ends, counted each from the one before
    Eigen::Vector2d p{0, 0};
};

struct StartingPoint;

/// The cycle of a starting point whose kind is grazing, two-vertices or stick-slip: what it says itself, or what is
/// seen of it. Empty where it has no flights to name (through sustained contact), where nothing touches, or where no
/// impact is left (the vanishing impact of a fixed point).
std::optional<BorderCycle> border_cycle_of(const ItineraryMap& map, const StartingPoint& start);

}  // namespace swirl::studies::bifurcation_curves
