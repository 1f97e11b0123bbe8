// Numbers as users write them, read in the precision in which they will be used, and checks of them before anything
// else is done.
#pragma once

#include "apps/command_line/errors.hpp"
#include "apps/command_line/flags.hpp"
#include "map/numbers/real.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace swirl::apps {

/// True of a number whose digits are not all 0 although the nearest double is: 1e-400, -2e-324.
bool underflows(const std::string& text);

/// The decimal `text` as a T, without a detour through double. @throws BadInput naming the option: it is no number, or
/// underflows
template <class T>
T number_from(const std::string& name, const std::string& text) {
    std::size_t begin = 0;
    while (begin < text.size() && std::isspace(static_cast<unsigned char>(text[begin])) != 0) ++begin;
    char* end = nullptr;
    const double rough = std::strtod(text.c_str() + begin, &end);
    if (begin == text.size() || end == text.c_str() + begin || *end != '\0')
        throw BadInput(fmt::format("{} = '{}' is not a number", name, text));
    if (rough == 0 && underflows(text))
        throw BadInput(fmt::format("{} = {} is outside its range: 0, or 1e-75 to 1e75 in size", name, text));
    if constexpr (std::is_same_v<T, double>) {
        return rough;
    } else if constexpr (std::is_same_v<T, long double>) {
        return std::strtold(text.c_str() + begin, nullptr);
    } else {
        // Boost's parser takes plain decimals only; what strtod takes beside them (nan, inf, hexadecimal) is rare here.
        const bool decimal = text.find_first_not_of("0123456789+-.eE", begin) == std::string::npos;
        if (!decimal) return T(rough);
        return T(text.substr(text[begin] == '+' ? begin + 1 : begin));
    }
}

/// What stands from `begin` on, between separators: one piece more than there are of these, any of them empty.
std::vector<std::string> pieces_of(const std::string& text, char separator, std::size_t begin = 0);

/// Comma-separated numbers. @throws BadInput unless there are `count` of them
template <class T>
std::vector<T> numbers_from(const std::string& name, const std::string& text, std::size_t count) {
    std::vector<T> numbers;
    for (const std::string& piece : pieces_of(text, ',')) numbers.push_back(number_from<T>(name, piece));
    if (numbers.size() != count)
        throw BadInput(fmt::format("{} = '{}' has {} numbers; it takes {}", name, text, numbers.size(), count));
    return numbers;
}

/// `count` points from the decimal `a` to the decimal `b` in equal steps, each the double nearest to A + (B − A)
/// i/(count − 1), so that the seventh of 0.1 … 1 in tenths is the number that a user writes as 0.7: an orbit of its
/// scene is then the same in every command. (In double the sum would give 0.7000000000000001.) @throws BadInput naming
/// A or B
std::vector<double> points_between(const std::string& a, const std::string& b, long count);

/// `count` points from A to B, both > 0, each the double nearest to A (B/A)^{i/(count − 1)}: of 0.001 … 1 in three
/// steps the numbers that a user writes as 0.01 and 0.1. @throws BadInput naming A or B
std::vector<double> points_between_logarithms(const std::string& a, const std::string& b, long count);

// Checks of numbers among the arguments, said before anything else is done.

/// The most impacts that a command is asked to follow, or to skip.
inline constexpr std::int64_t most_impacts = 1'000'000'000'000;

/// The whole number that a decimal is, also one with an exponent: 10000, 1e4, 2.5e3; 010 is ten; 10.0, 1e-3 and 0x10
/// are none. Nothing too of one beyond 64 bits: `too_large`, if it is given, tells these apart.
std::optional<std::int64_t> whole_number_from(std::string_view text, bool* too_large = nullptr);

/// For Flag::transform: a whole number from `least` to `most`, as whole_number_from() reads it. (CLI11's own conversion
/// takes 010 for eight.)
TextCheck whole_number(std::int64_t least, std::int64_t most);

/// An option that takes one of these; `type` stands for its value under --help.
template <class Target>
Flag add_whole_number(Flags& command, const std::string& name, Target& target, const std::string& type,
                      std::int64_t least, std::int64_t most, const std::string& help) {
    return command.add_option(name, target, type, help).transform(whole_number(least, most));
}

/// For Flag::check: a finite number, `least` or more. (CLI11's Range lets NaN through.)
TextCheck finite_number_from(double least);

/// For Flag::check: a number, `least` or more and below `limit`.
TextCheck number_below(double least, double limit);

}  // namespace swirl::apps
