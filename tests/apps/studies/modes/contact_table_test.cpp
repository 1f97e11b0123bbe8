// What a disk with friction ends as (μ = 0.4): named, and with the mean spin of its pendulum in closed form.
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/contact/rim_pendulum.hpp"
#include "map/orbit/orbit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace swirl::studies {
namespace {

using analysis::Kind;

struct Row {
    std::map<std::string, int> kinds;
    double worst = 0;  ///< of mean S, against the pendulum's
    int settling = 0;  ///< circulating ones that still slip a little in each turn
    long landings = 0, impacts = 0;
};

/// How often an orbit lands on the wall and leaves it again.
void count_landings(const Scene<double>& scene, const LabStart<double>& start, Row& row) {
    with_collision_map(scene, [&](const auto& map) {
        Orbit orbit(map, start);
        while (orbit.advance()) row.landings += !orbit.contacts().empty();
        row.impacts += static_cast<long>(orbit.impacts());
        return 0;
    });
}

/// The pendulum on which an orbit ends, or settles, from the classification's own last impact (before it, orbits that
/// differ by rounding part).
std::optional<RimPendulum> own_pendulum(const Scene<double>& scene, const std::vector<double>& end, Row& row) {
    return with_scene_map(scene, [&]<int D>(const SceneMap<D>& map) -> std::optional<RimPendulum> {
        const auto last = map.state_at(analysis::Vector<D>(end.data()));
        const auto return_step = map.return_step(last, 10 * contact_horizon);
        if (return_step.outcome != Outcome::in_contact) return {};
        const auto rolls = std::find_if(return_step.contacts.rbegin(), return_step.contacts.rend(),
                                        [](const auto& segment) { return segment.motion == ContactMotion::sticking; });
        if (rolls == return_step.contacts.rend()) return {};
        const ContactScene<double>& contact = map.contact();
        const RimPendulum pendulum = rim_pendulum(contact, rolls->from);
        const auto settled = settled_pendulum(contact, pendulum);
        row.settling += settled && settled->turns() && settled->height != pendulum.height;
        return settled;
    });
}

Row look_at(double alpha, double beta, double e, int starts) {
    const Scene<double> scene{
        disk_sides, alpha, beta, 0.4, e, Law::poisson, uniform_inertia_factor<double>(disk_sides)};
    const ContactScene<double> contact = contact_scene(make_body(scene), scene.mu, e, ImpactRule::poisson);
    Row row;
    for (int seed = 1; seed <= starts; ++seed) {
        const LabStart<double> start = random_start(beta, 1.0 / 7, static_cast<std::uint64_t>(seed), 0);
        const auto named = name_mode(scene, start, {}).verdict;
        ++row.kinds[std::string(name_of(named.kind))];
        count_landings(scene, start, row);
        SCOPED_TRACE(::testing::Message() << "alpha " << alpha << " beta " << beta << " e " << e << " seed " << seed);
        EXPECT_TRUE(named.kind == Kind::rolling || named.kind == Kind::rolling_librating ||
                    named.kind == Kind::rolling_circulating)
            << name_of(named.kind);
        double expected = -(1 - alpha) / alpha;
        if (named.kind == Kind::rolling_circulating) {
            const auto pendulum = own_pendulum(scene, named.end, row);
            EXPECT_TRUE(pendulum && pendulum->turns());
            if (!pendulum) continue;
            expected = mean_rolling_spin(contact, *pendulum);
        }
        EXPECT_NEAR(named.mean, expected, 1e-6);
        row.worst = std::max(row.worst, std::abs(named.mean - expected));
    }
    return row;
}

void print(double alpha, double beta, double e, const Row& row) {
    std::printf("e %-4g beta %-4g alpha %-4g ", e, beta, alpha);
    for (const auto& [kind, n] : row.kinds) std::printf(" %s %d", kind.c_str(), n);
    std::printf("  (%d settling; %ld landings of %ld impacts; mean S within %.1e)\n", row.settling, row.landings,
                row.impacts, row.worst);
}

TEST(DiskTable, EndsOnItsPendulum) {
    for (const auto& [alpha, beta, e] :
         {std::tuple{0.1, 0.05, 0.3}, {0.35, 0.05, 0.0}, {0.15, 0.05, 0.97}, {0.62, 0.23, 0.9}, {0.15, 0.6, 0.0}})
        print(alpha, beta, e, look_at(alpha, beta, e, 3));
}

/// Slips of 1e-8 in some turns: no measure by their number.
TEST(DiskTable, NamesDisksThatHardlySlipByWhatTheySettleOn) {
    const Row row = look_at(0.1, 0.05, 0.9, 20);
    print(0.1, 0.05, 0.9, row);
    EXPECT_GE(row.kinds.at("rolling-circulating"), 10);
    EXPECT_GE(row.settling, 1);
}

TEST(DiskTableNightly, EndsOnItsPendulumFromTwentyStartsOfNinetySixScenes) {
    for (const double e : {0.0, 0.3, 0.9, 0.97})
        for (const double beta : {0.05, 0.23, 0.6, 1.0})
            for (const double alpha : {0.1, 0.15, 0.35, 0.62, 0.8, 0.9})
                print(alpha, beta, e, look_at(alpha, beta, e, 20));
}

}  // namespace
}  // namespace swirl::studies
