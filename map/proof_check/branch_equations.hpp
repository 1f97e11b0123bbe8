// The equations between neighbouring points of a cycle along a curve of cycles, with one of the scene's numbers
// unknown.
#pragma once

#include "map/intervals/bifurcation_point.hpp"
#include "map/intervals/solution_curve.hpp"
#include "map/proof_check/cell_motion.hpp"
#include "map/proof_check/stated_branch.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::proof_check {

using intervals::Running;
using RunningGradient = GradientOver<Running>;

class BranchEquations {
public:
    /// @throws std::invalid_argument where the statement's parts contradict each other
    explicit BranchEquations(const StatedBranch& branch);

    std::size_t unknowns() const { return steps_.size() * width() + 1; }
    intervals::CurveLinearisation at(const std::vector<Running>& unknowns) const;

    /// With second derivatives.
    intervals::SecondOrder twice_at(const intervals::BallVector& unknowns) const;
    /// False: slip that stops at once, which has no second derivative.
    bool is_smooth() const;

    /// The first inequality of impact or flight that is not certain, or points that may be one; empty: none.
    std::string doubt(const std::vector<Running>& unknowns) const;
    /// How many multipliers lie inside the unit circle.
    std::optional<int> multipliers_inside(const std::vector<Running>& unknowns) const;
    std::size_t multipliers() const { return kept_.size(); }

private:
    std::size_t width() const { return kept_.size() + 1; }
    SceneOver<RunningGradient> scene_at(const Running& parameter) const;
    template <class S>
    StepVariablesOver<S> variables_of(const std::vector<S>& unknowns, std::size_t i) const;
    template <class S>
    std::vector<const GradientOver<S>*> equations_of(const StepEquationsOver<S>& all) const;
    bool is_in_range(const Running& parameter) const;
    std::string doubtful_impact(const std::vector<Running>& unknowns) const;
    std::string doubtful_flight(const std::vector<Running>& unknowns) const;
    bool differ(const std::vector<Running>& unknowns, std::size_t i) const;

    StatedScene scene_;
    Ball kappa_;
    std::vector<StatedStep> steps_;
    std::vector<std::size_t> kept_;  ///< of ψ, χ, v_n, v_t, S those that are unknown
    std::string parameter_;
};

}  // namespace swirl::proof_check
