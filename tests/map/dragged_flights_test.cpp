// First contacts over a floor that drags, held against an independent proof; what the floor does to J; endings.
#include "map/dragged/dragged_map.hpp"
#include "map/orbit/dragged_return.hpp"
#include "tests/map/dragged_draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>
#include <type_traits>

namespace swirl {
namespace {

using Real = long double;
using Point = std::complex<Real>;

/// A flight in the laboratory from the equations of motion alone: V' = -gamma (V - V_f), S' = -gamma_r S, V_f = O'
/// (dish) or 0 (table). V has a part K exp(i t) that stays, K = i gamma beta/(gamma + i).
struct PlainFlight {
    Scene<double> scene;
    Point place, left, carried;
    Real angle, spin;

    PlainFlight(const Scene<double>& s, const SectionPoint<double>& z) : scene(s) {
        const Real alpha = s.alpha, beta = s.beta, drag = s.drag;
        const Point n = std::polar<Real>(1, z.psi);
        place = beta + n - alpha * std::polar<Real>(1, z.psi + static_cast<Real>(z.chi));
        if (s.floor == Floor::dish) carried = Point(0, drag * beta) / Point(drag, 1);
        left = n * Point(z.vn, z.vt) - carried;
        angle = static_cast<Real>(z.psi) + z.chi;
        spin = z.spin;
    }
    static Real length(Real rate, Real t) { return rate > 0 ? -std::expm1(-rate * t) / rate : t; }

