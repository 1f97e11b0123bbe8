#include "apps/command_line/numbers.hpp"

#include "map/numbers/quad.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace swirl::apps {

bool underflows(const std::string& text) {
    const bool hexadecimal = text.find_first_of("xX") != std::string::npos;
    const std::string digits = text.substr(0, text.find_first_of(hexadecimal ? "pP" : "eE"));
    const bool all_zero =
        digits.find_first_of(hexadecimal ? "123456789abcdefABCDEF" : "123456789") == std::string::npos;
    return !all_zero && std::strtod(text.c_str(), nullptr) == 0;
}

std::vector<std::string> pieces_of(const std::string& text, char separator, std::size_t begin) {
    std::vector<std::string> pieces;
    while (begin <= text.size()) {
        const auto end = std::min(text.find(separator, begin), text.size());
        pieces.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return pieces;
}

std::vector<double> points_between(const std::string& a, const std::string& b, long count) {
    const Quad first = number_from<Quad>("A", a), last = number_from<Quad>("B", b);
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(count));
    for (long i = 0; i < count; ++i)
        points.push_back(static_cast<double>(count == 1 ? first : first + (last - first) * Quad(i) / Quad(count - 1)));
    return points;
}

std::vector<double> points_between_logarithms(const std::string& a, const std::string& b, long count) {
    using std::exp, std::log;  // and Quad's own
    const Quad first = log(number_from<Quad>("A", a)), last = log(number_from<Quad>("B", b));
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(count));
    for (long i = 0; i < count; ++i)
        points.push_back(static_cast<double>(exp(first + (last - first) * Quad(i) / Quad(std::max(count - 1, 1L)))));
    points.front() = number_from<double>("A", a);
    points.back() = number_from<double>("B", b);
    return points;
}

std::optional<std::int64_t> whole_number_from(std::string_view text, bool* too_large) {
    if (too_large != nullptr) *too_large = false;
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    const std::size_t exponent_at = text.find_first_of("eE");
    std::int64_t exponent = 0;
    if (exponent_at != std::string_view::npos) {
        std::string_view power = text.substr(exponent_at + 1);
        const bool signed_twice = power.starts_with("+-");
        if (power.starts_with('+')) power.remove_prefix(1);
        const auto [stop, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
        if (error != std::errc() || stop != power.data() + power.size() || signed_twice) return std::nullopt;
    }
    const std::string_view mantissa = text.substr(0, exponent_at);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    std::string digits(mantissa.substr(0, point));
    if (point < mantissa.size()) digits += mantissa.substr(point + 1);
    if (exponent_at == std::string_view::npos && point < mantissa.size()) return std::nullopt;
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    // The number is 0.DIGITS 10^magnitude; no digit of another value than 0 may stand behind its point.
    const std::size_t first = digits.find_first_not_of('0'), last = digits.find_last_not_of('0');
    if (first == std::string::npos) return 0;
    const std::int64_t magnitude =
        static_cast<std::int64_t>(point - first) + std::clamp<std::int64_t>(exponent, -1'000'000, 1'000'000);
    digits = digits.substr(first, last + 1 - first);
    if (magnitude < static_cast<std::int64_t>(digits.size())) return std::nullopt;
    constexpr std::int64_t longest = 19;  // digits of 2^63
    std::int64_t value = 0;
    if (magnitude <= longest) digits.append(static_cast<std::size_t>(magnitude) - digits.size(), '0');
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (magnitude > longest || error != std::errc()) {
        if (too_large != nullptr) *too_large = true;
        return std::nullopt;
    }
    return negative ? -value : value;
}

TextCheck whole_number(std::int64_t least, std::int64_t most) {
    // A transform rewrites its text: what CLI11 converts then has no leading zeros.
    const auto check = [least, most](std::string& text) {
        bool too_large = false;
        const auto value = whole_number_from(text, &too_large);
        if (!value && !too_large)
            return fmt::format("Value {} is no whole number: {} to {} are allowed", text, least, most);
        if (!value || *value < least || *value > most)
            return fmt::format("Value {} not in range {} to {}", text, least, most);
        text = fmt::format("{}", *value);
        return std::string();
    };
    return {check, fmt::format("INT in [{} - {}]", least, most)};
}

TextCheck finite_number_from(double least) {
    const auto check = [least](const std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool number = end != text.c_str() && *end == '\0';
        if (!number || !std::isfinite(value) || value < least || underflows(text))
            return fmt::format("Value {} is outside its range: {:g} or more, finite", text, least);
        return std::string();
    };
    return {check, fmt::format("FLOAT >= {:g}", least)};
}

TextCheck number_below(double least, double limit) {
    const auto check = [least, limit](const std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool number = end != text.c_str() && *end == '\0';
        if (!number || !(value >= least && value < limit) || underflows(text))
            return fmt::format("Value {} is outside its range: {:g} or more, below {:g}", text, least, limit);
        return std::string();
    };
    return {check, fmt::format("FLOAT in [{:g}, {:g})", least, limit)};
}

}  // namespace swirl::apps
