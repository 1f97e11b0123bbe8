// What is claimed of a cycle, and what a proof says of it: plain numbers, without interval arithmetic.
#pragma once

#include "map/model/impact.hpp"
#include "map/model/section.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::proof {

/// The smooth branch of F that one step takes.
struct Branch {
    int vertex_step = 0;
    ContactMode mode = ContactMode::frictionless;
    int slip = 0;  ///< the sign of u_t before the impact; 0: none (frictionless), or both (slip stops at once)
};

/// A member of a family: S after the first impact, or the first flight's time.
struct Phase {
    bool by_time = false;
    double value = 0;
};

/// A k-cycle with its itinerary; not yet proven.
struct CycleClaim {
    std::vector<SectionPoint<double>> points;
    std::vector<double> times;      ///< of the flight that begins at each point, in 1/ω_s
    std::vector<Branch> itinerary;  ///< of the impact that ends it; `slip` is found by the proof
};

/// |z − (re + i im)| ≤ radius.
struct MultiplierDisc {
    double re = 0, im = 0, radius = 0;
};

enum class ProvenStability {
    attracting,  ///< every multiplier inside the unit circle
    saddle,      ///< one outside, one inside
    repelling,   ///< every one outside
    neutral,     ///< a family's: one is exactly 1, all others inside
    undecided,   ///< a disc meets the unit circle
};
std::string_view name_of(ProvenStability stability);

enum class Verdict {
    proven,
    refuted,    ///< the solution of the itinerary's equations, which exists, is no orbit: an inequality is violated
    undecided,  ///< nothing is proven
};

/// Half-widths of a box: ψ, χ, v_n, v_t, S.
using PointRadii = std::array<double, 5>;

struct CycleProof {
    Verdict verdict = Verdict::undecided;
    std::string reason;  ///< what failed and by how much; empty if proven
    std::vector<SectionPoint<double>> points;
    std::vector<PointRadii> radii;  ///< of the boxes about the points
    std::vector<double> times, time_radii;
    std::vector<Branch> itinerary;
    std::optional<Phase> phase;  ///< of a family
    std::vector<MultiplierDisc> multipliers;
    ProvenStability stability = ProvenStability::undecided;

    bool proven() const { return verdict == Verdict::proven; }
    /// The largest half-width of the box.
    double radius() const;
};

}  // namespace swirl::proof
