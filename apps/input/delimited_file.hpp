// Tables of numbers in text files, as spreadsheets, cameras and other programs write them.
//
// One row a line. Cells are separated by a tab, a semicolon, a comma or blanks: the first of these, in this order, that
// the first row has outside quotes. Lines that are empty or begin with # or % are skipped; line ends are LF or CR LF; a
// cell may stand in double quotes ("" inside is one quote); blanks around a cell don't count. The first row is a header
// when none of its cells is a number and one is a word (inf and 1e400 are numbers, if bad ones). All rows have as many
// cells as the first.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps {

/// The rows of a file as text, and where each came from.
struct DelimitedFile {
    struct Row {
        std::size_t line;  ///< number in the file, from 1
        std::string text;  ///< the whole line
    };
    std::string name;                 ///< as the user gave it; "-" is standard input
    char separator = ' ';             ///< '\t', ';', ',' or ' ' (any number of blanks)
    std::vector<std::string> header;  ///< empty: none
    std::size_t columns = 0;
    std::vector<Row> rows;  ///< without the header
};

/// Reads a file; "-" reads standard input.
/// @throws BadInput naming the file: it can't be opened or read, is a directory, or has no rows
DelimitedFile read_delimited(const std::string& name);

/// The cells of one line, trimmed and without their quotes.
std::vector<std::string> cells_of(const std::string& line, char separator);

/// The number of the column (from 0) that `wanted` names: a header's name, or a number from 1 on.
/// @throws BadInput naming the option and listing the columns
std::size_t column_of(const DelimitedFile& file, const std::string& option, const std::string& wanted);

/// The header's name of a column, or its number from 1 on.
std::string column_name(const DelimitedFile& file, std::size_t column);

/// The columns as numbers. A cell that is empty, nan or NA is NaN where `gaps` says so.
///   wanted   columns from 0 on;   gaps   one truth value each: may a cell be missing
/// @throws BadInput naming the file, the line, its text and what is allowed: a wrong number of cells, a cell that is no
/// finite number. O(bytes).
std::vector<std::vector<double>> numbers_of(const DelimitedFile& file, const std::vector<std::size_t>& wanted,
                                            const std::vector<bool>& gaps);

/// "series 'a.csv', line 7: WHAT; the line reads 'x,y'" for a BadInput.
std::string at_line(const DelimitedFile& file, std::size_t row, const std::string& what);

}  // namespace swirl::apps
