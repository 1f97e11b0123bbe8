// The scene as users give it: flags, a TOML file, physical units.
#pragma once

#include "apps/command_line/flags.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/output/units.hpp"
#include "map/model/parameter.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <optional>
#include <string>

namespace swirl::apps {

/// Does a command follow a body over a floor that drags, a disk whose sticking impacts return slip, the rod, and
/// rounded corners? One that does not refuses such a scene.
enum class Extensions { refused, followed };

/// The texts that were given for the scene, by the names of the flags.
class SceneOptions {
public:
    /// Adds the flags to a command.
    void add_to(Flags& command);

    /// Reads --scene FILE if it was given; flags win. Call once after parsing. Unless `quiet`, an inertia factor that
    /// no body has is noted. @throws BadInput
    void read_file(bool quiet = false);

    /// The scene, every number read as a T. @throws BadInput (missing, units that are none, an extension where it is
    /// refused), std::invalid_argument (out of range)
    template <class T>
    Scene<T> scene(Extensions extensions = Extensions::refused) const;

    /// The units, if any physical number was given. @throws BadInput
    std::optional<Units> units() const;

    /// The uniform lamina's κ with rounded corners changes with α and r; along one of these a command keeps the
    /// scene's.
    ///   along  the parameter that is varied, if it is one of the scene
    /// @throws BadInput unless κ was given
    void require_inertia_along(const Scene<double>& scene, const std::optional<Parameter>& along) const;

    /// --max-time in 1/ω_s, given in the user's units or not at all. @throws BadInput
    double longest_flight(const std::optional<double>& given, double otherwise, double most) const;

    /// True if any flag of a scene, or a scene file, was given; the flag `but` apart.
    bool given(const std::string& but = "") const { return flags_.size() > flags_.count(but) || !file_.empty(); }
    /// What a flag itself was given, without the file's or another's word.
    std::string flag(const std::string& name, const std::string& otherwise) const {
        return flags_.count(name) != 0 ? flags_.at(name) : otherwise;
    }

    /// What was given for a parameter, `otherwise` where nothing was.
    std::string text(const std::string& name, const std::string& otherwise) const {
        return has(name) ? values_.at(name) : otherwise;
    }

    /// What the scene file has under [start], by the names of the flags.
    const std::map<std::string, std::string>& start_in_file() const { return start_; }

    /// The scene file; empty: none.
    const std::string& file() const { return file_; }

    /// Replaces one parameter (a sweep's or continuation's), as if its flag had been given.
    void set(const std::string& name, const std::string& text);

    /// True if the parameter was given, by a flag, the scene file or `set`.
    bool has(const std::string& name) const { return values_.count(name) != 0; }

private:
    const std::string& required(const std::string& name, const std::string& instead) const;
    /// A dimensionless ratio, given itself or as two lengths.
    template <class T>
    T ratio(const std::string& name, const std::string& length) const;
    template <class T>
    T positive(const std::string& name) const;
    /// @throws BadInput: a floor without drag or friction, or gravity without friction, which would be ignored
    void require_acting_floor() const;
    /// @throws BadInput: a command that does not follow drag
    [[noreturn]] void refuse_drag() const;
    /// @throws BadInput: a command that does not follow dry friction of the floor
    [[noreturn]] void refuse_dry_floor() const;
    /// G at standard gravity, where friction, R_c and ω_s are given and it is not.
    void take_standard_gravity();
    /// @throws BadInput: a command that does not know the rod
    [[noreturn]] static void refuse_rod();
    /// @throws BadInput: a command that does not follow rounded corners
    [[noreturn]] void refuse_rounding() const;
    /// @throws BadInput: a command that does not follow tangential restitution
    [[noreturn]] void refuse_tangential_restitution() const;

    std::map<std::string, std::string> values_;
    std::map<std::string, std::string> start_;
    std::map<std::string, std::string> flags_;
    std::string file_;
    bool floor_is_asked_ = false;  ///< by a flag or the file
};

/// "disk" or the number. @throws BadInput
int sides_from(const std::string& text);
Law law_from(const std::string& text);
Floor floor_from(const std::string& text);

template <class T>
T SceneOptions::positive(const std::string& name) const {
    const T value = number_from<T>(name, values_.at(name));
    if (!(value > T(0)) || !(value <= std::numeric_limits<T>::max()))
        throw BadInput(fmt::format("{} = {} is outside its range: {} > 0, finite", name, values_.at(name), name));
    return value;
}

template <class T>
T SceneOptions::ratio(const std::string& name, const std::string& length) const {
    if (has(name) && has(length)) throw BadInput(fmt::format("{} and {} are both given; give one", name, length));
    if (has(name)) return number_from<T>(name, values_.at(name));
    const T value = number_from<T>(length, required(length, name));
    required("container-radius", name);
    return value / positive<T>("container-radius");
}

template <class T>
Scene<T> SceneOptions::scene(Extensions extensions) const {
    units();  // refuses those that are none, whether or not anything is converted
    Scene<T> scene;
    scene.sides = sides_from(required("sides", ""));
    scene.alpha = ratio<T>("alpha", "polygon-radius");
    scene.beta = ratio<T>("beta", "swirl-radius");
    scene.mu = number_from<T>("mu", required("mu", ""));
    scene.restitution = number_from<T>("restitution", required("restitution", ""));
    if (has("law")) scene.law = law_from(values_.at("law"));
    if (has("drag")) scene.drag = number_from<T>("drag", values_.at("drag"));
    if (has("spin-drag")) {
        scene.spin_drag = number_from<T>("spin-drag", values_.at("spin-drag"));
        if (scene.spin_drag < T(0)) detail::out_of_range("spin-drag", scene.spin_drag, "0, or 1e-75 to 1000");
    }
    if (has("floor-friction")) scene.floor_friction = number_from<T>("floor-friction", values_.at("floor-friction"));
    if (has("gravity-ratio"))
        scene.gravity_ratio = number_from<T>("gravity-ratio", values_.at("gravity-ratio"));
    else if (scene.floor_friction != T(0))
        throw BadInput(
            "--gravity-ratio is missing: G = g/(R_c omega_s^2) (or --container-radius and --swirl-rate, with g = "
            "9.80665 m/s^2)");
    if (has("floor")) scene.floor = floor_from(values_.at("floor"));
    if (has("tangential-restitution"))
        scene.tangential_restitution = number_from<T>("tangential-restitution", values_.at("tangential-restitution"));
    if (has("corner") || has("corner-radius")) scene.corner = ratio<T>("corner", "corner-radius");
    require_acting_floor();
    if (extensions == Extensions::refused && scene.has_drag()) refuse_drag();
    if (extensions == Extensions::refused && scene.has_dry_floor()) refuse_dry_floor();
    if (extensions == Extensions::refused && scene.tangential_restitution != T(0)) refuse_tangential_restitution();
    if (extensions == Extensions::refused && scene.is_rod()) refuse_rod();
    if (extensions == Extensions::refused && scene.is_rounded()) refuse_rounding();
    if (scene.sides != disk_sides && (scene.sides < rod_sides || scene.sides > max_sides)) return validated(scene);
    scene.inertia_factor = has("inertia-factor") ? number_from<T>("inertia-factor", values_.at("inertia-factor"))
                                                 : uniform_inertia_factor<T>(scene.sides, scene.alpha, scene.corner);
    return validated(scene);
}

}  // namespace swirl::apps
