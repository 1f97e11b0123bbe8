// The three ladders of a scene, and what they advise.
#pragma once

#include "apps/studies/tradeoff/arithmetic_orbit.hpp"
#include "apps/studies/tradeoff/compare_flights.hpp"
#include "apps/studies/tradeoff/evidence.hpp"
#include "apps/studies/tradeoff/models.hpp"
#include "apps/studies/tradeoff/risk_ladder.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::tradeoff {

/// How much is counted with a budget: fixed numbers, so that equal arguments give equal results.
struct Amounts {
    explicit Amounts(double budget);

    std::int64_t transient;        ///< impacts before the flights that are drawn
    std::int64_t flights;          ///< drawn at most
    std::int64_t orbit;            ///< impacts of each arithmetic's own orbit
    std::int64_t most_collisions;  ///< of a verdict
    std::int64_t runs;             ///< starts of the verdicts, at most
    std::int64_t risk_runs;        ///< starts at which a risk is tried, at most
};

/// Fewer impacts are enough where, at 95 %, less than this share of the starts has another mode on the most.
inline constexpr double may_change = 0.1;

/// … and where mean S differs from that on the most by less than this, as a root mean square over the starts.
inline constexpr double mean_may_differ = 0.05;

/// At the knee a step errs by at most so many roundings of a double. Double's own errors are below.
inline constexpr double roundings_at_knee = most_roundings;

/// An arithmetic. `flights` is empty of the last, with which the others are compared; so are differences to it.
struct ArithmeticRow {
    const Arithmetic* arithmetic = nullptr;
    Timing time;
    std::optional<FlightComparison> flights;
    std::optional<ArithmeticOrbit> orbit;  ///< none without flights, or where the budget was spent
    double mean_spin_off = std::nan("");   ///< mean S less the last arithmetic's
    double exponent_off = std::nan("");    ///< largest exponent less the last arithmetic's
    /// Mode, period or outcome is not the last arithmetic's; none where one of the two orbits names no mode, being too
    /// short, or one stays in contact and the other has not gone on for a turn of the swirl longer.
    std::optional<bool> verdict_differs;
};

struct ModelRow {
    std::string name, paid_by;
    Timing with, without;
    double added() const { return with.median - without.median; }
};

struct Tradeoff {
    std::vector<ArithmeticRow> arithmetics;
    Evidence evidence;
    std::vector<RiskRow> risk;  ///< none where the start is given, or the budget was spent
    std::vector<ModelRow> model;
    DrawnFlights drawn;
    std::int64_t compared = 0;                ///< flights
    const Arithmetic* recommended = nullptr;  ///< none: `reason` says why
    const Arithmetic* knee = nullptr;         ///< none: nothing could be compared, or timed
    std::int64_t enough_collisions =
        0;  ///< the fewest impacts that are enough (`may_change`, `mean_may_differ`); 0: none below the most
    double recommended_risk = 0;  ///< of those in `risk` (risk_ladder.hpp); 0: call nothing before the limits
    std::string reason;           ///< why that arithmetic, or why none
    std::string advice;           ///< a sentence
    bool cut_short = false;       ///< the budget was spent before all that it should hold was counted
};

/// Measures. Takes about the budget.
Tradeoff measure(const Scene<double>& scene, const OrbitStarts& starts, const Amounts& amounts, const Budget& budget,
                 const RunControl& control = {});

/// The cheapest arithmetic of those of --accuracy whose verdict does not differ from the last one's and which missed or
/// misordered no contact; the knee; the fewest impacts that are enough, on that number and on all larger ones. Fills
/// what is recommended, and why.
/// The knee of work against precision is the cheapest arithmetic of all that found every contact and whose error of one
/// step is nowhere above `roundings_at_knee` ε c, ε of double, c the step's condition: from there on digits cost time
/// and are more than a double holds.
void recommend(Tradeoff& found);

}  // namespace swirl::studies::tradeoff
