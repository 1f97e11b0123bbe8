// The cycles of tests/references/cycles.json and the steady modes of steady_e1.json there: points and multipliers.
#include "map/derivative/multipliers.hpp"
#include "map/derivative/saltation.hpp"
#include "tests/map/differentiated_map.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <vector>

namespace swirl {
namespace {

using nlohmann::json;
using Complex = std::complex<double>;

double distance(const SectionPoint<double>& a, const SectionPoint<double>& b) {
    return std::max({std::fabs(wrapped_angle(a.psi - b.psi)), std::fabs(wrapped_angle(a.chi - b.chi)),
                     std::fabs(a.vn - b.vn), std::fabs(a.vt - b.vt), std::fabs(a.spin - b.spin)});
}

/// Largest error of a set of multipliers, relative for those above 1: each in turn, by falling modulus, is paired with
/// the nearest one left. (Sorting both would mispair those of equal modulus.)
double multiplier_error(const Eigen::VectorXcd& found, const json& listed) {
    std::vector<Complex> left(found.begin(), found.end());
    if (left.size() != listed.size()) return HUGE_VAL;
    double worst = 0;
    for (const json& m : listed) {
        const Complex wanted(m[0].get<double>(), m[1].get<double>());
        const auto nearest = std::min_element(left.begin(), left.end(), [&](const Complex& a, const Complex& b) {
            return std::abs(a - wanted) < std::abs(b - wanted);
        });
        worst = std::max(worst, std::abs(*nearest - wanted) / std::max(1.0, std::abs(wanted)));
        left.erase(nearest);
    }
    return worst;
}

/// |F^k(z) − z|, the return time's error and both forms' multipliers.
template <class Map>
void check_cycle(const Map& map, const json& cycle, double tolerance) {
    constexpr Shape shape = Map::shape;
    constexpr int dimension = section_dimension<shape>;
    using Matrix = Eigen::Matrix<double, dimension, dimension>;
    const auto start = tests::point_from<double>(cycle["point"]);
    const int period = cycle["period"];
    const tests::DifferentiatedMap differentiated(map);
    Matrix jets = Matrix::Identity(), saltation = Matrix::Identity();
    SectionPoint<double> z = start;
    double time = 0;
    for (int k = 0; k < period; ++k) {
        const auto step = differentiated.linearise(z);
        ASSERT_EQ(step.collision.outcome, FirstContactOutcome::contact);
        jets = step.derivative * jets;
        saltation = linearise_by_saltation(map, z).derivative * saltation;
        time += step.collision.flight_time;
        z = section_point(step.collision.after);
    }
    const double residual = distance(z, start);
    const double by_jets = multiplier_error(multipliers_of(jets), cycle["multipliers"]);
    const double by_saltation = multiplier_error(multipliers_of(saltation), cycle["multipliers"]);
    std::printf("N %3d period %2d  |F^k(z)-z| %.1e  multipliers: jets %.1e, saltation %.1e\n", map.scene().sides,
                period, residual, by_jets, by_saltation);
    EXPECT_LE(residual, 1e-12);
    EXPECT_NEAR(time, tests::number<double>(cycle["return_time"]), 1e-12 * period);
    EXPECT_LE(by_jets, tolerance);
    EXPECT_LE(by_saltation, tolerance);
}

void check_all(const char* file, int wanted, double tolerance = 1e-9) {
    const json references = tests::read_reference(file);
    int count = 0;
    for (const json& cycle : references["cycles"]) {
        SCOPED_TRACE(std::string(file) + ", number " + std::to_string(count++));
        with_collision_map(tests::scene_from<double>(cycle),
                           [&](const auto& map) { check_cycle(map, cycle, tolerance); });
    }
    EXPECT_EQ(count, wanted);
}

TEST(Cycles, ReferenceCyclesCloseWithTheirMultipliers) {
    check_all("cycles.json", 20);
}
TEST(Cycles, ReferenceSteadyModesCloseWithTheirMultipliers) {
    check_all("steady_e1.json", 10);
}

// Two of them strike so softly (u_n = 4e-4) that a multiplier is 4e4: rounding their points to double alone moves it by
// 2e-10 of itself.
TEST(Cycles, ReferenceFixedPointsOfAHexagonCloseWithTheirMultipliers) {
    check_all("fixed_points.json", 31, 1e-8);
}

}  // namespace
}  // namespace swirl
