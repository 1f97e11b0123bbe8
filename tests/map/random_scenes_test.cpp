// Random scenes over the whole range: every orbit ends with a named outcome, none stalls, and none takes much more work
// than the median.
#include "tests/map/contact_scenes.hpp"
#include "tests/map/follow_contact.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace swirl {
namespace {

using tests::Tally;

constexpr double until = 1000;
constexpr long most_impacts = 50'000'000;

struct RandomScene {
    Scene<double> scene;
    LabStart<double> start;
    Tally tally;
    double seconds = 0;

    double events() const { return static_cast<double>(tally.impacts + tally.pieces); }
    /// A unit of time counts as an event, too: a body at rest has few.
    double per_event(double cost) const { return cost / (events() + until); }
    bool stalled() const { return tally.outcome == Outcome::completed && tally.time < until; }
};

/// `with_thousand`: one scene in 40 has N = 1000, which rolls on its vertices with 10⁴ impacts per unit of time,
/// elastic ones with 10⁵.
std::vector<RandomScene> draw(int count, bool with_thousand) {
    constexpr int sides[] = {disk_sides, 3, 4, 5, 6, 8, 12, 20, 50};
    std::mt19937_64 random(2026);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<RandomScene> cases(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        auto& c = cases[static_cast<std::size_t>(i)];
        const double alpha = 0.02 + 0.96 * unit(random);
        const double beta = 2 * unit(random) * unit(random);
        const double mu = i % 7 == 0 ? 0 : 2 * unit(random);
        const double e = i % 11 == 0 ? 0 : i % 11 == 1 ? 1 : unit(random);
        c.scene = tests::uniform_scene(with_thousand && i % 40 == 39 ? 1000 : sides[i % 9], alpha, beta, mu, e,
                                       static_cast<Law>(i % 3));
        const double direction = 2 * pi<double>() * unit(random);
        c.start = {beta, 0, std::cos(direction) / 7, std::sin(direction) / 7, 6 * unit(random), 0};
    }
    return cases;
}

/// A bound on events per unit time. Contact begins by a landing, or by a strike of the next vertex of a polygon
/// that turns along the wall (N Ω/2π of them, Ω = |S| + |u_t|), and by slips and releases, some per turn of ψ. Each may
/// be followed by one chatter: rebounds that shrink by e until they are below rounding, ln(v/√(8ε a(1 − e)))/ln(1/e) of
/// them, some 20/ln(1/e). A polygon that rocks on an edge keeps the share r = (κ + cos 2π/N)/(κ + 1) of its turn at
/// each strike even if e = 0 (its angular momentum about the striking vertex stays: Housner, Bull. Seismol. Soc. Am. 53
/// (1963) 403), r + e(1 − r) between that and e = 1. An impact and up to three pieces of contact (slip, stick, lift)
/// make four events. For e = 1 their number is bounded only by how close to tangential the orbit runs along the wall.
double most_events(const Scene<double>& scene, const Tally& tally) {
    const double kappa = scene.inertia_factor;
    const double rocking =
        scene.is_disk() ? 0 : std::max(0.0, (kappa + std::cos(2 * pi<double>() / scene.sides)) / (kappa + 1));
    const double rebounds = 1 + 20 / std::log(1 / (rocking + scene.restitution * (1 - rocking)));
    const double corners = scene.is_disk() ? 0 : scene.sides / (2 * pi<double>());
    return 4 * rebounds * (1 + corners) * (1 + tally.fastest);
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Follows the orbit and times it, other programs' time not counted.
void follow(RandomScene& c) {
    const double began = thread_seconds();
    c.tally = tests::follow(c.scene, c.start, until, most_impacts);
    c.seconds = thread_seconds() - began;
}

/// Times the orbit alone, without the checks of this test.
void time_alone(RandomScene& c) {
    const double began = thread_seconds();
    tests::follow(c.scene, c.start, until, most_impacts, false);
    c.seconds = std::min(c.seconds, thread_seconds() - began);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::string in_words(const RandomScene& c) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "N = %d alpha %.17g beta %.17g mu %.17g e %.17g law %s vx %.17g vy %.17g angle %.17g", c.scene.sides,
                  c.scene.alpha, c.scene.beta, c.scene.mu, c.scene.restitution,
                  std::string(name_of(c.scene.law)).c_str(), c.start.vx, c.start.vy, c.start.angle);
    return text;
}

template <class Cost>
std::vector<double> costs_of(const std::vector<RandomScene>& cases, const Cost& cost) {
    std::vector<double> costs;
    costs.reserve(cases.size());
    for (const auto& c : cases) costs.push_back(c.per_event(cost(c)));
    return costs;
}

double seconds_of(const RandomScene& c) {
    return c.seconds;
}
/// Evaluations of flights by the searches for contact, and power series of motions in contact.
double work_of(const RandomScene& c) {
    return static_cast<double>(c.tally.moments + c.tally.steps);
}

/// Orbits that seem expensive are timed twice more, one after the other: other processes disturb a measurement.
void time_again(std::vector<RandomScene>& cases) {
    const double typical = median(costs_of(cases, seconds_of));
    for (auto& c : cases)
        for (int again = 0; again < 2 && c.per_event(c.seconds) >= 10 * typical; ++again) time_alone(c);
}

template <class Cost>
void check_costs(const char* name, const std::vector<RandomScene>& cases, const Cost& cost) {
    const std::vector<double> costs = costs_of(cases, cost);
    const auto worst = static_cast<std::size_t>(std::max_element(costs.begin(), costs.end()) - costs.begin());
    const double typical = median(costs), largest = costs[worst];
    std::printf("%s per event (and unit of time): median %.2g, largest %.2g (%.1f medians: %s)\n", name, typical,
                largest, largest / typical, in_words(cases[worst]).c_str());
    EXPECT_LE(largest, 20 * typical) << name << ": " << in_words(cases[worst]);
}

void check_endings(const std::vector<RandomScene>& cases) {
    std::map<std::string, long> outcomes;
    for (const auto& c : cases) {
        const std::string name = c.stalled() ? "too many impacts" : std::string(name_of(c.tally.outcome));
        ++outcomes[name];
        EXPECT_TRUE(!c.stalled() && c.tally.outcome != Outcome::unresolved &&
                    (c.tally.outcome != Outcome::diverged || c.scene.law == Law::newton))
            << name << " after " << c.tally.impacts << " impacts, t = " << c.tally.time << ": " << in_words(c);
    }
    for (const auto& [name, n] : outcomes) std::printf("%-18s %ld\n", name.c_str(), n);
}

void check_orbits(const std::vector<RandomScene>& cases) {
    double busiest = 0, fullest = 0, outside = 0, balance = 0;
    for (const auto& c : cases) {
        const double rate = c.events() / until;
        busiest = std::max(busiest, rate);
        if (c.scene.restitution < 1) {
            const double share = rate / most_events(c.scene, c.tally);
            fullest = std::max(fullest, share);
            EXPECT_LE(share, 1) << in_words(c);
        }
        outside = std::max(outside, c.tally.outside);
        EXPECT_LE(c.tally.outside, 1e-12) << in_words(c);
        if (c.tally.exchanged > 0 && c.scene.beta > 0)
            balance = std::max(balance, std::abs(c.tally.balance) / (c.tally.exchanged + 1));
    }
    EXPECT_LE(balance, 1e-9);  // as in sustained contact: the tolerance of the series, over some 10³ pieces
    std::printf("most events per unit time %.0f, at most %.2g of the bound; outside by %.1e; balance %.1e\n", busiest,
                fullest, outside, balance);
}

/// The work is counted in the searches' moments and the contacts' series: the same on every machine and at every load.
/// What it takes by the clock is compared in the nightly test alone: beside other programs an orbit of a millisecond
/// may take twenty times as long, and a check that fails by chance teaches to overlook failures.
enum class Clock { ignored, checked };

void check_random_scenes(int count, bool with_thousand, Clock clock) {
    auto cases = draw(count, with_thousand);
    std::atomic<int> done{0};
    tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
        follow(cases[i]);
        if (++done % 2000 == 0) std::fprintf(stderr, "%d of %d scenes\n", done.load(), count);
    });
    check_endings(cases);
    check_orbits(cases);
    if (clock == Clock::checked) {
        time_again(cases);
        check_costs("seconds", cases, seconds_of);
    }
    check_costs("looks and series", cases, work_of);
}

TEST(RandomScenes, EveryOneEndsWithAName) {
    check_random_scenes(static_cast<int>(tests::sample_count(200)), false, Clock::ignored);
}
TEST(RandomScenesNightly, EveryOneOfTwentyThousandEndsWithAName) {
    check_random_scenes(20'000, true, Clock::checked);
}

}  // namespace
}  // namespace swirl
