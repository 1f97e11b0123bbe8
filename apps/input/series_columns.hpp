// The columns of a file that a series is made of: those that the user names, or those that their names and values tell.
#pragma once

#include "apps/input/column_names.hpp"
#include "apps/input/series_choice.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

struct SeriesColumns {
    std::optional<std::size_t> time;  ///< none: rows are counted
    std::vector<double> times;        ///< of the rows, as the file has them (clock times in seconds), or counted
    bool in_frames = false;           ///< they count frames
    std::optional<double> seconds;    ///< of a unit of the times; nothing: unknown, of frames
    std::vector<std::size_t> values;  ///< one, or x and y, or x1, y1, x2, y2
    std::vector<std::string> notes;   ///< what was decided where the user said nothing
};

/// The column of times is the one that --time names ("none": there is none); else the first whose name is t or time (a
/// unit may follow); without a header the first of two or more; else the first column that rises (or rises for each
/// body) of those that may name times ("seconds", "Age [yr]"), then of those that name frames. If another column rises,
/// a note says that it was not used.
///
/// The values are --column, --angle, --marks, --mark or --position; else S or spin, else the last column that is
/// neither times nor what is no value (frames, identities, errors, words), with a note if there were others.
///
/// @throws BadInput for several bodies (bodies.hpp), a missing time, no such column
SeriesColumns columns_of(const DelimitedFile& file, const SeriesChoice& choice);

/// Times and what belongs to them, without values, of one body or of several.
SeriesColumns time_columns_of(const DelimitedFile& file, const SeriesChoice& choice);

/// A column of numbers without gaps, or of times of the clock.
bool has_only_times(const DelimitedFile& file, std::size_t column);

/// The columns whose values rise from row to row, of those that are numbers. O(cells), less where few rise.
std::vector<std::size_t> rising_columns(const DelimitedFile& file);

}  // namespace swirl::apps
