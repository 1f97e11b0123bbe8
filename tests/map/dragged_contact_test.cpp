// Contact over a floor that drags: its motions against Newton's equations in 18 digits, chatter that ends in it against
// impacts followed one by one, where a rolling disk comes to rest, and the derivative through it.
#include "map/contact/contact_run.hpp"
#include "map/dragged/floor_facts.hpp"
#include "map/orbit/dragged_return_derivative.hpp"
#include "tests/map/dragged_draw.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

namespace swirl {
namespace {

Scene<double> scene_over_floor(const nlohmann::json& entry) {
    Scene<double> scene = tests::scene_from<double>(entry);
    scene.drag = tests::number<double>(entry["drag"]);
    scene.spin_drag = tests::number<double>(entry["spin_drag"]);
    scene.floor = entry["floor"].get<std::string>() == "table" ? Floor::table : Floor::dish;
    return scene;
}

using Numbers = std::array<double, 5>;  // t, ψ, χ, u_t, S

Numbers end_of(const nlohmann::json& entry) {
    Numbers numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = tests::number<double>(entry["end"][i]);
    return numbers;
}

double apart(const Numbers& a, const Numbers& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double off = a[i] - b[i];
        most = std::max(most, std::abs(i == 1 || i == 2 ? std::remainder(off, 2 * pi<double>()) : off));
    }
    return most;
}

ContactMotion motion_of(int sense, double mu) {
    if (mu == 0 || sense > 0) return ContactMotion::sliding_forward;
    return sense < 0 ? ContactMotion::sliding_backward : ContactMotion::sticking;
}

TEST(DraggedContact, MotionsAreThoseOfNewtonsEquations) {
    const nlohmann::json reference = tests::read_reference("dragged_contact.json");
    int motions = 0, polygons = 0;
    double worst = 0;
    for (const auto& entry : reference["cases"]) {
        if (entry.contains("impacts")) continue;
        const Scene<double> scene = scene_over_floor(entry);
        const ContactScene<double> contact = contact_scene(make_body(scene), scene, ImpactRule::poisson);
        const auto start = [&](std::size_t i) { return tests::number<double>(entry["start"][i]); };
        const ContactEnd<double> end =
            run_contact(contact, scene.is_disk() ? Support::rim : Support::vertex,
                        motion_of(entry["sense"].get<int>(), scene.mu), {start(0), start(1), start(2), start(3)},
                        entry["event"] == "horizon" ? tests::number<double>(entry["duration"]) : 100.0);
        EXPECT_EQ(name_of(end.event), entry["event"].get<std::string>()) << entry.dump();
        const double off =
            apart({end.sums.time, end.state.psi, end.state.chi, end.state.ut, end.state.spin}, end_of(entry));
        // A slip begins where friction falls short by `stick_margin`, so late that its moment is known to 1e-10 alone.
        const bool slips = end.event == ContactEvent::slip;
        EXPECT_LT(off, slips ? 1e-9 : 1e-12) << entry.dump();
        if (!slips) worst = std::max(worst, off);
        ++motions;
        polygons += scene.is_disk() ? 0 : 1;
    }
    std::printf("  %d motions, %d of polygons, off by %.1e at most but for slips\n", motions, polygons, worst);
    EXPECT_GE(motions, 20);
    EXPECT_GE(polygons, 10);
}

TEST(DraggedContact, ChatterEndsWhereImpactsFollowedOneByOneLead) {
    const nlohmann::json reference = tests::read_reference("dragged_contact.json");
    int landings = 0;
    double worst = 0;
    for (const auto& entry : reference["cases"]) {
        if (!entry.contains("impacts")) continue;
        const Scene<double> scene = scene_over_floor(entry);
        const auto start = [&](std::size_t i) { return tests::number<double>(entry["start"][i]); };
        with_dragged_map(scene, [&](const auto& map) {
            const ReturnMap<std::decay_t<decltype(map)>> back(map);
            // u_n = v_n − β sin ψ and u_t = v_t + αS − β cos ψ
            const SectionPoint<double> z{start(0), 0, scene.beta * std::sin(start(0)) - start(4),
                                         start(2) - scene.alpha * start(3) + scene.beta * std::cos(start(0)), start(3)};
            const double until = tests::number<double>(entry["duration"]);
            double time = 0;
            ReturnStep<double> step;
            step.collision.after = post_impact_state(z);
            Outcome outcome = Outcome::completed;
            while (outcome == Outcome::completed && time < until) {
                outcome = back.advance(step, until - time);
                if (outcome == Outcome::completed) time += step.collision.flight_time;
            }
            ASSERT_EQ(outcome, Outcome::in_contact);
            const ContactSegment& last = step.contacts.back();
            const double off =
                apart({time + last.end, last.to.psi, last.to.chi, last.to.ut, last.to.spin}, end_of(entry));
            EXPECT_LT(off, 1e-12) << entry.dump();
            worst = std::max(worst, off);
            ++landings;
        });
    }
    std::printf("  %d landings, off by %.1e at most\n", landings, worst);
    EXPECT_GE(landings, 3);
}

/// Locked to the swirl where and only where describe says so: from rolling at ψ′ = 0 near its place.
TEST(DraggedContact, ARollingDiskLocksToTheSwirlWhereItIsSaidTo) {
    tests::DraggedDraw draw(3);
    int locks = 0, others = 0;
    for (int i = 0; i < 60; ++i) {
        Scene<double> scene = draw.scene(0.05, 2);
        scene.sides = disk_sides;
        scene.inertia_factor = uniform_inertia_factor<double>(disk_sides);
        scene.mu = 20;
        scene.beta = draw.uniform(0.05, 1);
        const FloorFacts facts = floor_facts(scene);
        const ContactScene<double> contact = contact_scene(make_body(scene), scene, ImpactRule::poisson);
        const double rho = 1 - scene.alpha;
        const double psi = facts.locked ? facts.locked->psi + 0.05 : -pi<double>() / 2;
        const ContactEnd<double> end =
            run_contact(contact, Support::rim, ContactMotion::sticking, {psi, 0, 0, -rho / scene.alpha}, 400.0);
        if (facts.locked && facts.locked->holds) {
            if (std::abs(std::abs(*facts.locking_ratio) - 1) < 0.02) continue;  // the well is shallow
            ASSERT_EQ(end.event, ContactEvent::horizon) << i;
            EXPECT_NEAR(std::remainder(end.state.psi - facts.locked->psi, 2 * pi<double>()), 0, 1e-3) << i;
            EXPECT_NEAR(end.state.spin, -rho / scene.alpha, 1e-3) << i;
            const Reaction<double> r = reaction_of(contact, Support::rim, ContactMotion::sticking,
                                                   {facts.locked->psi, 0, 0, facts.locked->spin});
            EXPECT_NEAR(r.normal, facts.locked->force, 1e-14);
            EXPECT_NEAR(r.spin_rate, 0, 1e-14);
            EXPECT_NEAR(std::abs(r.friction) / r.normal, facts.locked->friction, 1e-14);
            ++locks;
        } else if (!facts.locked) {
            // No ψ holds it: it falls behind the swirl, whether it leaves the wall or not.
            EXPECT_LT(end.state.psi, psi - 0.1) << i;
            ++others;
        }
    }
    std::printf("  %d lock, %d do not\n", locks, others);
    EXPECT_GT(locks, 20);
    EXPECT_GT(others, 5);
}

/// F's coordinates after one return step through the same contact; empty where it leads otherwise.
template <class Map>
std::vector<double> next_of(const ReturnMap<Map>& back, const SectionPoint<double>& z, const ReturnStep<double>& like) {
    const ReturnStep<double> step = back.advance(post_impact_state(z));
    if (step.outcome != Outcome::completed || step.contacts.size() != like.contacts.size() ||
        step.collision.vertex_step != like.collision.vertex_step)
        return {};
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
        if (step.contacts[i].finish != like.contacts[i].finish || step.contacts[i].motion != like.contacts[i].motion)
            return {};
    const auto next = coordinates<Map::shape>(section_point(step.collision.after));
    return {next.begin(), next.end()};
}

struct Compared {
    int states = 0, wrong = 0;
    double worst = 0;

