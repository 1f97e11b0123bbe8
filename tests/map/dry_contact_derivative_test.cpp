// The derivative of the return map through contact over a floor with dry friction, against differences.
#include "map/orbit/dry_return_derivative.hpp"
#include "tests/map/on_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace swirl {
namespace {

using tests::Draw;

/// Contact that lasts longer is no way to an impact here, in 1/ω_s.
constexpr double soon = 30;

template <class Map>
constexpr std::size_t coordinates_of = section_dimension<Map::shape>;

template <class Map>
using Coordinates = std::array<double, coordinates_of<Map>>;

template <class Map>
PostImpactState<double> state_of(const Coordinates<Map>& c) {
    return post_impact_state(section_point<Map::shape>(c));
}

/// Of v_n among the coordinates.
template <class Map>
constexpr std::size_t normal_velocity = coordinates_of<Map> - 3;

/// A state with one coordinate changed, on the surface u_n = const, on which contact begins at once; nothing where the
/// way from there is another.
template <class Map>
struct Side {
    Coordinates<Map> from, to;
};

std::string way_of(const std::vector<ContactSegment>& pieces) {
    std::string way;
    for (const ContactSegment& piece : pieces)
        way += std::string(name_of(piece.support, piece.motion)) + std::string(name_of(piece.finish)) + " ";
    return way;
}

template <class Map>
std::optional<Side<Map>> side_of(const ReturnMap<Map>& back, const Coordinates<Map>& here, std::size_t j, double change,
                                 const std::string& way) {
    const auto un_of = [&](const auto& c) { return contact_kinematics(back.map().body(), state_of<Map>(c)).un; };
    Side<Map> side{here, {}};
    side.from[j] += change;
    side.from[normal_velocity<Map>] += un_of(here) - un_of(side.from);
    const auto step = back.advance(state_of<Map>(side.from), soon);
    if (step.outcome != Outcome::completed || way_of(step.contacts) != way) return {};
    side.to = coordinates<Map::shape>(section_point(step.collision.after));
    return side;
}

struct Checked {
    int columns = 0;
    double worst = 0;
    std::map<std::string, int> ways;
};

/// Against differences over ± h and ± h/2, extrapolated.
template <class Map>
void check_derivative(const ReturnMap<Map>& back, const SectionPoint<double>& z, Checked& checked) {
    const auto here = coordinates<Map::shape>(z);
    const auto known = back.advance(post_impact_state(z), soon);
    const auto derivative = derivative_through_contact(back, z, known);
    const std::string way = way_of(known.contacts);
    constexpr double h = 1e-5;
    for (std::size_t j = 0; j < here.size(); ++j) {
        if (j == normal_velocity<Map>) continue;
        std::array<std::optional<Side<Map>>, 4> sides;
        const double changes[] = {h, -h, 0.5 * h, -0.5 * h};
        for (std::size_t s = 0; s < 4; ++s) sides[s] = side_of<Map>(back, here, j, changes[s], way);
        if (!std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.has_value(); })) continue;
        const std::size_t vn = normal_velocity<Map>;
        const double by_vn = (sides[0]->from[vn] - sides[1]->from[vn]) / (2 * h);
        for (std::size_t i = 0; i < here.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
            const double whole = (sides[0]->to[i] - sides[1]->to[i]) / (2 * h),
                         half = (sides[2]->to[i] - sides[3]->to[i]) / h;
            const double expected = derivative(row, column) + by_vn * derivative(row, static_cast<Eigen::Index>(vn));
            const double scale = 1 + derivative.cwiseAbs().maxCoeff();
            const double off = std::abs((4 * half - whole) / 3 - expected) / scale;
            // Flights and contacts are known to 10⁻¹³, 10⁻⁸ by h, 10⁻⁷ where a landing's error goes with it; what
            // grazes bends more than the extrapolation knows: where both differences differ by more.
            const double bends = std::abs(half - whole) / scale;
            if (bends > 1e-4) continue;
            EXPECT_LT(off, 1e-6 + 0.1 * bends) << "row " << i << " column " << j << " way " << way;
            checked.worst = std::max(checked.worst, off);
        }
        ++checked.columns;
        ++checked.ways[way];
    }
}

