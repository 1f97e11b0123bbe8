// Several bodies in one file: which column tells them apart, and the rows of one.
#pragma once

#include "apps/input/delimited_file.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

struct Bodies {
    std::optional<std::size_t> column;  ///< that tells them apart; none: there is one body
    std::vector<std::string> ids;       ///< the column's values, in the order of the rows
};

/// A column tells bodies apart if it has two values or more, each in two rows or more, and the times of each value's
/// rows rise. It is the first column of such a name ("particle", "TRACK_ID"), also where times rise over all rows; or,
/// where times repeat or fall, the first column that does it. Rows without a value belong to no body. O(cells) of the
/// columns that are tried.
///   time, times  the column of times and its values; none: only names tell
Bodies bodies_in(const DelimitedFile& file, std::optional<std::size_t> time, const std::vector<double>& times);

/// Each value is larger than the one before.
bool rises(const std::vector<double>& values);

/// The different values of a column, in the order of the rows; no empty ones.
std::vector<std::string> values_of(const DelimitedFile& file, std::size_t column);

/// "COLUMN=VALUE" of --where.
struct Condition {
    std::size_t column = 0;
    std::string value;
};
/// @throws BadInput for a text without =, or no such column
Condition condition_from(const DelimitedFile& file, const std::string& text);

/// Leaves the rows in which the column has the value, as a text or as a number. @throws BadInput if there are none,
/// with the values that there are
void keep_rows(DelimitedFile& file, const Condition& condition);

/// "0, 1, 2 and 37 others".
std::string listed(const std::vector<std::string>& values);

/// Refuses a file of several bodies, with their ids and the flags that take one or all. @throws BadInput
void require_one_body(const DelimitedFile& file, const Bodies& bodies);

}  // namespace swirl::apps