    /// One column of a derivative against central differences.
    template <class Column>
    void column(const Column& column, const std::vector<double>& ahead, const std::vector<double>& behind,
                double width) {
        double largest = 1, off = 0;
        for (std::size_t i = 0; i < ahead.size(); ++i) {
            const bool angle = i == 0 || (ahead.size() == 5 && i == 1);
            const double change = ahead[i] - behind[i];
            const double rate = (angle ? std::remainder(change, 2 * pi<double>()) : change) / width;
            largest = std::max(largest, std::abs(rate));
            off = std::max(off, std::abs(rate - column[static_cast<long>(i)]));
        }
        ++states;
        worst = std::max(worst, off / largest);
        wrong += off / largest > 1e-4 ? 1 : 0;
    }
};

template <class Map>
void compare_derivatives(const Map& map, const SectionPoint<double>& z, const ReturnStep<double>& known,
                         Compared& by_state, Compared& along_drag) {
    const ReturnMap<Map> back(map);
    const auto derivative = derivative_through_contact(back, z, known);
    if (!derivative.allFinite() || has_rested(known)) return;
    // Along what keeps u_n = v_n − αS sin χ − β sin ψ, which is smaller than any step after the last impact of chatter.
    const double h = 1e-7, beta = map.body().beta, alpha = Map::shape == Shape::disk ? 0 : map.body().alpha;
    struct Direction {
        double SectionPoint<double>::*member;
        double vn;
        int column;
    };
    constexpr bool turns = Map::shape == Shape::polygon;
    const Direction directions[] = {{&SectionPoint<double>::psi, beta * std::cos(z.psi), 0},
                                    {&SectionPoint<double>::chi, alpha * z.spin * std::cos(z.chi), 1},
                                    {&SectionPoint<double>::vt, 0, turns ? 3 : 2},
                                    {&SectionPoint<double>::spin, alpha * std::sin(z.chi), turns ? 4 : 3}};
    for (const Direction& direction : directions) {
        if (!turns && direction.column == 1) continue;
        SectionPoint<double> ahead = z, behind = z;
        ahead.*direction.member += h;
        behind.*direction.member -= h;
        ahead.vn += h * direction.vn;
        behind.vn -= h * direction.vn;
        const auto a = next_of(back, ahead, known), b = next_of(back, behind, known);
        const auto along = (derivative.col(direction.column) + direction.vn * derivative.col(turns ? 2 : 1)).eval();
        if (!a.empty() && !b.empty()) by_state.column(along, a, b, 2 * h);
    }
    Scene<double> more = map.scene(), less = more;
    more.drag += h;
    less.drag -= h;
    const Map map_more(more), map_less(less);
    const ReturnMap<Map> back_more(map_more), back_less(map_less);
    const auto a = next_of(back_more, z, known), b = next_of(back_less, z, known);
    const auto along = derivative_along_contact(back, Parameter::drag, z, known);
    if (!a.empty() && !b.empty() && along.allFinite()) along_drag.column(along, a, b, 2 * h);
}

/// After impacts that end in contact, and leave it again.
TEST(DraggedContact, DerivativeThroughItIsThatOfDifferences) {
    tests::DraggedDraw draw(29);
    Compared by_state, along_drag;
    for (int i = 0; i < 160 && along_drag.states < 60; ++i) {
        Scene<double> scene = draw.scene(1e-2, 1);
        scene.sides = std::min(scene.sides, 12);
        scene.inertia_factor = uniform_inertia_factor<double>(scene.sides);
        scene.restitution = draw.uniform(0, 0.5);
        const SectionPoint<double> first = draw.point(scene);
        with_dragged_map(scene, [&](const auto& map) {
            const ReturnMap<std::decay_t<decltype(map)>> back(map);
            ReturnStep<double> step;
            step.collision.after = post_impact_state(first);
            for (int k = 0, seen = 0; k < 300 && seen < 3; ++k) {
                const SectionPoint<double> z = section_point(step.collision.after);
                if (back.advance(step) != Outcome::completed) return;
                if (step.contacts.empty()) continue;
                compare_derivatives(map, z, step, by_state, along_drag);
                ++seen;
            }
        });
    }
    std::printf("  DF: %d columns, %d off, largest %.1e; along drag: %d, %d off, largest %.1e\n", by_state.states,
                by_state.wrong, by_state.worst, along_drag.states, along_drag.wrong, along_drag.worst);
    EXPECT_GE(by_state.states, 60);
    EXPECT_GE(along_drag.states, 15);
    EXPECT_EQ(by_state.wrong, 0);
    EXPECT_EQ(along_drag.wrong, 0);
}

}  // namespace
}  // namespace swirl
