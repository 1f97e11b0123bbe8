// The names of the recurrence conventions.
#pragma once

#include "analysis/recurrence/settings.hpp"
#include "apps/command_line/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::recurrence_names {

template <class E, std::size_t N>
using Words = std::array<std::pair<const char*, E>, N>;

using analysis::recurrence::BorderLines;
using analysis::recurrence::Logarithm;
using analysis::recurrence::Norm;
using analysis::recurrence::RatePairs;
using analysis::recurrence::RecurrenceTime;
using analysis::recurrence::Triangles;

inline constexpr Words<Norm, 3> norms{
    {{"euclidean", Norm::euclidean}, {"maximum", Norm::maximum}, {"manhattan", Norm::manhattan}}};
inline constexpr Words<RatePairs, 2> pairs{{{"outside-window", RatePairs::outside_window}, {"all", RatePairs::all}}};
inline constexpr Words<RecurrenceTime, 3> times{{{"midpoints", RecurrenceTime::midpoints},
                                                 {"white-lines", RecurrenceTime::white_lines},
                                                 {"line-starts", RecurrenceTime::line_starts}}};
inline constexpr Words<Triangles, 2> triangle_choices{{{"both", Triangles::both}, {"one", Triangles::one}}};
inline constexpr Words<BorderLines, 2> borders{
    {{"counted", BorderLines::counted}, {"discarded", BorderLines::discarded}}};
inline constexpr Words<Logarithm, 3> logarithms{
    {{"natural", Logarithm::natural}, {"binary", Logarithm::binary}, {"decimal", Logarithm::decimal}}};

template <class E, std::size_t N>
std::string word_of(E value, const Words<E, N>& words) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return "";
}

template <class E, std::size_t N>
std::vector<std::string> words_of(const Words<E, N>& words) {
    std::vector<std::string> all;
    for (const auto& [word, meaning] : words) all.emplace_back(word);
    return all;
}

/// Sets `target` to what `text` means; leaves it alone if `text` is empty. @throws BadInput listing the words
template <class E, std::size_t N>
void choose(const char* option, const std::string& text, const Words<E, N>& words, E& target) {
    if (text.empty()) return;
    std::string known;
    for (const auto& [word, meaning] : words) {
        if (text == word) {
            target = meaning;
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(word);
    }
    throw BadInput(fmt::format("{} = '{}' is none of: {}", option, text, known));
}

}  // namespace swirl::apps::recurrence_names
