#include "map/steady/edge_rest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swirl {

std::vector<EdgeRest> edge_rests(const Scene<double>& scene) {
    without_rounding(without_floor(validated(scene), "rest on an edge"), "rest on an edge");
    if (scene.is_disk() || scene.beta == 0) return {};
    const double mu = scene.mu, beta = scene.beta, alpha = scene.alpha;
    const double half = std::numbers::pi / scene.sides;
    const double sine = alpha * std::sin(half);  // of γ, half of the angle between the vertices
    const double cosine = std::sqrt((1 - sine) * (1 + sine));
    const double d = cosine - alpha * std::cos(half);  // from the container's centre to the body's
    const double c = mu / (cosine * (1 + mu * mu));
    const double across = beta * (d - c * mu), along = beta * c;  // across sin ψ + along cos ψ = −c d
    const double size = std::hypot(across, along);
    if (!(c * d <= size) || mu * (1 - d * cosine) > d * sine) return {};
    const double inertia = scene.inertia_factor * alpha * alpha + d * d - c * mu * d;
    std::vector<EdgeRest> rests;
    for (const double sign : {-1.0, 1.0}) {
        const double psi =
            std::remainder(std::atan2(across, along) + sign * std::acos(-c * d / size), 2 * std::numbers::pi);
        const double force = (d + beta * std::cos(psi) - mu * beta * std::sin(psi)) / (cosine * (1 + mu * mu));
        const double stiffness = across * std::cos(psi) - along * std::sin(psi);
        if (force > 0) rests.push_back({psi, force, inertia > 0 && stiffness > 0});
    }
    std::sort(rests.begin(), rests.end(), [](const EdgeRest& a, const EdgeRest& b) { return a.psi < b.psi; });
    return rests;
}

}  // namespace swirl
