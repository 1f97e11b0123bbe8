#include "apps/boundaries/plane_options.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/record/flag_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace swirl::apps::boundaries {

Plane plane_from(const std::vector<std::string>& texts) {
    if (texts.size() != 2) throw BadInput(fmt::format("planes = {}: --plane NAME=A:B is wanted twice", texts.size()));
    Plane plane;
    for (std::size_t i = 0; i < 2; ++i) plane.axes[i] = parameter_range_from(texts[i], false, false, "plane");
    if (plane.axes[0].name == plane.axes[1].name)
        throw BadInput(
            fmt::format("--plane {} and --plane {}: two different parameters are wanted", texts[0], texts[1]));
    return plane;
}

Scene<double> scene_of(SceneOptions options, const Plane& plane) {
    const auto set = [&](double first, double second) {
        options.set(plane.axes[0].name, fmt::format("{:.17g}", first));
        options.set(plane.axes[1].name, fmt::format("{:.17g}", second));
        return options.scene<double>();
    };
    for (const double first : {plane.axes[0].low, plane.axes[0].high})
        for (const double second : {plane.axes[1].low, plane.axes[1].high}) set(first, second);
    const Eigen::Vector2d middle = 0.5 * (plane.low() + plane.high());
    return set(middle[0], middle[1]);
}

Settings scene_settings_of(const Scene<double>& scene, const Plane& plane) {
    Settings settings;
    for (const auto& item : scene_settings(scene)) {
        const std::string flag = flag_name(item.first);
        if (flag != plane.axes[0].name && flag != plane.axes[1].name) settings.push_back(item);
    }
    return settings;
}

}  // namespace swirl::apps::boundaries
