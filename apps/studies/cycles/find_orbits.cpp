#include "apps/studies/cycles/find_orbits.hpp"

#include "analysis/cycles/find_cycles.hpp"
#include "apps/studies/cycles/steady_cycles.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace swirl::studies::cycles {

namespace {

using analysis::CyclePoints;

/// One task of the searches of all periods. That of period k counts k times, as a candidate costs k impacts; a search
/// that goes on takes half of what is left of it each time.
class SearchProgress {
public:
    SearchProgress(const FindOptions& options)
        : complete_(options.complete),
          report_(options.control.begin("orbits", before(options.first_period, options.last_period + 1))) {
        first_ = options.first_period;
    }

    void begin(int period) {
        begun_ = before(first_, period);
        left_ = period;
    }
    void begin_round() {
        round_ = complete_ ? left_ / 2 : left_;
        left_ -= round_;
    }
    void end_round() { begun_ += round_; }
    /// `share` of the round's candidates are tried.
    void at(double share) { report_(begun_ + round_ * share); }

private:
    static double before(int first, int period) {
        double sum = 0;
        for (int k = first; k < period; ++k) sum += k;
        return sum;
    }

    bool complete_;
    int first_ = 1;
    double begun_ = 0, round_ = 0, left_ = 0;
    ReportDone report_;
};

/// What the search for one period works with.
struct PeriodWork {
    const Scene<double>& scene;
    const analysis::ShootingMap& map;
    const FindOptions& options;
    int period;
    analysis::SearchOptions search;
    SearchProgress& progress;
};

/// Contact comes of impacts that lose, or of a vertex that friction holds (map/orbit/return_map.hpp).
bool can_land(const Scene<double>& scene) {
    return scene.restitution < 1 || (!scene.is_disk() && scene.mu > 0);
}

void try_candidates(const PeriodWork& work, const std::vector<CyclePoints>& candidates, analysis::KnownCycles& known,
                    PeriodSearch& result) {
    analysis::SearchOptions search = work.search;
    work.progress.begin_round();
    search.progress = [&](double done) { work.progress.at(done / static_cast<double>(candidates.size())); };
    const auto counts = analysis::add_cycles(work.map, 0, candidates, search, known);
    work.progress.end_round();
    result.tried += counts.tried;
    result.converged += counts.converged;
    result.unseen = analysis::unseen_cycles(known.times_found());
}

/// More random starts, twice as many each time, until nothing seems to be missing.
void search_on(const PeriodWork& work, std::int64_t tried, analysis::KnownCycles& known, PeriodSearch& result) {
    constexpr double none = 0.5;  // an estimate that rounds to no cycle
    const FindOptions& options = work.options;
    result.wants_more = true;
    while (result.wants_more && tried < options.most_starts && !options.control.is_stopped()) {
        const std::int64_t next = std::min(options.most_starts, std::max<std::int64_t>(2 * tried, 100));
        const std::int64_t before = result.unseen.found;
        try_candidates(
            work,
            random_candidates(work.scene, work.map, work.period, tried, next, options.candidates, options.control.stop),
            known, result);
        tried = next;
        result.wants_more = result.unseen.missed >= none || result.unseen.found > before;
    }
}

void search_period(const PeriodWork& work, const std::vector<CyclePoints>& trajectories, FoundOrbits& found) {
    const FindOptions& options = work.options;
    PeriodSearch result;
    result.period = work.period;
    work.progress.begin(work.period);
    analysis::KnownCycles known(work.map, 0, analysis::same_cycle, true);
    auto candidates = returning_candidates(work.map, work.period, trajectories, options.candidates);
    auto random = random_candidates(work.scene, work.map, work.period, 0, options.candidates.starts, options.candidates,
                                    options.control.stop);
    std::move(random.begin(), random.end(), std::back_inserter(candidates));
    try_candidates(work, candidates, known, result);
    if (options.complete) search_on(work, options.candidates.starts, known, result);
    auto cycles = known.completed(options.control.threads);
    if (work.period == 1 && work.scene.has_drag()) {
        auto others = dragged_cycles(work.scene, work.map, options.max_time, options.control, cycles);
        result.from_equations = static_cast<std::int64_t>(others.size());
        std::move(others.begin(), others.end(), std::back_inserter(cycles));
    }
    std::move(cycles.begin(), cycles.end(), std::back_inserter(found.cycles));
    found.tried += result.tried;
    found.converged += result.converged;
    found.searches.push_back(result);
}

}  // namespace

FoundOrbits find_orbits(const Scene<double>& scene, const analysis::ShootingMap& map, const FindOptions& options) {
    FoundOrbits found;
    found.none_exist = is_dissipative_without_drive(scene);
    if (found.none_exist) return found;
    const auto stopped = [&] { return options.control.is_stopped(); };
    // Over a floor that drags, and of rounded corners, fixed points are searched for as other cycles are.
    const bool known_from_equations = !scene.has_own_map();
    if (options.first_period == 1 && known_from_equations)
        found.steady = find_steady_cycles(scene, map, options.max_time, stopped, options.control.threads,
                                          options.candidates.accuracy, found.cycles);
    const bool searches = options.last_period > 1 || can_land(scene) || !known_from_equations;
    const auto trajectories =
        searches ? trajectories_of(scene, options.candidates, options.control.stop) : std::vector<CyclePoints>{};
    const auto timed = known_from_equations ? timed_map_of(scene) : analysis::TimedMap{};
    SearchProgress progress(options);
    for (int k = options.first_period; k <= options.last_period && !stopped(); ++k) {
        if (k == 1 && known_from_equations && !can_land(scene)) continue;
        PeriodWork work{scene, map, options, k, {}, progress};
        work.search.period = k;
        work.search.accept = accepted;
        work.search.timed = known_from_equations ? &timed : nullptr;
        work.search.threads = options.control.threads;
        work.search.stop = options.control.stop;
        work.search.shooting.one_of_many = true;
        if (k == 1 && known_from_equations)  // those of impacts alone are known from their equations
            work.search.wanted = [&](const CyclePoints& points) {
                return letter_from(map.step(points.front(), 0).letter).through_contact;
            };
        search_period(work, trajectories, found);
    }
    found.interrupted = stopped();
    return found;
}

}  // namespace swirl::studies::cycles
