// What one start settles on: its samples, period and mode.
#pragma once

#include "analysis/classification/mode.hpp"
#include "analysis/curves/shooting_residual.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/orbit/outcome.hpp"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace swirl::studies::diagrams {

struct SampleSettings {
    std::int64_t transient = 2500;                   ///< impacts before those that are kept
    std::int64_t collisions = 500;                   ///< impacts that are kept
    bool exhaustive = false;                         ///< all of them, whatever the verdict needs
    Accuracy accuracy = Accuracy::double_precision;  ///< in which they are followed
};

/// The limits of a verdict on such an orbit, unless it stays undecided.
analysis::ClassifyOptions limits_of(const SampleSettings& wanted);

/// Where the start of a sample came from.
enum class Origin { random, up, down };

struct Attractor {
    bool finished = false;  ///< false: stopped, and nothing else is meaningful
    Origin origin = Origin::random;
    std::int64_t start = 0;  ///< number of the random start
    Outcome outcome = Outcome::completed;
    analysis::Mode mode = analysis::Mode::undecided;
    analysis::Kind kind = analysis::Kind::none;
    std::int64_t impacts = 0;                ///< that its verdict was given on, from the start
    std::int64_t period = 0;                 ///< 0: none found
    double largest_exponent = std::nan("");  ///< per impact
    double distance = 0;                     ///< of the orbit's last state from the cycle, where there is one
    double mean_spin = std::nan("");         ///< time mean of S over the kept impacts, or over the period; NaN without
    double mean_spin_per_impact = std::nan("");
    MeanErrors mean_errors;             ///< of these two
    analysis::GrowthExponent growth;    ///< of one that is accelerated
    double limit_spin = analysis::nan;  ///< S* of one on a chord
    /// Each column has the coordinates of a state: the kept ones; on a cycle (`is_on_cycle`) one period of the orbit
    /// once it is on it, or of the polished cycle where it comes nearer so slowly that it is not on it after some
    /// 20,000 impacts.
    Eigen::MatrixXd states;
    std::optional<SectionPoint<double>> last;  ///< the orbit's last state; none without impacts
};

/// True if the states are one period of a cycle. An orbit that stays undecided may have a period all the same: its
/// states are all of its samples, tens of thousands; where the map ends on the way round they are fewer.
inline bool is_on_cycle(const Attractor& attractor) {
    return attractor.mode != analysis::Mode::undecided && attractor.period > 0 &&
           attractor.states.cols() == attractor.period;
}

/// The states as a list, as `analysis/cycles` takes them.
analysis::CyclePoints points_of(const Attractor& attractor);

/// Calls part(…) with each of its members, for who sends it elsewhere.
template <class Part>
void for_each_part(Attractor& attractor, Part&& part) {
    part(attractor.finished), part(attractor.origin), part(attractor.start), part(attractor.outcome);
    part(attractor.mode), part(attractor.kind), part(attractor.impacts), part(attractor.period);
    part(attractor.distance);
    part(attractor.mean_spin), part(attractor.mean_spin_per_impact), part(attractor.states), part(attractor.last);
    part(attractor.mean_errors), part(attractor.growth), part(attractor.limit_spin), part(attractor.largest_exponent);
}

/// Follows a start and names what it settles on: the verdict of `classify` (name_mode) with these counts of impacts; an
/// orbit that they leave undecided is followed on for as long as `classify` does. One that can only die away is waited
/// for. A stop is named (`finished` false); apart from that a pure function of its arguments. Cost: one step
/// of the map an impact, and a derivative, some four steps, for each that is kept; for orbits that stay undecided some
/// 20,000 impacts more.
/// @throws std::invalid_argument for a start out of range
Attractor settle(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings,
                 const analysis::Stop& stop = {});

/// Takes what start number `place` settles on.
using TakeAttractor = std::function<void(std::size_t place, const Attractor& attractor)>;

/// `settle` of each, the same to the bit, given to `take` as soon as it is known; nothing of those that a stop ended.
/// Orbits take their steps together (name_modes).
///   look  to which they are followed (NamingOptions), of scenes without an attracting steady mode; samples of chaos
///   are
///         those that are judged there. 0: to the limits
void settle_all(std::span<const SceneStart> starts, const SampleSettings& settings, const analysis::Stop& stop,
                const TakeAttractor& take, std::int64_t look = 0);

}  // namespace swirl::studies::diagrams
