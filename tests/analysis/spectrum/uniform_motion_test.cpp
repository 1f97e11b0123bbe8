#include "analysis/spectrum/uniform_motion.hpp"

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <complex>
#include <stdexcept>

namespace {

using namespace swirl::analysis;
using Complex = std::complex<double>;

TEST(UniformMotion, TheIntegralIsThatOfThePosition) {
    const UniformMotion motion{{0.3, -0.2}, {0.7, 0.4}, 1.5};
    for (const Frame frame : {Frame::laboratory, Frame::container, Frame::corotating}) {
        for (const double length : {1e-3, 0.15, 0.25, 1.0, 4.0}) {
            const double a = 2.1;
            const auto part = [&](auto component) {
                return boost::math::quadrature::gauss<double, 30>::integrate(
                    [&](double t) { return component(position_at(motion, t, frame, 0.6)); }, a, a + length);
            };
            const Complex exact(part([](Complex z) { return z.real(); }), part([](Complex z) { return z.imag(); }));
            const Complex found = position_integral(motion, a, a + length, frame, 0.6);
            EXPECT_LT(std::abs(found - exact), 1e-14 * length * 4) << name_of(frame) << " " << length;
        }
    }
}

TEST(UniformMotion, TheSwirlItselfRestsInItsOwnFrames) {
    const UniformMotion resting{{0.5, 0}, {0, 0}, 0};
    EXPECT_EQ(position_at(resting, 0, Frame::container, 0.5), Complex(0, 0));
    EXPECT_EQ(position_at(resting, 0, Frame::corotating, 0.5), Complex(0.5, 0));
    EXPECT_EQ(frame_from_name("corotating"), Frame::corotating);
    EXPECT_THROW(frame_from_name("moon"), std::invalid_argument);
}

}  // namespace