    /// |x|² − 1 of a vertex (disk: |X|² − (1 − α)²), and its rate.
    void gap(int vertex, Real t, Real& value, Real& rate) const {
        const Point turn = std::polar<Real>(1, t), swirl = static_cast<Real>(scene.beta) * turn;
        const Point x = place + carried * (turn - Point(1)) / Point(0, 1) + left * length(scene.drag, t) - swirl;
        const Point v = carried * turn + left * std::exp(-static_cast<Real>(scene.drag) * t) - Point(0, 1) * swirl;
        if (scene.is_disk()) {
            const Real reach = 1 - static_cast<Real>(scene.alpha);
            value = std::norm(x) - reach * reach;
            rate = 2 * (std::conj(x) * v).real();
            return;
        }
        const Real slowing = scene.turning_drag();
        const Real direction = angle + spin * length(slowing, t) + 2 * pi<Real>() * vertex / scene.sides;
        const Point arm = std::polar<Real>(scene.alpha, direction);
        const Point y = x + arm, w = v + Point(0, 1) * (spin * std::exp(-slowing * t)) * arm;
        value = std::norm(y) - 1;
        rate = 2 * (std::conj(y) * w).real();
    }
    /// M ≥ |g″| while nothing is outside.
    Real bound() const {
        const Real u = std::abs(left), b = scene.beta + std::abs(carried), s = std::abs(spin),
                   alpha = scene.is_disk() ? 0 : scene.alpha;
        const Real first = u + b + alpha * s;
        const Real second = scene.drag * u + b + alpha * s * (s + static_cast<Real>(scene.turning_drag()));
        return 2 * (first * first + second);
    }
};

/// How far a vertex is seen outside between two times, by g ≤ g_mid + ½|g′_mid|h + M h²/8: ≤ `allowed` proves that it
/// is not. Halves what is not proven down to `shortest`.
Real outside(const PlainFlight& flight, int vertex, Real from, Real to, Real bound, Real allowed, Real shortest) {
    Real value = 0, rate = 0;
    const Real h = to - from, middle = from + h / 2;
    flight.gap(vertex, middle, value, rate);
    if (value > allowed) return value;
    if (value + std::abs(rate) * h / 2 + bound * h * h / 8 <= allowed) return 0;
    if (h < shortest) return 0;  // what is left touches by less than |g′|h
    return std::max(outside(flight, vertex, from, middle, bound, allowed, shortest),
                    outside(flight, vertex, middle, to, bound, allowed, shortest));
}

struct Tally {
    int contacts = 0, endless = 0, sustained = 0, unresolved = 0, wrong = 0;
};

template <class Map>
void check_flight(const Map& map, const SectionPoint<double>& z, Tally& tally) {
    const Scene<double>& scene = map.scene();
    const PlainFlight flight(scene, z);
    const auto collision = map.advance(post_impact_state(z));
    if (collision.outcome == FirstContactOutcome::unresolved) ++tally.unresolved;
    if (collision.outcome == FirstContactOutcome::sustained) ++tally.sustained;
    const bool touches = collision.outcome == FirstContactOutcome::contact;
    if (!touches && collision.outcome != FirstContactOutcome::no_contact) return;
    ++(touches ? tally.contacts : tally.endless);
    const Real bound = flight.bound(), end = touches ? static_cast<Real>(collision.flight_time) : Real(60);
    // Gaps are known to rounding of what they are the sum of; |g′| at the contact says how near in time that is.
    const Real allowed = 1e-12L * (1 + bound);
    Real value = 0, rate = 0;
    if (touches) {
        flight.gap(collision.vertex_step, end, value, rate);
        const bool at_wall = std::abs(value) <= 1e-13L * (1 + bound) * (1 + end) && rate > -1e-6L;
        if (!at_wall) ++tally.wrong;
        EXPECT_TRUE(at_wall) << "N " << scene.sides << " g " << static_cast<double>(value);
    }
    const int count = scene.is_disk() ? 1 : scene.sides;
    const int every = std::max(1, count / 24);  // of many sides one in so many, beside those near the two that matter
    for (int k = 0; k < count; ++k) {
        const int from_struck = std::min(k, count - k), apart = std::abs(k - collision.vertex_step),
                  from_striking = std::min(apart, count - apart);
        if (k % every != 0 && from_struck > 3 && from_striking > 3) continue;
        const Real worst = outside(flight, k, 0, end, bound, allowed, std::max(end * 1e-7L, Real(1e-9)));
        if (worst > 0) ++tally.wrong;
        EXPECT_EQ(worst, 0) << "N " << scene.sides << " vertex " << k << " outside by " << static_cast<double>(worst)
                            << ", of tau " << static_cast<double>(end);
    }
}

void check_flights(int flights, unsigned seed) {
    tests::DraggedDraw draw(seed);
    Tally tally;
    for (int i = 0; i < flights; ++i) {
        const Scene<double> scene = draw.scene(1e-4, 3);
        const SectionPoint<double> z = draw.point(scene);
        with_dragged_map(scene, [&](const auto& map) { check_flight(map, z, tally); });
    }
    std::printf("%d contacts, %d endless flights, %d sustained, %d unresolved, %d wrong\n", tally.contacts,
                tally.endless, tally.sustained, tally.unresolved, tally.wrong);
    EXPECT_GT(tally.contacts, flights / 2);
    EXPECT_GT(tally.endless, flights / 100);
    EXPECT_EQ(tally.unresolved, 0);
    EXPECT_EQ(tally.wrong, 0);
}

TEST(DraggedFlights, FirstContactsAreProvenAnew) {
    check_flights(10'000, 11);
}

TEST(DraggedFlightsNightly, FirstContactsAreProvenAnew) {
    check_flights(100'000, 12);
}

/// J before and after a flight, and the floor's work in the swirling frame between: dJ/dt = −γ(V − V_f)·(V − ẑ×P) −
/// γ_r I S(S − 1), by Gauss–Legendre of ten points on pieces of a twentieth.
TEST(DraggedFlights, TheFloorsWorkIsWhatJLoses) {
    constexpr Real at[] = {0.1488743389816312L, 0.4333953941292472L, 0.6794095682990244L, 0.8650633666889845L,
                           0.9739065285171717L};
    constexpr Real weight[] = {0.2955242247147529L, 0.2692667193099964L, 0.2190863625159820L, 0.1494513491505806L,
                               0.0666713443086881L};
    tests::DraggedDraw draw(13);
    int flights = 0;
    double worst = 0;
    while (flights < 200) {
        const Scene<double> scene = draw.scene(1e-2, 2);
        const SectionPoint<double> z = draw.point(scene);
        with_dragged_map(scene, [&](const auto& map) {
            const auto c = map.advance(post_impact_state(z));
            if (c.outcome != FirstContactOutcome::contact) return;
            const PlainFlight flight(scene, z);
            const Real inertia = map.body().inertia, slowing = scene.turning_drag();
            const auto power = [&](Real t) {
                const Point turn = std::polar<Real>(1, t);
                const Point v = flight.carried * turn + flight.left * std::exp(-static_cast<Real>(scene.drag) * t);
                const Point p = flight.place + flight.carried * (turn - Point(1)) / Point(0, 1) +
                                flight.left * PlainFlight::length(scene.drag, t);
                const Point wind =
                    scene.floor == Floor::dish ? Point(0, 1) * static_cast<Real>(scene.beta) * turn : Point(0);
                const Real s = flight.spin * std::exp(-slowing * t);
                const Point relative = v - Point(0, 1) * p;
                return -static_cast<Real>(scene.drag) * (std::conj(v - wind) * relative).real() -
                       slowing * inertia * s * (s - 1);
            };
            const int pieces = 20 + static_cast<int>(20 * c.flight_time);
            const Real half = static_cast<Real>(c.flight_time) / (2 * pieces);
            Real work = 0;
            for (int i = 0; i < pieces; ++i)
                for (int k = 0; k < 5; ++k)
                    for (const Real side : {-1, 1}) work += half * weight[k] * power(half * (2 * i + 1 + side * at[k]));
            const double before = jacobi_of(map.body(), post_impact_state(z));
            const double after = jacobi_of(map.body(), c.after) - c.jacobi_restitution - c.jacobi_friction;
            const double scale = 1 + std::abs(before) + std::abs(after);
            worst = std::max(worst, std::abs(after - before - static_cast<double>(work)) / scale);
            EXPECT_NEAR(after - before, static_cast<double>(work), 1e-12 * scale);
            ++flights;
        });
    }
    std::printf("%d flights, largest residual %.1e\n", flights, worst);
}

/// A body in a dish that the drag leaves off the wall rides, and one on a table comes to rest.
TEST(DraggedFlights, ABodyWithoutContactRides) {
    Scene<double> scene{.sides = 6,
                        .alpha = 0.3,
                        .beta = 0.4,
                        .mu = 0.5,
                        .restitution = 0.9,
                        .inertia_factor = uniform_inertia_factor<double>(6)};
    scene.drag = 1;
    const Flight<double> start{{-0.4, 0}, {0.1, 0}, {1, 0}, {0.3, 0}, 0.2, 0.4, false};
    for (const Floor floor : {Floor::dish, Floor::table}) {
        scene.floor = floor;
        const DraggedMap<double, Shape::polygon, ImpactRule::poisson> map(scene);
        const ReturnMap<DraggedMap<double, Shape::polygon, ImpactRule::poisson>> back(map);
        EXPECT_EQ(back.advance(start).outcome, floor == Floor::dish ? Outcome::riding : Outcome::no_contact);
    }
    // 1 − α < β/√(1 + γ²): the circle that it would ride on reaches the wall.
    scene.floor = Floor::dish;
    scene.beta = 1.2;
    const Flight<double> swept{{0, 0}, {0, 0}, {1, 0}, {0.3, 0}, 0, 1.2, false};
    const DraggedMap<double, Shape::polygon, ImpactRule::poisson> map(scene);
    EXPECT_EQ(map.advance(swept).outcome, FirstContactOutcome::contact);
}

/// Impacts with loss die out at the wall, contact goes on from there, and every ending has a name.
TEST(DraggedFlights, ChatterEndsInContact) {
    tests::DraggedDraw draw(14);
    int contacts = 0, ends_in_contact_so_often = 0, rides = 0;
    for (int i = 0; i < 60; ++i) {
        Scene<double> scene = draw.scene(1e-2, 1);
        scene.restitution = draw.uniform(0, 0.9);
        const SectionPoint<double> z = draw.point(scene);
        with_dragged_map(scene, [&](const auto& map) {
            const ReturnMap<std::decay_t<decltype(map)>> back(map);
            ReturnStep<double> step;
            step.collision.after = post_impact_state(z);
            Outcome outcome = Outcome::completed;
            for (int k = 0; k < 2'000 && outcome == Outcome::completed; ++k) {
                outcome = back.advance(step);
                contacts += step.contacts.empty() ? 0 : 1;
            }
            EXPECT_NE(outcome, Outcome::unresolved) << i;
            ends_in_contact_so_often += ends_in_contact(outcome);
            rides += outcome == Outcome::riding || outcome == Outcome::no_contact;
        });
    }
    std::printf("  %d return steps through contact; %d orbits end in contact, %d ride\n", contacts,
                ends_in_contact_so_often, rides);
    EXPECT_GT(ends_in_contact_so_often, 10);
}

}  // namespace
}  // namespace swirl
