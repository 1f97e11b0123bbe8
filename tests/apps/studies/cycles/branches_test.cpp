// Branches of polygons: their borders against the condition that makes them, their points against direct solution.
#include "apps/studies/branches/branches.hpp"
#include "analysis/continuation/continue_branch.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/collision_map.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace swirl {
namespace {

/// A copy: a loop over a member of a temporary would see nothing.
nlohmann::json listed(const std::string& file) {
    nlohmann::json cycles = tests::read_reference(file)["cycles"];
    EXPECT_GE(cycles.size(), 10U);
    return cycles;
}

/// [tests/references/README.md] The hexagon's fixed point.
nlohmann::json hexagon() {
    return {{"sides", 6},
            {"alpha", "0.4"},
            {"beta", "0.5"},
            {"mu", "0.5"},
            {"restitution", "0.9"},
            {"law", "poisson"},
            {"period", 1},
            {"point",
             {{"psi", "-0.083922288419212287574"},
              {"chi", "0.027966794811174552721"},
              {"vn", "-0.55420644250323559488"},
              {"vt", "0.88979354385790028771"},
              {"S", "-0.97926605821858726645"}}}};
}

struct Followed {
    Scene<double> scene;
    studies::SceneBranches system;
    analysis::Branch branch;
};

Followed follow(const nlohmann::json& c, const std::string& parameter_range_text) {
    const auto along = apps::parameter_range_from(parameter_range_text, false, true);
    Followed followed{tests::scene_from<double>(c), {}, {}};
    followed.system = studies::scene_branches(followed.scene, along);
    const double p = studies::value_of(followed.scene, along);
    const auto z = studies::coordinates_of(tests::point_from<double>(c["point"]), false);
    const auto guess = analysis::orbit_from(followed.system.map, z, p, c["period"]);
    EXPECT_TRUE(analysis::continue_branch(followed.system.map, guess, p, followed.system.options, followed.branch));
    return followed;
}

const analysis::SpecialPoint* first_of(const Followed& followed, const std::string& kind) {
    for (const auto& special : followed.branch.special)
        if (studies::kind_of(special) == kind) return &special;
    return nullptr;
}

// A steady mode that sticks has its impulse through the centre, q/p = −tan χ, and doesn't know μ: it begins to slide
// where μ = |tan χ|.
TEST(Branches, ASteadyModeBeginsToSlideWhereFrictionEnds) {
    const auto c = tests::read_reference("cycles.json")["cycles"][0];
    const auto followed = follow(c, "mu=0.01:0.9");
    const double threshold = std::tan(tests::number<double>(c["point"]["chi"]));
    double nearest = 1;
    for (const auto& special : followed.branch.special)
        if (studies::kind_of(special) == "stick-slip")
            nearest = std::min(nearest, std::abs(special.cycle.at.p() - threshold));
    EXPECT_LE(nearest, 1e-10);
}

/// The largest gap of any vertex within the flights of a cycle, their ends apart.
double largest_inner_gap(const Scene<double>& scene, const analysis::CurvePoint& cycle) {
    const auto body = make_body(scene);
    const auto points = cycle.points();
    double largest = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto flight = flight_from(body, post_impact_state(studies::section_point_of(points[i])));
        const double duration = cycle.shooting.steps[i].duration;
        for (int k = 0; k < scene.sides; ++k) {
            const auto gap = [&](double t) {
                const auto at = instant_at<Shape::polygon>(flight, t);
                const auto x = at.centre + body.turned_to_vertex(at.arm, k);
                return dot(x, x) - 1;
            };
            constexpr int samples = 20'000;
            for (int j = 1; j < samples; ++j) {
                const double t = duration * j / samples, h = duration / samples;
                if (gap(t) < gap(t - h) || gap(t) < gap(t + h)) continue;
                double low = t - h, high = t + h;  // golden section on the maximum
                for (int n = 0; n < 80; ++n) {
                    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
                    (gap(a) > gap(b) ? high : low) = gap(a) > gap(b) ? b : a;
                }
                largest = std::max(largest, gap(0.5 * (low + high)));
            }
        }
    }
    return largest;
}

TEST(Branches, AGrazingIsLocatedToRounding) {
    int seen = 0;
    const auto cycles = tests::read_reference("cycles.json")["cycles"];
    for (const std::size_t i : {1U, 3U}) {
        const auto followed = follow(cycles[i], "alpha=0.05:0.97");
        const auto* grazing = first_of(followed, "grazing");
        if (grazing == nullptr) continue;
        ++seen;
        EXPECT_FALSE(grazing->goes_on);
        const auto scene = with_parameter(followed.scene, Parameter::alpha, grazing->cycle.at.p());
        // 10⁻¹⁰ in the parameter.
        EXPECT_NEAR(largest_inner_gap(scene, grazing->cycle.at), 0, 1e-9) << "cycle " << i;
    }
    EXPECT_GT(seen, 0);
}

