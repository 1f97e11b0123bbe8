#include "analysis/classification/mode.hpp"

#include <array>
#include <cstdio>

namespace swirl::analysis {

std::string in_words(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

}  // namespace swirl::analysis
