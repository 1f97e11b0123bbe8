// Branches of a scene's cycles along a parameter.
#pragma once

#include "analysis/continuation/continue_branch.hpp"
#include "analysis/section_map.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/parameter_range.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace swirl::studies {

/// What continuation needs to know of a scene: its map along the parameter (or that of the scene alone, for a family),
/// normal forms in 113 bits, names of borders.
struct SceneBranches {
    analysis::ShootingMap map;
    analysis::ContinuationOptions options;
};
///   accuracy  in which each step is computed (SceneMap)
///   stop      true: branches end where they are
SceneBranches scene_branches(const Scene<double>& scene, const ParameterRange& along,
                             Accuracy accuracy = Accuracy::double_precision, const analysis::Stop& stop = {});

/// The scene's value of the parameter; a family's is not needed.
double value_of(const Scene<double>& scene, const ParameterRange& along);

/// The name of a border from the last cycle before it and the itinerary behind it: "stick-slip", "two-vertices",
/// "grazing", "landing" (contact that lasts begins or ends), or "border" where none of these is seen there.
std::string border_name(const Scene<double>& scene, const analysis::CurvePoint& last,
                        const std::vector<std::int64_t>& itinerary_after, bool goes_on, Accuracy accuracy);

/// Second and third derivatives of Fᵏ by differences of DF in 113 bits.
analysis::HigherForms scene_forms(const Scene<double>& scene, Parameter parameter, const analysis::CyclePoints& points,
                                  double p);

/// What a special point is called: its kind, or the border's name.
std::string kind_of(const analysis::SpecialPoint& special);

/// How pieces of work are run, as `run_pieces` does.
using RunPieces = std::function<void(std::size_t count, const std::function<KeepResult(std::size_t)>& work)>;

/// Follows switches of flips and branch points, `depth` times one after another. `branches` grows, the same however
/// pieces are run.
///   longest  period of the branches that are switched to
///   run      a piece for each period that is switched to; empty: in turn
void follow_switches(const SceneBranches& scene, std::vector<analysis::Branch>& branches, int depth,
                     std::size_t longest = std::numeric_limits<std::size_t>::max(), const RunPieces& run = {});

}  // namespace swirl::studies
