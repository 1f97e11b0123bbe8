// A scene and a start, any numbers. They are refused, or the orbit from there has finite states, impulses that do not
// pull, times that do not fall and vertices inside, ends with a name, and costs no more than its steps may.
#include "apps/command_line/start_options.hpp"
#include "apps/studies/scene_map/scene_orbit.hpp"
#include "apps/studies/scene_map/step_cost.hpp"
#include "map/first_contact/bounds.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <vector>

namespace swirl::apps {
namespace {

using tests::fuzz::Bytes, tests::fuzz::require;

constexpr int most_impacts = 60;
/// Of contact without an impact, a twentieth of the program's own: most of the time would go into motions that last.
constexpr double horizon = contact_horizon / 20;
/// In ordinary impacts: an orbit is left after so much. One step may cost more, see require_bounded.
constexpr double most_cost = 2'000;

/// κ: a body's is at most 1.
constexpr double least_inertia = 1e-100, most_inertia = 1e6;

Scene<double> scene_from(Bytes& bytes) {
    Scene<double> scene;
    switch (bytes.below(4)) {
        case 0:
            scene.sides = 3 + bytes.below(10);
            break;
        case 1:
            scene.sides = disk_sides;
            break;
        case 2:
            scene.sides = 3 + static_cast<int>(bytes.take<std::uint32_t>() % max_sides);
            break;
        default:
            scene.sides = bytes.take<std::int32_t>();
    }
    scene.law = static_cast<Law>(bytes.below(3));
    const bool uniform = bytes.below(4) != 0;
    scene.alpha = bytes.number();
    scene.beta = bytes.number();
    scene.mu = bytes.number();
    scene.restitution = bytes.number();
    const double factor = std::clamp(std::abs(bytes.number()), least_inertia, most_inertia);
    scene.inertia_factor = uniform ? uniform_inertia_factor<double>(scene.sides) : factor;
    return scene;
}

/// In the laboratory, from the container's centre or anywhere; on the section, leaving the wall or any point.
Start<double> start_from(Bytes& bytes, const Scene<double>& scene) {
    const int kind = bytes.below(4);
    double z[6];
    for (double& number : z) number = bytes.number();
    if (kind == 0) return LabStart<double>{scene.beta, 0, z[2], z[3], z[4], z[5]};
    if (kind == 1) return LabStart<double>{z[0], z[1], z[2], z[3], z[4], z[5]};
    if (kind == 3) return SectionPoint<double>{z[0], scene.is_disk() ? 0 : z[1], z[2], z[3], z[4]};
    const double room = pi<double>() / scene.sides - std::asin(scene.alpha * std::sin(pi<double>() / scene.sides));
    const double chi = scene.is_disk() ? 0 : room * z[1];
    const double at_rest = scene.alpha * z[4] * std::sin(chi) + scene.beta * std::sin(z[0]);
    return SectionPoint<double>{z[0], chi, at_rest - std::abs(z[2]), z[3], z[4]};
}

void require_finite(std::initializer_list<double> numbers, const char* promise) {
    for (const double number : numbers) {
        if (!std::isfinite(number)) std::fprintf(stderr, "not finite: %g\n", number);
        require(std::isfinite(number), promise);
    }
}

/// The vertex that struck and its neighbours, or the disk, are inside to rounding.
void require_inside(const Scene<double>& scene, const SceneOrbit<double>& orbit) {
    const LabState<double> lab = orbit.lab();
    const double x = lab.x - scene.beta * std::cos(lab.time.phase), y = lab.y - scene.beta * std::sin(lab.time.phase);
    double reach = std::hypot(x, y) + scene.alpha;
    if (!scene.is_disk()) {
        reach = 0;
        for (const int beside : {-1, 0, 1}) {
            const double direction =
                lab.direction.phase + 2 * pi<double>() / scene.sides * (orbit.frame().vertex + beside);
            reach = std::max(reach,
                             std::hypot(x + scene.alpha * std::cos(direction), y + scene.alpha * std::sin(direction)));
        }
    }
    require(reach <= 1 + 1e-12 + 16 * 0x1p-52 * (1 + scene.beta), "all vertices are inside");
}

void require_contacts(const std::vector<ContactSegment>& contacts) {
    for (const ContactSegment& contact : contacts) {
        require_finite({contact.start, contact.end, contact.turned, contact.work}, "contact is finite");
        require(contact.start <= contact.end, "contact does not end before it begins");
    }
}

void require_impact(const Scene<double>& scene, const SceneOrbit<double>& orbit, double time) {
    const Collision<double>& c = orbit.collision();
    require(c.impulse.normal >= 0, "no impulse pulls");
    require(c.flight_time >= 0, "no flight is shorter than nothing");
    require_finite({c.impulse.normal, c.impulse.tangential, c.flight_time}, "an impact is finite");
    const PostImpactState<double>& z = c.after;
    require_finite({z.psi.x, z.psi.y, z.chi.x, z.chi.y, z.vn, z.vt, z.spin}, "a state is finite");
    const LabState<double> lab = orbit.lab();
    require_finite({lab.t, lab.x, lab.y, lab.vx, lab.vy, lab.angle}, "a place is finite");
    require(lab.t >= time, "time does not fall");
    require_inside(scene, orbit);
}

/// The search for a contact has its limit, twice after a release; so has contact.
void require_bounded(const ReturnStep<double>& step) {
    require(step.collision.steps <= 2 * detail::step_limit, "a search ends");
    require(contact_steps(step) <= most_contact_steps + 1, "contact ends");
}

void follow(const Scene<double>& scene, SceneOrbit<double>& orbit) {
    double time = 0, cost = 0;
    bool alive = true;
    for (int impact = 0; alive && impact < most_impacts && cost < most_cost; ++impact) {
        alive = orbit.advance(horizon);
        require_bounded(orbit.return_step());
        require_contacts(orbit.contacts());
        cost += cost_of(orbit.return_step());
        if (!alive) break;
        require_impact(scene, orbit, time);
        time = orbit.lab().t;
        alive = orbit.outcome() == Outcome::completed;
    }
    require(alive || orbit.outcome() != Outcome::completed, "an orbit that has ended says how");
    require(!name_of(orbit.outcome()).empty(), "every end has a name");
}

}  // namespace
}  // namespace swirl::apps

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace swirl;
    tests::fuzz::Bytes bytes(data, size);
    const Scene<double> scene = apps::scene_from(bytes);
    const apps::Start<double> start = apps::start_from(bytes, scene);
    std::optional<apps::SceneOrbit<double>> orbit;
    if (!tests::fuzz::answers([&] { orbit.emplace(scene, start); })) return 0;
    apps::follow(scene, *orbit);
    return 0;
}
