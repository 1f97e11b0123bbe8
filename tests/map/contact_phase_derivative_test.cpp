// The derivative of a phase of contact, and its derivative along parameters, against differences in 113 bits.
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/return_derivative.hpp"
#include "tests/map/compared_derivatives.hpp"
#include "tests/map/landings.hpp"

#include <gtest/gtest.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

namespace swirl {
namespace {

using tests::most, tests::usual, tests::worse;
using Kind = tests::ComparedDerivatives;

/// A motion in contact that can begin, on an edge, a vertex or a rim.
struct Start {
    Scene<double> scene;
    ChatterCompletion<double> completion;
};

Start random_start(tests::Random& random, Support support) {
    const int sides = support == Support::rim ? disk_sides : random.one_of({3, 4, 6});
    const auto law = static_cast<Law>(random.one_of({0, 1, 2}));
    const double mu = random.chance(0.2) ? 0 : random.between(0, 1);
    Start start{tests::random_scene(random, sides, mu, 0.5, law), {}};
    const double room = tests::contact_of(start.scene).widest_chi;
    ContactState<double>& z = start.completion.state;
    start.completion.support = support;
    z = {random.angle(), 0, random.between(-1, 1), random.between(-2, 2)};
    if (support == Support::vertex) z.chi = 0.9 * room * random.between(-1, 1);
    if (support == Support::edge) z.chi = -room, z.spin = z.ut;
    return start;
}

/// The events of a phase, and its last.
template <class T>
std::string events_of(const ContactPhase<T>& phase) {
    std::string events;
    for (const ContactSegment& piece : phase.segments)
        if (piece.end > piece.start) events += std::string(name_of(piece.finish)) + ", ";
    return events + std::string(name_of(phase.finish));
}

/// The end of contact from a start, moved along one of the coordinates ψ, u_t, S, χ.
ContactPhase<Quad> moved_end(const Start& start, int coordinate, const Quad& h) {
    const auto scene = tests::contact_of(tests::scene_in<Quad>(start.scene));
    const ContactState<double>& z = start.completion.state;
    ChatterCompletion<Quad> near{true, start.completion.support, {z.psi, z.chi, z.ut, z.spin}, 0, Quad(0), Quad(0)};
    if (near.support == Support::edge) near.state.chi = -scene.widest_chi;
    Quad* const numbers[] = {&near.state.psi, &near.state.ut, &near.state.spin, &near.state.chi};
    *numbers[coordinate] += h;
    if (near.support == Support::edge) near.state.spin = near.state.ut;
    return follow_contact(scene, near, 20);
}

/// The end of a phase in a scene with another value of one parameter; the edge stays on the wall.
ContactPhase<Quad> end_along(const Start& start, Parameter parameter, const Quad& h) {
    Scene<Quad> moved = tests::scene_in<Quad>(start.scene);
    number_of(moved, parameter) += h;
    const auto scene = tests::contact_of(moved);
    const ContactState<double>& z = start.completion.state;
    ChatterCompletion<Quad> near{true, start.completion.support, {z.psi, z.chi, z.ut, z.spin}, 0, Quad(0), Quad(0)};
    if (near.support == Support::edge) near.state.chi = -scene.widest_chi;
    return follow_contact(scene, near, 20);
}

/// The largest error of ∂(end)/∂λ relative to its largest entry, λ each parameter in turn.
double error_along_parameters(const Start& start, const ContactPhase<double>& phase) {
    using J = ContactJet<1>;
    const ContactState<double>& z = start.completion.state;
    double worst = 0;
    for (const Parameter parameter : all_parameters) {
        Scene<J> along = scene_in<J>(start.scene);
        if (parameter == Parameter::mu && start.scene.mu == 0) continue;
        if (parameter == Parameter::drag) continue;                    // DraggedContact has a floor that drags
        if (parameter == Parameter::corner) continue;                  // not followed in contact
        if (parameter == Parameter::tangential_restitution) continue;  // of the disk alone
        number_of(along, parameter).v[0] = 1;
        const ContactScene<J> scene = tests::contact_of(along);
        const J chi = start.completion.support == Support::edge ? J(-scene.widest_chi) : J(z.chi);
        const auto found = coordinates<Shape::polygon>(section_point(contact_along(
            tests::contact_of(start.scene), scene, phase, ContactState<J>{J(z.psi), chi, J(z.ut), J(z.spin)}, 0)));
        const Quad h(1e-13);
        const ContactPhase<Quad> above = end_along(start, parameter, h), below = end_along(start, parameter, Quad(-h));
        if (events_of(above) != events_of(phase) || events_of(below) != events_of(phase)) continue;
        const auto x = coordinates<Shape::polygon>(section_point(above.strike.after)),
                   y = coordinates<Shape::polygon>(section_point(below.strike.after));
        double error = 0, size = 1;
        for (std::size_t k = 0; k < 5; ++k) {
            const double expected =
                static_cast<double>((k < 2 ? wrapped_angle(Quad(x[k] - y[k])) : Quad(x[k] - y[k])) / (2 * h));
            error = worse(error, std::abs(found[k].v[0] - expected));
            size = std::max(size, std::abs(expected));
        }
        worst = worse(worst, error / size);
    }
    return worst;
}

/// Adds the largest error of the phase's derivative, relative to its largest entry, to those of its last event.
void compare_phase(const Start& start, std::map<std::string, Kind>& kinds) {
    using J = ContactJet<4>;
    const ContactScene<double> plain = tests::contact_of(start.scene);
    const ContactPhase<double> phase = follow_contact(plain, start.completion, 20);
    if (!phase.resolved || phase.finish == ContactEvent::horizon || !(phase.sums.time > 0)) return;
    const Scene<double>& s = start.scene;
    const ContactScene<J> scene = tests::contact_of(
        Scene<J>{s.sides, J(s.alpha), J(s.beta), J(s.mu), J(s.restitution), s.law, J(s.inertia_factor)});
    const ContactState<double>& z = start.completion.state;
    const bool edge = start.completion.support == Support::edge;
    const PostImpactState<J> end = contact_along(
        plain, scene, phase,
        ContactState<J>{J(z.psi, 0), edge ? J(z.chi) : J(z.chi, 3), J(z.ut, 1), edge ? J(z.ut, 1) : J(z.spin, 2)}, 0);
    const auto found = coordinates<Shape::polygon>(section_point(end));
    const int freedom = edge ? 2 : start.completion.support == Support::rim ? 3 : 4;
    double error = 0, size = 1;
    for (int i = 0; i < freedom; ++i) {
        const Quad h(1e-13);
        const ContactPhase<Quad> above = moved_end(start, i, h), below = moved_end(start, i, Quad(-h));
        if (events_of(above) != events_of(phase) || events_of(below) != events_of(phase)) return;
        const auto x = coordinates<Shape::polygon>(section_point(above.strike.after)),
                   y = coordinates<Shape::polygon>(section_point(below.strike.after));
        for (std::size_t k = 0; k < 5; ++k) {
            const double expected =
                static_cast<double>((k < 2 ? wrapped_angle(Quad(x[k] - y[k])) : Quad(x[k] - y[k])) / (2 * h));
            error = worse(error, std::abs(found[k].v[i] - expected));
            size = std::max(size, std::abs(expected));
        }
    }
    const char* const begins[] = {"rim", "vertex", "edge"};
    Kind& kind = kinds[std::string(begins[static_cast<int>(start.completion.support)]) + " to " +
                       std::string(name_of(phase.finish))];
    ++kind.compared;
    kind.worst = worse(kind.worst, error / size);
}

std::map<std::string, Kind> compare_phases(int phases, std::uint64_t seed) {
    std::map<std::string, Kind> kinds;
    tests::Random random(seed);
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (int i = 0; i < phases; ++i) compare_phase(random_start(random, support), kinds);
    for (const auto& [name, kind] : kinds)
        std::printf("%s: %ld phases, largest difference %.1e\n", name.c_str(), kind.compared, kind.worst);
    return kinds;
}

/// Compares phases along the scene's parameters, also of edges at rest, which slip later and end on either vertex.
std::map<std::string, Kind> compare_phases_along_parameters(int phases, std::uint64_t seed) {
    std::map<std::string, Kind> kinds;
    tests::Random random(seed);
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (int i = 0; i < phases; ++i) {
            Start start = random_start(random, support);
            ContactState<double>& z = start.completion.state;
            if (support == Support::edge && random.chance(0.7)) z.spin = z.ut = 0;
            const auto phase = follow_contact(tests::contact_of(start.scene), start.completion, 20);
            if (!phase.resolved || phase.finish == ContactEvent::horizon || !(phase.sums.time > 0)) continue;
            Kind& kind = kinds[events_of(phase)];
            ++kind.compared;
            kind.worst = worse(kind.worst, error_along_parameters(start, phase));
        }
    for (const auto& [name, kind] : kinds)
        std::printf("%s: %ld phases, largest difference %.1e\n", name.c_str(), kind.compared, kind.worst);
    return kinds;
}

TEST(ContactPhaseDerivative, IsWhatDifferencesIn113BitsGive) {
    const auto kinds = compare_phases(45, 3);
    EXPECT_GE(kinds.size(), 5U);
    for (const auto& [name, kind] : kinds) {
        EXPECT_GE(kind.compared, 5) << name;
        EXPECT_LE(kind.worst, usual) << name;  // measured: 4.6e-11
    }
}
TEST(ContactPhaseDerivative, AlongParametersIsWhatDifferencesIn113BitsGive) {
    long slipped = 0;
    for (const auto& [name, kind] : compare_phases_along_parameters(60, 5)) {
        slipped += name.find("slip") != std::string::npos ? kind.compared : 0;
        EXPECT_LE(kind.worst, usual) << name;
    }
    EXPECT_GE(slipped, 10);
}
TEST(ContactPhaseDerivativeNightly, AlongParametersIsWhatDifferencesIn113BitsGiveInThreeThousand) {
    for (const auto& [name, kind] : compare_phases_along_parameters(1000, 6)) EXPECT_LE(kind.worst, most) << name;
}
TEST(ContactPhaseDerivativeNightly, IsWhatDifferencesIn113BitsGiveInThreeThousand) {
    for (const auto& [name, kind] : compare_phases(1000, 4)) EXPECT_LE(kind.worst, most) << name;
}

}  // namespace
}  // namespace swirl
