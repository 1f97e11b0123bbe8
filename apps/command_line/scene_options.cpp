#include "apps/command_line/scene_options.hpp"

#include "apps/command_line/numbers.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/record/flag_text.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

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

const std::array<SceneName, 20> scene_names = {{
    {"sides", "N: 2 (a rod) to 1000000, or disk", {"disk"}},
    {"alpha", "R_p/R_c, body over container, 0 < alpha < 1"},
    {"beta", "r_s/R_c, circle of the swirl over container, >= 0"},
    {"mu", "mu, coefficient of friction, >= 0"},
    {"restitution", "e, coefficient of restitution, 0 to 1"},
    {"law", "poisson (default), newton or stronge", {"poisson", "newton", "stronge"}},
    {"inertia-factor", "kappa, I = kappa m R_p^2 (default: the uniform lamina's)"},
    {"drag", "gamma, the floor's viscous drag: force -gamma (V - V_floor), in m omega_s (default 0)"},
    {"spin-drag", "gamma_r, its torque -gamma_r I S, in omega_s (default: as --drag)"},
    {"floor-friction", "M, the floor's dry (Coulomb) friction: force -M m g <u/|u|>, mean over the body (default 0)"},
    {"gravity-ratio", "G = g/(R_c omega_s^2), with --floor-friction (SI units: 9.80665 m/s^2 if not given)"},
    {"floor", "that acts: dish (default; it moves with the container) or table (at rest)", {"dish", "table"}},
    {"tangential-restitution", "e_t of a disk, 0 to 1: an impact that sticks returns u_t+ = -e_t u_t- (default 0)"},
    {"corner", "r/R_c, radius of a polygon's rounded corners, 0 <= r < alpha (default 0; alpha is --sides disk)"},
    {"container-radius", "R_c in m; with any of these six all that you give and read is in m, s, kg"},
    {"swirl-radius", "r_s in m, instead of --beta"},
    {"swirl-rate", "omega_s in rad/s (default 1); also with --series and --angle"},
    {"polygon-radius", "R_p in m, instead of --alpha"},
    {"corner-radius", "r in m, instead of --corner"},
    {"mass", "m in kg (default 1)"},
}};

/// A ratio, and the length that may be given instead.
constexpr std::pair<const char*, const char*> same_quantity[] = {
    {"alpha", "polygon-radius"}, {"beta", "swirl-radius"}, {"corner", "corner-radius"}};

constexpr std::array<const char*, 9> start_names = {"x", "y", "vx", "vy", "angle", "spin", "point", "speed", "seed"};

bool is_start_name(const std::string& name) {
    return std::find(start_names.begin(), start_names.end(), name) != start_names.end();
}

bool is_scene_name(const std::string& name) {
    for (const auto& known : scene_names)
        if (name == known.name) return true;
    return false;
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

struct ParsedFile {
    std::string name, text;
    toml::table table;

    /// What stands there for a number, as long as it lies in one line.
    std::string written(const toml::node& node) const {
        const toml::source_region& at = node.source();
        const std::vector<std::string> lines = pieces_of(text, '\n');
        if (at.begin.line != at.end.line || at.begin.line < 1 || at.begin.line > lines.size()) return "";
        std::string number = lines[at.begin.line - 1].substr(at.begin.column - 1, at.end.column - at.begin.column);
        std::erase(number, '_');
        return number.substr(0, number.find_first_not_of("0123456789+-.eE"));
    }

    /// A number or a string as a flag has it; of numbers in brackets, as of a point, a list with commas.
    std::string text_of(const std::string& key, const toml::node& node) const {
        if (const auto* words = node.as_string()) return words->get();
        if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
        if (const auto* number = node.as_floating_point()) {
            const std::string digits = number->get() == 0 ? written(node) : "";
            return underflows(digits) ? digits : fmt::format("{}", number->get());  // 0.4 as a flag has it
        }
        const auto* list = node.as_array();
        if (list == nullptr || key != "point")
            throw BadInput(fmt::format("scene file '{}': key '{}' must be a number or a string", name, key));
        std::string all;
        for (const toml::node& one : *list) all += (all.empty() ? "" : ",") + text_of("of point", one);
        return all;
    }
};

ParsedFile parsed(const std::string& file) {
    std::string text = read_text("scene file", file, longest_scene_file);
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // a byte order mark
    std::string ascii = in_ascii(text);
    try {
        toml::table table = toml::parse(ascii);
        return {file, std::move(ascii), std::move(table)};
    } catch (const toml::parse_error& error) {
        throw BadInput(fmt::format("scene file '{}', line {}: {}{}", file, error.source().begin.line,
                                   error.description(), ascii == text ? "" : " (? is what is not ASCII)"));
    }
}

/// The key with - for _, as documents and records write it, where that is one.
std::string meant(const std::string& name, bool (*is_known)(const std::string&)) {
    const std::string flag = flag_name(name);
    return is_known(flag) ? fmt::format("; did you mean {}?", flag) : "";
}

/// All mass on the circle of the vertices has kappa = 1; what is no number is refused elsewhere.
void note_inertia(const std::string& factor) {
    if (std::strtod(factor.c_str(), nullptr) > 1)
        report(fmt::format(
            "swirl: note: inertia-factor = {} is above 1, which no body within the circle of its vertices has",
            factor));
}

}  // namespace

int sides_from(const std::string& text) {
    if (text == "disk") return disk_sides;
    bool too_large = false;
    const auto value = whole_number_from(text, &too_large);
    if (!value && !too_large)
        throw BadInput(fmt::format("sides = {} is no whole number: 2 to {}, or disk", text, max_sides));
    if (!value || *value < rod_sides || *value > max_sides)
        throw BadInput(fmt::format("sides = {} is outside its range: 2 to {}, or disk", text, max_sides));
    return static_cast<int>(*value);
}

