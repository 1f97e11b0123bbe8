// The members of SceneOrbit, for the files that compile them, one a number type.
#pragma once

#include "apps/studies/scene_map/scene_orbit.hpp"
#include "map/baselines/baseline_map.hpp"

#include <stdexcept>
#include <type_traits>

namespace swirl::studies {

template <class T>
struct SceneOrbitFunctions {
    bool (*advance)(void* orbit, double horizon, const ContactSink& sink);
    const ReturnStep<T>& (*return_step)(const void* orbit);
    const LabFrame<T>& (*frame)(const void* orbit);
    Outcome (*outcome)(const void* orbit);
    long long (*impacts)(const void* orbit);
};

namespace scene_orbit_detail {

template <class Map>
struct Owned {
    using T = typename Map::Number;

    template <class AnyStart>
    Owned(const Map& m, const AnyStart& start) : map(m), orbit(map, start) {}
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;

    Map map;
    Orbit<Map> orbit;  ///< refers to it

    static Orbit<Map>& of(void* owned) { return static_cast<Owned*>(owned)->orbit; }
    static const Orbit<Map>& of(const void* owned) { return static_cast<const Owned*>(owned)->orbit; }

    static bool advance(void* owned, double horizon, const ContactSink& sink) {
        return of(owned).advance(horizon, sink);
    }
    static const ReturnStep<T>& return_step(const void* owned) { return of(owned).return_step(); }
    static const LabFrame<T>& frame(const void* owned) { return of(owned).frame(); }
    static Outcome outcome(const void* owned) { return of(owned).outcome(); }
    static long long impacts(const void* owned) { return of(owned).impacts(); }

    static constexpr SceneOrbitFunctions<T> functions{&advance, &return_step, &frame, &outcome, &impacts};
};

}  // namespace scene_orbit_detail

template <class T>
SceneOrbit<T>::SceneOrbit(const Scene<T>& scene, const Start<T>& start, const std::optional<BaselineSearch>& search)
    : body_(make_body(validated(scene))) {
    const auto own = [&](const auto& map) {
        using Owned = scene_orbit_detail::Owned<std::decay_t<decltype(map)>>;
        functions_ = &Owned::functions;
        orbit_ =
            std::visit([&](const auto& s) -> std::shared_ptr<void> { return std::make_shared<Owned>(map, s); }, start);
    };
    with_collision_map(scene, [&](const auto& map) {
        using Exact = std::decay_t<decltype(map)>;
        if (!search) return own(map);
        if constexpr (std::is_same_v<T, double>)
            own(BaselineMap<Exact::shape, Exact::rule>(map, *search));
        else
            throw std::logic_error("a baseline's search is in double");
    });
}

template <class T>
bool SceneOrbit<T>::advance(double horizon, const ContactSink& sink) {
    return functions_->advance(orbit_.get(), horizon, sink);
}

template <class T>
const ReturnStep<T>& SceneOrbit<T>::return_step() const {
    return functions_->return_step(orbit_.get());
}

template <class T>
const LabFrame<T>& SceneOrbit<T>::frame() const {
    return functions_->frame(orbit_.get());
}

template <class T>
Outcome SceneOrbit<T>::outcome() const {
    return functions_->outcome(orbit_.get());
}

template <class T>
long long SceneOrbit<T>::impacts() const {
    return functions_->impacts(orbit_.get());
}

}  // namespace swirl::studies
