#include "apps/modes/settled_cycle.hpp"

#include "apps/modes/name_mode.hpp"
#include "apps/modes/verdict_in_words.hpp"
#include "apps/system/section_coordinates.hpp"

#include <Eigen/Core>

#include <fmt/format.h>

namespace swirl::apps {

SettledCycle settled_cycle(const Scene<double>& scene, const Start<double>& start, Accuracy accuracy,
                           const std::function<bool()>& stop) {
    const NamedMode named = name_mode(scene, start, {}, accuracy, stop);
    SettledCycle settled;
    if (!named.finished) return settled;
    settled.mode = mode_in_words(named.verdict);
    const std::vector<double>& point = named.verdict.point;
    if (point.empty()) return settled;
    settled.point = section_point_of(Eigen::Map<const Eigen::VectorXd>(point.data(), std::ssize(point)));
    settled.period = static_cast<int>(named.verdict.period);
    return settled;
}

std::string no_cycle_in_words(const SettledCycle& settled) {
    return fmt::format("swirl: the start settles on no cycle to go on from: {}", settled.mode);
}

}  // namespace swirl::apps
