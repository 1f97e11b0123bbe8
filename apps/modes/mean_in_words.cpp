#include "apps/modes/mean_in_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swirl::apps {

namespace {

/// The first digit, 1 to 9, that is left of `value` where one digit is shown, and its power of ten.
struct Leading {
    double digit;
    int power;
};

Leading leading_of(double value) {
    const int power = static_cast<int>(std::floor(std::log10(value)));
    return {value / std::pow(10, power), power};
}

/// "2e-05", "0.014": one digit, two where the first is 1.
std::string short_error(double error) {
    return fmt::format("{:.{}g}", error, leading_of(error).digit < 1.95 ? 2 : 1);
}

}  // namespace

std::string with_error(double mean, double error) {
    constexpr double shown = 5e-9, most = 1e6;  // eight digits tell less; decimals are no way to write more
    if (!(error > shown * std::max(1.0, std::abs(mean))) || !(std::abs(mean) < most) || !(error < most))
        return fmt::format("{:.8g}", mean);
    const Leading lead = leading_of(error);
    const int decimals = std::max(0, lead.digit < 1.95  ? 1 - lead.power
                                     : lead.digit < 9.5 ? -lead.power
                                                        : -lead.power - 1);
    return fmt::format("{:.{}f} +- {:.{}f}", mean, decimals, error, decimals);
}

std::string about(double mean) {
    return fmt::format("about {:.1g}", mean);
}

std::string mean_in_words(double mean, const MeanErrors& errors) {
    switch (errors.kind) {
        case MeanKind::bounded:
            return fmt::format("{:.8g} (off by {} at most)", mean, short_error(std::max(errors.bound, 1e-300)));
        case MeanKind::too_short:
            return about(mean) + " (too short a run for an error)";
        case MeanKind::sampled:
            return with_error(mean, errors.per_time);
        case MeanKind::none:
        case MeanKind::exact:
            break;
    }
    return fmt::format("{:.8g}", mean);
}

}  // namespace swirl::apps