/// The second vertex's gap at the impacts of a cycle, the smallest; or the shortest flight, at whose end it touches
/// too.
double nearest_to_two_vertices(const Scene<double>& scene, const analysis::CurvePoint& cycle) {
    const auto body = make_body(scene);
    const auto points = cycle.points();
    double nearest = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto flight = flight_from(body, post_impact_state(studies::section_point_of(points[i])));
        const auto at = instant_at<Shape::polygon>(flight, cycle.shooting.steps[i].duration);
        std::vector<double> gaps;
        for (int k = 0; k < scene.sides; ++k) {
            const auto x = at.centre + body.turned_to_vertex(at.arm, k);
            gaps.push_back(std::abs(dot(x, x) - 1));
        }
        std::sort(gaps.begin(), gaps.end());
        nearest = std::min({nearest, gaps[1], cycle.shooting.steps[i].duration});
    }
    return nearest;
}

TEST(Branches, TwoVerticesAreLocatedToRounding) {
    int seen = 0;
    for (const auto& c : listed("cycles.json")) {
        const auto followed = follow(c, "alpha=0.05:0.97");
        for (const auto& special : followed.branch.special) {
            if (studies::kind_of(special) != "two-vertices") continue;
            ++seen;
            const auto scene = with_parameter(followed.scene, Parameter::alpha, special.cycle.at.p());
            EXPECT_LE(nearest_to_two_vertices(scene, special.cycle.at), 1e-10) << "alpha = " << special.cycle.at.p();
        }
    }
    std::printf("%d borders of two vertices\n", seen);
    EXPECT_GE(seen, 5);
}

// What lies behind a border takes the time that the cycle takes: no impact slips in or is left out.
TEST(Branches, FlightsAreContinuousAlongABranch) {
    for (const char* along : {"beta=0:2", "alpha=0.01:0.99"}) {
        const auto followed = follow(hexagon(), along);
        ASSERT_GT(followed.branch.points.size(), 10U);
        for (std::size_t i = 1; i < followed.branch.points.size(); ++i) {
            const auto& a = followed.branch.points[i - 1].at;
            const auto& b = followed.branch.points[i].at;
            EXPECT_LE(std::abs(a.shooting.duration - b.shooting.duration), 0.1) << along << " = " << b.p();
            for (const auto& step : b.shooting.steps) EXPECT_GT(step.margin, 1e-6) << along << " = " << b.p();
        }
        for (const auto end : {followed.branch.begin, followed.branch.end})
            EXPECT_NE(end, analysis::CurveEnd::not_converged) << along;
    }
}

// The steady mode whose impacts fade as β → 1 − α.
TEST(Branches, WhereImpactsVanishIsLocated) {
    const auto followed = follow(hexagon(), "beta=0:2");
    const auto* grazing = first_of(followed, "grazing");
    ASSERT_NE(grazing, nullptr);
    EXPECT_FALSE(grazing->goes_on);
    double nearest = 1;
    for (const auto& special : followed.branch.special)
        if (studies::kind_of(special) == "grazing")
            nearest = std::min(nearest, std::abs(special.cycle.at.p() - (1 - followed.scene.alpha)));
    EXPECT_LE(nearest, 1e-10);
}

TEST(Branches, PointsAreCyclesOfTheirScenes) {
    const auto c = tests::read_reference("cycles.json")["cycles"][4];
    for (const char* along :
         {"alpha=0.4:0.6", "beta=0.4:0.6", "mu=0.5:0.7", "restitution=0.8:1", "inertia-factor=0.3:0.45"}) {
        const auto followed = follow(c, along);
        const auto parameter = apps::parameter_range_from(along, false, true).parameter.value();
        ASSERT_GT(followed.branch.points.size(), 5U) << along;
        for (std::size_t i = 0; i < followed.branch.points.size(); i += 7) {
            const auto& point = followed.branch.points[i];
            const auto map = studies::shooting_map_of(with_parameter(followed.scene, parameter, point.at.p()));
            const auto shooting = analysis::shooting_residual(map, point.at.points(), 0);
            ASSERT_TRUE(shooting.alive) << along;
            EXPECT_LE(shooting.residual(), 1e-12) << along << " = " << point.at.p();
        }
    }
}

// ∂F/∂p by Jets against central differences of F.
TEST(Branches, TheDerivativeAlongEveryParameter) {
    for (const auto& c : listed("cycles.json")) {
        const auto scene = tests::scene_from<double>(c);
        const auto z = studies::coordinates_of(tests::point_from<double>(c["point"]), false);
        for (const Parameter parameter : all_parameters) {
            if (parameter == Parameter::tangential_restitution) continue;  // of the disk alone
            const auto map = studies::shooting_map_of(scene, parameter);
            Scene<double> copy = scene;
            const bool vanishes = parameter == Parameter::drag || parameter == Parameter::corner;
            const double p = vanishes ? 0.05 : number_of(copy, parameter);
            constexpr double h = 1e-6;
            const auto step = map.step(z, p);
            const auto above = map.step(z, p + h), below = map.step(z, p - h);
            ASSERT_TRUE(step.alive && above.alive && below.alive);
            if (above.letter != below.letter) continue;
            const Eigen::VectorXd quotient = map.difference(above.state, below.state) / (2 * h);
            // h² of the third derivative and ε/h.
            EXPECT_LE((quotient - step.by_parameter).norm(), 1e-7 * (1 + step.by_parameter.norm()))
                << name_of(parameter);
        }
    }
}

}  // namespace
}  // namespace swirl
