// Swirl's own maps: exact in double and quad, and the searches of map/baselines.
#include "map/baselines/baseline_map.hpp"
#include "map/batch/orbit_batch.hpp"
#include "map/dry/dry_map.hpp"
#include "map/numbers/quad.hpp"
#include "peer.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl::peers {
namespace {

template <class T>
Vec2<T> unit_vector(const Vec2<double>& v) {
    using std::sqrt;
    const Vec2<T> wide{T(v.x), T(v.y)};
    return (T(1) / T(sqrt(dot(wide, wide)))) * wide;
}
/// In more digits the angles are those of the double's vectors, which are of length 1 but for rounding.
template <class T>
PostImpactState<T> widened(const State& z) {
    return {unit_vector<T>(z.psi), unit_vector<T>(z.chi), T(z.vn), T(z.vt), T(z.spin)};
}
template <>
State widened<double>(const State& z) {
    return z;
}
template <class T>
Vec2<double> narrowed(const Vec2<T>& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
template <class T>
State narrowed(const PostImpactState<T>& z) {
    return {narrowed(z.psi), narrowed(z.chi), static_cast<double>(z.vn), static_cast<double>(z.vt),
            static_cast<double>(z.spin)};
}

template <class Map>
class SwirlPeer final : public Peer {
public:
    using T = typename Map::Number;
    explicit SwirlPeer(Map map) : map_(std::move(map)) {}

    Impact next(const State& start) override {
        Collision<T> collision;
        map_.advance(widened<T>(start), collision);
        if (collision.outcome != FirstContactOutcome::contact) return {};
        const int vertex = Map::shape == Shape::disk ? 0 : map_.body().vertex_number(collision.vertex_step);
        return {true, static_cast<double>(collision.flight_time), vertex, narrowed(collision.after)};
    }
    int follow(State& state, int count) override {
        Collision<T> collision;
        collision.after = widened<T>(state);
        int done = 0;
        for (; done < count; ++done) {
            map_.advance(collision.after, collision);
            if (collision.outcome != FirstContactOutcome::contact) break;
        }
        state = narrowed(collision.after);
        return done;
    }

private:
    Map map_;
};

/// Many orbits at once; one impact is that of one lane.
template <class Map>
class AbreastPeer final : public Peer {
public:
    static constexpr std::size_t orbits = 64;
    explicit AbreastPeer(Map map) : map_(std::move(map)), step_(map_) {}

    Impact next(const State& start) override {
        std::vector<BatchedOrbit<Map>> one{{&step_, start, 1}};
        Impact impact;
        follow_batch(std::span(one), [&](const BatchedOrbit<Map>& orbit, const BatchedImpact& seen) {
            const Body<double>& body = map_.body();
            const int vertex = Map::shape == Shape::disk ? 0 : body.vertex_number(seen.vertex_step);
            impact = {true, seen.flight_time, vertex, orbit.state};
        });
        return impact;
    }
    long follow_from(const std::vector<State>& starts, std::size_t first, std::size_t count) override {
        std::vector<BatchedOrbit<Map>> all;
        for (std::size_t at = first; at < starts.size() && all.size() < orbits; ++at)
            all.push_back({&step_, starts[at], static_cast<long long>(count)});
        return static_cast<long>(follow_batch(std::span(all)).impacts);
    }

private:
    Map map_;
    ReturnMap<Map> step_;
};

template <class Map>
std::unique_ptr<Peer> peer_of(const Map& map) {
    return std::make_unique<SwirlPeer<Map>>(map);
}

}  // namespace

std::unique_ptr<Peer> make_swirl_peer(const std::string& name, const Scene<double>& scene) {
    if (scene.has_dry_floor()) {
        if (name != "double") return nullptr;
        return with_dry_map(scene, [](const auto& map) { return peer_of(map); });
    }
    if (name == "quad") {
        // The scene's numbers are the doubles' values: what differs is the arithmetic alone.
        const Scene<Quad> wide{scene.sides,       scene.alpha, scene.beta,          scene.mu,
                               scene.restitution, scene.law,   scene.inertia_factor};
        return with_collision_map(wide, [](const auto& map) { return peer_of(map); });
    }
    if (name == "abreast") {
        return with_collision_map(scene, [](const auto& map) -> std::unique_ptr<Peer> {
            return std::make_unique<AbreastPeer<std::decay_t<decltype(map)>>>(map);
        });
    }
    if (name == "double" || name == "newton" || name == "stronge") {
        Scene<double> own = scene;
        if (name != "double") own.law = name == "newton" ? Law::newton : Law::stronge;
        return with_collision_map(own, [](const auto& map) { return peer_of(map); });
    }
    BaselineSearch search;
    if (name == "paper")
        search = BaselineSearch::paper;
    else if (name == "brent")
        search = BaselineSearch::brent;
    else if (name == "fixed-step")
        search = BaselineSearch::fixed_step;
    else
        return nullptr;
    return with_collision_map(scene, [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        return peer_of(BaselineMap<Map::shape, Map::rule>(map, search));
    });
}

}  // namespace swirl::peers
