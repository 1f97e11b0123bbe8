#include "analysis/recurrence/settings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace swirl::analysis::recurrence {
namespace {

Settings recurrence_analysis_jl() {
    return {};
}

// White lines are taken from the whole matrix, border included; the main diagonal is left out of diagonal lines only.
Settings pyunicorn() {
    Settings s;
    s.strict = true;
    s.rate_pairs = RatePairs::all;
    s.window_on_rate = false;
    s.window_on_vertical = false;
    s.longest_of_all_lines = true;
    s.border_white_lines = true;
    s.recurrence_time = RecurrenceTime::white_lines;
    s.empty_is_zero = true;
    return s;
}

// As pyunicorn, except that DET is divided by all recurrence points and white lines are counted from two points on.
Settings pyrqa() {
    Settings s = pyunicorn();
    s.determinism_of_all_points = true;
    s.min_recurrence_time = 2;
    return s;
}

Settings crp_toolbox() {
    Settings s;
    s.strict = true;
    s.recurrence_time = RecurrenceTime::white_lines;
    s.time_entropy_scale = TimeEntropyScale::log_longest;
    return s;
}

struct Preset {
    std::string_view name;
    Settings (*make)();
};
constexpr std::array<Preset, 4> presets{{{"RecurrenceAnalysis.jl", recurrence_analysis_jl},
                                         {"pyunicorn", pyunicorn},
                                         {"PyRQA", pyrqa},
                                         {"CRP Toolbox", crp_toolbox}}};

bool same_letters(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

void require_at_least(const char* name, int value, int least) {
    if (value < least)
        throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) +
                                    ": must be >= " + std::to_string(least));
}

}  // namespace

Settings preset(std::string_view name) {
    for (const Preset& p : presets)
        if (same_letters(p.name, name)) return p.make();
    std::string known;
    for (const Preset& p : presets) known += (known.empty() ? "" : ", ") + std::string(p.name);
    throw std::invalid_argument("convention = " + std::string(name) + ": must be one of " + known);
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const Preset& p : presets) names.emplace_back(p.name);
    return names;
}

int theiler_window(const Settings& settings, bool cross) {
    return settings.theiler.value_or(cross ? 0 : 1);
}

void validate(const Settings& settings) {
    require_at_least("theiler", settings.theiler.value_or(0), 0);
    require_at_least("min-diagonal", settings.min_diagonal, 1);
    require_at_least("min-vertical", settings.min_vertical, 1);
    require_at_least("min-recurrence-time", settings.min_recurrence_time, 1);
    require_at_least("trend-border", settings.trend_border, 0);
    if (settings.border_white_lines && settings.recurrence_time != RecurrenceTime::white_lines)
        throw std::invalid_argument("border_white_lines = true: needs recurrence_time = white_lines");
}

}  // namespace swirl::analysis::recurrence
