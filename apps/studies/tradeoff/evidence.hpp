// The scene's verdict on fewer and more impacts.
#pragma once

#include "analysis/classification/escape_rate.hpp"
#include "apps/studies/modes/escape.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/tradeoff/drawn_flights.hpp"
#include "apps/studies/tradeoff/timing.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::studies::tradeoff {

/// The verdict on so many impacts after as many that are left out. NaN where not measured.
struct EvidenceRow {
    std::int64_t collisions = 0;
    RunVerdict verdict;                       ///< of the first start (name_mode)
    double mean_spin_error = std::nan("");    ///< standard error of mean S along that orbit (MeanErrors); 0: exact
    double mean_spin_off = std::nan("");      ///< mean S less that of the most impacts
    double mean_spin_differs = std::nan("");  ///< root mean square of the same over all starts
    double exponent_off = std::nan("");       ///< the same of the largest exponent
    std::int64_t runs = 0;                    ///< starts
    std::int64_t changed = 0;                 ///< of these, how many have another mode on the most impacts
    analysis::RateInterval changed_rate;
    double seconds = std::nan("");  ///< that the verdict on the first start took
};

/// Impacts after which a run counts as one in chaos, if it is: so many that no start is told from another by them, and
/// so few that chaos which ends within the verdict's impacts is still there.
inline constexpr std::int64_t chaos_judged_after = 100;

struct Evidence {
    std::vector<EvidenceRow> rows;               ///< by rising number of impacts
    std::optional<analysis::EscapeRate> escape;  ///< of the verdicts on the most; none where no run was in chaos
    bool whole = true;                           ///< false: the budget was spent before
    bool judged_most = true;                     ///< false: … before the most impacts were judged
};

/// The numbers of impacts: 100, 300, 1000, 3000 … up to `most`.
std::vector<std::int64_t> evidence_ladder(std::int64_t most);

/// Verdicts on each of these numbers, from each start: eight first, and twice as many each time as long as these fit
/// into the budget, up to starts.count. An orbit that has ended says the same on any larger number, and is not followed
/// again. Equal arguments give equal results but for `seconds` and `runs`, whatever the number of threads.
Evidence gather_evidence(const Scene<double>& scene, const OrbitStarts& starts, const std::vector<std::int64_t>& ladder,
                         const Budget& budget, const RunControl& control);

}  // namespace swirl::studies::tradeoff
