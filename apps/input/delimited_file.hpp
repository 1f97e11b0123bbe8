// Tables of numbers in text files, as spreadsheets, cameras, trackers and other programs write them.
//
// One row a line. Line ends are LF, CR LF or CR. Cells are separated by a tab, a semicolon, a comma or blanks, which a
// line `sep=;` may say; blanks around a cell don't count; a cell may stand in double quotes ("" inside is one quote).
// Lines that are empty (in a table of one column they are gaps) or begin with # or % are skipped. Which rows are header
// and preamble: table_layout.hpp. All rows have as many cells. What is no UTF-8 becomes U+FFFD.
#pragma once

#include "apps/input/table_layout.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps {

/// The rows of a file as text, and where each came from.
struct DelimitedFile {
    std::string name;             ///< as the user gave it; "-" is standard input
    std::string what = "series";  ///< for messages
    TableLayout layout;
    char separator = ' ';             ///< the layout's
    std::vector<std::string> header;  ///< the layout's; empty: none
    std::size_t columns = 0;
    std::shared_ptr<const std::string> content;
    std::vector<TextRow> rows;  ///< without the header; of the content

    /// @throws BadInput naming the line: too few or too many cells
    std::vector<std::string> cells(std::size_t row) const;
};

/// The cells of row after row: without a copy where no quotes and no commas in pairs need one.
class CellReader {
public:
    explicit CellReader(const DelimitedFile& file) : file_(file) {}

    /// Until the next call. @throws BadInput naming the line: too few or too many cells
    const std::vector<std::string_view>& at(std::size_t row);

private:
    const DelimitedFile& file_;
    std::vector<std::string_view> cells_;
    std::vector<std::string> copies_;
};

/// Reads a file; "-" reads standard input.
/// @throws BadInput naming the file: it can't be opened or read, is a directory, is UTF-16, or has no rows
DelimitedFile read_delimited(const std::string& name, const LayoutChoice& choice = {});

/// The number of the column (from 0) that `wanted` names: a header's name, a number from 1 on, or a name that differs
/// from just one of the header's in case, in the signs between words, by its unit ("angle (rad)") or its group
/// ("tip.x").
/// @throws BadInput naming the option and listing the columns
std::size_t column_of(const DelimitedFile& file, const std::string& option, const std::string& wanted);

/// The header's name of a column, or its number from 1 on.
std::string column_name(const DelimitedFile& file, std::size_t column);

/// The columns as numbers. A cell that is a gap (cells.hpp) is NaN where `gaps` says so.
///   wanted   columns from 0 on;   gaps   one truth value each: may a cell be missing
/// @throws BadInput naming the file, the line, its text and what is allowed: a wrong number of cells, a cell that is no
/// finite number. O(bytes).
std::vector<std::vector<double>> numbers_of(const DelimitedFile& file, const std::vector<std::size_t>& wanted,
                                            const std::vector<bool>& gaps);

/// A column of times: numbers, or times of the clock (cells.hpp), which become seconds after the first.
struct ReadTimes {
    std::vector<double> values;
    bool of_clock = false;
};
ReadTimes times_of(const DelimitedFile& file, std::size_t column);

/// "series 'a.csv', line 7: WHAT; the line reads 'x,y'" for a BadInput.
std::string at_line(const DelimitedFile& file, std::size_t row, const std::string& what);

}  // namespace swirl::apps
