// SceneOrbit's members that know its map, for the files that compile them, one a number type.
#pragma once

#include "apps/studies/scene_map/scene_orbit.hpp"
#include "map/baselines/baseline_map.hpp"
#include "map/corners/corner_map.hpp"
#include "map/orbit/dragged_return.hpp"
#include "map/orbit/dry_return.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace swirl::studies {

/// An orbit with the map that it refers to.
template <class Map>
class OrbitByMap final : public OrbitOfScene<typename Map::Number> {
public:
    using T = typename Map::Number;

    template <class AnyStart>
    OrbitByMap(const Map& map, const AnyStart& start) : map_(map), orbit_(map_, start) {}

    bool advance(double horizon, const ContactSink& sink) override { return orbit_.advance(horizon, sink); }
    const ReturnStep<T>& return_step() const override { return orbit_.return_step(); }
    const LabFrame<T>& frame() const override { return orbit_.frame(); }
    Outcome outcome() const override { return orbit_.outcome(); }
    long long impacts() const override { return orbit_.impacts(); }

private:
    Map map_;
    Orbit<Map> orbit_;  ///< refers to it
};

template <class T>
SceneOrbit<T>::SceneOrbit(const Scene<T>& scene, const Start<T>& start, const std::optional<BaselineSearch>& search)
    : body_(make_body(validated(scene))) {
    const auto own = [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        orbit_ = std::visit([&](const auto& s) { return std::make_unique<OrbitByMap<Map>>(map, s); }, start);
    };
    if (scene.has_drag()) {
        if (search) throw std::invalid_argument("a baseline's search is not extended to a floor that drags");
        with_dragged_map(scene, own);
        return;
    }
    if (scene.has_dry_floor()) {
        if constexpr (std::is_same_v<T, double>) {
            if (search) throw std::invalid_argument("a baseline's search is not extended to a floor with dry friction");
            with_dry_map(scene, own);
            return;
        } else {
            throw std::invalid_argument("a floor with dry friction is followed in double alone; double is wanted");
        }
    }
    if (scene.is_rounded()) {
        if (search) throw std::invalid_argument("a baseline's search is not extended to rounded corners");
        with_corner_map(scene, own);
        return;
    }
    with_collision_map(scene, [&](const auto& map) {
        using Exact = std::decay_t<decltype(map)>;
        if (!search) return own(map);
        if constexpr (std::is_same_v<T, double>)
            own(BaselineMap<Exact::shape, Exact::rule>(map, *search));
        else
            throw std::logic_error("a baseline's search is in double");
    });
}

}  // namespace swirl::studies
