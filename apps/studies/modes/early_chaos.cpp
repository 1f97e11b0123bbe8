#include "apps/studies/modes/early_chaos.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/classification/escape_rate.hpp"
#include "analysis/classification/follow_until_settled.hpp"
#include "analysis/random_draws.hpp"
#include "apps/studies/modes/attractors.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace swirl::studies {

namespace {

// A sampled run is never called, and the others have the changed ones that the sample lacks: where no more than a
// third of the runs is drawn, questions at 97.5 % keep 95 % for those that are called.
constexpr double confidence = 0.975;
constexpr std::size_t largest_part = 3;
// Nothing is called where that has a smaller chance than this, by what the sample has shown so far.
constexpr double hopeless = 0.001;
constexpr std::uint64_t stream_of_samples = 0x7269736b;  // "risk"

void require_risk(double risk) {
    if (!(risk >= 0 && risk < 1)) analysis::refuse("risk", risk, "0 or more, below 1");
}

/// How many runs without another verdict among them tell that fewer than the risk have one.
std::int64_t fewest_judged(double risk) {
    constexpr double more_than_runs = 1e15;
    const double fewest = std::floor(std::log(1 - confidence) / std::log1p(-risk)) + 1;
    return static_cast<std::int64_t>(std::min(fewest, more_than_runs));
}

/// How many candidates are to be judged.
std::int64_t wanted_of(double risk, std::int64_t runs) {
    return std::max(2 * fewest_judged(risk), runs / 16);
}

/// How many runs are drawn for so many candidates more, if they are such a share of them.
std::size_t draws_for(double candidates, double share) {
    return static_cast<std::size_t>(1.05 * candidates / share) + 1;
}

/// True if a sample of so many runs may be a third of them, should all be candidates.
bool is_enough(std::int64_t runs, double risk) {
    return draws_for(static_cast<double>(wanted_of(risk, runs)), 1) <= static_cast<std::size_t>(runs) / largest_part;
}

/// A candidate of the sample.
struct Judged {
    double score = 0;
    bool changed = false;
};

/// Runs whose cells have been looked at.
class LookedAt {
public:
    LookedAt(const RiskQuestion& question, const RunsAtRisk& runs)
        : question_(question), runs_(runs), seen_(question.runs) {}

