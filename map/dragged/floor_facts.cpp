#include "map/dragged/floor_facts.hpp"

#include <cmath>
#include <limits>

namespace swirl {

FloorFacts floor_facts(const Scene<double>& scene) {
    validated(scene);
    FloorFacts facts;
    const bool table = scene.floor == Floor::table;
    const double drag = scene.drag, rho = 1 - scene.alpha, kappa = scene.inertia_factor;
    facts.riding_radius = table ? scene.beta : scene.beta / std::hypot(1, drag);
    facts.riding_room = rho - facts.riding_radius;
    facts.rides = drag > 0 && facts.riding_room > 0;
    if (!scene.is_disk() || scene.mu == 0) return facts;
    const double tilt = table ? drag : 0;
    const double held = (drag + kappa * scene.turning_drag()) * rho, drive = scene.beta * std::hypot(1, tilt);
    facts.locking_ratio = drive > 0 ? held / drive : std::numeric_limits<double>::infinity();
    if (!(*facts.locking_ratio <= 1)) return facts;
    LockedRolling locked;
    locked.psi = -std::asin(*facts.locking_ratio) - std::atan(tilt);
    locked.spin = -rho / scene.alpha;
    locked.force = scene.beta * (std::cos(locked.psi) - tilt * std::sin(locked.psi)) + rho;
    locked.friction = kappa * scene.turning_drag() * rho / locked.force;
    locked.bounce_decay = drag - 2 * kappa * rho * scene.turning_drag() / locked.force;
    locked.holds = locked.force > 0 && scene.mu >= locked.friction;
    facts.locked = locked;
    return facts;
}

}  // namespace swirl
