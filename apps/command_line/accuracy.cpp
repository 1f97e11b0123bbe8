#include "apps/command_line/accuracy.hpp"

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>

#include <array>

namespace swirl::apps {

namespace {

constexpr std::array all = {
    Accuracy::double_precision, Accuracy::extended, Accuracy::quad, Accuracy::paper, Accuracy::brent,
    Accuracy::fixed_step};

}  // namespace

Accuracy accuracy_from(const std::string& name, int extended_bits) {
    std::string allowed;
    const bool has_extended = extended_bits > std::numeric_limits<double>::digits;
    for (const Accuracy accuracy : all) {
        if (accuracy == Accuracy::extended && !has_extended) continue;
        if (name == name_of(accuracy)) return accuracy;
        allowed += fmt::format("{}{}", allowed.empty() ? "" : ", ", name_of(accuracy));
    }
    if (name == name_of(Accuracy::extended))
        throw BadInput(fmt::format("accuracy = extended: long double has {} bits here, no more than double; give {}",
                                   extended_bits, allowed));
    throw BadInput(fmt::format("accuracy = {} is none of: {}", name, allowed));
}

std::vector<std::string> accuracy_names() {
    std::vector<std::string> names;
    for (const Accuracy accuracy : all) names.emplace_back(name_of(accuracy));
    return names;
}

std::string accuracy_help() {
    return fmt::format(
        "double (default), extended ({} bits), quad (113 bits); to compare with: paper, brent, fixed-step. simulate, "
        "recurrence and spectrum keep all digits; elsewhere each step is computed so and rounded to double",
        std::numeric_limits<long double>::digits);
}

}  // namespace swirl::apps
