#include "apps/command_line/documents.hpp"

#include "apps/command_line/caller.hpp"
#include "apps/output/value.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace swirl::apps {

std::string version() {
    return SWIRL_VERSION;
}

std::string instruction_set() {
    // What the compiler was allowed to use, not what this machine has: that is what fixes the bits.
#if defined(__AVX512F__)
    return "x86-64-v4";
#elif defined(__AVX2__)
    return "x86-64-v3";
#elif defined(__x86_64__)
    return "x86-64";
#elif defined(__aarch64__)
    return "aarch64";
#else
    return "generic";
#endif
}

Settings scene_settings(const Scene<double>& scene) {
    Settings settings;
    if (scene.is_disk())
        settings.emplace_back("sides", std::string("disk"));
    else
        settings.emplace_back("sides", std::int64_t{scene.sides});
    settings.emplace_back("alpha", scene.alpha);
    settings.emplace_back("beta", scene.beta);
    settings.emplace_back("mu", scene.mu);
    settings.emplace_back("restitution", scene.restitution);
    settings.emplace_back("law", std::string(name_of(scene.law)));
    settings.emplace_back("inertia_factor", scene.inertia_factor);
    if (scene.has_drag()) settings.emplace_back("drag", scene.drag);
    if (!(scene.spin_drag < 0)) settings.emplace_back("spin_drag", scene.spin_drag);  // else it is as drag
    if (scene.floor_friction != 0 || scene.gravity_ratio != 0) {
        settings.emplace_back("floor_friction", scene.floor_friction);
        settings.emplace_back("gravity_ratio", scene.gravity_ratio);
    }
    if (scene.acts_in_flight() || scene.floor != Floor::dish)
        settings.emplace_back("floor", std::string(name_of(scene.floor)));
    if (scene.tangential_restitution != 0)
        settings.emplace_back("tangential_restitution", scene.tangential_restitution);
    if (scene.is_rounded()) settings.emplace_back("corner", scene.corner);
    return settings;
}

Settings start_settings(const StartOptions& options, const Scene<double>& scene) {
    if (options.is_random()) return {{"speed", options.speed()}, {"seed", options.seed()}};
    const auto start = options.start<double>(scene);
    if (const auto* lab = std::get_if<LabStart<double>>(&start))
        return {{"x", lab->x},   {"y", lab->y},         {"vx", lab->vx},
                {"vy", lab->vy}, {"angle", lab->angle}, {"spin", lab->spin}};
    const auto& z = std::get<SectionPoint<double>>(start);
    Settings settings = {{"psi", z.psi}, {"chi", z.chi}, {"vn", z.vn}, {"vt", z.vt}, {"S", z.spin}};
    if (scene.is_disk()) settings.erase(settings.begin() + 1);
    return settings;
}

Settings unit_settings(const Units& units) {
    return {{"length", units.length}, {"time", units.time}, {"mass", units.mass}};
}

std::string settings_text(const Settings& settings) {
    std::string text;
    for (const auto& [name, value] : settings) {
        text += name + " =";
        std::visit(
            [&](const auto& v) {
                using Content = std::decay_t<decltype(v)>;
                if constexpr (std::is_same_v<Content, double>)
                    text += fmt::format(" {:.17g}", v);
                else if constexpr (std::is_arithmetic_v<Content>)
                    text += fmt::format(" {}", v);
                else if constexpr (std::is_same_v<Content, std::string>)
                    text += " " + v;
                else
                    for (const auto& item : v) text += fmt::format(" {}", item);
            },
            value);
        text += "\n";
    }
    return text;
}

JsonWriter document_writer() {
    if (auto caller = caller_of_this_thread())
        return JsonWriter([caller = std::move(caller)](std::string_view text) { caller->take_text(text); });
    return JsonWriter(stdout);
}

void write_members(JsonWriter& json, const Settings& settings) {
    for (const auto& [name, content] : settings) {
        json.key(name);
        write_value(json, content);
    }
}

void write_json(JsonWriter& json, std::string_view key, const Settings& settings) {
    json.key(key);
    json.begin_object();
    write_members(json, settings);
    json.end_object();
}

void write_scene(JsonWriter& json, const Scene<double>& scene, const SceneOptions& options, const StartOptions* start) {
    write_json(json, "scene", scene_settings(scene));
    if (start != nullptr) write_json(json, "start", start_settings(*start, scene));
    if (const auto units = options.units()) write_json(json, "units", unit_settings(*units));
}

void write_scene(const RecordGroup& root, const Scene<double>& scene, const StartOptions* start) {
    write_attributes(root.group("scene"), scene_settings(scene));
    if (start != nullptr) write_attributes(root.group("start"), start_settings(*start, scene));
}

void write_attributes(const RecordGroup& group, const Settings& settings) {
    for (const auto& [name, value] : settings) group.attribute(name, value);
}

std::string scene_in_words(const Scene<double>& scene) {
    const std::string body = scene.is_disk() ? "disk" : scene.is_rod() ? "rod" : fmt::format("{} sides", scene.sides);
    std::string floor;
    if (scene.has_drag())
        floor =
            fmt::format(", {} with drag {:g}, spin drag {:g}", name_of(scene.floor), scene.drag, scene.turning_drag());
    if (scene.has_dry_floor())
        floor = fmt::format(", {} with floor friction {:g}, gravity ratio {:g}", name_of(scene.floor),
                            scene.floor_friction, scene.gravity_ratio);
    const std::string returned =
        scene.tangential_restitution == 0 ? "" : fmt::format(", e_t {:g}", scene.tangential_restitution);
    const std::string corners = scene.is_rounded() ? fmt::format(" with corners of {:g}", scene.corner) : "";
    return fmt::format("{}{}, alpha {:g}, beta {:g}, mu {:g}, e {:g}, {}, kappa {:.6g}{}{}", body, corners, scene.alpha,
                       scene.beta, scene.mu, scene.restitution, name_of(scene.law), scene.inertia_factor, floor,
                       returned);
}

}  // namespace swirl::apps
