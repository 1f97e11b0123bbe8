#include "apps/command_line/scene_options.hpp"

#include "apps/command_line/text_file.hpp"

#include <array>

// toml++ asserts, or lets the optimiser assume, what text may break ("[%" under 3.3) before it says what is wrong with
// it: here it comes to say so, in every build.
#undef NDEBUG
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <fmt/format.h>
#include <toml++/toml.h>

namespace swirl::apps {

namespace {

struct SceneName {
    const char* name;
    const char* help;
    std::vector<std::string> words = {};  ///< that completion offers
};

const std::array<SceneName, 12> scene_names = {{
    {"sides", "N: 3 to 1000000, or disk", {"disk"}},
    {"alpha", "R_p/R_c, body over container, 0 < alpha < 1"},
    {"beta", "r_s/R_c, circle of the swirl over container, >= 0"},
    {"mu", "mu, coefficient of friction, >= 0"},
    {"restitution", "e, coefficient of restitution, 0 to 1"},
    {"law", "poisson (default), newton or stronge", {"poisson", "newton", "stronge"}},
    {"inertia-factor", "kappa, I = kappa m R_p^2 (default: the uniform lamina's)"},
    {"container-radius", "R_c in m; with any of these five all that you give and read is in m, s, kg"},
    {"swirl-radius", "r_s in m, instead of --beta"},
    {"swirl-rate", "omega_s in rad/s (default 1); also with --series and --angle"},
    {"polygon-radius", "R_p in m, instead of --alpha"},
    {"mass", "m in kg (default 1)"},
}};

/// A ratio, and the length that may be given instead.
constexpr std::pair<const char*, const char*> same_quantity[] = {{"alpha", "polygon-radius"}, {"beta", "swirl-radius"}};

bool is_scene_name(const std::string& name) {
    for (const auto& known : scene_names)
        if (name == known.name) return true;
    return false;
}

std::string text_of(const std::string& file, const std::string& key, const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());  // 0.4 as a flag has it
    throw BadInput(fmt::format("scene file '{}': key '{}' must be a number or a string", file, key));
}

// A scene is a dozen lines; above it a file is taken for one that never ends.
constexpr std::size_t longest_scene_file = std::size_t{1} << 20;

/// What is not ASCII becomes '?': a scene has it in comments alone. toml++ 3.3 calls "α = 0.4" unreachable, and the
/// optimiser may believe it.
std::string in_ascii(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) > 127) c = '?';
    return text;
}

toml::table parsed(const std::string& file) {
    std::string text = read_text("scene file", file, longest_scene_file);
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // a byte order mark
    const std::string ascii = in_ascii(text);
    try {
        return toml::parse(ascii);
    } catch (const toml::parse_error& error) {
        throw BadInput(fmt::format("scene file '{}', line {}: {}{}", file, error.source().begin.line,
                                   error.description(), ascii == text ? "" : " (? is what is not ASCII)"));
    }
}

}  // namespace

int sides_from(const std::string& text) {
    if (text == "disk") return disk_sides;
    char* end = nullptr;
    const long value = std::strtol(text.c_str(), &end, 10);
    if (text.empty() || *end != '\0' || value < 3 || value > max_sides)
        throw BadInput(fmt::format("sides = {} is outside its range: 3 to {}, or disk", text, max_sides));
    return static_cast<int>(value);
}

Law law_from(const std::string& text) {
    for (const Law law : {Law::poisson, Law::newton, Law::stronge})
        if (text == name_of(law)) return law;
    throw BadInput(fmt::format("law = {} is none of: poisson, newton, stronge", text));
}

void SceneOptions::add_to(Flags& command) {
    for (const auto& known : scene_names) {
        command
            .add_text(
                std::string("--") + known.name,
                [this, name = std::string(known.name)](const std::string& text) { flags_[name] = text; }, known.help)
            ->type_name("")
            ->offer(known.words)
            ->group("Scene");
    }
    command.add_option("--scene", file_, "TOML file with the same names as keys under [scene]; flags win")
        ->type_name("FILE.toml")
        ->group("Scene");
}

void SceneOptions::read_file() {
    if (!file_.empty()) {
        const toml::table document = parsed(file_);
        for (const auto& [key, node] : document)
            if (key.str() != "scene")
                throw BadInput(
                    fmt::format("scene file '{}': unknown key '{}'; only [scene] is known", file_, key.str()));
        const toml::table* scene = document["scene"].as_table();
        if (scene == nullptr) throw BadInput(fmt::format("scene file '{}' has no table [scene]", file_));
        for (const auto& [key, node] : *scene) {
            const std::string name(key.str());
            if (!is_scene_name(name))
                throw BadInput(fmt::format("scene file '{}': unknown key '{}' under [scene]", file_, name));
            values_[name] = text_of(file_, name, node);
        }
    }
    // A flag replaces the file's other way of saying the same, too.
    for (const auto& [flag, other] : same_quantity) {
        if (flags_.count(flag) != 0 && flags_.count(other) == 0) values_.erase(other);
        if (flags_.count(other) != 0 && flags_.count(flag) == 0) values_.erase(flag);
    }
    for (const auto& [name, text] : flags_) values_[name] = text;
}

void SceneOptions::set(const std::string& name, const std::string& text) {
    for (const auto& [flag, other] : same_quantity)
        if (name == flag) values_.erase(other);
    values_[name] = text;
}

const std::string& SceneOptions::required(const std::string& name, const std::string& instead) const {
    const auto found = values_.find(name);
    if (found != values_.end()) return found->second;
    if (instead.empty() || name == "container-radius")
        throw BadInput(
            fmt::format("--{} is missing (a scene needs --sides, --alpha, --beta, --mu, --restitution, or "
                        "--scene FILE)",
                        name));
    throw BadInput(fmt::format("--{} is missing (or --{} with --container-radius)", instead, name));
}

double SceneOptions::longest_flight(const std::optional<double>& given, double otherwise, double most) const {
    const auto own = units();
    const double time = given ? without_units(*given, own, "1/omega_s") : otherwise;
    if (!(time > 0 && time <= most))
        throw BadInput(fmt::format("max-time = {:g} is outside its range: 0 < max-time <= {:.6g}", given.value_or(time),
                                   in_units(most, own, "1/omega_s")));
    return time;
}

std::optional<Units> SceneOptions::units() const {
    bool any = false;
    for (const char* name : {"container-radius", "swirl-radius", "swirl-rate", "polygon-radius", "mass"})
        any = any || has(name);
    if (!any) return std::nullopt;
    Units units;
    if (has("container-radius")) units.length = positive<double>("container-radius");
    if (has("swirl-rate")) units.time = 1 / positive<double>("swirl-rate");
    if (has("mass")) units.mass = positive<double>("mass");
    return units;
}

}  // namespace swirl::apps
