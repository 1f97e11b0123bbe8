// Branches of a scene's cycles, and how they leave: JSON, tables and records share them.
#pragma once

#include "analysis/continuation/continue_branch.hpp"
#include "apps/command_line/accuracy.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/parallel_pieces.hpp"
#include "apps/command_line/parameter_range.hpp"

#include <functional>
#include <limits>
#include <vector>

namespace swirl::apps {

/// What continuation needs to know of a scene: its map along the parameter (or that of the scene alone, for a family),
/// normal forms in 113 bits, names of borders.
struct SceneBranches {
    analysis::ShootingMap map;
    analysis::ContinuationOptions options;
};
///   accuracy  in which each step is computed (SceneMap)
SceneBranches scene_branches(const Scene<double>& scene, const ParameterRange& along,
                             Accuracy accuracy = Accuracy::double_precision);

/// The scene's value of the parameter; a family's is not needed.
double value_of(const Scene<double>& scene, const ParameterRange& along);

/// The name of a border from the last cycle before it and the word behind it: "stick-slip", "two-vertices", "grazing",
/// "landing" (contact that lasts begins or ends), or "border" where none of these is seen there.
std::string border_name(const Scene<double>& scene, const analysis::CurvePoint& last,
                        const std::vector<std::int64_t>& word_after, bool goes_on, Accuracy accuracy);

/// Second and third derivatives of Fᵏ by differences of DF in 113 bits.
analysis::HigherForms scene_forms(const Scene<double>& scene, Parameter parameter, const analysis::CyclePoints& points,
                                  double p);

/// What a special point is called: its kind, or the border's name.
std::string kind_of(const analysis::SpecialPoint& special);

/// `branches` of the JSON document.
void write_branches(JsonWriter& json, const SceneBranches& scene, const std::vector<analysis::Branch>& branches);

/// Groups `branches` (points), `branch_ends` (one row a branch) and `special` of a record.
///   observable  a coordinate that is written as `value` beside S, unless it is S
void write_branches(const RecordGroup& root, const SceneBranches& scene, const std::vector<analysis::Branch>& branches,
                    const std::string& observable = "S");

/// Where an observable stands in a state of that size: psi, chi, vn, vt or S.
Eigen::Index place_of(const std::string& observable, Eigen::Index size);

///   units  the user's, if there are any, of a family's flight times
void print_branches(const SceneBranches& scene, const ParameterRange& along,
                    const std::vector<analysis::Branch>& branches, const std::optional<Units>& units = {});

/// How pieces of work are run: in turn, or as `run_pieces` does.
using RunPieces = std::function<void(std::size_t count, const std::function<KeepResult(std::size_t)>& work)>;
void run_in_turn(std::size_t count, const std::function<KeepResult(std::size_t)>& work);

/// Follows switches of flips and branch points, `depth` times one after another. `branches` grows, the same however
/// pieces are run.
///   longest  period of the branches that are switched to
///   run      a piece for each period that is switched to
void follow_switches(const SceneBranches& scene, std::vector<analysis::Branch>& branches, int depth,
                     std::size_t longest = std::numeric_limits<std::size_t>::max(), const RunPieces& run = run_in_turn);

/// A section point as a JSON object.
void write_point(JsonWriter& json, const Eigen::VectorXd& z);
/// The same of a list of coordinates, which NaN may fill up; null of none.
void write_point_or_null(JsonWriter& json, const std::vector<double>& coordinates);
/// A word as a list of {vertex_step, contact_mode}.
void write_word(JsonWriter& json, const std::vector<std::int64_t>& word);
/// The names of a section point's coordinates; a disk's has four.
std::vector<std::string> coordinate_names(Eigen::Index size);
/// The unit of one of them.
std::string units_of_coordinate(const std::string& name);
/// A group's dimension `coordinate`, with these names as its coordinate.
void write_coordinate_names(const RecordGroup& group, Eigen::Index size);

}  // namespace swirl::apps
