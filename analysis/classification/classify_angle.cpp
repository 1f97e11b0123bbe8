#include "analysis/classification/classify_angle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr double few_continuum = 0.005, much_continuum = 0.3;
constexpr int fewest_blocks = 3;
constexpr double near_level = 1.5;  // of it: a noise up to this is that level

struct Verdict {
    Mode mode = Mode::undecided;
    Kind kind = Kind::none;
};

Verdict judge(const AngleSpectrum& found) {
    if (found.is_straight()) return {Mode::steady, Kind::fixed_point};
    if (found.slow > found.in_lines + found.in_continuum) return {Mode::undecided, Kind::transient};
    if (found.lines == 0 && !(found.in_continuum > 0) && found.uncertain == 0) return {Mode::steady, Kind::fixed_point};
    if (found.lines > 0 && found.largest_continuum_share() <= few_continuum) return {Mode::quasi_steady, Kind::none};
    if (found.continuum_share() >= much_continuum && found.blocks >= fewest_blocks)
        return {Mode::chaotic, Kind::chaotic};
    return {};
}

/// Halves of which one has less than this of the other's variance of S are no one motion. Two equal lines that beat
/// once over the whole length have (1 − 2/π)/(1 + 2/π) = 0.22 in the worst phase.
constexpr double least_of_other_half = 0.2;

/// The variance of S in the half that has less over that in the other; 1 where halves are too short to be looked at, 0
/// where the one alone is steady.
double agreement_of_halves(std::span<const double> angle, double spacing, double noise, double resolution) {
    const std::size_t half = angle.size() / 2;
    if (half < fewest_angles) return 1;
    const AngleSpectrum first = spectrum_of_angle(angle.first(half), spacing, noise, resolution);
    const AngleSpectrum second = spectrum_of_angle(angle.last(half), spacing, noise, resolution);
    const Mode one = judge(first).mode, other = judge(second).mode;
    if (one != other && (one == Mode::steady || other == Mode::steady)) return 0;
    const double a = first.in_lines + first.in_continuum, b = second.in_lines + second.in_continuum;
    return std::max(a, b) > 0 ? std::min(a, b) / std::max(a, b) : 1;
}

std::string words_of_level(const AngleSpectrum& found, double given) {
    if (given > 0 && near_level * given < found.level)
        return "the level is more than the noise given, so the level counts";
    if (given > near_level * found.level) return "the level is much less than the noise given";
    return "so much is in the highest third of the frequencies: noise, or motion as fast as the rows";
}

std::string words_of_lines(const AngleSpectrum& found) {
    if (found.lines > 0) return "S repeats, in one period or several";
    return found.uncertain > 0 ? "there are none but such as rounding makes" : "S has no period";
}

/// Without lines rounding explains a continuum, or leaves open whether there is any (the last evidence).
double believed_share(const AngleSpectrum& found) {
    return found.lines > 0 ? found.largest_continuum_share() : found.continuum_share();
}

std::string words_of_continuum(const AngleSpectrum& found) {
    const double share = believed_share(found);
    if (share == 0)
        return found.lines > 0 ? "nothing but lines is above the noise"
                               : "nothing is above noise and rounding: S is constant";
    if (share <= few_continuum) return "there are lines, and what faint lines leave";
    if (!(found.in_continuum > 0)) return "rounding alone makes as much";
    if (share < much_continuum || found.blocks < fewest_blocks)
        return "it is more than lines leave and less than chaos: weak chaos, or a torus seen too briefly";
    return "S is irregular beyond the camera's noise (a shaken container looks the same)";
}

std::string other_continuum_in_words(const AngleSpectrum& found) {
    const std::string regular = "at most " + in_words(few_continuum) + ": steady or quasi-steady; ";
    if (found.continuum_share() >= much_continuum && found.blocks < fewest_blocks)
        return regular + "a series so long that its spectrum has " + std::to_string(fewest_blocks) + " blocks, not " +
               std::to_string(found.blocks) + ": chaotic";
    return regular + "at least " + in_words(much_continuum) + ": chaotic; between: undecided";
}

