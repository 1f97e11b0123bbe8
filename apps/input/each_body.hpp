// One answer for each of the bodies that a file holds.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/input/series_choice.hpp"

#include <functional>

namespace swirl::apps {

/// Runs a command for each value of the column --each, as if --where had named it; the file is read once. In JSON the
/// documents are the list `bodies` of one; a body that is refused (too few rows) has {series {body}, refused} there.
///   scene, start  whose --swirl-rate and --angle are flags of the series, too
/// @return the largest of the exit codes
/// @throws BadInput with -o, which holds one body, and if all are refused
int for_each_body(SeriesChoice& series, const SceneOptions& scene, const StartOptions& start,
                  const OutputOptions& output, const std::function<int()>& run);

}  // namespace swirl::apps
