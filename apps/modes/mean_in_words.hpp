// A mean of S and its error for people.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/studies/modes/means.hpp"

#include <string>

namespace swirl::apps {

/// "-0.05 +- 0.02": the error with one digit, two where the first is 1, and the mean with as many decimals. Eight
/// digits without "+-" where the error is NaN, or less than they show.
std::string with_error(double mean, double error);

/// "about -0.05": one digit of a mean whose error is not known.
std::string about(double mean);

/// A mean, and what is known of its error: "0.1234567 (off by 3e-05 at most)", "about -0.05 (too short a run for an
/// error)".
std::string mean_in_words(double mean, const MeanErrors& errors);

}  // namespace swirl::apps
