#include "apps/modes/verdict_in_words.hpp"

#include "apps/output/wrapped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

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

namespace {

using analysis::Classification, analysis::Evidence, analysis::Kind, analysis::Mode;

const Evidence* evidence_of(const Classification& verdict, std::string_view name) {
    const auto found = std::find_if(verdict.evidence.begin(), verdict.evidence.end(),
                                    [&](const Evidence& e) { return e.name == name; });
    return found == verdict.evidence.end() ? nullptr : &*found;
}

std::string sureness_of_cycle(const Classification& verdict) {
    if (evidence_of(verdict, "rank of the derivative along the cycle") != nullptr)
        return "settled: superstable, the cycle annihilates every direction";
    const Evidence* multiplier = evidence_of(verdict, "slowest multiplier");
    if (multiplier == nullptr || !(multiplier->value < multiplier->threshold))
        return "as far as it was followed: the orbit has stayed on a cycle that does not attract";
    return fmt::format("settled: {}attracts, slowest multiplier {:.6g}",
                       verdict.kind == Kind::family ? "a member of a family, which " : "the cycle ", multiplier->value);
}

std::string sureness_of_exponent(const Classification& verdict, const ExponentUnit& unit) {
    const double value = verdict.largest_exponent / unit.steps, error = verdict.largest_exponent_error / unit.steps;
    const std::string seen = "as far as it was " + unit.seen;
    if (std::isnan(value)) return seen;
    return fmt::format("{}: largest exponent {:.4g}{} {}", seen, value,
                       std::isnan(error) ? "" : fmt::format(" +- {:.2g}", error), unit.words);
}

}  // namespace

std::string mode_in_words(const Classification& verdict) {
    return fmt::format("mode {}{}{}", name_of(verdict.mode),
                       verdict.kind == Kind::none ? "" : fmt::format(" ({})", name_of(verdict.kind)),
                       verdict.period > 0 ? fmt::format(", period {}", verdict.period) : "");
}

std::string no_cycle_in_words(const Classification& verdict) {
    return fmt::format("swirl: the start settles on no cycle to go on from: {}", mode_in_words(verdict));
}

std::string sureness_in_words(const Classification& verdict, const std::optional<Units>& units,
                              const ExponentUnit& exponent) {
    if (const Evidence* chord = evidence_of(verdict, "slowest multiplier of the chord"); chord != nullptr)
        return fmt::format("settled: the chord attracts, slowest multiplier {:.6g}", chord->value);
    if (verdict.kind == Kind::accelerated) return "as far as it was followed: energy is created without bound";
    if (verdict.mode == Mode::undecided) return "undecided: " + reason_in_words(verdict);
    if (!verdict.multipliers.empty() || evidence_of(verdict, "closure throughout") != nullptr)
        return sureness_of_cycle(verdict);
    if (const Evidence* contact = evidence_of(verdict, "time in contact"); contact != nullptr)
        return fmt::format("{}: no impact for {}{}",
                           verdict.kind == Kind::rolling ? "settled, at rest" : "as far as it was followed",
                           with_unit(contact->value, units, "1/omega_s"), units ? "" : "/omega_s");
    if (verdict.kind == Kind::sliding) return "settled: nothing changes S";
    if (const Evidence* room = evidence_of(verdict, "room at the wall"); room != nullptr)
        return fmt::format("settled: rides along with the floor, {}{} off the wall at its nearest",
                           with_unit(room->value, units, "R_c"), units ? "" : " R_c");
    if (const Evidence* level = evidence_of(verdict, "white level of the angle in radians"); level != nullptr)
        return fmt::format("as far as it was measured: noise of {:.3g} radians or less in the angle", level->value);
    if (const Evidence* residual = evidence_of(verdict, "residual about the phase means");
        residual != nullptr && verdict.period > 0)
        return fmt::format("as far as it was measured: residual {:.3g}, at most {:.3g} is noise", residual->value,
                           residual->threshold);
    return sureness_of_exponent(verdict, exponent);
}

namespace {

/// What decided of a body that stays on the wall: S at rest, the limit that its periods come to, or their equality.
const Evidence* reason_of_contact(const Classification& verdict) {
    if (verdict.mode == Mode::steady) return evidence_of(verdict, "range of S");
    for (const char* decides : {"change of mean S still to come", "change of the period still to come",
                                "spread of the periods", "work of slip, last quarter"})
        if (const Evidence* e = evidence_of(verdict, decides)) return e;
    return nullptr;
}

}  // namespace

namespace {

/// The last piece of evidence that can change the verdict; the others say of themselves that nothing in them does.
const Evidence& last_that_decides(const Classification& verdict) {
    const auto found = std::find_if(verdict.evidence.rbegin(), verdict.evidence.rend(),
                                    [](const Evidence& e) { return !e.changes_if.starts_with("nothing"); });
    return found == verdict.evidence.rend() ? verdict.evidence.back() : *found;
}

/// An orbit that keeps its size is undecided for another reason: it has no rotation number.
const Evidence* reason_of_undecided(const Classification& verdict) {
    const Evidence& last = last_that_decides(verdict);
    const bool keeps_size =
        last.name == "change of spread along the tail" && std::abs(std::log(last.value)) <= std::log(last.threshold);
    const Evidence* rotation = keeps_size ? evidence_of(verdict, "rotation number") : nullptr;
    return rotation != nullptr ? rotation : &last;
}

/// The piece of evidence that the verdict rests on. There is one.
const Evidence& deciding(const Classification& verdict) {
    if (verdict.mode == Mode::undecided) return *reason_of_undecided(verdict);
    if (const Evidence* closure = evidence_of(verdict, "closure"); closure != nullptr && verdict.period > 0)
        return *closure;
    if (evidence_of(verdict, "time in contact") != nullptr)
        if (const Evidence* e = reason_of_contact(verdict)) return *e;
    for (const char* decides :
         {"share of the continuum in S", "rotation number", "largest exponent", "divergence of neighbours per sample",
          "logarithmic separation of neighbours", "residual about the phase means"})
        if (const Evidence* e = evidence_of(verdict, decides)) return *e;
    return verdict.evidence.back();
}

}  // namespace

std::string reason_in_words(const Classification& verdict) {
    if (verdict.evidence.empty()) return "there is no evidence";
    const Evidence& e = deciding(verdict);
    if (verdict.mode == Mode::undecided) return e.says;
    if (e.name == "closure")
        return fmt::format("{}, after {} impact{}, to {:.2g}", e.says, verdict.period, verdict.period == 1 ? "" : "s",
                           e.value);
    return fmt::format("{} {:.4g}: {}", e.name, e.value, e.says);
}

std::string verdict_in_lines(const Classification& verdict, const std::optional<Units>& units,
                             const ExponentUnit& exponent) {
    const std::string sureness = sureness_in_words(verdict, units, exponent);
    std::string lines = fmt::format("  {}\n", sureness);
    if (verdict.mode != Mode::undecided) lines += fmt::format("  because: {}\n", reason_in_words(verdict));
    if (!verdict.evidence.empty() && !sureness.starts_with("settled"))
        lines += fmt::format("  changes if: {}\n", deciding(verdict).changes_if);
    return all_wrapped(lines, 4);
}

std::string table_of(const std::vector<Evidence>& evidence) {
    std::string text;
    for (const auto& e : evidence)
        text += all_wrapped(fmt::format("  evidence: {:<40} {:>12.4g}  against {:>10.4g}\n"
                                        "            {}\n            changes if: {}\n",
                                        e.name, e.value, e.threshold, e.says, e.changes_if),
                            14);
    return text;
}

}  // namespace swirl::apps