Law law_from(const std::string& text) {
    for (const Law law : all_laws)
        if (text == name_of(law)) return law;
    throw BadInput(fmt::format("law = {} is none of: poisson, newton, stronge", text));
}

Floor floor_from(const std::string& text) {
    for (const Floor floor : {Floor::dish, Floor::table})
        if (text == name_of(floor)) return floor;
    throw BadInput(fmt::format("floor = {} is none of: dish, table", text));
}

void SceneOptions::require_acting_floor() const {
    if (has("gravity-ratio") && !has("floor-friction"))
        throw BadInput(
            fmt::format("gravity-ratio = {} acts by friction alone: --floor-friction M is wanted, 0 or 1e-75 to 1000",
                        values_.at("gravity-ratio")));
    if (!floor_is_asked_ || has("drag") || has("spin-drag") || has("floor-friction")) return;
    throw BadInput(fmt::format("floor = {} acts by drag or friction alone: --drag G or --floor-friction M is wanted",
                               values_.at("floor")));
}

void SceneOptions::refuse_drag() const {
    throw BadInput(
        fmt::format("drag = {}, spin-drag = {}: this command is not extended to a floor that drags; 0 is wanted",
                    text("drag", "0"), text("spin-drag", text("drag", "0"))));
}

void SceneOptions::refuse_dry_floor() const {
    throw BadInput(
        fmt::format("floor-friction = {}: this command is not extended to a floor with dry friction; 0 is wanted",
                    text("floor-friction", "0")));
}

void SceneOptions::take_standard_gravity() {
    if (!has("floor-friction") || has("gravity-ratio")) return;
    if (!has("container-radius") || !has("swirl-rate")) return;
    constexpr double g = 9.80665;  // m/s², the standard's
    const auto own = units();
    values_["gravity-ratio"] = fmt::format("{:.17g}", g * own->time * own->time / own->length);
}

void SceneOptions::refuse_rod() {
    throw BadInput("sides = 2: this command is not extended to the rod; 3 to 1000000, or disk, is wanted");
}

void SceneOptions::refuse_rounding() const {
    const char* const given = has("corner") ? "corner" : "corner-radius";
    throw BadInput(
        fmt::format("{} = {}: this command is not extended to rounded corners; 0 is wanted", given, text(given, "0")));
}

void SceneOptions::refuse_tangential_restitution() const {
    throw BadInput(
        fmt::format("tangential-restitution = {}: this command is not extended to tangential restitution; 0 is wanted",
                    text("tangential-restitution", "0")));
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
    command
        .add_option("--scene", file_, "FILE.toml",
                    "TOML file with the same names as keys under [scene], a start's under [start]; flags win")
        ->group("Scene");
}

void SceneOptions::read_file(bool quiet) {
    if (!file_.empty()) {
        const ParsedFile parsed_file = parsed(file_);
        for (const auto& [key, node] : parsed_file.table)
            if (key.str() != "scene" && key.str() != "start")
                throw BadInput(fmt::format("scene file '{}': unknown key '{}'; only [scene] and [start] are known",
                                           file_, key.str()));
        const auto take = [&](const char* part, bool (*is_known)(const std::string&),
                              std::map<std::string, std::string>& values) {
            const toml::table* table = parsed_file.table[part].as_table();
            if (table == nullptr) throw BadInput(fmt::format("scene file '{}' has no table [{}]", file_, part));
            for (const auto& [key, node] : *table) {
                const std::string name(key.str());
                if (!is_known(name))
                    throw BadInput(fmt::format("scene file '{}': unknown key '{}' under [{}]{}", file_, name, part,
                                               meant(name, is_known)));
                values[name] = parsed_file.text_of(name, node);
            }
        };
        take("scene", is_scene_name, values_);
        if (parsed_file.table.contains("start")) take("start", is_start_name, start_);
    }
    // A flag replaces the file's other way of saying the same, too.
    for (const auto& [flag, other] : same_quantity) {
        if (flags_.count(flag) != 0 && flags_.count(other) == 0) values_.erase(other);
        if (flags_.count(other) != 0 && flags_.count(flag) == 0) values_.erase(flag);
    }
    for (const auto& [name, text] : flags_) values_[name] = text;
    floor_is_asked_ = has("floor");
    take_standard_gravity();
    if (!quiet) note_inertia(text("inertia-factor", ""));
}

void SceneOptions::set(const std::string& name, const std::string& text) {
    for (const auto& [flag, other] : same_quantity)
        if (name == flag) values_.erase(other);
    values_[name] = text;
    if (name == "floor-friction") take_standard_gravity();
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

void SceneOptions::require_inertia_along(const Scene<double>& scene, const std::optional<Parameter>& along) const {
    const bool changes = along == Parameter::corner || (along == Parameter::alpha && scene.is_rounded());
    if (!changes || has("inertia-factor")) return;
    throw BadInput(
        fmt::format("along {}: kappa of the uniform lamina with rounded corners changes with it; --inertia-factor K is "
                    "wanted, which stays",
                    name_of(*along)));
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
    for (const char* name :
         {"container-radius", "swirl-radius", "swirl-rate", "polygon-radius", "corner-radius", "mass"})
        any = any || has(name);
    if (!any) return std::nullopt;
    Units units;
    if (has("container-radius")) units.length = positive<double>("container-radius");
    if (has("swirl-rate")) units.time = 1 / positive<double>("swirl-rate");
    if (has("mass")) units.mass = positive<double>("mass");
    return units;
}

}  // namespace swirl::apps
