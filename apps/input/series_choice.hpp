// Which columns of which file a measured series is made of, and how they are read, as the flags say it.
#pragma once

#include "apps/command_line/flags.hpp"
#include "apps/input/delimited_file.hpp"
#include "apps/input/series_of_motion.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// What the number of --swirl-rate counts.
enum class RateUnit {
    radians,          ///< per unit of the series' time
    turns_a_minute,   ///< "33rpm"
    turns_a_second,   ///< "0.5Hz"
    radians_a_second  ///< "3.1rad/s"
};

/// A text as a shell takes it for one word.
std::string in_one_word(const std::string& text);

/// Empty members: by the rules of read_series().
struct SeriesChoice {
    std::string file;
    std::string column;
    std::string time;
    double spacing = 1;         ///< of the samples where there is no time column, > 0
    std::optional<double> fps;  ///< frames a second: times are a column of frames, or the rows, over it

    std::string angle;      ///< a column of angles, whose rate is analysed; in place of `column`. The flag
                            ///< is the start's --angle (StartOptions::angle_text)
    bool degrees = false;   ///< it is in degrees, not radians
    int symmetry = 1;       ///< it is known modulo 1/symmetry of a turn
    double swirl_rate = 1;  ///< ω_s: S is in units of it; negative: clockwise
    RateUnit rate_unit = RateUnit::radians;
    std::vector<std::string> marks;     ///< two points of the body, x1 y1 x2 y2: the angle is that of their line
    std::vector<std::string> mark;      ///< one, x y: the angle is its direction from the origin
    std::vector<std::string> position;  ///< two columns x, y, whose distance from the origin is analysed

    std::vector<std::string> origin;   ///< x and y, of `position` and `mark`
    bool fits_origin = false;          ///< it is the centre of the circle fitted to the points
    double scale = 1;                  ///< lengths are multiplied by it
    bool y_down = false;               ///< y points down, as in images: the sense of turns is the other one
    bool shows_down = false;           ///< the motion itself shows where y points (bodies fall): no note says it
    std::optional<double> likelihood;  ///< a point that its tracker is less sure of is a gap

    std::vector<std::string> where;           ///< COLUMN=VALUE: the rows that are read
    std::string each;                         ///< a column: each of its values is a body of its own
    std::optional<std::int64_t> header_line;  ///< the line of the names
    bool decimal_comma = false;
    std::string rows;                         ///< impacts or samples; empty: by the times
    LongSteps long_steps = LongSteps::maybe;  ///< of `column`, unless `rows` says it; an angle and a position are
                                              ///< sampled: lost_rows

    std::shared_ptr<const DelimitedFile> table;  ///< the file, if it has been read

    /// Adds the flags. `spacing` is asked for where `with_spacing`.
    ///   file_flag  as CLI11 has it: "--series", or "FILE,--series" for a positional
    void add_to(Flags& command, bool with_spacing, const std::string& file_flag = "--series");
    /// True if anything but the file and --rows was given.
    bool given() const;
    /// "--fps 30 --y-down": what was given beside the file, to be given again.
    std::string flags() const;

    /// The text of --swirl-rate: a number, or one followed by rpm, Hz or rad/s. @throws BadInput
    void set_swirl_rate(const std::string& text);
    /// --swirl-rate says something: it is not the 1 that it is unless given.
    bool has_swirl_rate() const { return swirl_rate != 1 || rate_unit != RateUnit::radians; }
    /// An angle is analysed, not a column or a distance.
    bool is_angle() const { return !angle.empty() || !marks.empty() || !mark.empty(); }
    /// @throws BadInput for flags that don't go together, and numbers out of range
    void check() const;
    /// The file, read if it was not. @throws BadInput
    std::shared_ptr<const DelimitedFile> read() const;
};

}  // namespace swirl::apps
