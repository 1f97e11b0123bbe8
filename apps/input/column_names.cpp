#include "apps/input/column_names.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace swirl::apps {

namespace {

enum class Letters { none, letter, digit };

Letters letters_of(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isdigit(byte) != 0) return Letters::digit;
    return std::isalpha(byte) != 0 || byte >= 0x80 ? Letters::letter : Letters::none;
}

struct Word {
    std::string lower;
    std::size_t begin = 0;  ///< in the name
};

/// Runs of letters and runs of digits, without the unit in brackets: "X_Arena0" is x, arena, 0; "imageNumber" is image,
/// number; "poseX1" is pose, x, 1.
std::vector<Word> words_of(const std::string& name) {
    const std::string unit = unit_in_name(name);
    const bool bracketed = !name.empty() && !unit.empty() && (name.back() == ')' || name.back() == ']');
    const std::size_t size = bracketed ? name.size() - unit.size() - 2 : name.size();
    std::vector<Word> words;
    Letters before = Letters::none;
    bool lower_before = false;
    for (std::size_t i = 0; i < size; ++i) {
        const Letters kind = letters_of(name[i]);
        const auto byte = static_cast<unsigned char>(name[i]);
        const bool is_capital = std::isupper(byte) != 0;
        if (kind != Letters::none) {
            if (kind != before || (is_capital && lower_before)) words.push_back({"", i});
            words.back().lower += static_cast<char>(std::tolower(byte));
        }
        before = kind;
        lower_before = std::islower(byte) != 0;
    }
    return words;
}

template <std::size_t N>
bool any_word(const std::string& name, const std::array<const char*, N>& any_of) {
    const auto words = words_of(name);
    return std::any_of(words.begin(), words.end(), [&](const Word& word) {
        return std::find(any_of.begin(), any_of.end(), word.lower) != any_of.end();
    });
}

/// The words of a name, side by side.
std::string joined_words(const std::string& name) {
    std::string joined;
    for (const Word& word : words_of(name)) joined += word.lower;
    return joined;
}

template <std::size_t N>
bool is_one_of(const std::string& text, const std::array<const char*, N>& any_of) {
    return std::find(any_of.begin(), any_of.end(), text) != any_of.end();
}

template <std::size_t N>
std::optional<double> factor_of(const std::array<std::pair<const char*, double>, N>& units, const std::string& unit) {
    const auto found = std::find_if(units.begin(), units.end(), [&](const auto& entry) { return unit == entry.first; });
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

/// The likelihood of a point whose columns begin so ("tip."), or the only one that there is.
std::optional<std::size_t> likelihood_of(const DelimitedFile& file, const std::string& begin) {
    std::optional<std::size_t> last;
    std::size_t count = 0;
    for (std::size_t k = 0; k < file.header.size(); ++k) {
        if (!names_likelihood(file.header[k])) continue;
        if (!begin.empty() && file.header[k].rfind(begin, 0) == 0) return k;
        ++count;
        last = k;
    }
    return count == 1 ? last : std::nullopt;
}

}  // namespace

std::string unit_of_column(const DelimitedFile& file, std::size_t column) {
    std::string unit = file.layout.units.empty() ? "" : file.layout.units[column];
    for (const char bracket : {'(', ')', '[', ']'})
        unit.erase(std::remove(unit.begin(), unit.end(), bracket), unit.end());
    return unit;
}

bool names_time(const std::string& name) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const std::string word : {"time", "t"})
        if (lower.rfind(word, 0) == 0 &&
            (lower.size() == word.size() || std::isalnum(static_cast<unsigned char>(lower[word.size()])) == 0))
            return true;
    return false;
}

bool may_name_time(const std::string& name) {
    static constexpr std::array whole = {"seconds",    "sec",      "secs",  "milliseconds", "timestamp",
                                         "timestamps", "datetime", "date",  "age",          "ages",
                                         "elapsed",    "clock",    "timems"};
    static constexpr std::array last = {"t", "time", "timestamp", "seconds", "sec", "msec"};
    if (is_one_of(joined_words(name), whole)) return true;
    const auto words = words_of(name);
    return words.size() > 1 && is_one_of(words.back().lower, last);
}

bool names_frame(const std::string& name) {
    static constexpr std::array whole = {"frame",       "frames",     "frameidx",       "frameid",           "frameno",
                                         "framenumber", "frameindex", "framen",         "imagenumber",       "fnum",
                                         "slice",       "slicen",     "slicen\xC2\xB0", "slicen\xEF\xBF\xBD"};
    return is_one_of(joined_words(name), whole);
}

bool names_spin(const std::string& name) {
    return name == "S" || name == "spin";
}

