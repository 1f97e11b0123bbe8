// One number of the scene as a variable, by name.
#pragma once

#include "map/model/scene.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace swirl {

/// The scene's numbers that can be varied continuously.
enum class Parameter { alpha, beta, mu, restitution, inertia_factor, drag, tangential_restitution, corner };

inline constexpr Parameter all_parameters[] = {Parameter::alpha,
                                               Parameter::beta,
                                               Parameter::mu,
                                               Parameter::restitution,
                                               Parameter::inertia_factor,
                                               Parameter::drag,
                                               Parameter::tangential_restitution,
                                               Parameter::corner};

/// By the name of the command's flag.
inline std::string_view name_of(Parameter parameter) {
    static constexpr std::string_view names[] = {
        "alpha", "beta", "mu", "restitution", "inertia-factor", "drag", "tangential-restitution", "corner"};
    return names[static_cast<std::size_t>(parameter)];
}

inline std::optional<Parameter> parameter_named(std::string_view name) {
    for (const Parameter parameter : all_parameters)
        if (name_of(parameter) == name) return parameter;
    return std::nullopt;
}

template <class T>
inline T& number_of(Scene<T>& scene, Parameter parameter) {
    switch (parameter) {
        case Parameter::alpha:
            return scene.alpha;
        case Parameter::beta:
            return scene.beta;
        case Parameter::mu:
            return scene.mu;
        case Parameter::restitution:
            return scene.restitution;
        case Parameter::inertia_factor:
            return scene.inertia_factor;
        case Parameter::drag:
            return scene.drag;
        case Parameter::tangential_restitution:
            return scene.tangential_restitution;
        case Parameter::corner:
            break;
    }
    return scene.corner;
}

/// The scene with another value of one parameter.
template <class T>
inline Scene<T> with_parameter(Scene<T> scene, Parameter parameter, const T& value) {
    number_of(scene, parameter) = value;
    return scene;
}

/// A scene in another number type.
template <class To, class From>
inline Scene<To> scene_in(const Scene<From>& s) {
    return {s.sides,
            To(s.alpha),
            To(s.beta),
            To(s.mu),
            To(s.restitution),
            s.law,
            To(s.inertia_factor),
            To(s.drag),
            To(s.spin_drag),
            s.floor,
            To(s.tangential_restitution),
            To(s.corner),
            To(s.floor_friction),
            To(s.gravity_ratio)};
}

}  // namespace swirl