    /// Looks at all runs of these runs' cells. False if it was stopped.
    bool look_at(std::span<const std::size_t> runs) {
        std::vector<std::size_t> cells, missing;
        for (const std::size_t run : runs) cells.push_back(run / question_.each);
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        for (const std::size_t cell : cells)
            for (std::size_t run = cell * question_.each; run < (cell + 1) * question_.each; ++run)
                if (!seen_[run]) missing.push_back(run);
        const auto found = runs_.follow(missing, question_.look);
        if (!found) return false;
        for (std::size_t i = 0; i < missing.size(); ++i) seen_[missing[i]] = (*found)[i];
        return true;
    }
    bool has_seen(std::size_t run) const { return seen_[run].has_value(); }
    const SeenRun& seen(std::size_t run) const { return *seen_[run]; }
    /// The mean exponent of the run's cell; none where a run of it is not chaotic.
    std::optional<double> score(std::size_t run) {
        const std::size_t first = run / question_.each * question_.each;
        if (first == scored_) return score_;
        scored_ = first;
        double sum = 0;
        for (std::size_t i = first; i < first + question_.each; ++i) {
            if (!seen_[i]->chaotic) return score_ = std::nullopt;
            sum += seen_[i]->exponent;
        }
        return score_ = sum / static_cast<double>(question_.each);
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t scored_ = none;  ///< the first run of the cell whose score was asked last
    std::optional<double> score_;
    const RiskQuestion& question_;
    const RunsAtRisk& runs_;
    std::vector<std::optional<SeenRun>> seen_;
};

struct Sample {
    std::vector<std::size_t> drawn;
    std::vector<Judged> judged;   ///< the candidates among them
    std::vector<char> at_limits;  ///< of all runs, 1 of each that was followed to the limits
    bool too_few = false;         ///< candidates for a question
    bool refuted = false;         ///< the first question, before all are drawn
};

/// Adds these runs to the sample, the candidates of them followed to the limits. False if it was stopped.
bool judge(std::span<const std::size_t> drawn, const RunsAtRisk& runs, LookedAt& looked, Sample& sample) {
    if (!looked.look_at(drawn)) return false;
    std::vector<std::size_t> candidates;
    for (const std::size_t run : drawn)
        if (looked.score(run)) candidates.push_back(run);
    const auto limits = runs.follow(candidates, 0);
    if (!limits) return false;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        sample.judged.push_back({*looked.score(candidates[i]), !(*limits)[i].chaotic});
        sample.at_limits[candidates[i]] = 1;
    }
    sample.drawn.insert(sample.drawn.end(), drawn.begin(), drawn.end());
    return true;
}

void sort_by_score(std::vector<Judged>& judged) {
    std::stable_sort(judged.begin(), judged.end(), [](const Judged& a, const Judged& b) { return a.score > b.score; });
}

/// True if the third of all runs that may be drawn has so many candidates with a chance below `hopeless` only.
bool has_too_few(const RiskQuestion& question, std::int64_t wanted, const Sample& sample) {
    const double most = analysis::most_rate(std::ssize(sample.judged), std::ssize(sample.drawn), 1 - hopeless);
    return most * static_cast<double>(question.runs / largest_part) < static_cast<double>(wanted);
}

/// True if the first question, which allows of no run with another verdict, will be answered with no but for a chance
/// below `hopeless`. It is about the `asked` surest of all candidates, each of which is among those of now with the
/// chance `part`. Where more than `above` of them are, the surest run with another verdict is one of them.
bool is_refuted(double risk, std::int64_t wanted, std::vector<Judged> judged) {
    sort_by_score(judged);
    const auto first = std::find_if(judged.begin(), judged.end(), [](const Judged& one) { return one.changed; });
    const std::int64_t above = first - judged.begin(), asked = fewest_judged(risk);
    if (above >= std::min(asked, std::ssize(judged))) return false;
    constexpr double drawn_beyond = 1.1;  // as many as wanted, and some of the last draws
    const double part = static_cast<double>(judged.size()) / (drawn_beyond * static_cast<double>(wanted));
    return part > analysis::most_rate(above, asked, 1 - hopeless);
}

/// Draws until so many candidates are judged, no run is left, or nothing can be called any more. To look for that
/// earlier large draws are judged in four parts. None if it was stopped.
std::optional<Sample> draw(const RiskQuestion& question, std::int64_t wanted, const RunsAtRisk& runs,
                           LookedAt& looked) {
    constexpr std::size_t most_parts = 4, least_of_a_part = 64;
    RandomOrder order(question.runs, question.seed);
    Sample sample;
    sample.at_limits.assign(question.runs, 0);
    while (std::ssize(sample.judged) < wanted && order.left() > 0) {
        const auto missing = static_cast<double>(wanted - std::ssize(sample.judged));
        const double share = std::max(static_cast<double>(sample.judged.size()), 1.0) /
                             std::max(static_cast<double>(sample.drawn.size()), 1.0);
        const auto drawn = order.take(draws_for(missing, share));
        const std::size_t parts = std::clamp(drawn.size() / least_of_a_part, std::size_t{1}, most_parts);
        for (std::size_t i = 0; i < parts; ++i) {
            const std::size_t first = i * drawn.size() / parts, end = (i + 1) * drawn.size() / parts;
            if (!judge(std::span(drawn).subspan(first, end - first), runs, looked, sample)) return std::nullopt;
            sample.too_few = has_too_few(question, wanted, sample);
            sample.refuted = is_refuted(question.risk, wanted, sample.judged);
            if (sample.too_few || sample.refuted) return sample;
        }
    }
    sample.too_few = sample.drawn.size() > question.runs / largest_part;
    return sample;
}

/// What the first question would be about, as far as it is drawn.
void take_down_refuted(std::vector<Judged> judged, double risk, RiskEvidence& evidence) {
    sort_by_score(judged);
    evidence.judged = std::min(fewest_judged(risk), std::ssize(judged));
    evidence.changed =
        std::count_if(judged.begin(), judged.begin() + evidence.judged, [](const Judged& one) { return one.changed; });
    evidence.bound = analysis::most_rate(evidence.changed, evidence.judged, confidence);
}

/// Asks about more and more candidates, by falling score, and takes down the last answer that is below the risk. Those
/// of one score go together; the first question is about as many as can be answered so at all.
void ask(std::vector<Judged> judged, double risk, RiskEvidence& evidence) {
    sort_by_score(judged);
    const std::int64_t fewest = fewest_judged(risk), step = std::max<std::int64_t>(1, fewest / 10);
    std::int64_t next = fewest, changed = 0;
    for (std::int64_t n = 1; n <= std::ssize(judged); ++n) {
        const Judged& last = judged[static_cast<std::size_t>(n - 1)];
        changed += last.changed ? 1 : 0;
        const bool is_last = n == std::ssize(judged);
        if (n < next && !(is_last && n >= fewest)) continue;
        if (!is_last && judged[static_cast<std::size_t>(n)].score == last.score) continue;
        next = n + step;
        const double bound = analysis::most_rate(changed, n, confidence);
        const bool is_below = bound < risk;
        if (is_below) evidence.least_exponent = last.score;
        if (is_below || evidence.judged == 0) {
            evidence.judged = n;
            evidence.changed = changed;
            evidence.bound = bound;
        }
        if (!is_below) return;
    }
}

/// A run that is called, whose mean has a larger error than is wanted.
struct RoughMean {
    std::size_t run = 0;
    std::int64_t look = 0;
    double error = 0;  ///< there
};

bool is_mean_known(const SeenRun& seen, const RiskQuestion& question) {
    return seen.mean_error <= question.error || std::isinf(question.error);
}

/// The first look at which an error that falls with the root of the impacts is small enough, the next one of a tail too
/// short to tell an error; 0: none before the limits.
std::int64_t look_for_mean(const RoughMean& mean, const RiskQuestion& question) {
    namespace detail = analysis::classification_detail;
    const double times = std::isnan(mean.error) ? 1 : std::max(mean.error / question.error, 1.0);
    const double wanted = times * times * static_cast<double>(mean.look);
    std::int64_t look = detail::next_look(mean.look);
    while (look <= question.last_look && static_cast<double>(look) < wanted) look = detail::next_look(look);
    return look <= question.last_look && static_cast<double>(look) >= wanted ? look : 0;
}

/// Follows these to later looks until their means are known; those that need the limits, or are not chaotic any more
/// and not settled, are added to `left`. False if it was stopped.
bool follow_means(const RiskQuestion& question, std::vector<RoughMean> rough, const RunsAtRisk& runs,
                  std::vector<std::size_t>& left) {
    while (!rough.empty()) {
        std::map<std::int64_t, std::vector<std::size_t>> at_look;
        for (const RoughMean& mean : rough) {
            const std::int64_t look = look_for_mean(mean, question);
            (look > 0 ? at_look[look] : left).push_back(mean.run);
        }
        rough.clear();
        for (const auto& [look, some] : at_look) {
            const auto seen = runs.follow(some, look);
            if (!seen) return false;
            for (std::size_t i = 0; i < some.size(); ++i) {
                const SeenRun& now = (*seen)[i];
                if (now.known || (now.chaotic && is_mean_known(now, question)))
                    runs.keep(some[i]);
                else if (now.chaotic)
                    rough.push_back({some[i], look, now.mean_error});
                else
                    left.push_back(some[i]);
            }
        }
    }
    std::sort(left.begin(), left.end());
    return true;
}

}  // namespace

