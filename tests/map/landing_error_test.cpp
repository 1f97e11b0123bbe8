// The estimate that comes with a landing, `landing_error`, held against the same landing in 113 bits, where chatter is
// followed down to 10⁻¹⁷: of random orbits of polygons, their neighbours at the wall or not.
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

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

/// In axes that turn with the swirl, in contact: the centre, its velocity against the container, and αS.
using Body5 = std::array<double, 5>;

Body5 body_of(const Scene<double>& scene, const ContactSegment& piece) {
    const ContactState<double>& z = piece.to;
    const Vec2<double> n = cis(z.psi), arm = scene.alpha * cis(z.psi + z.chi);
    const Vec2<double> place = n - arm, velocity = quarter_turned(z.ut * n - z.spin * arm);
    return {place.x, place.y, velocity.x, velocity.y, scene.alpha * z.spin};
}

double apart(const Body5& a, const Body5& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// What an orbit comes to, and the estimates of its landings, the first of which it begins with.
struct Later {
    Body5 body{};
    Support landed_on = Support::vertex;
    double error = 0;
};

/// So many times what chatter would last by free flights is long enough for it to end, with its neighbour's.
constexpr double times_chatter = 64;

/// How long to look after an impact that ends chattering: 0 after others.
double looked_at_for(const ContactScene<double>& contact, const PostImpactState<double>& from) {
    const double un = std::abs(contact_kinematics(contact.body, from).un);
    if (un <= velocity_rounding(contact, from) || !may_chatter(contact, from)) return 0;
    if (!chatter_completion(contact, from).in_contact) return 0;
    return times_chatter * chatter_error(contact, from).moved / un;
}

/// `duration` after an impact; nothing if that is no time in contact.
///   prolonged  if given, the duration is that after the last landing in it, and is noted here
template <class Map>
std::optional<Later> later(const Map& map, const Scene<double>& scene, PostImpactState<typename Map::Number> from,
                           double duration, double* prolonged = nullptr) {
    using T = typename Map::Number;
    const ReturnMap<Map> returns(map);
    Later end;
    T left(duration), passed(0);
    for (int i = 0; i < 3000; ++i) {
        if constexpr (std::is_same_v<T, double>) {
            if (prolonged) {
                const auto contact = contact_scene(map.body(), map.scene().mu, map.scene().restitution, Map::rule);
                left = std::max(left, looked_at_for(contact, from));
                *prolonged = passed + left;
            }
        }
        const ReturnStep<T> step = returns.advance(from, static_cast<double>(left));
        if (!step.contacts.empty()) end.error += step.contacts.front().error;
        if (i == 0 && !step.contacts.empty()) end.landed_on = step.contacts.front().support;
        if (step.outcome == Outcome::in_contact && !step.contacts.empty()) {
            end.body = body_of(scene, step.contacts.back());
            return end;
        }
        if (step.outcome != Outcome::completed || step.collision.flight_time >= left) return {};
        left -= step.collision.flight_time;
        passed += step.collision.flight_time;
        from = step.collision.after;
    }
    return {};
}

PostImpactState<Quad> in_quad(const PostImpactState<double>& z, int coordinate = -1, double by = 0) {
    const SectionPoint<double> p = section_point(z);
    PostImpactState<Quad> wide{renormalised(Vec2<Quad>{Quad(z.psi.x), Quad(z.psi.y)}),
                               renormalised(Vec2<Quad>{Quad(z.chi.x), Quad(z.chi.y)}), Quad(z.vn), Quad(z.vt),
                               Quad(z.spin)};
    if (coordinate == 0) wide.psi = cis(Quad(p.psi) + Quad(by));
    if (coordinate == 1) wide.chi = cis(Quad(p.chi) + Quad(by));
    if (coordinate == 2) wide.vn += Quad(by);
    if (coordinate == 3) wide.vt += Quad(by);
    if (coordinate == 4) wide.spin += Quad(by);
    return wide;
}

/// The largest change of what 113 bits come to as the start changes by some ε in each of its coordinates: what double
/// cannot tell.
template <class Wide>
double untold(const Wide& wide, const Scene<double>& scene, const PostImpactState<double>& from, double duration,
              const Later& known) {
    double most = 0;
    for (int coordinate = 0; coordinate < 5; ++coordinate)
        for (const double by : {-4e-16, -1e-16, 1e-16, 4e-16})
            if (const auto near = later(wide, scene, in_quad(from, coordinate, by), duration))
                most = std::max(most, apart(near->body, known.body));
    return most;
}

struct Tally {
    long vertices = 0, edges = 0, close = 0, beyond = 0;
    double largest = 0;  ///< difference
};

template <class Map>
void compare(const Map& map, const Scene<double>& scene, const PostImpactState<double>& from, Tally& tally) {
    double duration = 0;
    const auto found = later(map, scene, from, 0, &duration);
    if (!found) return;
    with_collision_map(tests::scene_in<Quad>(scene), [&](const auto& wide) {
        const auto known = later(wide, scene, in_quad(from), duration);
        if (!known) return;
        ++(found->landed_on == Support::edge ? tally.edges : tally.vertices);
        tally.close += found->error > 1e-14;
        const double difference = apart(found->body, known->body);
        tally.largest = std::max(tally.largest, difference);
        const double size = 1 + std::abs(from.vn) + std::abs(from.vt) + scene.alpha * std::abs(from.spin);
        if (difference <= found->error + 2e-14 * size) return;  // 100 ε
        const double rounding = untold(wide, scene, from, duration, *known);
        if (difference <= found->error + 2e-14 * size + 2 * rounding) return;
        ++tally.beyond;
        const SectionPoint<double> z = section_point(from);
        ADD_FAILURE() << "N " << scene.sides << " alpha " << scene.alpha << " beta " << scene.beta << " mu " << scene.mu
                      << " e " << scene.restitution << ' ' << name_of(scene.law) << " after " << z.psi << ' ' << z.chi
                      << ' ' << z.vn << ' ' << z.vt << ' ' << z.spin << ": off by " << difference << ", landing_error "
                      << found->error << ", rounding " << rounding;
    });
}

/// All landings of an orbit in the first three time units, four at most.
template <class Map>
void compare_orbit(const Map& map, const Scene<double>& scene, const LabStart<double>& start, Tally& tally) {
    const ContactScene<double> contact = tests::contact_of(scene);
    Orbit orbit(map, start);
    double time = 0;
    for (int landings = 0; landings < 4 && orbit.impacts() < 300 && time < 3 && orbit.advance(3 - time);) {
        time = orbit.frame().time.unwound();
        const PostImpactState<double> from = orbit.post_impact();
        if (!(looked_at_for(contact, from) > 0)) continue;
        ++landings;
        compare(map, scene, from, tally);
    }
}

/// Orbits of `count` scenes.
///   most_mu  large friction: edges and jams
Tally compare_landings(long count, std::uint64_t seed, double most_mu) {
    tests::Random random(seed);
    Tally tally;
    for (long i = 0; i < count; ++i) {
        const int sides = random.one_of({3, 4, 5, 6});
        const Law law = random.chance(0.5) ? Law::newton : random.chance(0.5) ? Law::stronge : Law::poisson;
        const double mu = random.between(0.05, most_mu), e = random.between(0, 0.5);
        Scene<double> scene = tests::random_scene(random, sides, mu, e, law);
        if (random.chance(0.5)) scene.alpha = random.between(0.6, 0.97);
        const double room = 0.9 * (1 - scene.alpha), x = scene.beta + room * random.between(-0.7, 0.7),
                     y = room * random.between(-0.7, 0.7), vx = random.between(-0.6, 0.6),
                     vy = random.between(-0.6, 0.6), angle = random.angle(), spin = random.between(-0.5, 0.5);
        with_collision_map(scene, [&](const auto& map) {
            compare_orbit(map, scene, LabStart<double>{x, y, vx, vy, angle, spin}, tally);
        });
    }
    std::printf(
        "%ld landings on a vertex, %ld on an edge, %ld with an estimate above 1e-14; largest difference %.1e; %ld "
        "beyond their estimate\n",
        tally.vertices, tally.edges, tally.close, tally.largest, tally.beyond);
    return tally;
}

/// Rocks onto its neighbour just as it lands: χ rises by 4e-14 alone, past χ_m by 2e-14 (the first one), or the
/// neighbour is at the wall within rounding while the vertex still leaves at some 10⁻⁹. They were off by 1.7e-7, 3e-10
/// and 8e-10, with an estimate of 10⁻²¹.
TEST(LandingError, KnowsANeighbourThatStrikesBeforeChatterEnds) {
    struct Case {
        double alpha, beta, mu, e;
        Law law;
        LabStart<double> start;
    };
    const Case cases[] = {{0.61490441179784039,
                           0.81010444248693347,
                           2.7822796667967826,
                           0.0058040993687258902,
                           Law::newton,
                           {0.58738179063375417, -0.028570772782938982, 0.55081675507935157, -0.031632071829841624,
                            -2.5612339626287817, 0.46854685571197729}},
                          {0.66785882764118398,
                           0.75622938582737109,
                           3.8670404445451485,
                           0.0062365223183591389,
                           Law::stronge,
                           {0.66541060165913524, 0.20708539960379216, 0.35715792755170761, 0.07161524104362238,
                            2.5341989315440117, 0.12924271715708446}},
                          {0.32000717162943054,
                           3.2581618290647327,
                           3.0146087841695741,
                           0.00021045134780528496,
                           Law::poisson,
                           {3.1770317942042205, -0.3606977792699978, -0.31300738459303096, -0.43242737123656616,
                            -2.5796422673163821, 0.17313183077002103}}};
    for (const Case& c : cases) {
        const Scene<double> scene = tests::uniform_scene(3, c.alpha, c.beta, c.mu, c.e, c.law);
        Tally tally;
        with_collision_map(scene, [&](const auto& map) { compare_orbit(map, scene, c.start, tally); });
        EXPECT_GE(tally.close, 1);
        EXPECT_EQ(tally.beyond, 0);
        EXPECT_LT(tally.largest, 2e-9);
    }
}

TEST(LandingError, IsWhatALandingIsOffByAtMost) {
    EXPECT_GT(compare_landings(tests::sample_count(100), 1, 4).vertices, 10);
}

TEST(LandingErrorNightly, IsWhatALandingIsOffByAtMostInTwentyThousand) {
    const Tally ordinary = compare_landings(8000, 2, 1), large = compare_landings(10'000, 3, 4);
    EXPECT_GT(ordinary.vertices + large.vertices, 15'000);
    EXPECT_GT(ordinary.edges + large.edges, 20);
}

}  // namespace
}  // namespace swirl
