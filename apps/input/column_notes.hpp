// What the name, the unit and the values of a column say against how it is read.
#pragma once

#include "apps/input/measured_series.hpp"

#include <cstddef>
#include <vector>

namespace swirl::apps {

/// Sets the unit of an angle (series.angle_unit): degrees by the flag, else the one that the column names, radians
/// where it names none or degrees. Notes: a unit or values of an angle that speak for another unit, a symmetry, a fold;
/// of a column that it is no S as it stands. O(values).
///   column, values  the first that is analysed, as the file has it
void note_column(const DelimitedFile& file, const SeriesChoice& choice, std::size_t column,
                 const std::vector<double>& values, MeasuredSeries& series);

}  // namespace swirl::apps