void describe(const AngleSpectrum& found, double given, Classification& result) {
    result.evidence.push_back({"white level of the angle in radians", found.level, given > 0 ? given : found.noise,
                               words_of_level(found, given),
                               "nothing: this does not decide; lines and continuum are what stands above it"});
    result.evidence.push_back(
        {"distances from a straight line, range in radians", found.range, 1.1 * found.resolution,
         found.is_straight() ? "rounding alone explains it: S is constant" : "it is more than rounding makes",
         found.is_straight() ? "a larger range: lines and continuum decide"
                             : "at most " + in_words(1.1 * found.resolution) + ": steady"});
    if (found.is_straight()) return;
    const double all = found.slow + found.in_lines + found.in_continuum;
    const double slow = all > 0 ? found.slow / all : 0;
    result.evidence.push_back(
        {"share of S that drifts", slow, 0.5, slow > 0.5 ? "S still settles" : "S keeps its mean",
         slow > 0.5 ? "at most 0.5: lines and continuum decide" : "above 0.5: undecided, since S still settles"});
    if (slow > 0.5) return;
    result.evidence.push_back({"lines in the spectrum of the angle", static_cast<double>(found.lines), 1,
                               words_of_lines(found),
                               found.lines > 0 ? "no line: steady, if there is no continuum"
                                               : "a line or more: quasi-steady, if there is no continuum"});
    result.evidence.push_back({"share of the continuum in S", believed_share(found), few_continuum,
                               words_of_continuum(found), other_continuum_in_words(found)});
    if (found.lines > 0 || found.in_continuum > 0 || found.uncertain == 0) return;
    result.evidence.push_back({"lines that rounding may have made", static_cast<double>(found.uncertain), 0,
                               "rounding may make lines of their size",
                               "no such lines: steady; larger ones: quasi-steady"});
}

}  // namespace

Classification classify_angle(std::span<const double> angle, double spacing, const ClassifySeriesOptions& options,
                              double resolution) {
    const AngleSpectrum measured = spectrum_of_angle(angle, spacing, 0, resolution);
    const AngleSpectrum found = spectrum_of_angle(angle, spacing, options.noise, resolution);
    Classification result;
    result.steps = static_cast<std::int64_t>(angle.size());
    result.mean = found.rate;
    std::vector<double> rates;
    for (std::size_t i = 1; i < angle.size(); ++i) rates.push_back((angle[i] - angle[i - 1]) / spacing);
    const auto rate = recurrence::recurrence_rate(recurrence::embed_series(rates), options.recurrence_threshold);
    result.recurrence_rate = rate.with_diagonal();
    result.recurrence_rate_without_diagonal = rate.without_diagonal();
    describe(found, options.noise, result);
    const Verdict verdict = judge(found), by_level = judge(measured);
    const bool contradicts = options.noise > near_level * found.level && verdict.mode != by_level.mode;
    const double agreement =
        verdict.mode == Mode::quasi_steady ? agreement_of_halves(angle, spacing, options.noise, resolution) : 1;
    if (agreement < least_of_other_half) {
        result.kind = Kind::transient;
        result.evidence.push_back(
            {"variance of S in one half over the other", agreement, least_of_other_half,
             agreement > 0 ? "S still settles: its lines die out or grow" : "S still settles: one half alone is steady",
             "above " + in_words(least_of_other_half) +
                 ": quasi-steady; a later half alone (--transient) may be what it settles on"});
    } else if (contradicts) {
        result.evidence.push_back(
            {"noise given in radians", options.noise, near_level * found.level,
             "more than the angle shows, and without it the verdict is " + std::string(name_of(by_level.mode)),
             "at most " + in_words(near_level * found.level) + ": " + std::string(name_of(by_level.mode))});
    } else {
        result.mode = verdict.mode;
        result.kind = verdict.kind;
    }
    return result;
}

}  // namespace swirl::analysis
