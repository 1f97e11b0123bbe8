// Seeded random scenes and states for the tests of the map.
#pragma once

#include "map/model/section.hpp"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace swirl::tests {

/// Numbers that are the same with every standard library: the engine is specified, its distributions are not.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    double log_between(double low, double high) { return low * std::pow(high / low, unit()); }
    double sign() { return unit() < 0.5 ? -1.0 : 1.0; }
    double angle() { return between(-M_PI, M_PI); }
    bool chance(double probability) { return unit() < probability; }
    int one_of(std::initializer_list<int> values) { return values.begin()[engine_() % values.size()]; }

private:
    std::mt19937_64 engine_;
};

/// χ_m = π/N − asin(α sin(π/N)): |χ| up to which the other vertices have room (map/README.md, "Impact"); 0 for the
/// disk.
inline double largest_chi(const Scene<double>& scene) {
    if (scene.is_disk()) return 0;
    return M_PI / scene.sides - std::asin(scene.alpha * std::sin(M_PI / scene.sides));
}

/// A polygon or disk of any kind in the ranges of map/README.md, "Scene".
inline Scene<double> random_scene(Random& random, int sides, double mu, double restitution, Law law) {
    Scene<double> scene;
    scene.sides = sides;
    scene.alpha = random.between(0.05, 0.95);
    scene.beta = random.chance(0.2) ? random.between(1, 5) : random.between(0.02, 1);
    scene.mu = mu;
    scene.restitution = restitution;
    scene.law = law;
    scene.inertia_factor = uniform_inertia_factor<double>(sides);
    return scene;
}

/// A state just after an impact that leaves the wall with |u_n| = `leaving`; all other vertices inside.
inline SectionPoint<double> random_point(Random& random, const Scene<double>& scene, double leaving, double speed = 1,
                                         double spin = 3) {
    SectionPoint<double> z;
    z.psi = random.angle();
    z.chi = 0.999 * largest_chi(scene) * random.between(-1, 1);
    z.spin = spin * random.between(-1, 1);
    z.vt = speed * random.between(-1, 1) + scene.beta * std::cos(z.psi);
    z.vn = -leaving + scene.alpha * z.spin * std::sin(z.chi) + scene.beta * std::sin(z.psi);
    return z;
}

}  // namespace swirl::tests
