#include "analysis/curves/walk.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace swirl::analysis {

std::string_view name_of(CurveEnd end) {
    static constexpr std::array<std::string_view, 12> names{"plane",       "range",    "closed", "1:1",
                                                            "1:2",         "halved",   "border", "not-converged",
                                                            "most-points", "switched", "family", "stopped"};
    return names[static_cast<std::size_t>(end)];
}

std::string name_of(const CurveEnding& ending) {
    return ending.border.empty() ? std::string(name_of(ending.why)) : ending.border;
}

CurveEnd CurveWalk::run() {
    while (!has_ended_) step();
    return end_;
}

void CurveWalk::step() {
    if (stop_ && stop_()) return end(CurveEnd::stopped);
    if (static_cast<int>(count()) >= rule_.most_points) return end(CurveEnd::most_points);
    look_ahead();
    if (has_ended_) return;
    CurvePoint next;
    Correction outcome = correct(problem_, here(), length_, next);
    if (outcome == Correction::converged && !(problem_.product(here().tangent, next.tangent) > rule_.cosine))
        outcome = Correction::failed;
    if (outcome == Correction::converged && go_to(next)) {
        itinerary_behind_.clear();
        if (++successes_ > rule_.successes_before) length_ = std::min(rule_.growth * length_, rule_.longest);
        if (!has_ended_) look_back();
        return;
    }
    if (outcome == Correction::itinerary_changed) itinerary_behind_ = next.shooting.itinerary;
    restart(0.5 * length_);
    if (length_ < rule_.shortest) meet_end(outcome);
}

}  // namespace swirl::analysis
