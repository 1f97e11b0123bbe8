#include "apps/studies/tradeoff/models.hpp"

#include "apps/studies/scene_map/impact_row.hpp"
#include "map/orbit/return_map.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace swirl::studies::tradeoff {

namespace {

using State = PostImpactState<double>;

/// Chains from the drawn starts, round and round: `follow(state, steps)` gives its impacts.
template <class Follow>
TimedWork along_chains(std::vector<State> starts, int steps, Follow follow) {
    return [starts = std::move(starts), steps, follow, first = std::size_t{0}](std::size_t chains) mutable {
        std::int64_t impacts = 0;
        for (std::size_t i = 0; i < chains; ++i) impacts += follow(starts[first++ % starts.size()], steps);
        return impacts;
    };
}

/// So that no compiler leaves out what nobody reads.
void keep(double value) {
    [[maybe_unused]] static volatile double kept;
    kept = value;
}

/// The collision map alone.
template <class Map>
TimedWork bare_map(const Map& map, const std::vector<State>& starts, int steps) {
    return along_chains(starts, steps, [map](const State& start, int count) {
        Collision<double> collision;
        collision.after = start;
        std::int64_t impacts = 0;
        for (; impacts < count; ++impacts) {
            map.advance(collision.after, collision);
            if (collision.outcome != FirstContactOutcome::contact) break;
        }
        keep(collision.after.spin);
        return impacts;
    });
}

/// A map and what refers to it, at one place.
template <class Map>
struct Returned {
    explicit Returned(const Map& m) : map(m), return_map(map) {}
    Returned(const Returned&) = delete;
    Returned& operator=(const Returned&) = delete;
    Map map;
    ReturnMap<Map> return_map;
};

/// The return map.
template <class Map>
TimedWork with_contact_watched(const Map& map, const std::vector<State>& starts, int steps) {
    return along_chains(starts, steps,
                        [its = std::make_shared<const Returned<Map>>(map)](const State& start, int count) {
                            ReturnStep<double> step;
                            step.collision.after = start;
                            std::int64_t impacts = 0;
                            while (impacts < count && its->return_map.advance(step) == Outcome::completed) ++impacts;
                            keep(step.collision.after.spin);
                            return impacts;
                        });
}

/// The orbit's stretch, from where the last call ended.
template <class Restart, class Advance>
TimedWork along_orbit(std::int64_t stretch, Restart restart, Advance advance) {
    auto state = std::make_shared<decltype(restart())>(restart());
    return [=, at = std::int64_t{0}](std::size_t impacts) mutable {
        for (std::size_t i = 0; i < impacts; ++i, ++at) {
            if (at == stretch) {
                *state = restart();
                at = 0;
            }
            advance(*state);
        }
        return static_cast<std::int64_t>(impacts);
    };
}

/// The states of a body with a rim in place of vertices, which leaves the wall as fast.
std::vector<State> as_disk(const Scene<double>& polygon, const Scene<double>& disk, std::vector<State> states) {
    const Body<double> vertices = make_body(polygon), rim = make_body(disk);
    for (State& z : states) {
        const double un = contact_kinematics(vertices, z).un;
        z.chi = {1, 0};
        z.vn += un - contact_kinematics(rim, z).un;
    }
    return states;
}

Scene<double> with_other(Scene<double> scene, double Scene<double>::*member, double value) {
    scene.*member = value;
    return scene;
}

Scene<double> with_sides(Scene<double> scene, int sides) {
    scene.sides = sides;
    return scene;
}

/// Friction: the map without it beside that with it, on the same flights: one each. Where μ is 0, friction's code with
/// μ = 0.
template <class Map>
ModelPiece friction_piece(const Map& map, const DrawnFlights& drawn) {
    const Scene<double>& scene = map.scene();
    using Without = CollisionMap<double, Map::shape, ImpactRule::frictionless>;
    using With = std::conditional_t<Map::rule == ImpactRule::frictionless,
                                    CollisionMap<double, Map::shape, ImpactRule::poisson>, Map>;
    const Without without(with_other(scene, &Scene<double>::mu, 0));
    return {"friction", scene.mu > 0 ? "every command" : "nothing: mu = 0", bare_map(With(scene), drawn.timed, 1),
            bare_map(without, drawn.timed, 1)};
}

/// Orientation: vertices beside a rim. Of a disk, the vertices of a polygon that is nearly one.
template <class Map>
ModelPiece orientation_piece(const Map& map, const DrawnFlights& drawn) {
    constexpr int nearly_round = 1000;  // vertices stand out by 10⁻⁵ of the radius
    const Scene<double>& scene = map.scene();
    const Scene<double> polygon = scene.is_disk() ? with_sides(scene, nearly_round) : scene;
    const Scene<double> disk = with_sides(scene, disk_sides);
    const auto rims = scene.is_disk() ? drawn.timed : as_disk(scene, disk, drawn.timed);
    using Polygon = CollisionMap<double, Shape::polygon, Map::rule>;
    constexpr ImpactRule rim_rule =
        Map::rule == ImpactRule::frictionless ? ImpactRule::frictionless : ImpactRule::poisson;
    using Disk = CollisionMap<double, Shape::disk, rim_rule>;
    return {"orientation of vertices", scene.is_disk() ? "nothing: a disk has none" : "every command",
            bare_map(Polygon(polygon), drawn.timed, drawn.timed_steps), bare_map(Disk(disk), rims, drawn.timed_steps)};
}

/// The look for contact after every impact: for chatter at e < 1, and at e = 1 for a vertex that friction holds, whose
/// rebounds fall, too (ReturnMap). Where no contact can come it is left out: it is there at the next e below.
template <class Map>
ModelPiece watch_piece(const Map& map, const DrawnFlights& drawn) {
    const Scene<double>& scene = map.scene();
    constexpr bool may_be_held = Map::shape == Shape::polygon && Map::rule != ImpactRule::frictionless;
    const bool watched = scene.restitution < 1 || may_be_held;
    const Map lossy(with_other(scene, &Scene<double>::restitution, std::nextafter(1.0, 0.0)));
    return {"watch for contact", watched ? "every command" : "nothing: e = 1, and no friction holds a vertex",
            with_contact_watched(watched ? map : lossy, drawn.timed, drawn.timed_steps),
            bare_map(map, drawn.timed, drawn.timed_steps)};
}

std::string contact_paid_by(const DrawnFlights& drawn) {
    if (drawn.through_contact > 0) return "every command";
    return ends_in_contact(drawn.outcome) ? "every command, once: the orbit ends on the wall"
                                          : "nothing: this orbit has none";
}

/// The orbit with its sustained contact beside its flights alone.
template <class Map>
ModelPiece contact_piece(const Map& map, const DrawnFlights& drawn) {
    const auto its = std::make_shared<const Returned<Map>>(map);
    const State begin = *drawn.begin;
    const auto restart = [begin] {
        ReturnStep<double> step;
        step.collision.after = begin;
        return step;
    };
    return {"motion in contact", contact_paid_by(drawn),
            along_orbit(drawn.stretch, restart, [its](ReturnStep<double>& step) { its->return_map.advance(step); }),
            with_contact_watched(map, drawn.timed, drawn.timed_steps)};
}

/// DF of every step.
ModelPiece derivative_piece(const Scene<double>& scene, const DrawnFlights& drawn) {
    return with_scene_map(scene, [&](const auto& map) -> ModelPiece {
        const auto chains = [&](auto make_step) {
            return along_chains(drawn.timed, drawn.timed_steps, [map, make_step](State z, int count) {
                std::int64_t impacts = 0;
                for (; impacts < count; ++impacts) {
                    const auto step = make_step(map, z);
                    if (!step.alive) break;
                    z = step.state;
                }
                keep(z.spin);
                return impacts;
            });
        };
        return {"derivative", "verdicts, exponents, cycles, branches",
                chains([](const auto& m, const State& z) { return m.linearise(z); }),
                chains([](const auto& m, const State& z) { return m.advance(z); })};
    });
}

/// Place and direction in the laboratory, and beside them a row of all fields.
void add_simulate_pieces(const Scene<double>& scene, const DrawnFlights& drawn, std::vector<ModelPiece>& pieces) {
    with_collision_map(scene, [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        const auto its = std::make_shared<const Map>(map);
        const SectionPoint<double> begin = section_point(*drawn.begin);
        try {
            require_leaving(map.body(), begin);
        } catch (const std::invalid_argument&) {
            return;  // within rounding of two contacts at once: no orbit begins there
        }
        const auto step = [](auto& orbit) { orbit.advance(); };
        pieces.push_back({"laboratory frame", "simulate, recurrence, spectrum",
                          along_orbit(
                              drawn.stretch, [its, begin] { return std::make_shared<Orbit<Map>>(*its, begin); },
                              [step](auto& orbit) { step(*orbit); }),
                          along_orbit(
                              drawn.stretch, [its, begin] { return std::make_shared<ReducedOrbit<Map>>(*its, begin); },
                              [step](auto& orbit) { step(*orbit); })});
    });
    const auto restart = [scene, begin = section_point(*drawn.begin)] {
        return SceneOrbit<double>(scene, Start<double>(begin));
    };
    if (pieces.back().name != "laboratory frame") return;
    pieces.push_back({"fields of a record's row", "simulate",
                      along_orbit(drawn.stretch, restart,
                                  [](SceneOrbit<double>& orbit) {
                                      orbit.advance();
                                      keep(impact_row(orbit).jacobi);
                                  }),
                      along_orbit(drawn.stretch, restart, [](SceneOrbit<double>& orbit) { orbit.advance(); })});
}

}  // namespace

std::vector<ModelPiece> model_pieces(const Scene<double>& scene, const DrawnFlights& drawn) {
    std::vector<ModelPiece> pieces;
    if (drawn.timed.empty()) return pieces;
    with_collision_map(scene, [&](const auto& map) {
        pieces.push_back(
            {"flight and impact", "every command", bare_map(map, drawn.timed, drawn.timed_steps), TimedWork()});
        pieces.push_back(friction_piece(map, drawn));
        pieces.push_back(orientation_piece(map, drawn));
        pieces.push_back(watch_piece(map, drawn));
        pieces.push_back(contact_piece(map, drawn));
    });
    pieces.push_back(derivative_piece(scene, drawn));
    add_simulate_pieces(scene, drawn, pieces);
    return pieces;
}

}  // namespace swirl::studies::tradeoff
