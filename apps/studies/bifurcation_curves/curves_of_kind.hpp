// Curves of one kind, each once: those of another kind never hold them, so that kinds are searched side by side.
#pragma once

#include "apps/studies/bifurcation_curves/border_curve.hpp"
#include "apps/studies/bifurcation_curves/search_equations.hpp"

#include <compare>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// Curves of one can only be parts of each other: fold, flip and Neimark–Sacker curves of one period, or all on one
/// kind of border (their cycles lack the impact that vanishes there, so that a starting point's period is not theirs).
struct CurveKind {
    std::string kind;
    std::size_t period = 0;  ///< 0: all

    auto operator<=>(const CurveKind&) const = default;
};
/// Empty where a starting point's kind is followed by nobody.
std::optional<CurveKind> curve_kind_of(const StartingPoint& start);

/// What a starting point has led to.
struct Followed {
    std::shared_ptr<const Curve> curve;  ///< none: one that is known, or none was found
    std::optional<std::size_t> on;       ///< number of the starting point of the curve through it; none: no curve
    std::shared_ptr<const BorderCurve> border;  ///< the curve with its equations, of one on a border
    std::vector<std::size_t> parts;             ///< numbers of the starting points whose curves were parts of this one
    bool without = false;                       ///< no curve was found
};

class CurvesOfKind {
public:
    explicit CurvesOfKind(std::shared_ptr<const SearchEquations> equations) : equations_(std::move(equations)) {}

    /// Follows the curve through a starting point, unless it is on one that was found before. What it finds depends on
    /// the order of the calls. None if it was stopped.
    ///   number  of the starting point, by which it is named in `parts`
    std::optional<Followed> follow(std::size_t number, const StartingPoint& start);

private:
    /// A curve with its equations, as it is written, and the number of its starting point.
    template <class Equations>
    struct Known {
        std::shared_ptr<const Equations> curve;
        std::shared_ptr<const Curve> listed;
        std::size_t number = 0;
    };

    std::optional<Followed> follow_smooth(std::size_t number, const StartingPoint& start, analysis::BoundaryKind kind);
    std::optional<Followed> follow_touch(std::size_t number, const StartingPoint& start);
    template <class Equations>
    Followed add(Known<Equations> found, std::vector<Known<Equations>>& known) const;
    template <class Equations>
    bool is_part(const Known<Equations>& part, const Known<Equations>& whole) const;
    bool runs_along(const CurveCycle& at, const Curve& curve) const;
    bool is_at(const analysis::Boundary& part, std::size_t i, const analysis::Boundary& whole) const;
    bool is_at(const BorderCurve& part, std::size_t i, const BorderCurve& whole) const;
    bool is_stopped() const { return equations_->follow.control.is_stopped(); }

    std::shared_ptr<const SearchEquations> equations_;
    std::vector<Known<analysis::Boundary>> smooth_;
    std::vector<Known<BorderCurve>> borders_;
};

}  // namespace swirl::studies::bifurcation_curves
