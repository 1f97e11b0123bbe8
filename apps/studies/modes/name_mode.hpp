// The mode of one orbit of a scene: the verdict that `classify`, `sweep`, `bifurcate` and `tour` share.
#pragma once

#include "analysis/classification/classify.hpp"
#include "analysis/classification/growth.hpp"
#include "apps/studies/modes/means.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/orbit/outcome.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace swirl::studies {

/// The verdict on one orbit, and how following it ended.
struct NamedMode {
    analysis::Classification verdict;
    MeanErrors mean_errors;  ///< of the verdict's means
    Outcome outcome = Outcome::completed;
    long long impacts = 0;
    Accuracy accuracy = Accuracy::double_precision;  ///< in which its orbit was followed
    analysis::GrowthExponent growth;                 ///< of the energy, by impacts, of one that is accelerated
    double limit_spin = analysis::nan;               ///< S* of a chord
    bool finished = true;  ///< false: stopped before there was a verdict; nothing else is meaningful then
};

/// The evidence of a landing: how many rebounds of its chatter its period does not count.
inline constexpr const char* rebounds_evidence = "rebounds of its chatter";

/// What else a verdict saw of its orbit.
struct OrbitSamples {
    std::vector<Eigen::VectorXd> points;       ///< coordinates of the tail; none where the orbit ended
    std::optional<SectionPoint<double>> last;  ///< of the orbit; none without impacts
};

/// Classifies one start of a scene. A pure function of its arguments, if it is not stopped.
///   accuracy  in which each step is computed (SceneMap)
///   samples   filled where it is given
/// @throws std::invalid_argument for a scene or start out of range
NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& settings,
                    Accuracy accuracy = Accuracy::double_precision, const analysis::Stop& stop = {},
                    OrbitSamples* samples = nullptr);

/// A start of a scene.
struct SceneStart {
    Scene<double> scene;
    Start<double> start;
};

/// What is asked of several orbits.
struct NamingOptions {
    analysis::ClassifyOptions settings;
    Accuracy accuracy = Accuracy::double_precision;
    analysis::Stop stop;
    bool samples = false;  ///< what the verdict saw of each orbit is given, too
    /// 0: orbits are followed to the limits. Else to this look alone, one of 192, 288, 432, 648 … (each half as many
    /// impacts again), when orbits are looked at. What has settled until then, or ended, has the verdict that it has at
    /// the limits; of the others the last third of these impacts is judged, and they are chaotic or without mode and
    /// kind.
    std::int64_t look = 0;
};

/// Takes what start number `place` comes to.
using TakeNamed = std::function<void(std::size_t place, const NamedMode& named, OrbitSamples& samples)>;

/// `name_mode` of each, the same to the bit, given to `take` as soon as it is known; nothing of those that are stopped.
/// Orbits of one shape and impact rule take their steps together (../scene_map/lanes.hpp) as long as these are ordinary
/// flights. For that they are held all at once: some 70 bytes for each impact that is judged.
void name_modes(std::span<const SceneStart> starts, const NamingOptions& options, const TakeNamed& take);

/// That of one orbit by itself. @throws std::invalid_argument as name_mode
NamedMode name_alone(const SceneStart& start, const NamingOptions& options, OrbitSamples* samples = nullptr);

/// How many are well named together: with more, lanes are no fuller.
std::size_t most_named_together();

}  // namespace swirl::studies
