// One cell of a text file: what separates cells, which are numbers, gaps, times of the clock.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps {

std::string_view trimmed(std::string_view text);

/// A tab, a semicolon, a comma or blanks (' '): the first of these, in this order, that a line has outside quotes.
char separator_of(std::string_view line);

/// The cells of one line, trimmed and without their quotes.
std::vector<std::string> cells_of(std::string_view line, char separator);

/// The same of a line without quotes, as parts of it.
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Empty, or a word by which programs say that there is no value: nan, NA, null, inf (TRex, MATLAB), #N/A, …
bool is_missing(std::string_view cell);

/// A plain decimal, with the point or the comma that `decimal` is, beside which points part thousands; no hexadecimal,
/// infinity or nan.
std::optional<double> number_in(std::string_view cell, char decimal = '.');

/// A number as `0,25` or `-1,5E-3`, with one comma and no point.
bool has_decimal_comma(std::string_view cell);

/// Meant as a number, though perhaps none that can be used: inf, 1e400, 0x10.
bool looks_like_a_number(const std::string& cell);

/// A time of the clock.
struct ClockTime {
    std::int64_t seconds = 0;  ///< since 1970, or since midnight where there is no date
    double fraction = 0;       ///< of a second
};

/// ISO 8601: `2024-10-07T10:44:40.6138240+01:00` (T or a blank, any number of decimals, Z or an offset or neither), or
/// a time of day, `10:44:40.61`.
std::optional<ClockTime> clock_time_in(std::string_view cell);

/// A number, a gap or a time of the clock: what rows of measured values have, and headers have not.
bool is_value(std::string_view cell, char decimal);

}  // namespace swirl::apps
