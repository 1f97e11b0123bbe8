#include "apps/command_line/parameter_range.hpp"

#include "apps/command_line/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace swirl::apps {

namespace {

constexpr long most_columns = 1'000'000;

/// `text` with the flag's name before it.
[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw BadInput(fmt::format("{}: {}", text, why));
}

long count_from(const std::string& text, const std::string& count) {
    const auto value = whole_number_from(count);
    if (!value || *value < 2 || *value > most_columns)
        refuse(text, fmt::format("COUNT = {} is outside its range: 2 to {}", count, most_columns));
    return *value;
}

/// NAME=V,V,…: rising.
void take_list(const std::string& named, const std::vector<std::string>& values, ParameterRange& along) {
    for (const std::string& text : values) {
        const double value = number_from<double>(along.name, text);
        if (!std::isfinite(value)) refuse(named, fmt::format("{} = {} is not finite", along.name, text));
        if (std::find(along.columns.begin(), along.columns.end(), value) != along.columns.end())
            refuse(named, text + " is given twice");
        along.columns.push_back(value);
    }
    std::sort(along.columns.begin(), along.columns.end());
    along.low = along.columns.front();
    along.high = along.columns.back();
}

/// Names of the parameters, in their order.
std::vector<std::string_view> names_over(RangesOver over) {
    std::vector<std::string_view> names;
    for (const Parameter parameter : all_parameters)
        if (over != RangesOver::plain_scenes ||
            (parameter != Parameter::drag && parameter != Parameter::tangential_restitution &&
             parameter != Parameter::corner))
            names.push_back(name_of(parameter));
    return names;
}

}  // namespace

ParameterRange parameter_range_from(const std::string& text, bool counted, bool families, const std::string& flag) {
    const std::string named = flag + " " + text;
    const std::string wanted =
        counted ? "NAME=A:B:COUNT, NAME=A:B:COUNT:log or NAME=V,V,... is wanted" : "NAME=A:B is wanted";
    const auto equals = text.find('=');
    if (text.empty()) throw BadInput(fmt::format("--{} is missing: {}", flag, wanted));
    if (equals == std::string::npos) refuse(named, wanted);
    const bool is_list = counted && text.find(',', equals) != std::string::npos;
    auto parts = pieces_of(text, ':', equals + 1);
    const bool by_logarithm = counted && parts.size() == 4 && parts.back() == "log";
    if (by_logarithm) parts.pop_back();
    if (!is_list && parts.size() != (counted ? 3U : 2U)) refuse(named, wanted);
    ParameterRange along;
    along.name = text.substr(0, equals);
    along.parameter = parameter_named(along.name);
    if (along.name == "floor-friction" || along.name == "gravity-ratio" || along.name == "spin-drag")
        refuse(named,
               fmt::format("no derivative along {} is followed; sweep --grid {}=... is", along.name, along.name));
    if (!along.parameter && !(families && (along.name == "S" || along.name == "tau")))
        refuse(named, fmt::format("NAME is none of: {}", parameters_in_words(flag == "plane" ? RangesOver::plain_scenes
                                                                             : families      ? RangesOver::families
                                                                                             : RangesOver::scenes)));
    if (along.parameter == Parameter::drag && flag == "plane")
        refuse(named, "this command is not extended to a floor that drags");
    if (along.parameter == Parameter::tangential_restitution && flag == "plane")
        refuse(named, "this command is not extended to tangential restitution");
    if (along.parameter == Parameter::corner && flag == "plane")
        refuse(named, "this command is not extended to rounded corners");
    if (is_list) {
        take_list(named, pieces_of(text, ',', equals + 1), along);
        return along;
    }
    const double a = number_from<double>("A", parts[0]);
    const double b = number_from<double>("B", parts[1]);
    if (!std::isfinite(a) || !std::isfinite(b) || a == b) refuse(named, "A and B must be finite and differ");
    if (by_logarithm && !(a > 0 && b > 0)) refuse(named, "A and B of :log must be above 0");
    along.low = std::min(a, b);
    along.high = std::max(a, b);
    along.falling = a > b;
    if (counted)
        along.columns = (by_logarithm ? points_between_logarithms : points_between)(parts[0], parts[1],
                                                                                    count_from(named, parts[2]));
    return along;
}

std::string parameters_in_words(RangesOver over) {
    const std::string words = fmt::format("{}", fmt::join(names_over(over), ", "));
    return over == RangesOver::families ? words + "; S or tau for a family" : words;
}

std::vector<std::string> parameters_to_offer(RangesOver over) {
    std::vector<std::string> words;
    for (const std::string_view name : names_over(over)) words.push_back(fmt::format("{}=", name));
    if (over == RangesOver::families) words.insert(words.end(), {"S=", "tau="});
    return words;
}

}  // namespace swirl::apps
