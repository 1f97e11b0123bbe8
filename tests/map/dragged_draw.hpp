// Random scenes over a floor that drags, and states that leave the wall.
#pragma once

#include "map/model/scene.hpp"
#include "map/model/section.hpp"

#include <cmath>
#include <random>

namespace swirl::tests {

struct DraggedDraw {
    std::mt19937_64 bits;
    explicit DraggedDraw(unsigned seed) : bits(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    double log(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

    int sides() {
        const double shape = uniform(0, 1);
        if (shape < 0.2) return disk_sides;
        return shape < 0.9 ? 3 + static_cast<int>(uniform(0, 10)) : static_cast<int>(log(13, 3000));
    }
    Scene<double> scene(double least_drag, double most_drag) {
        Scene<double> scene;
        scene.sides = sides();
        scene.alpha = uniform(0.1, 0.8);
        scene.beta = uniform(0, 1.5);
        scene.mu = uniform(0, 1) < 0.2 ? 0 : uniform(0, 2);
        scene.restitution = uniform(0.3, 1);
        scene.law = static_cast<Law>(static_cast<int>(uniform(0, 3)));
        scene.inertia_factor = uniform_inertia_factor<double>(scene.sides);
        scene.drag = log(least_drag, most_drag);
        if (uniform(0, 1) < 0.5) scene.spin_drag = uniform(0, 1) < 0.2 ? 0 : log(least_drag, most_drag);
        scene.floor = uniform(0, 1) < 0.5 ? Floor::dish : Floor::table;
        return scene;
    }
    /// A state that leaves the wall, in one of five slowly; every other vertex is inside.
    SectionPoint<double> point(const Scene<double>& scene) {
        SectionPoint<double> z{uniform(-3.14, 3.14), 0, 0, uniform(-1, 1), uniform(-3, 3)};
        if (!scene.is_disk()) {
            const double half = pi<double>() / scene.sides;
            z.chi = uniform(-0.999, 0.999) * (half - std::asin(scene.alpha * std::sin(half)));
        }
        const double leaving = uniform(0, 1) < 0.2 ? log(1e-6, 1e-2) : uniform(0.01, 2);
        z.vn = scene.alpha * z.spin * std::sin(z.chi) + scene.beta * std::sin(z.psi) - leaving;
        return z;
    }
};

}  // namespace swirl::tests