bool names_body(const std::string& name) {
    static constexpr std::array whole = {
        "particle",    "particleid", "track", "trackid",    "trackn",      "trackn\xC2\xB0", "trackn\xEF\xBF\xBD",
        "tracknumber", "tid",        "id",    "individual", "individuals", "individualid",   "identity",
        "animal",      "animalid",   "fish",  "fishid",     "body",        "bodyid",         "object",
        "objectid",    "instance",   "mouse", "arena",      "roi",         "target",         "blobid"};
    return is_one_of(joined_words(name), whole);
}

bool names_angle(const std::string& name) {
    static constexpr std::array words = {"theta", "\xCE\xB8", "angle",    "orientation", "heading",
                                         "th",    "phi",      "\xCF\x86", "yaw",         "rotation"};
    static constexpr std::array no_angle = {"speed", "velocity", "acceleration", "v",    "a",
                                            "omega", "rate",     "std",          "error"};
    return any_word(name, words) && !any_word(name, no_angle);
}

bool names_degrees(const std::string& unit) {
    return unit.find("deg") != std::string::npos || unit.find("\xC2\xB0") != std::string::npos;
}

std::optional<double> radians_in(const std::string& unit) {
    constexpr double turn = 2 * std::numbers::pi;
    static constexpr std::array<std::pair<const char*, double>, 15> units = {{{"rad", 1},
                                                                              {"radian", 1},
                                                                              {"radians", 1},
                                                                              {"mrad", 1e-3},
                                                                              {"deg", turn / 360},
                                                                              {"degree", turn / 360},
                                                                              {"degrees", turn / 360},
                                                                              {"\xC2\xB0", turn / 360},
                                                                              {"turn", turn},
                                                                              {"turns", turn},
                                                                              {"rev", turn},
                                                                              {"revs", turn},
                                                                              {"gon", turn / 400},
                                                                              {"grad", turn / 400},
                                                                              {"cycles", turn}}};
    return factor_of(units, unit);
}

std::optional<double> turning_rate_in(const std::string& unit) {
    static constexpr std::array angles = {"rad", "radians", "deg", "degrees", "\xC2\xB0", "rev", "turns"};
    static constexpr std::array per_second = {"s", "sec", "second", "s1", "pers", "persec", "persecond"};
    const auto words = words_of(unit);
    if (words.empty()) return std::nullopt;
    if (words.size() == 1 && words[0].lower == "rpm") return 2 * std::numbers::pi / 60;
    std::string per;
    for (std::size_t k = 1; k < words.size(); ++k) per += words[k].lower;
    const std::string& angle = words[0].lower;
    if (angle == "rev" && (per == "min" || per == "permin")) return 2 * std::numbers::pi / 60;
    return is_one_of(angle, angles) && is_one_of(per, per_second) ? radians_in(angle) : std::nullopt;
}

std::optional<double> turning_rate_of(const DelimitedFile& file, std::size_t column) {
    if (const auto rate = turning_rate_in(unit_of_column(file, column))) return rate;
    if (file.header.empty()) return std::nullopt;
    constexpr std::size_t longest = 3;  // words: "rad per s"
    const auto words = words_of(file.header[column]);
    for (std::size_t k = words.size(); k > 0 && k + longest > words.size(); --k) {
        std::string end = words[k - 1].lower;
        for (std::size_t next = k; next < words.size(); ++next) end.append(" ").append(words[next].lower);
        if (const auto rate = turning_rate_in(end)) return rate;
    }
    return std::nullopt;
}

bool names_likelihood(const std::string& name) {
    static constexpr std::array words = {"likelihood", "confidence", "score", "probability", "visibility"};
    return any_word(name, words);
}

bool names_no_value(const std::string& name) {
    static constexpr std::array words = {"quality", "error", "err", "std", "sd", "sem", "sigma", "uncertainty"};
    static constexpr std::array whole = {"row",       "index",    "label", "missing",
                                         "timestamp", "unnamed0", "nr",    "framecounter"};
    return names_frame(name) || names_body(name) || names_likelihood(name) || any_word(name, words) ||
           is_one_of(joined_words(name), whole);
}

