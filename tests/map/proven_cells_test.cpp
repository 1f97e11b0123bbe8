// Cells of a plane with a proven number of fixed points: against the list of all fixed points at single parameters, and
// what is false refused by the check.
#include "map/proof/all_fixed_points.hpp"
#include "map/proof/steady_cells.hpp"
#include "map/proof_check/stated_plane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::tests {
namespace {

using cells::PlaneCell;
using proof::PlaneScene;

const auto go_on = [] { return false; };

Scene<double> hexagon(Law law = Law::poisson) {
    return {6, 0.4, 0.5, 0.5, 0.95, law, uniform_inertia_factor<double>(6)};
}

struct Plane {
    PlaneScene scene;
    cells::ParameterCell all;
    cells::PlanePiece piece;
    double share = 0;
};

/// Both sides halved so often.
Plane plane_of(const Scene<double>& scene, const std::array<Parameter, 2>& parameters, const cells::ParameterCell& all,
               int halvings, double max_time) {
    Plane plane{{scene, parameters, max_time}, all, {}};
    cells::PlaneLimits limits;
    for (std::size_t i = 0; i < 2; ++i) limits.least[i] = (all.high[i] - all.low[i]) / (1 << halvings);
    plane.piece = proof::proven_piece(plane.scene, all, limits, go_on);
    for (const PlaneCell& cell : plane.piece.cells)
        if (cell.proven) plane.share += 1.0 / static_cast<double>(1ULL << static_cast<unsigned>(cell.depth));
    return plane;
}

Plane small_plane() {
    return plane_of(hexagon(), {Parameter::alpha, Parameter::beta}, {{0.3, 0.5}, {0.31, 0.51}}, 4, 3);
}

/// At random places of proven cells a whole list of fixed points has the cell's counts.
void expect_counts_at_random_places(const Plane& plane, int count, unsigned seed) {
    std::vector<const PlaneCell*> proven;
    for (const PlaneCell& cell : plane.piece.cells)
        if (cell.proven) proven.push_back(&cell);
    ASSERT_FALSE(proven.empty());
    std::mt19937 draw(seed);
    for (int i = 0; i < count; ++i) {
        const PlaneCell& cell = *proven[draw() % proven.size()];
        Scene<double> scene = plane.scene.base;
        for (std::size_t k = 0; k < 2; ++k) {
            const double share = std::uniform_real_distribution<double>(0, 1)(draw);
            number_of(scene, plane.scene.parameters[k]) = cell.low[k] + share * (cell.high[k] - cell.low[k]);
        }
        const auto all = proof::all_fixed_points(scene, plane.scene.max_time, go_on);
        ASSERT_TRUE(all.complete());
        int attracting = 0, saddles = 0, repelling = 0;
        for (const auto& proof : all.proven) {
            attracting += proof.stability == proof::ProvenStability::attracting ? 1 : 0;
            saddles += proof.stability == proof::ProvenStability::saddle ? 1 : 0;
            repelling += proof.stability == proof::ProvenStability::repelling ? 1 : 0;
        }
        EXPECT_EQ(static_cast<int>(all.proven.size()), cell.fixed_points) << scene.alpha << ' ' << scene.beta;
        EXPECT_EQ(attracting, cell.attracting) << scene.alpha << ' ' << scene.beta;
        EXPECT_EQ(saddles, cell.saddles) << scene.alpha << ' ' << scene.beta;
        EXPECT_EQ(repelling, cell.repelling) << scene.alpha << ' ' << scene.beta;
    }
}

proof_check::StatedPlane stated(const Plane& plane) {
    const Scene<double>& scene = plane.scene.base;
    proof_check::StatedPlane result;
    result.scene.sides = scene.sides;
    result.scene.alpha = scene.alpha;
    result.scene.beta = scene.beta;
    result.scene.mu = scene.mu;
    result.scene.restitution = scene.restitution;
    result.scene.inertia_factor = scene.inertia_factor;
    result.scene.uniform_lamina = true;
    result.scene.law = std::string(name_of(scene.law));
    result.names = {std::string(name_of(plane.scene.parameters[0])), std::string(name_of(plane.scene.parameters[1]))};
    result.plane = plane.all;
    result.max_time = plane.scene.max_time;
    for (const PlaneCell& cell : plane.piece.cells)
        if (cell.proven) result.proven.push_back(cell);
    return result;
}

TEST(ProvenCells, HaveTheFixedPointsThatAreListedAtSingleParameters) {
    const Plane plane = small_plane();
    std::printf("%zu cells, %.1f %% of the plane proven\n", plane.piece.cells.size(), 100 * plane.share);
    EXPECT_GT(plane.share, 0.8);
    expect_counts_at_random_places(plane, 4, 1);
}

TEST(ProvenCells, AreProvenAgainByOtherEquationsAndNoOtherCountsAre) {
    const Plane plane = small_plane();
    const proof_check::StatedPlane all = stated(plane);
    EXPECT_EQ(proof_check::what_fails(all, go_on), "");
    for (int PlaneCell::*count :
         {&PlaneCell::fixed_points, &PlaneCell::attracting, &PlaneCell::saddles, &PlaneCell::repelling})
        for (const int more : {1, -1}) {
            proof_check::StatedPlane edited = all;
            edited.proven = {all.proven[all.proven.size() / 2]};
            edited.proven.front().*count += more;
            EXPECT_NE(proof_check::what_fails(edited, go_on), "");
        }
    proof_check::StatedPlane other = all;
    other.proven.resize(1);
    other.scene.mu = 0.2;  // there are fewer whose friction holds
    EXPECT_NE(proof_check::what_fails(other, go_on), "");
    other = all;
    other.proven = {other.proven.front(), other.proven.front()};
    EXPECT_NE(proof_check::what_fails(other, go_on), "");
    other = all;
    other.names[1] = other.names[0];
    EXPECT_THROW(proof_check::what_fails(other, go_on), std::invalid_argument);
}

TEST(ProvenCellsNightly, HoldForAllLawsAndParameters) {
    struct Case {
        Scene<double> scene;
        std::array<Parameter, 2> parameters;
        cells::ParameterCell all;
    };
    const auto scene = [](int sides, double alpha, double beta, double mu, double e, Law law) {
        return Scene<double>{sides, alpha, beta, mu, e, law, uniform_inertia_factor<double>(sides)};
    };
    using P = Parameter;
    unsigned seed = 2;
    for (const Case& c :
         {Case{hexagon(), {P::alpha, P::beta}, {{0.2, 0.1}, {0.7, 0.9}}},
          Case{hexagon(Law::newton), {P::mu, P::restitution}, {{0.2, 0.8}, {0.7, 0.95}}},
          Case{hexagon(Law::stronge), {P::beta, P::mu}, {{0.2, 0.2}, {0.7, 0.9}}},
          Case{scene(3, 0.4, 0.5, 0.5, 0.9, Law::poisson), {P::alpha, P::beta}, {{0.3, 0.3}, {0.6, 0.7}}},
          Case{scene(4, 0.4, 0.5, 0.3, 0.9, Law::stronge), {P::alpha, P::mu}, {{0.3, 0.2}, {0.6, 0.7}}}}) {
        const Plane plane = plane_of(c.scene, c.parameters, c.all, 6, 4);
        std::printf("%zu cells, %.1f %% of the plane proven\n", plane.piece.cells.size(), 100 * plane.share);
        EXPECT_GT(plane.share, 0.4);
        expect_counts_at_random_places(plane, 40, seed++);
        EXPECT_EQ(proof_check::what_fails(stated(plane), go_on), "");
    }
}

}  // namespace
}  // namespace swirl::tests
