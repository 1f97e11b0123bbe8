#include "apps/output/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <vector>

namespace swirl::apps {

namespace {

/// Powers of R_c, 1/ω_s and m.
struct Powers {
    double length = 0, time = 0, mass = 0;
};

/// None for what is made of anything else.
std::optional<Powers> powers_of(const std::string& unit) {
    std::istringstream factors(unit);
    Powers powers;
    bool any = false;
    for (std::string factor; factors >> factor; any = true) {
        const bool divides = factor.rfind("1/", 0) == 0;
        if (divides) factor.erase(0, 2);
        const auto caret = factor.find('^');
        double power = caret == std::string::npos ? 1 : std::strtod(factor.c_str() + caret + 1, nullptr);
        if (divides) power = -power;
        factor.resize(std::min(caret, factor.size()));
        if (factor == "R_c")
            powers.length += power;
        else if (factor == "omega_s")
            powers.time -= power;
        else if (factor == "m")
            powers.mass += power;
        else
            return std::nullopt;
    }
    return any ? std::optional(powers) : std::nullopt;
}

/// The numbers of a list; empty unless all of it are.
std::vector<double> all_numbers(const std::vector<std::string>& words) {
    std::vector<double> numbers;
    for (const std::string& word : words) {
        char* end = nullptr;
        numbers.push_back(std::strtod(word.c_str(), &end));
        if (word.empty() || *end != '\0') return {};
    }
    return numbers;
}

std::vector<std::string> words_of(const std::string& text, char separator) {
    std::vector<std::string> words;
    std::istringstream all(text);
    for (std::string word; std::getline(all, word, separator);) words.push_back(word);
    if (text.ends_with(separator)) words.emplace_back();
    return words;
}

}  // namespace

std::optional<double> physical_scale(const Units& units, const std::string& unit) {
    const auto powers = powers_of(unit);
    if (!powers) return std::nullopt;
    return std::pow(units.length, powers->length) * std::pow(1 / units.time, -powers->time) *
           std::pow(units.mass, powers->mass);
}

std::string unit_label(const std::string& unit) {
    const auto powers = powers_of(unit);
    if (!powers) return unit == "rad" ? unit : "";
    if (unit == "omega_s") return "rad/s";
    const auto is = [&](double length, double time, double mass) {
        return powers->length == length && powers->time == time && powers->mass == mass;
    };
    if (is(1, -1, 1)) return "N s";
    if (is(1, -2, 1)) return "N";
    if (is(2, -2, 1)) return "J";
    std::string over, under;
    const auto put = [&](const char* name, double power) {
        if (power == 0) return;
        std::string& side = power > 0 ? over : under;
        side += fmt::format("{}{}", side.empty() ? "" : " ", name);
        if (std::abs(power) != 1) side += fmt::format("^{:g}", std::abs(power));
    };
    put("kg", powers->mass);
    put("m", powers->length);
    put("s", powers->time);
    return under.empty() ? over : fmt::format("{}/{}", over.empty() ? "1" : over, under);
}

std::optional<ShownUnit> shown_unit(const Units& units, const std::string& unit) {
    const auto scale = physical_scale(units, unit);
    if (!scale) return std::nullopt;
    ShownUnit shown{unit_label(unit), *scale};
    if (shown.label != "N s" && shown.label != "N" && shown.label != "J") return shown;
    for (const char* prefix : {"m", "u", "n"}) {
        if (!(shown.scale < 1)) break;
        shown = {prefix + unit_label(unit), shown.scale * 1000};
    }
    return shown;
}

double in_units(double value, const std::optional<Units>& units, const std::string& unit) {
    return units ? value * physical_scale(*units, unit).value_or(1) : value;
}

double without_units(double given, const std::optional<Units>& units, const std::string& unit) {
    return units ? given / physical_scale(*units, unit).value_or(1) : given;
}

std::string with_unit(double value, const std::optional<Units>& units, const std::string& unit) {
    if (!units) return fmt::format("{:g}", value);
    const ShownUnit shown = shown_unit(*units, unit).value_or(ShownUnit{unit_label(unit)});
    return fmt::format("{:g}{}{}", value * shown.scale, shown.label.empty() ? "" : " ", shown.label);
}

std::string point_without_units(const std::string& text, const std::optional<Units>& units) {
    std::vector<double> z = all_numbers(words_of(text, ','));
    if (!units || (z.size() != 4 && z.size() != 5)) return text;
    for (const std::size_t i : {z.size() - 3, z.size() - 2}) z[i] = without_units(z[i], units, "R_c omega_s");
    return fmt::format("{}", fmt::join(z, ","));
}

std::string range_without_units(const std::string& text, const std::optional<Units>& units, const std::string& unit) {
    const auto equals = text.find('=');
    if (!units || !physical_scale(*units, unit) || equals == std::string::npos) return text;
    const char separator = text.find(':') == std::string::npos ? ',' : ':';
    std::vector<std::string> words = words_of(text.substr(equals + 1), separator);
    const std::size_t count = separator == ':' ? std::min<std::size_t>(2, words.size()) : words.size();
    const std::vector<double> given = all_numbers({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count)});
    for (std::size_t i = 0; i < given.size(); ++i) words[i] = fmt::format("{}", without_units(given[i], units, unit));
    return fmt::format("{}={}", text.substr(0, equals), fmt::join(words, separator == ':' ? ":" : ","));
}

std::string units_in_words(const std::optional<Units>& units) {
    if (!units) return "";
    const double rate = 1 / units->time, frequency = rate / (2 * std::numbers::pi);
    return fmt::format("SI units: R_c = {:g} m, omega_s = {:g} rad/s ({:.4g} Hz, {:.4g} rpm), m = {:g} kg\n",
                       units->length, rate, frequency, 60 * frequency, units->mass);
}

}  // namespace swirl::apps
