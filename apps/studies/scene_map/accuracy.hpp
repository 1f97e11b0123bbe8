// In which arithmetic, and by which search for the next contact, an orbit is followed.
#pragma once

#include "map/baselines/baseline_contact.hpp"
#include "map/model/scene.hpp"

#include <optional>
#include <string_view>

namespace swirl::studies {

enum class Accuracy {
    double_precision,  ///< 53 bits
    extended,          ///< long double: 64 bits on x86
    quad,              ///< 113 bits
    paper,             ///< to compare with: double with another search (map/baselines), and so are those below
    brent,
    fixed_step
};

/// "double", "extended", "quad", "paper", "brent", "fixed-step".
std::string_view name_of(Accuracy accuracy);

/// The search that takes the exact one's place; none for the first three.
inline std::optional<BaselineSearch> baseline_of(Accuracy accuracy) {
    switch (accuracy) {
        case Accuracy::double_precision:
        case Accuracy::extended:
        case Accuracy::quad:
            return std::nullopt;
        case Accuracy::paper:
            return BaselineSearch::paper;
        case Accuracy::brent:
            return BaselineSearch::brent;
        case Accuracy::fixed_step:
            return BaselineSearch::fixed_step;
    }
    return std::nullopt;
}

/// @throws std::invalid_argument
///   what  "a floor that drags", …
[[noreturn]] void refuse_baseline(Accuracy accuracy, std::string_view what);

/// `baseline_of`, to follow an orbit of the scene.
/// @throws std::invalid_argument for a search to compare with where the scene has a map of its own
template <class T>
std::optional<BaselineSearch> baseline_for(const Scene<T>& scene, Accuracy accuracy) {
    const std::optional<BaselineSearch> search = baseline_of(accuracy);
    if (search && scene.has_drag()) refuse_baseline(accuracy, "a floor that drags");
    if (accuracy != Accuracy::double_precision && scene.has_dry_floor())
        refuse_baseline(accuracy, "a floor with dry friction");
    if (search && scene.is_rounded()) refuse_baseline(accuracy, "rounded corners");
    return search;
}

}  // namespace swirl::studies
