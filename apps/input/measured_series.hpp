// A measured series: one column of a text file, with its times.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps {

/// Which columns of which file, as the flags say it. Empty: by the rules of read_series().
struct SeriesChoice {
    std::string file;
    std::string column;
    std::string time;
    double spacing = 1;  ///< of the samples where there is no time column, > 0
};

struct MeasuredSeries {
    std::string column;            ///< its name, or its number from 1 on
    std::string time;              ///< of the column of times; empty: none
    std::vector<double> values;    ///< NaN: missing
    std::vector<double> times;     ///< rising
    std::size_t missing = 0;       ///< samples that are NaN
    bool even = true;              ///< times lie on an even grid, see `largest_deviation`
    double spacing = 1;            ///< mean distance of the times
    double largest_step = 1;       ///< between neighbouring rows
    double largest_deviation = 0;  ///< of a time from the even grid, in spacings; up to even_within counts as even
};

/// In spacings: 30 frames a second printed in whole milliseconds are up to 3 % off (half a millisecond of their own and
/// half of the ends'). At the Nyquist frequency 4 % is a phase of 0.13.
inline constexpr double even_within = 0.04;

/// Reads a series. The column of times is the one that `time` names ("none": there is none), by default the header's t
/// or time (a unit may follow: "time [s]"), or without a header the first of two or more. The values are the column
/// that `column` names, by default S or spin, or else the last that isn't the times. A missing value is kept as NaN.
/// Values are 0 or within a scene's bounds (10⁻⁷⁵ … 10⁷⁵), so that their fourth powers can be held; smaller ones are
/// allowed if at least one value is within them.
/// @throws BadInput naming file, line, its text and what is allowed: see delimited_file.hpp; a missing, repeated or
/// falling time; a value or time that is too large, values that are all too small; fewer than two values
MeasuredSeries read_series(const SeriesChoice& choice);

/// `count` samples from number `first` on. @throws BadInput with fewer than two values among them
MeasuredSeries part_of(const MeasuredSeries& series, std::size_t first, std::size_t count);

}  // namespace swirl::apps
