// What a file is taken for, what would be analysed of it, and by which command.
#pragma once

#include "apps/input/bodies.hpp"
#include "apps/input/column_names.hpp"
#include "apps/input/measured_series.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::inspect {

struct Inspection {
    std::shared_ptr<const DelimitedFile> file;
    std::vector<std::string> columns;  ///< names, or numbers from 1 on
    std::string time;                  ///< the column of times; empty: none
    bool in_frames = false;
    Bodies bodies;
    std::vector<PointColumns> points;
    std::optional<MeasuredSeries> series;  ///< what would be analysed, of several bodies the first; none: `problem`
    std::string problem;                   ///< why nothing can be analysed
    std::string command;                   ///< that analyses it
    std::vector<std::string> notes;
};

/// Chooses, where the flags say nothing, in this order: S; the line of two points that keep their distance (to a
/// twentieth: marks on one body); an angle, in degrees if it spans more than a turn in radians does; the distance of a
/// point, from the centre of the circle fitted if (0, 0) is not among its positions; any other column.
///   swirl_rate  the text of --swirl-rate, or empty
/// @throws BadInput for a file that can't be read as a table
Inspection inspection_of(SeriesChoice choice, const std::string& swirl_rate);

}  // namespace swirl::apps::inspect
