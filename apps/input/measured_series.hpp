// A measured series: one column of a text file, with its times.
#pragma once

#include "apps/command_line/flags.hpp"
#include "apps/input/series_of_motion.hpp"

#include <cmath>
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

    std::string angle;                  ///< a column of angles, whose rate is analysed; in place of `column`. The flag
                                        ///< is the start's --angle (StartOptions::angle_text)
    bool degrees = false;               ///< it is in degrees, not radians
    int symmetry = 1;                   ///< it is known modulo 1/symmetry of a turn
    double swirl_rate = 1;              ///< ω_s in radians per unit of time: S is in units of it
    std::vector<std::string> position;  ///< two columns x, y, whose distance from (0, 0) is analysed

    LongSteps long_steps = LongSteps::maybe;  ///< of `column`; an angle and a position are sampled: lost_rows

    /// Adds the flags. `spacing` is asked for where `with_spacing`.
    void add_to(Flags& command, bool with_spacing);
    /// True if anything but the file was given.
    bool given() const { return !(column.empty() && time.empty() && position.empty()) || degrees || symmetry != 1; }
};

/// What the values of a series are.
inline constexpr const char* as_measured = "as measured";
inline constexpr const char* spin_of_angle = "S of an angle";
inline constexpr const char* distance_of_position = "distance of a position";

/// A turn of more than so much of half a period, from row to row, may have been one the other way.
inline constexpr double sure_turn = 0.9;

/// An angle as it was measured, with NaN for what is missing.
struct MeasuredAngle {
    std::vector<double> times, values;  ///< radians
    double period = 0;                  ///< that it is known modulo
    double resolution = 0;              ///< it is rounded to multiples of it (decimal_resolution); 0: it isn't
};

struct MeasuredSeries {
    std::string column;                  ///< its name, or its number from 1 on; of a position both, "x, y"
    std::string time;                    ///< of the column of times; empty: none
    std::vector<double> values;          ///< NaN: missing
    std::vector<double> times;           ///< rising
    std::size_t rows = 0;                ///< of the file
    std::size_t missing = 0;             ///< samples that are NaN, rows that were lost among them
    std::size_t gaps = 0;                ///< runs of them
    std::string quantity;                ///< one of the three below
    MeasuredAngle angle;                 ///< of an angle: its rows, one more than `values` has
    double swirl_rate = 1;               ///< of an angle: ω_s, in radians per unit of time
    double largest_turn = std::nan("");  ///< of an angle, see AngleRates
    bool even = true;                    ///< times lie on an even grid, see `largest_deviation`
    double spacing = 1;                  ///< mean distance of the times
    double largest_step = 1;             ///< between neighbouring rows
    /// The direction of every turn of an angle is known.
    bool is_unwrapped() const { return !(largest_turn > sure_turn); }
    /// Made of an angle or a position, and so a signal in time.
    bool is_motion() const { return quantity == spin_of_angle || quantity == distance_of_position; }
    double largest_deviation = 0;  ///< of a time from the even grid, in spacings; up to even_within counts as even
};

/// In spacings: 30 frames a second printed in whole milliseconds are up to 3 % off (half a millisecond of their own and
/// half of the ends'). At the Nyquist frequency 4 % is a phase of 0.13.
inline constexpr double even_within = 0.04;

/// Reads a series. The column of times is the one that `time` names ("none": there is none), by default the header's t
/// or time (a unit may follow: "time [s]"), or without a header the first of two or more. The values are the column
/// that `column` names, by default S or spin, or else the last that isn't the times. A missing value is kept as NaN.
/// Values are 0 or within a scene's bounds (10⁻⁷⁵ … 10⁷⁵), so that their fourth powers can be held; smaller ones are
/// allowed if at least one value is within them. Rows that were lost between even times are NaN
/// (fill_lost_rows). Of
/// `angle` the values are S, half-way between the rows (rates_of_angle). Of `position` they are the distance from the
/// origin of x and y, the swirl's centre in the laboratory or the container's in its own frame: either is a function of
/// the state that rotates with the swirl, as S is; it swings along every flight, in a steady mode, too.
/// @throws BadInput naming file, line, its text and what is allowed: see delimited_file.hpp; a missing, repeated or
/// falling time; a value or time that is too large, values that are all too small; fewer than two values
MeasuredSeries read_series(const SeriesChoice& choice);

/// `count` samples from number `first` on. @throws BadInput with fewer than two values among them
MeasuredSeries part_of(const MeasuredSeries& series, std::size_t first, std::size_t count);

/// "column S, 3600 rows, spacing 0.0333333, 1 gap (2 samples missing)", for tables.
std::string series_in_words(const MeasuredSeries& series);

}  // namespace swirl::apps
