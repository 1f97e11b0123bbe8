// A verdict in a few lines for people: what it is, how sure, and why.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/output/units.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// "mode quasi-steady (cycle), period 4"
std::string mode_in_words(const analysis::Classification& verdict);

/// The line that says why nothing goes on from a start that settles on this.
std::string no_cycle_in_words(const analysis::Classification& verdict);

/// What an exponent is said for: so many steps, in words.
struct ExponentUnit {
    double steps = 1;
    std::string words = "per impact";
    std::string seen = "followed";  ///< "as far as it was followed", or "measured"
};

/// How sure, in one line. `settled`: nothing that follows can change it (an attracting cycle, rest). `as far as it was
/// followed`: nothing settles chaos or a torus. `undecided`: why.
std::string sureness_in_words(const analysis::Classification& verdict, const std::optional<Units>& units = {},
                              const ExponentUnit& exponent = {});

/// What decided, in one line: of the evidence the piece that the verdict rests on.
std::string reason_in_words(const analysis::Classification& verdict);

/// What people read below the mode, in lines of at most 100 columns: how sure; why ("because: …"); and, unless it is
/// settled, what would change it ("changes if: …").
std::string verdict_in_lines(const analysis::Classification& verdict, const std::optional<Units>& units = {},
                             const ExponentUnit& exponent = {});

/// All of the evidence, a few lines each.
std::string table_of(const std::vector<analysis::Evidence>& evidence);

}  // namespace swirl::apps