std::vector<PointColumns> points_in(const DelimitedFile& file) {
    static constexpr std::array other = {"bbox", "min",    "max",      "err",    "error", "std",
                                         "var",  "vel",    "velocity", "speed",  "acc",   "ens",
                                         "size", "offset", "midline",  "region", "width"};
    static constexpr std::array rates = {"v", "a"};  // but "Xpos_A" is a place
    std::vector<PointColumns> points;
    for (std::size_t k = 0; k < file.header.size(); ++k) {
        const std::string& name = file.header[k];
        const auto words = words_of(name);
        const auto is_x = [](const Word& word) { return word.lower == "x" || word.lower == "xpos"; };
        const auto x = std::find_if(words.begin(), words.end(), is_x);
        if (x == words.end() || std::count_if(words.begin(), words.end(), is_x) > 1 || any_word(name, other)) continue;
        if (x->lower == "x" && any_word(name, rates)) continue;
        std::string partner = name, shared;
        partner[x->begin] = name[x->begin] == 'x' ? 'y' : 'Y';
        const auto y = std::find(file.header.begin(), file.header.end(), partner);
        if (y == file.header.end()) continue;
        for (const Word& word : words)
            if (!is_x(word)) shared += (shared.empty() ? "" : ".") + word.lower;
        points.push_back({shared, k, static_cast<std::size_t>(y - file.header.begin()),
                          likelihood_of(file, name.substr(0, x->begin))});
    }
    return points;
}

std::optional<double> seconds_in(const std::string& unit) {
    static constexpr std::array<std::pair<const char*, double>, 21> units = {
        {{"s", 1},       {"ns", 1e-9},           {"nanoseconds", 1e-9}, {"microseconds", 1e-6},
         {"usec", 1e-6}, {"millis", 1e-3},       {"minute", 60},        {"sec", 1},
         {"secs", 1},    {"second", 1},          {"seconds", 1},        {"ms", 1e-3},
         {"msec", 1e-3}, {"milliseconds", 1e-3}, {"us", 1e-6},          {"µs", 1e-6},
         {"min", 60},    {"minutes", 60},        {"h", 3600},           {"hr", 3600},
         {"hours", 3600}}};
    return factor_of(units, unit);
}

namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t most_rows = 6;  // of names

template <std::size_t N>
bool is_among(const std::array<const char*, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_unit(const std::string& cell) {
    static constexpr std::array units = {"s",   "sec", "ms", "us",    "µs",    "min",    "h",    "m",     "mm",
                                         "cm",  "um",  "µm", "px",    "pixel", "pixels", "deg",  "°",     "degrees",
                                         "rad", "rpm", "Hz", "rad/s", "deg/s", "m/s",    "mm/s", "frame", "frames"};
    if (is_among(units, cell)) return true;
    return cell.size() > 1 &&
           ((cell.front() == '(' && cell.back() == ')') || (cell.front() == '[' && cell.back() == ']'));
}

bool are_units(const Cells& cells) {
    bool any = false;
    for (const auto& cell : cells) {
        if (!cell.empty() && !is_unit(cell)) return false;
        any = any || !cell.empty();
    }
    return any;
}

/// The rows of names directly above the first row of numbers, from above.
std::vector<Cells> rows_of_names(const std::vector<TextRow>& lines, const TableLayout& layout) {
    std::vector<Cells> rows;
    for (std::size_t i = layout.first_row; i > 0 && rows.size() < most_rows; --i) {
        Cells cells = cells_of(lines[i - 1].text, layout.separator);
        if (!is_header(cells) && !begins_pose_row(cells)) break;
        if ((layout.columns > 1 && cells.size() < 2) || cells.size() > layout.columns + 1) break;
        rows.insert(rows.begin(), std::move(cells));
    }
    return rows;
}

/// "tip.x" of bodyparts and coords; the scorer is the same everywhere, and one individual's name says nothing.
Cells pose_names(const std::vector<Cells>& rows, std::size_t columns) {
    Cells names{"frame"};
    for (std::size_t k = 1; k < columns; ++k) {
        std::string name;
        for (const Cells& row : rows) {
            if (k >= row.size() || row.front() == "scorer") continue;
            const bool same = std::all_of(row.begin() + 1, row.end(), [&](const auto& cell) { return cell == row[1]; });
            if (row.front() == "individuals" && same) continue;
            name += (name.empty() ? "" : ".") + row[k];
        }
        names.push_back(name);
    }
    return names;
}

/// An upper row names groups of columns where it, or the row below it, begins with an empty cell.
bool names_groups(const Cells& upper, const Cells& lower) {
    const bool has_empty = std::any_of(upper.begin() + 1, upper.end(), [](const auto& cell) { return cell.empty(); });
    return (upper.front().empty() || lower.front().empty()) && (has_empty || upper.size() < lower.size());
}

Cells group_names(const Cells& upper, const Cells& lower, std::size_t columns) {
    const auto cell = [](const Cells& cells, std::size_t k) { return k < cells.size() ? cells[k] : std::string(); };
    Cells groups;
    std::set<std::string> different;
    for (std::size_t k = 0; k < columns; ++k) {
        const std::string group = cell(upper, k);
        groups.push_back(group.empty() && k > 0 ? groups.back() : group);
        if (!groups.back().empty() && !cell(lower, k).empty()) different.insert(groups.back());
    }
    Cells names;
    for (std::size_t k = 0; k < columns; ++k) {
        const std::string name = cell(lower, k);
        const bool plain = groups[k].empty() || different.size() < 2;
        names.push_back(name.empty() ? cell(upper, k) : plain ? name : groups[k] + "." + name);
    }
    return names;
}

/// The names, and how many of the rows hold them, from below.
std::pair<Cells, std::size_t> names_in(const std::vector<Cells>& rows, std::size_t columns) {
    const std::size_t n = rows.size();
    std::size_t pose = 0;
    while (pose < n && begins_pose_row(rows[n - 1 - pose])) ++pose;
    if (pose > 0) return {pose_names({rows.end() - static_cast<std::ptrdiff_t>(pose), rows.end()}, columns), pose};
    if (n >= 3 && rows[n - 1] == rows[n - 2] && rows[n - 3].size() == rows[n - 1].size()) return {rows[n - 3], 3};
    if (n >= 2 && names_groups(rows[n - 2], rows[n - 1])) return {group_names(rows[n - 2], rows[n - 1], columns), 2};
    return {rows[n - 1], 1};
}

bool last_cells_are_empty(const std::vector<TextRow>& lines, const TableLayout& layout) {
    for (std::size_t i = layout.first_row; i < std::min(lines.size(), layout.first_row + lines_looked_at); ++i) {
        const Cells cells = cells_of(lines[i].text, layout.separator);
        if (cells.size() != layout.columns || !cells.back().empty()) return false;
    }
    return true;
}

}  // namespace

