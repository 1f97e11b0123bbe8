#include "map/dragged/floor_facts.hpp"

#include <cmath>
#include <limits>

namespace swirl {

namespace {

/// A disk on the wall, on which friction acts with −`turning` along the wall: κγ_rρ of rolling, 0 of sliding.
class WallMotion {
public:
    WallMotion(const Scene<double>& scene, double turning)
        : scene_(scene),
          turning_(turning),
          rho_(1 - scene.alpha),
          tilt_(scene.floor == Floor::table ? scene.drag : 0) {}

    /// What holds the disk back over the swirl's most: it is locked up to 1. Infinite without swirl.
    double locking_ratio() const {
        const double drive = scene_.beta * std::hypot(1, tilt_);
        return drive > 0 ? (scene_.drag * rho_ + turning_) / drive : std::numeric_limits<double>::infinity();
    }

    /// If it is locked; its spin is left 0.
    std::optional<LockedRolling> locked() const {
        const double ratio = locking_ratio();
        if (!(ratio <= 1)) return {};
        LockedRolling locked;
        locked.psi = -std::asin(ratio) - std::atan(tilt_);
        locked.force = scene_.beta * (std::cos(locked.psi) - tilt_ * std::sin(locked.psi)) + rho_;
        locked.friction = turning_ / locked.force;
        locked.holds = locked.force > 0 && scene_.mu >= locked.friction;
        locked.bounce_decay = scene_.drag - 2 * turning_ / locked.force;
        return locked;
    }

private:
    const Scene<double>& scene_;
    double turning_, rho_, tilt_;
};

}  // namespace

std::optional<LockedRolling> locked_sliding(const Scene<double>& scene) {
    validated(scene);
    if (!scene.is_disk() || scene.mu != 0 || scene.turning_drag() == 0) return {};
    return WallMotion(scene, 0).locked();
}

FloorFacts floor_facts(const Scene<double>& scene) {
    validated(scene);
    FloorFacts facts;
    const double rho = 1 - scene.alpha;
    facts.riding_radius = scene.floor == Floor::table ? scene.beta : scene.beta / std::hypot(1, scene.drag);
    facts.riding_room = rho - facts.riding_radius;
    facts.rides = scene.drag > 0 && facts.riding_room > 0;
    if (!scene.is_disk() || scene.mu == 0) return facts;
    const WallMotion rolling(scene, scene.inertia_factor * scene.turning_drag() * rho);
    facts.locking_ratio = rolling.locking_ratio();
    facts.locked = rolling.locked();
    if (facts.locked) facts.locked->spin = -rho / scene.alpha;
    return facts;
}

}  // namespace swirl
