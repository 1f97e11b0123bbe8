#include "apps/modes/means.hpp"

#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

namespace swirl::apps {

namespace {

/// Is nothing sampled? A cycle's mean is that of one period; what stays on the wall rests, turns evenly or swings.
bool is_exact(analysis::Kind kind) {
    using analysis::Kind;
    switch (kind) {
        case Kind::fixed_point:
        case Kind::family:
        case Kind::cycle:
        case Kind::landing:
        case Kind::rolling:
        case Kind::rolling_librating:
        case Kind::rolling_circulating:
        case Kind::sliding:
        case Kind::two_vertex:
            return true;
        default:
            return false;
    }
}

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

std::string_view name_of(MeanKind kind) {
    switch (kind) {
        case MeanKind::none:
            return "none";
        case MeanKind::exact:
            return "exact";
        case MeanKind::sampled:
            return "sampled";
        case MeanKind::bounded:
            return "bounded";
        case MeanKind::too_short:
            return "too-short";
    }
    return "";
}

MeanErrors errors_of_means(const analysis::Classification& verdict, std::span<const double> spins,
                           std::span<const double> integrals, std::span<const double> durations) {
    MeanErrors errors;
    if (!std::isfinite(verdict.mean)) return errors;
    if (is_exact(verdict.kind)) return {MeanKind::exact, 0, 0, analysis::nan};
    if (verdict.kind == analysis::Kind::quasi_periodic) {
        errors.kind = MeanKind::bounded;
        errors.bound = analysis::bound_of_ratio(integrals, durations);
    }
    if (verdict.kind != analysis::Kind::chaotic) return errors;
    const analysis::MeanError per_time = analysis::error_of_ratio(integrals, durations);
    errors.kind = per_time.outcome == analysis::SamplingOutcome::sampled ? MeanKind::sampled : MeanKind::too_short;
    errors.per_time = per_time.standard_error;
    errors.per_impact = analysis::error_of_mean(spins).standard_error;
    return errors;
}

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

std::string mean_in_words(double mean, const MeanErrors& errors) {
    switch (errors.kind) {
        case MeanKind::bounded:
            return fmt::format("{:.8g} (off by {} at most)", mean, short_error(std::max(errors.bound, 1e-300)));
        case MeanKind::too_short:
            return fmt::format("about {:.1g} (too short a run for an error)", mean);
        case MeanKind::sampled:
            return with_error(mean, errors.per_time);
        case MeanKind::none:
        case MeanKind::exact:
            break;
    }
    return fmt::format("{:.8g}", mean);
}

double mean_of(std::span<const double> values) {
    return values.empty() ? analysis::nan : gsl_stats_mean(values.data(), 1, values.size());
}

double error_of_mean(std::span<const double> values, std::span<const double> errors) {
    if (values.size() == 1 && errors.size() == 1 && errors[0] > 0) return errors[0];
    if (values.size() < 2) return analysis::nan;
    return gsl_stats_sd(values.data(), 1, values.size()) / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace swirl::apps
