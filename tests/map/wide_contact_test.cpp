// Sustained contact in more digits: in 113 bits it is its own reference, for double and long double the reference.
#include "map/contact/motion_choice.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/landings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <type_traits>

namespace swirl {
namespace {

using tests::Landing, tests::ContactReturn, tests::contact_return, tests::random_landing, tests::widened;

/// Differences of place, velocities (of S that of the rim, α(S − S′)) and times.
template <class T>
std::array<double, 9> differences(const Quad& alpha, const ContactReturn<T>& a, const ContactReturn<Quad>& b) {
    const auto less = [](const T& x, const Quad& y) { return static_cast<double>(Quad(x) - y); };
    const PostImpactState<T>& z = a.after;
    const PostImpactState<Quad>& w = b.after;
    return {less(z.psi.x, w.psi.x),
            less(z.psi.y, w.psi.y),
            less(z.chi.x, w.chi.x),
            less(z.chi.y, w.chi.y),
            less(z.vn, w.vn),
            less(z.vt, w.vt),
            static_cast<double>(alpha) * less(z.spin, w.spin),
            less(a.time, b.time),
            static_cast<double>(alpha) * less(a.turned, b.turned)};
}

double largest(const std::array<double, 9>& list) {
    double most = 0;
    for (const double d : list) most = std::max(most, std::abs(d));
    return most;
}

/// By how much the end of a return changes with its start, or with α, β, μ or κ relative to themselves: the largest.
template <class Map>
double condition_of(const Map& map, const PostImpactState<Quad>& from, const ContactReturn<Quad>& known) {
    const Quad h(1e-15);
    double condition = 1;
    const auto note = [&](const std::optional<ContactReturn<Quad>>& beside) {
        if (beside && beside->way == known.way)
            condition =
                std::max(condition, largest(differences(map.body().alpha, *beside, known)) / static_cast<double>(h));
    };
    for (const auto number :
         {&Scene<Quad>::alpha, &Scene<Quad>::beta, &Scene<Quad>::mu, &Scene<Quad>::inertia_factor}) {
        Scene<Quad> scene = map.scene();
        scene.*number *= Quad(1) + h;
        note(contact_return(Map(scene), from));
    }
    for (int i = 0; i < 5; ++i) {
        SectionPoint<Quad> near = section_point(from);
        Quad* const numbers[] = {&near.psi, &near.chi, &near.vn, &near.vt, &near.spin};
        if (i == 1 && Map::shape == Shape::disk) continue;
        *numbers[i] += i == 2 ? Quad(-h) : h;  // away from the wall
        note(contact_return(map, post_impact_state(near)));
    }
    return condition;
}

struct Tally {
    long compared = 0, other_way = 0;
    double worst = 0;  ///< difference by condition, the size of what is rounded (lengths, velocities, time) and ε
    double balance = 0;
};

/// Compares a landing followed in T with the one in 113 bits.
template <class T>
void compare(const Landing& landing, Tally& tally) {
    with_collision_map(tests::scene_in<Quad>(landing.scene), [&](const auto& wide_map) {
        const auto from = widened(wide_map.body(), landing.from);
        const auto reference = contact_return(wide_map, from);
        if (!reference) return;
        const Quad balance =
            jacobi_of(wide_map.body(), reference->after) - jacobi_of(wide_map.body(), from) - reference->work;
        tally.balance = std::max(
            tally.balance, std::abs(static_cast<double>(balance)) / (1 + static_cast<double>(reference->exchanged)));
        EXPECT_LE(reference->landing_error, 16 * static_cast<double>(epsilon<Quad>()));
        with_collision_map(tests::scene_in<T>(landing.scene), [&](const auto& map) {
            const auto found = contact_return(map, widened(map.body(), landing.from));
            if (!found || found->way != reference->way) return void(++tally.other_way);
            const double condition = condition_of(wide_map, from, *reference);
            const double difference = largest(differences(wide_map.body().alpha, *found, *reference));
            const double size = 1 + std::abs(landing.from.vn) + std::abs(landing.from.vt) +
                                landing.scene.alpha * std::abs(landing.from.spin) +
                                static_cast<double>(reference->time);
            tally.worst = std::max(tally.worst, difference / (condition * size * static_cast<double>(epsilon<T>())));
            ++tally.compared;
        });
    });
}

template <class T>
Tally compare_landings(int landings, std::uint64_t seed) {
    Tally tally;
    tests::Random random(seed);
    for (const int sides : {disk_sides, 3, 4, 6, 12})
        for (int i = 0; i < landings;)
            if (const auto landing = random_landing(random, sides)) {
                compare<T>(*landing, tally);
                ++i;
            }
    std::printf(
        "%ld landings, %ld more with other events: difference by condition and epsilon %.2g, balance of J %.1e\n",
        tally.compared, tally.other_way, tally.worst, tally.balance);
    return tally;
}

///   most  difference by condition, size and ε
void expect_rounding(const Tally& tally, double most) {
    EXPECT_LE(tally.worst, most);
    EXPECT_LE(tally.balance, 1e-31);  // of J in 113 bits, ε = 1.9e-34
    EXPECT_LE(tally.other_way, 0.05 * static_cast<double>(tally.compared));
}

TEST(WideContact, IsWhatDoubleAndExtendedPrecisionRoundOff) {
    expect_rounding(compare_landings<double>(8, 1), 8);  // measured: 1.7 and 0.75
    expect_rounding(compare_landings<long double>(8, 2), 8);
}
TEST(WideContactNightly, IsWhatDoubleAndExtendedPrecisionRoundOffInTwoThousandLandings) {
    expect_rounding(compare_landings<double>(200, 3), 16);  // measured: 13 and 8.6
    expect_rounding(compare_landings<long double>(200, 4), 16);
}

// Just after an impact that reversed the slip, |u_t| = 0.045 |u_n|: it ends with chatter, and the vertex sticks. Slip
// that went on after chatter would be wrong by the first order of u_n: 3e-10 in double.
TEST(WideContact, ASlipThatEndsWithChatter) {
    Scene<double> scene =
        tests::uniform_scene(6, 0.11855468561051304, 0.1776045950511877, 0.24447206936212673, 0.59427803669677137);
    scene.law = Law::poisson;
    const SectionPoint<double> from{-0.48224172829491629, -0.37446420615930787, -0.068847324763608345,
                                    0.19175078336715709, -0.31177161931180852};
    Tally tally;
    compare<double>({scene, post_impact_state(from)}, tally);
    compare<long double>({scene, post_impact_state(from)}, tally);
    std::printf("difference by condition and epsilon %.2g, balance of J %.1e\n", tally.worst, tally.balance);
    EXPECT_EQ(tally.compared, 2);
    expect_rounding(tally, 16);  // measured: 8.8
}

/// From a rocking triangle on, whose hops are shorter from impact to impact.
template <class T>
void follow_rocking_triangle() {
    const Scene<double> scene = tests::uniform_scene(3, 0.4, 0.8, 0.5, 0.5);
    with_collision_map(tests::scene_in<T>(scene), [](const auto& map) {
        const SectionPoint<T> start{T(-1.2019398591), T(0.693455), T(-0.47764), T(1.01596), T(1.05075)};
        ReducedOrbit<std::decay_t<decltype(map)>> orbit(map, start);
        T time(0);
        while (orbit.impacts() < 2000 && orbit.advance()) time += orbit.collision().flight_time;
        std::printf("%lld impacts in %.17g before an edge rests on the wall\n", orbit.impacts(),
                    static_cast<double>(time));
        EXPECT_EQ(orbit.outcome(), Outcome::in_contact);
        ASSERT_FALSE(orbit.contacts().empty());
        EXPECT_EQ(orbit.contacts().back().support, Support::edge);
    });
}

// The last hops of an edge's neighbour last for √ε: what looks for their end has to look as near as that.
TEST(WideContact, ARockingTriangleLandsInEveryArithmetic) {
    follow_rocking_triangle<double>();
    follow_rocking_triangle<long double>();
    follow_rocking_triangle<Quad>();
}

/// A motion in contact from `start`, in pieces no longer than `longest`: to an event, or for so long.
ContactEnd<Quad> in_pieces(const ContactScene<Quad>& scene, Support support, ContactMotion motion,
                           const ContactState<Quad>& start, double duration, double longest) {
    ContactEnd<Quad> whole;
    whole.state = start;
    while (whole.event == ContactEvent::horizon && whole.sums.time < duration) {
        const Quad left = Quad(duration) - whole.sums.time;
        const ContactEnd<Quad> piece =
            run_contact(scene, support, motion, whole.state, std::min(left, Quad(longest)), [](const auto&...) {});
        whole.event = piece.event;
        whole.state = piece.state;
        whole.sums.time += piece.sums.time;
        whole.sums.turned += piece.sums.turned;
        whole.sums.work += piece.sums.work;
    }
    return whole;
}

TEST(WideContact, Of113BitsDoesNotDependOnItsSteps) {
    tests::Random random(5);
    double worst = 0;
    int events = 0;
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (int i = 0; i < 20; ++i) {
            const int sides = support == Support::rim ? disk_sides : random.one_of({3, 4, 6});
            const Scene<double> s = tests::uniform_scene(sides, random.between(0.1, 0.9), random.between(0.05, 1),
                                                         random.between(0, 0.6), 0.5);
            const ContactScene<Quad> scene = tests::contact_of(tests::scene_in<Quad>(s));
            ContactState<Quad> z{Quad(random.angle()), Quad(0), Quad(random.between(-1, 1)),
                                 Quad(random.between(-2, 2))};
            if (support == Support::vertex) z.chi = Quad(0.9 * random.between(-1, 1)) * scene.widest_chi;
            if (support == Support::edge) z.chi = -scene.widest_chi, z.spin = z.ut;
            const MotionChoice<Quad> choice = choose_motion(scene, support, z, 0);
            if (!choice.stays || choice.support != support) continue;
            const ContactEnd<Quad> once = in_pieces(scene, support, choice.motion, z, 3, 3),
                                   often = in_pieces(scene, support, choice.motion, z, 3, 0.07);
            ASSERT_EQ(once.event, often.event);
            events += once.event != ContactEvent::horizon;
            for (const Quad& d :
                 {once.state.psi - often.state.psi, once.state.chi - often.state.chi, once.state.ut - often.state.ut,
                  once.state.spin - often.state.spin, once.sums.time - often.sums.time,
                  once.sums.turned - often.sums.turned, once.sums.work - often.sums.work})
                worst = std::max(worst, std::abs(static_cast<double>(d)));
        }
    std::printf("%d motions ended by an event; in steps of 0.07 at most they differ by %.1e\n", events, worst);
    EXPECT_GE(events, 20);
    EXPECT_LE(worst, 1e-28);  // ε of 113 bits is 1.9e-34
}

}  // namespace
}  // namespace swirl
