#include "apps/studies/modes/rolling_bounces.hpp"

#include "analysis/special_values.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "map/dragged/floor_facts.hpp"
#include "map/model/impact.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <cmath>
#include <optional>
#include <vector>

namespace swirl::studies {

namespace {

using DiskMap = SceneMap<disk_dimension>;

/// Speed at which the disk leaves the wall, in the container's frame.
double leaving_speed(const Scene<double>& scene, const PostImpactState<double>& z) {
    return scene.beta * z.psi.y - z.vn;
}

/// Low bounces displace the motion in proportion to their speed v. Nothing couples the spin of sliding to them.
bool is_near(const Scene<double>& scene, const LockedRolling& rolling, const PostImpactState<double>& z) {
    const double v = leaving_speed(scene, z), bounce = 2 * v / rolling.force;
    return v > 0 && bounce <= longest_bounce && std::abs(std::atan2(z.psi.y, z.psi.x) - rolling.psi) <= bounce &&
           (scene.mu == 0 || scene.alpha * std::abs(z.spin - rolling.spin) <= v);
}

/// −d ln(v³/λ)/dt over the next impacts, by least squares; v³/λ of a bounce is v²τ/2. Nothing where one of them slips,
/// ends contact, or is not near rolling.
std::optional<double> measured_decay(const DiskMap& map, const Scene<double>& scene, const LockedRolling& rolling,
                                     PostImpactState<double> z) {
    std::vector<double> times, logarithms;
    double time = 0;
    for (int n = 0; n < rolling_bounces; ++n) {
        if (!is_near(scene, rolling, z)) return {};
        const auto step = map.advance(z);
        if (!step.alive) return {};
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact || (scene.mu > 0 && !ends_in_stick(letter.mode))) return {};
        times.push_back(time);
        logarithms.push_back(std::log(std::pow(leaving_speed(scene, z), 2) * step.duration));
        time += step.duration;
        z = step.state;
    }
    double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, sum = 0;
    gsl_fit_linear(times.data(), 1, logarithms.data(), 1, times.size(), &intercept, &slope, &c00, &c01, &c11, &sum);
    return -slope;
}

}  // namespace

void look_for_rolling(const DiskMap& map, const Scene<double>& scene, const analysis::Tail<DiskMap>& tail,
                      NamedMode& named) {
    auto& verdict = named.verdict;
    if (tail.ended || verdict.mode != analysis::Mode::undecided) return;
    if (scene.restitution != 1 || scene.tangential_restitution != 0 || !scene.has_drag()) return;
    const bool slides = scene.mu == 0;
    const std::optional<LockedRolling> rolling = slides ? locked_sliding(scene) : floor_facts(scene).locked;
    if (!rolling || !rolling->holds || !(rolling->bounce_decay > 0)) return;
    const auto decay = measured_decay(map, scene, *rolling, tail.last);
    if (!decay || !(std::abs(*decay / rolling->bounce_decay - 1) <= bounce_rate_margin)) return;
    verdict.mode = analysis::Mode::steady;
    verdict.kind = slides ? analysis::Kind::sliding : analysis::Kind::rolling;
    verdict.mean = verdict.mean_per_step = rolling->spin;
    verdict.rotation = analysis::nan;
    verdict.evidence = {
        {"decay rate of v^3 of its bounces", *decay, rolling->bounce_decay,
         fmt::format(
             "for {} impacts it bounces about {}, locked to the swirl, and the bounces die away at the rate that "
             "the drag predicts: with e = 1 it never lands, and S tends to {:.9g}",
             rolling_bounces, slides ? "sliding along the wall" : "rolling without slip", rolling->spin),
         fmt::format("off that rate by more than {:g} %: it would not be on its way there", 100 * bounce_rate_margin)}};
}

}  // namespace swirl::studies
