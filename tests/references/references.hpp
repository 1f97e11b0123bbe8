// Reads the references in JSON of this folder. Their numbers are decimal strings, parsed in the type asked for.
#pragma once

#include "map/model/scene.hpp"
#include "map/model/section.hpp"
#include "tests/references/reference_file.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace swirl::tests {

inline nlohmann::json read_reference(const std::string& name) {
    const std::string path = reference_path(name);
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path);
    return nlohmann::json::parse(file);
}

template <class T>
T number(const nlohmann::json& text) {
    const auto& digits = text.get_ref<const std::string&>();
    if constexpr (std::is_same_v<T, double>)
        return std::stod(digits);
    else if constexpr (std::is_same_v<T, long double>)
        return std::stold(digits);
    else
        return T(digits);
}

template <class T>
Scene<T> scene_from(const nlohmann::json& c) {
    Scene<T> scene;
    scene.sides = c["sides"];
    scene.alpha = number<T>(c["alpha"]);
    scene.beta = number<T>(c["beta"]);
    scene.mu = number<T>(c["mu"]);
    scene.restitution = number<T>(c["restitution"]);
    const std::string law = c["law"];
    for (const Law candidate : all_laws)
        if (name_of(candidate) == law) scene.law = candidate;
    if (name_of(scene.law) != law) throw std::runtime_error("unknown law " + law);
    if (c.contains("corner")) scene.corner = number<T>(c["corner"]);
    scene.inertia_factor = uniform_inertia_factor<T>(scene.sides, scene.alpha, scene.corner);
    if (c.contains("tangential_restitution")) scene.tangential_restitution = number<T>(c["tangential_restitution"]);
    return scene;
}

template <class T>
SectionPoint<T> point_from(const nlohmann::json& p) {
    const T chi = p.contains("chi") ? number<T>(p["chi"]) : T(0);
    return {number<T>(p["psi"]), chi, number<T>(p["vn"]), number<T>(p["vt"]), number<T>(p["S"])};
}

}  // namespace swirl::tests
