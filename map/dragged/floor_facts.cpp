#include "map/dragged/floor_facts.hpp"

#include <cmath>
#include <limits>

namespace swirl {

namespace {

/// The disk's drag over the swirl's most, for drag that holds back the centre and, by friction f = −`turning`, its
/// spin.
struct Locking {
    double rho, tilt, ratio;

    Locking(const Scene<double>& scene, double turning)
        : rho(1 - scene.alpha), tilt(scene.floor == Floor::table ? scene.drag : 0) {
        const double drive = scene.beta * std::hypot(1, tilt);
        ratio = drive > 0 ? (scene.drag * rho + turning) / drive : std::numeric_limits<double>::infinity();
    }

    LockedRolling motion(const Scene<double>& scene, double turning) const {
        LockedRolling locked;
        locked.psi = -std::asin(ratio) - std::atan(tilt);
        locked.force = scene.beta * (std::cos(locked.psi) - tilt * std::sin(locked.psi)) + rho;
        locked.bounce_decay = scene.drag - 2 * turning / locked.force;
        locked.friction = turning / locked.force;
        locked.holds = locked.force > 0 && scene.mu >= locked.friction;
        return locked;
    }
};

}  // namespace

std::optional<LockedRolling> locked_sliding(const Scene<double>& scene) {
    validated(scene);
    if (!scene.is_disk() || scene.mu != 0) return {};
    const Locking locking(scene, 0);
    if (!(locking.ratio <= 1)) return {};
    LockedRolling locked = locking.motion(scene, 0);
    locked.spin = scene.turning_drag() > 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
    return locked;
}

FloorFacts floor_facts(const Scene<double>& scene) {
    validated(scene);
    FloorFacts facts;
    const double rho = 1 - scene.alpha;
    facts.riding_radius = scene.floor == Floor::table ? scene.beta : scene.beta / std::hypot(1, scene.drag);
    facts.riding_room = rho - facts.riding_radius;
    facts.rides = scene.drag > 0 && facts.riding_room > 0;
    if (!scene.is_disk() || scene.mu == 0) return facts;
    const double turning = scene.inertia_factor * scene.turning_drag() * rho;
    const Locking locking(scene, turning);
    facts.locking_ratio = locking.ratio;
    if (!(locking.ratio <= 1)) return facts;
    facts.locked = locking.motion(scene, turning);
    facts.locked->spin = -rho / scene.alpha;
    return facts;
}

}  // namespace swirl
