// How a table lies in a text file: preamble, header rows, a row of units, separator, decimal comma.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps {

/// So many lines tell how a table lies.
inline constexpr std::size_t lines_looked_at = 400;

/// A line of a file, whose content lives elsewhere.
struct TextRow {
    std::size_t line = 0;  ///< number in the file, from 1
    std::string_view text;
};

/// What the user says of a file's form, in place of what is found.
struct LayoutChoice {
    std::optional<std::size_t> header_line;  ///< number of the line with the names
    bool decimal_comma = false;
    std::string what = "series";  ///< the file is, for messages: "series 'a.csv', line 7: …"
};

struct TableLayout {
    char separator = ' ';
    char decimal = '.';
    std::vector<std::string> header;  ///< empty: none
    std::vector<std::string> units;   ///< one a column, from a row of units or a name's brackets; empty: none
    std::size_t columns = 0;
    std::size_t first_row = 0;       ///< of the lines, the first of numbers
    bool ends_in_separator = false;  ///< rows have an empty cell more, which is none
    bool comma_in_pairs = false;     ///< comma is separator and decimal sign: two cells make a number
    std::vector<std::string> notes;  ///< what was decided, for people
};

/// The first line is a header if none of its cells is a number and one is a word, and the lines below have as many
/// cells. Where that does not fit, the rows are the longest run at the end of what is looked at (400 lines) with equal
/// numbers of cells and numbers among them; above it stand, from below: a row of units; rows of names: one, or
/// DeepLabCut's (scorer, individuals, bodyparts, coords), or two of which the upper names groups of columns (Tracker,
/// .trc), or three of which two are equal (TrackMate: the first holds the names); and a preamble, each line of which
/// has a word. A header that is one name short has row names before it (R); an empty name too much is none.
///   lines  without blank lines and comments;   separator  that a line `sep=;` gave, else 0
///   file  begins each message: "series 'a.csv'"
/// @throws BadInput where commas may be separators or decimal signs
TableLayout layout_of(const std::string& file, const std::vector<TextRow>& lines, const LayoutChoice& choice,
                      char separator);

/// The cells of a row by a layout.
std::vector<std::string> cells_in(std::string_view line, const TableLayout& layout);

/// The unit that stands in a name's brackets or after its last underscore ("Time (ms)", "t [s]", "t_ms"), or "".
std::string unit_in_name(const std::string& name);

}  // namespace swirl::apps
