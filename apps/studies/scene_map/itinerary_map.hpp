// The letters of an orbit's itinerary: which smooth branch of the return map each step took.
#pragma once

#include "map/model/parameter.hpp"
#include "map/orbit/return_map.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace swirl::studies {

struct Letter {
    int vertex_step = 0;
    ContactMode mode = ContactMode::frictionless;
    bool through_contact = false;  ///< the way led through sustained contact
};

/// As analyses carry it, one number: 6 · vertex step + contact mode; −1 less that where the way led through contact.
inline std::int64_t number_of(const Letter& letter) {
    constexpr int modes = 6;
    const std::int64_t number = modes * std::int64_t{letter.vertex_step} + static_cast<int>(letter.mode);
    return letter.through_contact ? -1 - number : number;
}

inline Letter letter_from(std::int64_t number) {
    constexpr int modes = 6;
    const bool through_contact = number < 0;
    if (through_contact) number = -1 - number;
    return {static_cast<int>(number / modes), static_cast<ContactMode>(number % modes), through_contact};
}

inline Letter letter_of(const ReturnStep<double>& step) {
    return {step.collision.vertex_step, step.collision.impulse.mode, !step.contacts.empty()};
}

// Flights and impacts by an itinerary that is given, over two parameters, for cycles on the borders of the map.

/// g and g′ of a vertex at a time after z; derivatives by (z, t, p₁, p₂), D + 3 long.
struct ItineraryTouchRows {
    double gap = 0, rate = 0;
    Eigen::RowVectorXd gap_by, rate_by;
};

/// One of swirl::ModeMargins with its derivatives.
struct ModeMargin {
    double value = 0;
    Eigen::RowVectorXd by;
};

/// The state after its impact then, with derivatives by the same, D × (D + 3).
struct ItineraryStep {
    ItineraryTouchRows touch;
    Eigen::VectorXd after;
    Eigen::MatrixXd after_by;
    ContactMode mode = ContactMode::frictionless;
    bool stops = false;           ///< slip could stop: the next two have a meaning
    ModeMargin slip, late, held;  ///< p_k − p_end; C(p_k); |B₃| − μB₁
};

struct ItineraryMap {
    int dimension = 0;
    int sides = 0;                      ///< 0: a disk, whose rim is its one vertex
    std::vector<double> angle_periods;  ///< per coordinate; 0: a plain number
    using Point = Eigen::VectorXd;
    using Plane = Eigen::Vector2d;
    std::function<ItineraryStep(const Point& z, double time, const Plane& p, int vertex)> step;
    std::function<ItineraryTouchRows(const Point& z, double time, const Plane& p, int vertex)> touch;
    /// The vertices nearest to the wall at a time, with their gaps: the nearest first.
    std::function<std::vector<std::pair<int, double>>(const Point& z, double time, const Plane& p)> nearest;
};

/// The scene's; vertices are counted from the one that has just struck. Friction is what `scene` has, or where μ is a
/// parameter.
ItineraryMap itinerary_map_of(const Scene<double>& scene, Parameter first, Parameter second);

}  // namespace swirl::studies
