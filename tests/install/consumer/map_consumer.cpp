// Swirl::map brings what its headers need: Eigen and the Jets that differentiate the map.
#include "map/numbers/jets.hpp"

#include <Eigen/Core>

#include <cstdio>

int main() {
    const ceres::Jet<double, 1> x(3.0, 0);  // d(x²)/dx = 2x
    const ceres::Jet<double, 1> square = x * x;
    std::printf("x^2 at 3: %g, derivative %g\n", square.a, square.v(0));
    return square.a == 9.0 && square.v(0) == 6.0 ? 0 : 1;
}
