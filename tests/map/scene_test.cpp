// Scenes and starts: which are invalid, and the error's text.
#include "map/orbit/laboratory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Scene<double> good_scene() {
    return {6, 0.4, 0.5, 0.5, 0.9, Law::poisson, uniform_inertia_factor<double>(6)};
}

template <class Call>
std::string refusal(Call&& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

std::string refusal_of(const Scene<double>& scene) {
    return refusal([&] { validated(scene); });
}

/// One line that has the parameter's name, its value and its range.
void expect_names(const std::string& message, const std::string& name, const std::string& value,
                  const std::string& range) {
    EXPECT_NE(message.find(name), std::string::npos) << message;
    EXPECT_NE(message.find(value), std::string::npos) << message;
    EXPECT_NE(message.find(range), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Scene, TheWholeRangeIsAccepted) {
    for (const int sides : {disk_sides, 3, 6, 1000, 1'000'000})
        for (const double alpha : {1e-6, 0.4, 0.999999})
            for (const double beta : {0.0, 0.5, 5.0})
                for (const double mu : {0.0, 0.5, 5.0})
                    for (const double e : {0.0, 0.5, 1.0})
                        EXPECT_EQ(refusal_of({sides, alpha, beta, mu, e, Law::stronge, 0.5}), "");
}

TEST(Scene, EveryParameterOutOfRangeIsRefusedByNameValueAndRange) {
    struct Wrong {
        double Scene<double>::*field;
        const char* name;
        const char* range;
        std::vector<double> values;
    };
    const std::vector<Wrong> wrongs = {
        {&Scene<double>::alpha, "alpha", "0 < alpha < 1", {0, 1, 1.2, -0.5, nan, infinity}},
        {&Scene<double>::beta, "beta", "beta >= 0", {-1e-9, -3, nan, infinity}},
        {&Scene<double>::mu, "mu", "mu >= 0", {-1, nan, infinity}},
        {&Scene<double>::restitution, "restitution", "0 <= restitution <= 1", {-0.5, 1.5, nan, infinity}},
        {&Scene<double>::inertia_factor, "inertia-factor", "inertia-factor > 0", {0, -1, nan, infinity}}};
    for (const Wrong& wrong : wrongs)
        for (const double value : wrong.values) {
            Scene<double> scene = good_scene();
            scene.*wrong.field = value;
            std::ostringstream text;
            text << value;  // the shortest number: none of these has more than six digits
            expect_names(refusal_of(scene), wrong.name, text.str(), wrong.range);
        }
    for (const int sides : {-1, 1, 1'000'001}) {
        Scene<double> scene = good_scene();
        scene.sides = sides;
        expect_names(refusal_of(scene), "sides", std::to_string(sides), "2 to 1000000");
    }
}

TEST(Scene, TheMapRefusesWhatTheSceneRefuses) {
    Scene<double> scene = good_scene();
    scene.alpha = nan;
    EXPECT_THROW((CollisionMap<double, Shape::polygon, ImpactRule::poisson>(scene)), std::invalid_argument);
}

TEST(Scene, UniformLaminasHaveTheirMomentsOfInertia) {
    EXPECT_NEAR(uniform_inertia_factor<double>(3), 0.25, 1e-15);     // I = m a²/12 with a = √3 R
    EXPECT_NEAR(uniform_inertia_factor<double>(4), 1.0 / 3, 1e-15);  // m a²/6, a = √2 R
    EXPECT_NEAR(uniform_inertia_factor<double>(6), 5.0 / 12, 1e-15);
    EXPECT_NEAR(uniform_inertia_factor<double>(1'000'000), 0.5, 1e-11);
    EXPECT_EQ(uniform_inertia_factor<double>(disk_sides), 0.5);
}

std::string refusal_of(const Scene<double>& scene, const LabStart<double>& start) {
    return refusal([&] { flight_from(make_body(scene), start); });
}

TEST(LabStart, OutsideTheContainerIsRefused) {
    Scene<double> scene = good_scene();
    EXPECT_EQ(refusal_of(scene, {0.5, 0, 0, 0, 0, 0}), "");
    expect_names(refusal_of(scene, {1.5, 0, 0, 0, 0, 0}), "start", " = 1.4 is outside", "at most 1");
    scene.sides = disk_sides;
    expect_names(refusal_of(scene, {0.5, 0.7, 0, 0, 0, 0}), "start", " = 1.1 is outside", "at most 1");
    EXPECT_EQ(refusal_of(scene, {0.5, 0.59, 0, 0, 0, 0}), "");
}

TEST(LabStart, OnlyVerticesCountNotTheCircumscribedCircle) {
    const Scene<double> scene = good_scene();  // hexagon, α = 0.4: an edge may face the wall up to |X| = 0.633
    EXPECT_EQ(refusal_of(scene, {0.5 + 0.63, 0, 0, 0, M_PI / 6, 0}), "");
    EXPECT_NE(refusal_of(scene, {0.5 + 0.63, 0, 0, 0, 0, 0}), "");
    EXPECT_NE(refusal_of(scene, {0.5 + 0.64, 0, 0, 0, M_PI / 6, 0}), "");
}

TEST(LabStart, EveryNumberThatIsNotFiniteIsRefusedByName) {
    const char* names[] = {"x", "y", "vx", "vy", "angle", "spin"};
    double LabStart<double>::*fields[] = {&LabStart<double>::x,  &LabStart<double>::y,     &LabStart<double>::vx,
                                          &LabStart<double>::vy, &LabStart<double>::angle, &LabStart<double>::spin};
    for (int i = 0; i < 6; ++i)
        for (const double value : {nan, infinity, -infinity}) {
            LabStart<double> start{0.5, 0, 0, 0, 0, 0};
            start.*fields[i] = value;
            expect_names(refusal_of(good_scene(), start), std::string(names[i]) + " = ",
                         std::isnan(value) ? "nan" : "inf", "any finite number");
        }
}

}  // namespace
}  // namespace swirl