SeenRun seen_of(analysis::Kind kind, Outcome outcome, double exponent, double mean_error) {
    const bool chaotic = kind == analysis::Kind::chaotic;
    return {!chaotic && (kind != analysis::Kind::none || outcome != Outcome::completed), chaotic, exponent, mean_error};
}

std::int64_t early_look(const analysis::ClassifyOptions& limits) {
    namespace detail = analysis::classification_detail;
    constexpr std::int64_t part = 9, least = 432;
    std::int64_t look = detail::first_look;
    while (look < least || detail::next_look(look) <= (limits.transient + limits.collisions) / part)
        look = detail::next_look(look);
    return look <= limits.transient ? look : 0;
}

std::int64_t last_look(const analysis::ClassifyOptions& limits) {
    namespace detail = analysis::classification_detail;
    std::int64_t last = 0;
    for (std::int64_t look = detail::next_look(detail::first_look); look <= limits.transient;
         look = detail::next_look(look))
        last = look;
    return last;
}

std::optional<FollowedAtRisk> follow_at_risk(const RiskQuestion& question, std::span<const std::size_t> own,
                                             const RunsAtRisk& runs) {
    require_risk(question.risk);
    FollowedAtRisk followed;
    RiskEvidence& evidence = followed.evidence;
    evidence.runs = static_cast<std::int64_t>(question.runs);
    const auto to_limits = [&](std::span<const std::size_t> some) {
        return runs.follow(some, 0) ? std::optional(followed) : std::nullopt;
    };
    if (question.risk == 0 || question.look == 0) return to_limits(own);
    evidence.least_runs = least_runs(question.risk);
    if (!is_enough(evidence.runs, question.risk)) return to_limits(own);
    LookedAt looked(question, runs);
    const auto sample = draw(question, wanted_of(question.risk, evidence.runs), runs, looked);
    if (!sample) return std::nullopt;
    followed.sample = sample->drawn;
    evidence.drawn = std::ssize(sample->drawn);
    evidence.followed = std::ssize(sample->judged);
    if (sample->refuted)
        take_down_refuted(sample->judged, question.risk, evidence);
    else if (!sample->too_few)
        ask(sample->judged, question.risk, evidence);
    if (!std::isnan(evidence.least_exponent)) evidence.impacts = question.look;
    if (evidence.impacts > 0 && !looked.look_at(own)) return std::nullopt;
    std::vector<std::size_t> left;
    std::vector<RoughMean> rough;
    for (const std::size_t run : own) {
        if (sample->at_limits[run]) continue;  // it has its verdict
        if (!looked.has_seen(run)) {
            left.push_back(run);
            continue;
        }
        const auto score = looked.score(run);
        const SeenRun& seen = looked.seen(run);
        const bool is_called = evidence.impacts > 0 && score && *score >= evidence.least_exponent;
        if (is_called && !is_mean_known(seen, question))
            rough.push_back({run, question.look, seen.mean_error});
        else if (is_called || seen.known)
            runs.keep(run);
        else
            left.push_back(run);
    }
    evidence.means_followed = std::ssize(rough);
    if (!follow_means(question, std::move(rough), runs, left)) return std::nullopt;
    return to_limits(left);
}

