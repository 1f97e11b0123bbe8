#include "apps/input/cells.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace swirl::apps {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// So many digits at the beginning of `text`, which is shortened by them.
std::optional<int> digits_of(std::string_view& text, std::size_t count) {
    int value = 0;
    if (text.size() < count) return std::nullopt;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + count, value);
    if (error != std::errc() || stop != text.data() + count || value < 0) return std::nullopt;
    text.remove_prefix(count);
    return value;
}

bool skip(std::string_view& text, std::string_view any_of) {
    if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/// Days since 1970-01-01.
std::optional<std::int64_t> days_in(std::string_view& text) {
    const auto year = digits_of(text, 4);
    if (!year || !skip(text, "-/")) return std::nullopt;
    const auto month = digits_of(text, 2);
    if (!month || !skip(text, "-/")) return std::nullopt;
    const auto day = digits_of(text, 2);
    if (!day) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year{*year}, std::chrono::month{static_cast<unsigned>(*month)},
                                           std::chrono::day{static_cast<unsigned>(*day)}};
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_days(date).time_since_epoch().count();
}

constexpr std::string_view minus_sign = "\xE2\x88\x92";  // U+2212, of spreadsheets

/// Beside decimal commas points part thousands: 1.234.567,5.
bool has_thousands(std::string_view cell) {
    if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
    const std::string_view whole = cell.substr(0, cell.find(','));
    const auto are_digits = [](std::string_view text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (whole.size() < cell.size() && !are_digits(cell.substr(whole.size() + 1))) return false;
    const std::size_t first = std::min(whole.find('.'), whole.size());
    if (first > 3 || !are_digits(whole.substr(0, first)) || whole.front() == '0') return false;
    for (std::size_t point = first; point < whole.size(); point += 4)
        if (whole[point] != '.' || whole.size() < point + 4 || !are_digits(whole.substr(point + 1, 3))) return false;
    return true;
}

/// "+01:00", "-0530", "Z" or nothing, in seconds.
std::optional<std::int64_t> offset_in(std::string_view text) {
    if (text.empty() || text == "Z" || text == "z") return 0;
    const int sign = text.front() == '-' ? -1 : 1;
    if (!skip(text, "+-")) return std::nullopt;
    const auto hours = digits_of(text, 2);
    skip(text, ":");
    const auto minutes = text.empty() ? std::optional(0) : digits_of(text, 2);
    if (!hours || !minutes || !text.empty()) return std::nullopt;
    return sign * (3600 * *hours + 60 * *minutes);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

char separator_of(std::string_view line) {
    bool quoted = false;
    bool tab = false, semicolon = false, comma = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        tab = tab || c == '\t';
        semicolon = semicolon || c == ';';
        comma = comma || c == ',';
    }
    return tab ? '\t' : semicolon ? ';' : comma ? ',' : ' ';
}

void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    const std::string_view text = separator == '\t' ? line : trimmed(line);
    for (std::size_t begin = 0;;) {
        std::size_t end = separator == ' ' ? begin : std::min(text.find(separator, begin), text.size());
        while (end < text.size() && separator == ' ' && !is_blank(text[end])) ++end;
        cells.push_back(trimmed(text.substr(begin, end - begin)));
        if (end == text.size()) return;
        begin = end + 1;
        if (separator == ' ')
            while (begin < text.size() && is_blank(text[begin])) ++begin;
    }
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
    if (line.find('"') == std::string_view::npos) {
        std::vector<std::string_view> parts;
        split_cells(line, separator, parts);
        return {parts.begin(), parts.end()};
    }
    std::vector<std::string> cells;
    const std::string_view text = separator == '\t' ? line : trimmed(line);
    std::size_t i = 0;
    const auto at_separator = [&] { return separator == ' ' ? is_blank(text[i]) : text[i] == separator; };
    while (true) {
        std::string cell;
        bool quoted = false;  // some of the cell was in quotes: that part keeps its blanks
        std::size_t kept = 0;
        while (i < text.size() && !at_separator()) {
            if (text[i] != '"') {
                cell += text[i++];
                continue;
            }
            if (trimmed(std::string_view(cell).substr(kept)).empty()) cell.resize(kept);
            quoted = true;
            for (++i; i < text.size(); ++i) {
                if (text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"')
                    cell += text[++i];
                else if (text[i] == '"')
                    break;
                else
                    cell += text[i];
            }
            if (i < text.size()) ++i;
            kept = cell.size();
        }
        if (!quoted)
            cell = std::string(trimmed(cell));
        else if (trimmed(std::string_view(cell).substr(kept)).empty())
            cell.resize(kept);
        cells.push_back(std::move(cell));
        if (i >= text.size()) return cells;
        ++i;
        if (separator == ' ')
            while (i < text.size() && is_blank(text[i])) ++i;
    }
}

bool is_missing(std::string_view cell) {
    if (cell.empty()) return true;
    if (cell.size() > 9) return false;
    std::string lower(cell);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    static constexpr std::array words = {"nan",  "-nan", "+nan", "na",   "n/a",      "#n/a",      "null",
                                         "none", "inf",  "-inf", "+inf", "infinity", "-infinity", "-nan(ind)"};
    return std::find(words.begin(), words.end(), lower) != words.end();
}

std::optional<double> number_in(std::string_view cell, char decimal) {
    if (cell.empty()) return std::nullopt;
    if (cell.substr(0, minus_sign.size()) == minus_sign)
        return number_in("-" + std::string(cell.substr(minus_sign.size())), decimal);
    if (decimal == ',' && cell.find('.') != std::string_view::npos) {
        if (!has_thousands(cell)) return std::nullopt;
        std::string text(cell);
        text.erase(std::remove(text.begin(), text.end(), '.'), text.end());
        return number_in(text, decimal);
    }
    if (decimal == ',' && has_decimal_comma(cell)) {
        std::string text(cell);
        text[text.find(',')] = '.';
        return number_in(text);
    }
    const char first = cell[cell.front() == '-' || cell.front() == '+' ? 1 % cell.size() : 0];
    if (first != '.' && (first < '0' || first > '9')) return std::nullopt;  // inf, nan; "+-1"
    double value = 0;
    const char* const stop = cell.data() + cell.size();
    const auto [end, error] = std::from_chars(cell.data() + (cell.front() == '+' ? 1 : 0), stop, value);
    if (end != stop || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range)  // which too small ones are, too
        value = std::strtod(std::string(cell).c_str(), nullptr);
    if (!std::isfinite(value)) return std::nullopt;
    return value;
}

bool has_decimal_comma(std::string_view cell) {
    const std::size_t comma = cell.find(',');
    if (comma == std::string::npos || comma + 1 == cell.size()) return false;
    if (cell.find_first_of(".,", comma + 1) != std::string::npos || cell.find('.') < comma) return false;
    const auto is_digit = [&](std::size_t i) { return cell[i] >= '0' && cell[i] <= '9'; };
    return is_digit(comma + 1) && (comma == 0 || is_digit(comma - 1) || cell[comma - 1] == '-') &&
           cell.find_first_not_of("0123456789+-,eE") == std::string::npos;
}

bool looks_like_a_number(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return !cell.empty() && *end == '\0' && !std::isnan(value);
}

std::optional<ClockTime> clock_time_in(std::string_view cell) {
    if (cell.size() < 7 || cell.find(':') == std::string::npos) return std::nullopt;
    std::string_view text = cell;
    std::int64_t days = 0;
    if (cell.size() > 10 && (cell[4] == '-' || cell[4] == '/')) {
        const auto date = days_in(text);
        if (!date || !skip(text, "Tt ")) return std::nullopt;
        days = *date;
    }
    const auto hour = text.size() > 1 && text[1] == ':' ? digits_of(text, 1) : digits_of(text, 2);
    if (!hour || *hour > 24 || !skip(text, ":")) return std::nullopt;
    const auto minute = digits_of(text, 2);
    if (!minute || *minute > 59 || !skip(text, ":")) return std::nullopt;
    const auto second = digits_of(text, 2);
    if (!second || *second > 60) return std::nullopt;
    ClockTime time;
    if (skip(text, ".,")) {
        const std::size_t size = std::min(text.find_first_not_of("0123456789"), text.size());
        time.fraction = std::strtod(("0." + std::string(text.substr(0, size))).c_str(), nullptr);
        text.remove_prefix(size);
    }
    const auto offset = offset_in(text);
    if (!offset) return std::nullopt;
    time.seconds = 86400 * days + std::int64_t{3600} * *hour + std::int64_t{60} * *minute + *second - *offset;
    return time;
}

bool is_value(std::string_view cell, char decimal) {
    return is_missing(cell) || number_in(cell, decimal) || clock_time_in(cell);
}

}  // namespace swirl::apps
