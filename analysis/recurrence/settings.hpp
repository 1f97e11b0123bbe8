// Every convention in which recurrence packages differ, as a named option, and presets that reproduce the packages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::analysis::recurrence {

/// Distance of two points. In one dimension all three are |x_i - x_j|.
enum class Norm { euclidean, maximum, manhattan };

/// What RR is divided by: the pairs that the Theiler window leaves, or all pairs of the matrix.
enum class RatePairs { outside_window, all };

/// Diagonal lines of a symmetric matrix: counted in both triangles (each line twice) or in one.
enum class Triangles { both, one };

/// Lines that touch the border of the matrix, so that their true length is unknown.
enum class BorderLines { counted, discarded };

/// What a recurrence time is, between two consecutive vertical lines of one column:
///   midpoints    w + floor(v1/2) + floor(v2/2), w the white points between lines of v1 and v2 points
///   white_lines  w
///   line_starts  from the first point of a line to the first of the next (Gao & Cai's second type, T2)
enum class RecurrenceTime { midpoints, white_lines, line_starts };

enum class Logarithm { natural, binary, decimal };

/// What RTE is divided by: nothing, or the logarithm of the longest recurrence time.
enum class TimeEntropyScale { none, log_longest };

struct Settings {
    Norm norm = Norm::euclidean;
    bool strict = false;          ///< recurrent when distance < threshold, instead of <=
    std::optional<int> theiler;   ///< W >= 0: pairs with |i - j| < W are left out; empty: 1, or 0 if cross
    int min_diagonal = 2;         ///< shortest diagonal line in DET, L, ENTR; >= 1
    int min_vertical = 2;         ///< shortest vertical line in LAM, TT, VENTR; >= 1
    int min_recurrence_time = 1;  ///< shortest recurrence time in MRT, RTE; >= 1
    RatePairs rate_pairs = RatePairs::outside_window;
    bool window_on_rate = true;      ///< RR counts only the points outside the window
    bool window_on_vertical = true;  ///< vertical lines and recurrence times are taken after the window is applied
    bool determinism_of_all_points = false;  ///< DET is divided by all recurrence points, those in the window too
    bool longest_of_all_lines = false;       ///< Lmax and Vmax also look at lines shorter than the minimum
    Triangles triangles = Triangles::both;
    BorderLines border_lines = BorderLines::counted;
    bool border_white_lines = false;  ///< white lines that touch the border count (white_lines only)
    RecurrenceTime recurrence_time = RecurrenceTime::midpoints;
    Logarithm logarithm = Logarithm::natural;
    TimeEntropyScale time_entropy_scale = TimeEntropyScale::none;
    bool empty_is_zero = false;  ///< entropies and DIV without lines are 0 instead of NaN
    int trend_border = 10;       ///< TREND leaves out this many outermost diagonals; >= 0
};

/// Settings that reproduce a published package: "RecurrenceAnalysis.jl", "pyunicorn", "PyRQA", "CRP Toolbox"
/// (upper and lower case alike). Norm, minimal lengths, Theiler window and threshold stay the caller's: without one it
/// is 1, or 0 of a cross recurrence, whose main diagonal is a line like others. What each does: README.md. Throws
/// std::invalid_argument, listing the known names, for any other name.
Settings preset(std::string_view name);

/// The names that preset() knows.
std::vector<std::string> preset_names();

/// The Theiler window in force: settings.theiler, or its default (1 for one trajectory, 0 for a cross recurrence).
int theiler_window(const Settings& settings, bool cross);

/// Throws std::invalid_argument naming the option, its value and its range.
void validate(const Settings& settings);

}  // namespace swirl::analysis::recurrence