std::int64_t least_runs(double risk) {
    require_risk(risk);
    if (risk == 0) return 0;
    // A sixteenth of so few runs is less than twice the fewest.
    return static_cast<std::int64_t>(largest_part * draws_for(static_cast<double>(2 * fewest_judged(risk)), 1));
}

bool has_attracting_steady_mode(const Scene<double>& scene) {
    return !steady_shares(scene, {}).empty();
}

std::int64_t look_of_one(double risk, const analysis::ClassifyOptions& limits) {
    namespace detail = analysis::classification_detail;
    require_risk(risk);
    const std::int64_t all = limits.transient + limits.collisions;
    std::int64_t before = detail::first_look, look = detail::next_look(before);
    for (; before <= limits.transient && look < all; before = std::exchange(look, detail::next_look(look)))
        if (analysis::chance_of_leaving(0, static_cast<double>(look), static_cast<double>(all - look)) < risk)
            return look;
    return 0;
}

std::vector<std::size_t> RandomOrder::take(std::size_t count) {
    const auto at = [this](std::size_t place) {
        const auto found = moved_.find(place);
        return found == moved_.end() ? place : found->second;
    };
    std::vector<std::size_t> drawn;
    for (; drawn.size() < count && left() > 0; ++taken_) {
        const std::uint64_t bits = analysis::random_bits({taken_, 0, 0, 0}, {seed_, stream_of_samples})[0];
        const std::size_t place = taken_ + bits % left();
        drawn.push_back(at(place));
        moved_[place] = at(taken_);
    }
    return drawn;
}

std::size_t RiskPieces::number(std::size_t run, std::int64_t to) const {
    std::size_t level = to > 0 ? 1 : 0;
    for (std::int64_t at = look; at < to; at = analysis::classification_detail::next_look(at)) ++level;
    return level * runs + run;
}

std::vector<RiskPieces::Group> RiskPieces::groups(std::span<const std::size_t> pieces) const {
    std::map<std::size_t, std::vector<std::size_t>> by_level;
    for (const std::size_t piece : pieces) by_level[piece / runs].push_back(run(piece));
    std::vector<Group> groups;
    for (auto& [level, some] : by_level) {
        std::int64_t to = level > 0 ? look : 0;
        for (std::size_t l = 1; l < level; ++l) to = analysis::classification_detail::next_look(to);
        groups.push_back({to, std::move(some)});
    }
    return groups;
}

}  // namespace swirl::studies
