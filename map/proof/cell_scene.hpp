// A scene with two of its numbers over a cell.
#pragma once

#include "map/proof/scene_numbers.hpp"
#include "map/proof/solution_equations.hpp"
#include "map/proof/steady_cells.hpp"

#include <cstddef>

namespace swirl::proof {

/// The scene with its two parameters over the cell as the variables number `first` and the next of S.
///   at_middle  the parameters are those of the cell's middle, without width
template <class S>
SceneIn<S> scene_over(const PlaneScene& plane, const cells::ParameterCell& cell, std::size_t first,
                      bool at_middle = false) {
    auto scene = scene_as<S>(ball_scene(plane.base), [](const Ball& x) { return S(x); });
    for (std::size_t i = 0; i < 2; ++i)
        set_parameter(scene, plane.parameters[i],
                      at_middle ? S(cell.middle(i)) : S::variable(cell.low[i], cell.high[i], first + i));
    set_inertia(scene);
    return scene;
}

}  // namespace swirl::proof
