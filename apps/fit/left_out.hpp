// What became of the kinks of a film: how many are fitted, and why the others are not. For both fits of films, of a
// body in the dish and of one that falls on a plate, which count them by the same members.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/studies/fits/film_impacts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::apps::fit {

/// Usable impacts beyond the first of those that are fitted as one.
template <class Fit>
std::size_t repeats_of(const Fit& found) {
    return found.counts[static_cast<std::size_t>(studies::KinkUse::used)] - found.thinned - found.fit.impacts.size() -
           found.fit.left_out;
}

/// Kinks that are not fitted, by reason.
template <class Fit>
Settings counts_of(const Fit& found) {
    Settings counts;
    for (std::size_t use = 1; use < studies::kink_uses; ++use)
        counts.emplace_back(std::string(studies::names_of(studies::KinkUse{static_cast<int>(use)}).key),
                            static_cast<std::int64_t>(found.counts[use]));
    counts.emplace_back("thinned", static_cast<std::int64_t>(found.thinned));
    counts.emplace_back("alike", static_cast<std::int64_t>(repeats_of(found)));
    return counts;
}

/// The table's lines on what the tracker's noise does to e and mu, and on what is used.
template <class Fit>
void print_used(const Fit& found) {
    std::vector<std::string> reasons;
    for (std::size_t use = 1; use < studies::kink_uses; ++use)
        if (found.counts[use] > 0)
            reasons.push_back(fmt::format("{} {}", found.counts[use],
                                          studies::names_of(studies::KinkUse{static_cast<int>(use)}).words));
    if (repeats_of(found) > 0) reasons.push_back(fmt::format("{} like others, in their means", repeats_of(found)));
    if (found.thinned > 0) reasons.push_back(fmt::format("{} thinned", found.thinned));
    const std::string left_out = reasons.empty() ? "" : fmt::format("; left out: {}", fmt::join(reasons, ", "));
    if (found.noisier > 0)
        fmt::print("  as much noise   again moves e by {:.2g}, mu by {:.2g} ({} films)\n", found.restitution_shift,
                   found.friction_shift, found.noisier);
    fmt::print("{}\n", wrapped(fmt::format("  used            {} impacts{}", found.fit.impacts.size(), left_out), 18));
}

}  // namespace swirl::apps::fit
