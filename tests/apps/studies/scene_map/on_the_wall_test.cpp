// The surface on which impacts at e = 0 end: F leads onto it, and its derivatives are those of differences.
#include "apps/studies/scene_map/on_the_wall.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/orbit/laboratory.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace swirl::studies {
namespace {

using tests::scene_of;

template <int D>
using Point = analysis::Vector<D>;

/// Points of the orbit from a random start after its first impacts.
template <int D>
std::vector<Point<D>> points_of(const Scene<double>& scene, int count) {
    const SceneMap<D> map(scene);
    ReturnStep<double> step = map.first_impact(random_start(scene.beta, paper_speed, 1, 0));
    std::vector<Point<D>> points;
    for (int i = 0; i < count && map.goes_on(step); ++i) {
        points.push_back(map.coordinates(step.collision.after));
        step = map.return_step(step.collision.after);
    }
    return points;
}

/// Largest difference between DP, ∂P/∂α and ∂P/∂β and central differences. Their error is h²/6 of a third derivative of
/// size 1, and ε/h = 2·10⁻¹⁰ of rounding.
template <int D>
double away_from_differences(const Scene<double>& scene, const Point<D>& z) {
    constexpr double h = 1e-6;  // what is near the wall stays so
    const auto moved = [&](const Scene<double>& s, const Point<D>& at) { return on_the_wall<D>(make_body(s), at).z; };
    const Body<double> body = make_body(scene);
    const WallState<D> at = on_the_wall<D>(body, z);
    double largest = 0;
    for (int i = 0; i < D; ++i) {
        const Point<D> d = h * Point<D>::Unit(i);
        const Point<D> slope = (moved(scene, z + d) - moved(scene, z - d)) / (2 * h);
        largest = std::max(largest, (slope - at.by_state.col(i)).template lpNorm<Eigen::Infinity>());
    }
    for (const Parameter parameter : {Parameter::alpha, Parameter::beta, Parameter::mu}) {
        Scene<double> copy = scene;
        const double p = number_of(copy, parameter);
        const Point<D> slope =
            (moved(with_parameter(scene, parameter, p + h), z) - moved(with_parameter(scene, parameter, p - h), z)) /
            (2 * h);
        largest = std::max(largest, (slope - at.along(parameter)).template lpNorm<Eigen::Infinity>());
    }
    return largest;
}

struct Seen {
    int all = 0, on_surface = 0, edges = 0;
};

/// States may also be near one of the smaller surfaces without being on it.
template <int D>
void expect_surface(const Scene<double>& scene, Seen& seen) {
    const Body<double> body = make_body(scene);
    for (const Point<D>& z : points_of<D>(scene, 200)) {
        const double size = 1 + z.template lpNorm<Eigen::Infinity>();
        const WallState<D> at = on_the_wall<D>(body, z);
        ++seen.all;
        if (at.beside > 1e-13 * size) continue;
        ++seen.on_surface;
        EXPECT_LE(away_from_differences<D>(scene, z), 1e-8 * size);
        seen.edges += at.by_state.row(1).isZero(0);
    }
}

TEST(OnTheWall, ImpactsWithoutRestitutionLeadThereAndItsDerivativesAreThoseOfDifferences) {
    Seen seen;
    for (const Law law : {Law::poisson, Law::newton, Law::stronge}) {
        expect_surface<polygon_dimension>(scene_of(3, 0.7415, 1.4442, 0.5, 0, law), seen);
        expect_surface<polygon_dimension>(scene_of(4, 0.7373, 1.3231, 1.5, 0, law), seen);
        expect_surface<polygon_dimension>(scene_of(8, 0.3378, 1.4511, 2, 0, law), seen);
        expect_surface<disk_dimension>(scene_of(disk_sides, 0.4, 0.9, 0.5, 0, law), seen);
    }
    EXPECT_GE(seen.on_surface, 0.9 * seen.all);
    EXPECT_GT(seen.edges, 100);
}

TEST(OnTheWall, OneBesideItIsTold) {
    const Body<double> body = make_body(scene_of(3, 0.7415, 1.4442, 0.5, 0));
    const Point<polygon_dimension> z = points_of<polygon_dimension>(scene_of(3, 0.7415, 1.4442, 0.5, 0), 50).back();
    ASSERT_TRUE(on_the_wall<polygon_dimension>(body, z).by_state.row(1).isZero(0));
    for (const double off : {1e-6, 1e-5}) {
        Point<polygon_dimension> beside = z;
        beside[1] += off;
        EXPECT_NEAR(on_the_wall<polygon_dimension>(body, beside).beside, off, 0.5 * off);
    }
    Point<polygon_dimension> far = z;
    far[1] += 1e-3;
    EXPECT_FALSE(on_the_wall<polygon_dimension>(body, far).by_state.row(1).isZero(0));
}

}  // namespace
}  // namespace swirl::studies
