#include "apps/studies/tradeoff/tradeoff.hpp"

#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>

namespace swirl::studies::tradeoff {

// A step in quad takes some 60 microseconds, verdicts up the ladder to n impacts some 4 n and a tenth of a second: on
// one thread the flights take an eighth of the budget, the orbits a twentieth, the verdicts a third. A run of chaos to
// the look and to the limits takes some 7 ms in lanes: those of a risk a third.
Amounts::Amounts(double budget)
    : transient(10'000),
      flights(static_cast<std::int64_t>(std::clamp(1000 * budget, 100.0, 1e7))),
      orbit(static_cast<std::int64_t>(std::clamp(200 * budget, 200.0, 1e6))),
      most_collisions(static_cast<std::int64_t>(std::clamp(1000 * budget, 300.0, 1e7))),
      runs(static_cast<std::int64_t>(std::clamp(6.4 * budget, 8.0, static_cast<double>(most_starts)))),
      risk_runs(static_cast<std::int64_t>(std::clamp(45 * budget, 8.0, 1e5))) {}

namespace {

/// Each arithmetic's own orbit; none of those that the budget was spent on.
void follow_orbits(const Scene<double>& scene, const PostImpactState<double>& begin, std::int64_t count,
                   const Budget& budget, const RunControl& control, Tradeoff& found) {
    const auto orbits = std::make_shared<std::vector<std::optional<ArithmeticOrbit>>>(found.arithmetics.size());
    std::vector<const Arithmetic*> arithmetics;
    for (const auto& row : found.arithmetics) arithmetics.push_back(row.arithmetic);
    // The last arithmetic takes longest, and so comes first.
    run_pieces(arithmetics.size(), "tradeoff: orbits", control, [=, &budget](std::size_t i) -> KeepResult {
        const std::size_t r = arithmetics.size() - 1 - i;
        const auto orbit = orbit_by(*arithmetics[r], scene, begin, count, budget);
        return [orbits, r, orbit] { (*orbits)[r] = orbit; };
    });
    for (std::size_t r = 0; r < found.arithmetics.size(); ++r) {
        found.arithmetics[r].orbit = (*orbits)[r];
        if (!found.arithmetics[r].orbit) found.cut_short = true;
    }
}

/// Whether an orbit was long enough for a verdict.
bool names_a_mode(const ArithmeticOrbit& orbit) {
    return orbit.mode != analysis::Mode::undecided || orbit.outcome != Outcome::completed;
}

bool is_same_verdict(const ArithmeticOrbit& a, const ArithmeticOrbit& b) {
    return a.mode == b.mode && a.period == b.period && a.outcome == b.outcome;
}

/// Of two orbits of which one stays in contact the other has to go on for a turn of the swirl longer: in more digits
/// chatter takes more impacts to the same end.
bool has_gone_as_far(const ArithmeticOrbit& a, const ArithmeticOrbit& b) {
    const auto stays = [](const ArithmeticOrbit& orbit) {
        return orbit.outcome == Outcome::in_contact || orbit.outcome == Outcome::contact_cut;
    };
    const auto goes_on = [](const ArithmeticOrbit& orbit) { return orbit.outcome == Outcome::completed; };
    const double turn = 2 * std::numbers::pi;
    if (stays(a) && goes_on(b)) return b.duration > a.duration + turn;
    if (stays(b) && goes_on(a)) return a.duration > b.duration + turn;
    return true;
}

void compare_orbits(Tradeoff& found) {
    const auto& last = found.arithmetics.back().orbit;
    for (auto& row : found.arithmetics) {
        if (&row == &found.arithmetics.back() || !row.orbit || !last) continue;
        row.mean_spin_off = row.orbit->mean_spin - last->mean_spin;
        row.exponent_off = row.orbit->largest_exponent - last->largest_exponent;
        if (names_a_mode(*row.orbit) && names_a_mode(*last) && has_gone_as_far(*row.orbit, *last))
            row.verdict_differs = !is_same_verdict(*row.orbit, *last);
    }
}

/// Times of the arithmetics and of the pieces of the model, all in turn.
void time_all(const Scene<double>& scene, const Budget& budget, const RunControl& control, Tradeoff& found) {
    if (found.drawn.timed.empty()) return;
    std::vector<TimedWork> works;
    for (const auto& row : found.arithmetics) {
        const ArithmeticMap map = row.arithmetic->make(scene, found.drawn.timed);
        works.push_back(
            [run = map.run, steps = found.drawn.timed_steps, first = std::size_t{0}](std::size_t n) mutable {
                const std::int64_t impacts = run(first, n, steps);
                first += n;
                return impacts;
            });
    }
    const std::vector<ModelPiece> pieces = model_pieces(scene, found.drawn);
    for (const ModelPiece& piece : pieces) {
        works.push_back(piece.with);
        if (piece.without) works.push_back(piece.without);
    }
    const ReportDone report = control.begin("tradeoff: times", budget.seconds());
    const std::vector<Timing> times = time_in_turn(works, budget, report);
    auto next = times.begin();
    for (auto& row : found.arithmetics) row.time = *next++;
    for (const ModelPiece& piece : pieces) {
        ModelRow row{piece.name, piece.paid_by, *next++, {}};
        if (piece.without) row.without = *next++;
        found.model.push_back(row);
    }
}

}  // namespace

Tradeoff measure(const Scene<double>& scene, const OrbitStarts& starts, const Amounts& amounts, const Budget& budget,
                 const RunControl& control) {
    Tradeoff found;
    for (const Arithmetic& arithmetic : all_arithmetics()) found.arithmetics.emplace_back().arithmetic = &arithmetic;
    found.evidence = gather_evidence(scene, starts, evidence_ladder(amounts.most_collisions), budget, control);
    OrbitStarts many = starts;
    if (many.is_random) many.count = most_starts;  // beginnings of orbits, where one orbit has too few flights
    found.drawn = draw_flights(scene, many, amounts.transient, amounts.flights, budget);
    if (found.drawn.begin) follow_orbits(scene, *found.drawn.begin, amounts.orbit, budget, control, found);
    compare_orbits(found);
    const ComparedFlights compared = compare_flights(scene, found.drawn.flights, all_arithmetics(), budget, control);
    found.compared = compared.flights;
    for (std::size_t r = 0; r < compared.arithmetics.size(); ++r)
        found.arithmetics[r].flights = compared.arithmetics[r];
    if (!found.evidence.whole || !compared.whole) found.cut_short = true;
    found.risk = measure_risks(scene, starts, amounts.risk_runs, budget, control);
    time_all(scene, budget, control, found);
    recommend(found);
    return found;
}

}  // namespace swirl::studies::tradeoff
