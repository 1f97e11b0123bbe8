// The rows of names above a table's numbers, made into one name a column.
#pragma once

#include "apps/input/table_layout.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

/// No cell is a number, and one is a word (inf and 1e400 are numbers, if bad ones).
bool is_header(const std::vector<std::string>& cells);

/// The first cell names a row of DeepLabCut's header (scorer, individuals, bodyparts, coords); others may be numbers.
bool begins_pose_row(const std::vector<std::string>& cells);

/// Names and units of the columns from the rows above lines[layout.first_row] (table_layout.hpp says which forms); what
/// stands above these is a preamble, of which a note is made.
void take_header(const std::vector<TextRow>& lines, TableLayout& layout);

/// A header that has a name less or more than rows have cells: an empty name too much, an empty cell at the end of each
/// row, or row names before them. @throws BadInput where it is none of these
void fit_header(const std::string& file, const std::vector<TextRow>& lines, TableLayout& layout);

/// A last column without a name and without a value is none: rows end in a separator.
void drop_empty_column(const std::vector<TextRow>& lines, TableLayout& layout);

}  // namespace swirl::apps
