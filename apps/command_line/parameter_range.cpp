#include "apps/command_line/parameter_range.hpp"

#include "apps/command_line/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace swirl::apps {

namespace {

constexpr long most_columns = 1'000'000;

/// `text` with the flag's name before it.
[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw BadInput(fmt::format("{}: {}", text, why));
}

long count_from(const std::string& text, const std::string& count) {
    long value = 0;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), value);
    if (error != std::errc() || end != count.data() + count.size() || value < 2 || value > most_columns)
        refuse(text, fmt::format("COUNT = {} is outside its range: 2 to {}", count, most_columns));
    return value;
}

}  // namespace

ParameterRange parameter_range_from(const std::string& text, bool counted, bool families, const std::string& flag) {
    const std::string named = flag + " " + text;
    const std::string wanted = counted ? "NAME=A:B:COUNT is wanted" : "NAME=A:B is wanted";
    const auto equals = text.find('=');
    if (text.empty()) throw BadInput(fmt::format("--{} is missing: {}", flag, wanted));
    if (equals == std::string::npos) refuse(named, wanted);
    const auto parts = pieces_of(text, ':', equals + 1);
    if (parts.size() != (counted ? 3U : 2U)) refuse(named, wanted);
    ParameterRange along;
    along.name = text.substr(0, equals);
    along.parameter = parameter_named(along.name);
    if (!along.parameter && !(families && (along.name == "S" || along.name == "tau")))
        refuse(named, fmt::format("NAME is none of: alpha, beta, mu, restitution, inertia-factor{}",
                                  families ? ", and for families S, tau" : ""));
    const double a = number_from<double>("A", parts[0]);
    const double b = number_from<double>("B", parts[1]);
    if (!std::isfinite(a) || !std::isfinite(b) || a == b) refuse(named, "A and B must be finite and differ");
    along.low = std::min(a, b);
    along.high = std::max(a, b);
    along.falling = a > b;
    if (counted) along.columns = points_between(parts[0], parts[1], count_from(named, parts[2]));
    return along;
}

std::vector<std::string> parameters_to_offer(bool families) {
    std::vector<std::string> words = {"alpha=", "beta=", "mu=", "restitution=", "inertia-factor="};
    if (families) words.insert(words.end(), {"S=", "tau="});
    return words;
}

}  // namespace swirl::apps