bool begins_pose_row(const Cells& cells) {
    static constexpr std::array names = {"scorer", "individuals", "bodyparts", "coords"};
    return is_among(names, cells.front());
}

bool is_header(const Cells& cells) {
    bool word = false;
    for (const auto& cell : cells) {
        if (number_in(cell) || has_decimal_comma(cell)) return false;
        word = word || !(is_missing(cell) || looks_like_a_number(cell) || clock_time_in(cell));
    }
    return word;
}

void take_header(const std::vector<TextRow>& lines, TableLayout& layout) {
    std::vector<Cells> rows = rows_of_names(lines, layout);
    const std::size_t seen = rows.size();
    if (rows.size() > 1 && are_units(rows.back())) {
        layout.units = std::move(rows.back());
        rows.pop_back();
    }
    const bool has_units = rows.size() < seen;
    std::size_t used = 0;
    if (!rows.empty()) std::tie(layout.header, used) = names_in(rows, layout.columns);
    const std::size_t above = layout.first_row - used - (has_units ? 1 : 0);
    if (above == 0) return;
    const std::size_t last = lines[above - 1].line;
    layout.notes.push_back(last == 1 ? "line 1 is above the table and is not read"
                                     : fmt::format("lines 1 to {} are above the table and are not read", last));
}

void fit_header(const std::string& file, const std::vector<TextRow>& lines, TableLayout& layout) {
    const std::size_t names = layout.header.size();
    if (names == layout.columns + 1 && layout.header.back().empty()) {
        layout.header.pop_back();
    } else if (names + 1 == layout.columns && last_cells_are_empty(lines, layout)) {
        layout.columns = names;
        layout.ends_in_separator = true;
    } else if (names + 1 == layout.columns) {
        layout.header.insert(layout.header.begin(), "row");
        if (!layout.units.empty()) layout.units.insert(layout.units.begin(), "");
        layout.notes.emplace_back("the header has a name less than rows have cells: the first cells name the rows");
    } else {
        const TextRow& row = lines[layout.first_row];
        throw BadInput(fmt::format("{}, line {}: {} cells, where {} are needed; the line reads '{}'", file, row.line,
                                   layout.columns, names, printable(row.text.substr(0, 100))));
    }
}

void drop_empty_column(const std::vector<TextRow>& lines, TableLayout& layout) {
    if (layout.columns < 2 || layout.separator == ' ' || layout.comma_in_pairs || layout.ends_in_separator) return;
    if (!layout.header.empty() && !layout.header.back().empty()) return;
    if (!last_cells_are_empty(lines, layout)) return;
    --layout.columns;
    layout.ends_in_separator = true;
    if (!layout.header.empty()) layout.header.pop_back();
}

std::string unit_in_name(const std::string& name) {
    for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')})
        if (const std::size_t begin = name.rfind(open);
            !name.empty() && name.back() == close && begin != std::string::npos)
            return name.substr(begin + 1, name.size() - begin - 2);
    const std::size_t underscore = name.rfind('_');
    static constexpr std::array units = {"s", "sec", "ms", "us", "min", "px", "mm", "cm", "deg", "rad"};
    if (underscore == std::string::npos || !is_among(units, std::string_view(name).substr(underscore + 1))) return "";
    return name.substr(underscore + 1);
}

}  // namespace swirl::apps