void check_drawn(int seeds, const std::vector<int>& sides, Checked& checked) {
    for (int seed = 0; seed < seeds; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        const Scene<double> scene =
            tests::drawn_over_dry_floor(draw, sides[static_cast<std::size_t>(seed) % sides.size()]);
        if (std::abs(scene.floor_deceleration() / scene.beta - 1) < 1e-2)
            continue;  // map/dry/README.md, "not followed"
        with_dry_map(scene, [&](const auto& map) {
            using Map = std::decay_t<decltype(map)>;
            const ReturnMap<Map> back(map);
            const tests::OnWall body(scene);
            for (int k = 0; k < 10; ++k) {
                const double chi = Map::shape == Shape::disk ? 0 : draw(-0.95, 0.95) * body.wall.contact.widest_chi;
                PostImpactState<double> start = post_impact_state(
                    body.wall.contact, ContactState<double>{draw(-2, 2), chi, draw(-1, 1), draw(-2, 2)});
                start.vn -= 1e-9;
                const auto step = back.advance(start, soon);
                if (step.outcome != Outcome::completed || step.contacts.empty()) continue;
                if (step.contacts.back().end < 1e-2 || step.collision.impulse.normal < 1e-2) continue;  // grazing
                check_derivative(back, section_point(start), checked);
            }
        });
    }
    for (const auto& [way, count] : checked.ways) std::printf("  %s: %d\n", way.c_str(), count);
    std::printf("  %d columns, off by %.1e at most\n", checked.columns, checked.worst);
}

TEST(DryContact, TheDerivativeOfADiskIsThatOfDifferences) {
    Checked checked;
    check_drawn(12, {disk_sides}, checked);
    EXPECT_GT(checked.columns, 60);
}

TEST(DryContact, TheDerivativeOfAPolygonIsThatOfDifferences) {
    Checked checked;
    check_drawn(40, {rod_sides, 3, 4, 5, 6}, checked);
    EXPECT_GT(checked.columns, 100);
    EXPECT_GT(checked.ways.size(), 8U);
}

/// ∂F along numbers of the scene, through contact.
TEST(DryContact, TheDerivativeAlongTheSceneIsThatOfDifferences) {
    int columns = 0;
    double worst = 0;
    for (int seed = 0; seed < 40; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        const int sides[] = {disk_sides, 3, 6};
        const Scene<double> scene = tests::drawn_over_dry_floor(draw, sides[seed % 3]);
        with_dry_map(scene, [&](const auto& map) {
            using Map = std::decay_t<decltype(map)>;
            const tests::OnWall body(scene);
            const double chi = Map::shape == Shape::disk ? 0 : draw(-0.95, 0.95) * body.wall.contact.widest_chi;
            PostImpactState<double> start =
                post_impact_state(body.wall.contact, ContactState<double>{draw(-2, 2), chi, draw(-1, 1), draw(-2, 2)});
            start.vn -= 1e-9;
            const ReturnMap<Map> back(map);
            const auto known = back.advance(start, soon);
            if (known.outcome != Outcome::completed || known.contacts.empty()) return;
            if (known.contacts.back().end < 1e-2 || known.collision.impulse.normal < 1e-2) return;  // grazing
            const std::string way = way_of(known.contacts);
            for (const Parameter parameter : {Parameter::mu, Parameter::restitution}) {
                if (parameter == Parameter::mu && scene.mu == 0) continue;
                constexpr double h = 1e-5;
                const auto at = [&](double change) -> std::optional<Coordinates<Map>> {
                    Scene<double> moved = scene;
                    number_of(moved, parameter) += change;
                    const Map other(moved, nullptr, map.pressure());
                    const auto step = ReturnMap<Map>(other).advance(start, soon);
                    if (step.outcome != Outcome::completed || way_of(step.contacts) != way) return {};
                    return coordinates<Map::shape>(section_point(step.collision.after));
                };
                const auto more = at(h), less = at(-h);
                if (!more || !less) continue;
                const auto along = derivative_along_contact(back, parameter, section_point(start), known);
                for (std::size_t i = 0; i < more->size(); ++i) {
                    const double whole = ((*more)[i] - (*less)[i]) / (2 * h);
                    const double off = std::abs(whole - along[static_cast<Eigen::Index>(i)]) / (1 + std::abs(whole));
                    EXPECT_LT(off, 1e-5) << seed << " " << name_of(parameter) << " " << i << " way " << way;
                    worst = std::max(worst, off);
                }
                ++columns;
            }
        });
    }
    std::printf("  %d columns, off by %.1e at most\n", columns, worst);
    EXPECT_GT(columns, 20);
}

}  // namespace
}  // namespace swirl
