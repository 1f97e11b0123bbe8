// Rows of a tracker's list that are not in the order of their times.
#pragma once

#include "apps/input/series_choice.hpp"

#include <memory>
#include <string>
#include <vector>

namespace swirl::apps {

/// The rows in the order of the first column that may name times or frames, as a tracker's list of spots has them. As
/// they are where the user says which times count, or a column is named t or time (its times must rise); where the
/// times rise, repeat, or go round again and again (a clock that wraps); and where several bodies have each their own.
///   notes  is added one if rows were moved
std::shared_ptr<const DelimitedFile> rows_in_order(std::shared_ptr<const DelimitedFile> file,
                                                   const SeriesChoice& choice, std::vector<std::string>& notes);

}  // namespace swirl::apps
