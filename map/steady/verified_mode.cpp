#include "map/steady/verified_mode.hpp"

#include "map/derivative/multipliers.hpp"
#include "map/derivative/saltation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>

namespace swirl {

namespace steady {

namespace {

double distance(const SectionPoint<double>& a, const SectionPoint<double>& b) {
    return std::max({std::fabs(wrapped_angle(a.psi - b.psi)), std::fabs(wrapped_angle(a.chi - b.chi)),
                     std::fabs(a.vn - b.vn), std::fabs(a.vt - b.vt), std::fabs(a.spin - b.spin)});
}

double size_of(const SectionPoint<double>& z) {
    return std::max({std::fabs(z.psi), std::fabs(z.vn), std::fabs(z.vt), std::fabs(z.spin)});
}

/// u_n before the impact, from that after it: C changes by B₂ p + B₃ q.
double speed_before(const Body<double>& body, const Collision<double>& collision) {
    const ContactKinematics<double> at = contact_kinematics(body, collision.after);
    return at.un + at.b2() * collision.impulse.normal + at.b3() * collision.impulse.tangential;
}

/// What rounding may move the time of impact by.
double time_rounding(const SectionPoint<double>& z, double speed) {
    return closing_units * epsilon<double>() * (1 + size_of(z)) / speed;
}

/// The next impact is the j-th vertex's at τ, and no mere touch.
bool is_expected(const MapOfScene& map, long long j, double tau, const SectionPoint<double>& z,
                 const Collision<double>& collision) {
    if (collision.outcome != FirstContactOutcome::contact) return false;
    if (!map.scene.is_disk() && (collision.vertex_step - j) % map.scene.sides != 0) return false;
    const double speed = speed_before(map.body, collision);
    return speed >= least_speed && std::fabs(collision.flight_time - tau) <= time_rounding(z, speed) + 1e-12 * tau;
}

}  // namespace

MapOfScene map_of(const Scene<double>& scene) {
    return with_collision_map(scene, [&](const auto& map) -> MapOfScene {
        const auto kept = std::make_shared<std::decay_t<decltype(map)>>(map);
        return {scene, make_body(scene), [kept](const SectionPoint<double>& z, bool with_derivative) -> Seen {
                    if (!with_derivative) return {kept->advance(post_impact_state(z)), {}};
                    const auto step = linearise_by_saltation(*kept, z);
                    return {step.collision, step.derivative};
                }};
    });
}

bool arrives(const MapOfScene& map, long long j, double tau, const SectionPoint<double>& z) {
    return is_expected(map, j, tau, z, map.apply(z, false).collision);
}

std::optional<SteadyMode> verified_mode(const MapOfScene& map, SteadyBranch branch, long long j, double tau,
                                        const SectionPoint<double>& z) {
    if (!arrives(map, j, tau, z)) return {};
    const auto& [collision, derivative] = map.apply(z, true);
    SteadyMode mode;
    mode.branch = branch, mode.j = j, mode.tau = tau, mode.chi = z.chi, mode.point = z;
    mode.contact = collision.impulse.mode;
    mode.speed = speed_before(map.body, collision);
    mode.residual = distance(section_point(collision.after), z);
    mode.amplification = derivative.norm();
    const double closed =
        time_rounding(z, mode.speed) * ((1 + mode.amplification) * mode.speed + 1 + std::fabs(z.spin));
    if (!(mode.residual <= closed)) return {};
    const Eigen::VectorXcd values = multipliers_of(derivative);
    mode.multipliers.assign(values.begin(), values.end());
    std::sort(mode.multipliers.begin(), mode.multipliers.end(),
              [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
    return mode;
}

}  // namespace steady

}  // namespace swirl
