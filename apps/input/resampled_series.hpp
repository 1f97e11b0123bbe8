// --resample: a measured series on even times of a spacing that was given.
#pragma once

#include "analysis/spectrum/resample.hpp"
#include "apps/command_line/documents.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

/// Straight lines, with a low-pass where the grid is not the samples' own (resample.hpp); what was done is put into
/// `done`. @throws BadInput for a spacing that is not positive
analysis::Resampled resampled(const std::string& spacing, const std::vector<double>& times,
                              const std::vector<double>& values, Settings& done);

/// "resampled by straight lines to a spacing of …".
std::string resampling_in_words(const analysis::Resampled& series);

}  // namespace swirl::apps
