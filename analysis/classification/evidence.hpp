// One piece of evidence for a verdict.
#pragma once

#include <string>

namespace swirl::analysis {

/// What was measured, against what, what it says, and what other value would have changed the verdict.
struct Evidence {
    std::string name;
    double value = 0;
    double threshold = 0;
    std::string says;
    std::string changes_if;
};

/// A threshold as it stands in a sentence: three digits.
std::string in_words(double number);

}  // namespace swirl::analysis
