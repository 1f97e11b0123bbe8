// A verdict in a few lines for people: what it is, how sure, and why, and its mean of S with the error.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/command_line/plain_names.hpp"
#include "apps/output/units.hpp"
#include "apps/studies/modes/means.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

// A mean of S and its error for people.

/// "-0.05 +- 0.02": the error with one digit, two where the first is 1, and the mean with as many decimals. Eight
/// digits without "+-" where the error is NaN, or less than they show.
std::string with_error(double mean, double error);

/// "about -0.05": one digit of a mean whose error is not known.
std::string about(double mean);

/// A mean, and what is known of its error: "0.1234567 (off by 3e-05 at most)", "about -0.05 (too short a run for an
/// error)".
std::string mean_in_words(double mean, const MeanErrors& errors);

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
