#include "apps/command_line/start_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

namespace swirl::apps {

namespace {

// Named in the help, over the flags.
constexpr const char* start_group =
    "Start (in m, s, rad where the scene is in SI units: --container-radius, --swirl-rate ...)";

std::uint64_t seed_from(const std::string& flag, const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc() || end != text.data() + text.size())
        throw BadInput(fmt::format("{}: {} is outside its range: 0 to 18446744073709551615", flag, text));
    return seed;
}

}  // namespace

Flag add_seed(Flags& command, std::uint64_t& seed, const std::string& help, bool* given, const std::string& flag) {
    const auto take = [&seed, given, flag](const std::string& text) {
        seed = seed_from(flag, text);
        if (given != nullptr) *given = true;
    };
    return command.add_text(flag, take, help)->type_name("");
}

void StartOptions::add_to(Flags& command) {
    constexpr std::pair<const char*, const char*> lab_names[] = {
        {"x", "centre, from the swirl's centre, in R_c (default: the container's centre, beta)"},
        {"y", "centre, in R_c (default 0)"},
        {"vx", "velocity, in R_c omega_s (default 0)"},
        {"vy", "velocity, in R_c omega_s (default 0)"},
        {"angle", "vertex 0's direction, in radians (default 0); with --series the column of a measured angle"},
        {"spin", "in omega_s, so it is S; in SI units in rad/s (default 0)"}};
    for (const auto& [name, help] : lab_names)
        command
            .add_text(
                std::string("--") + name,
                [this, key = std::string(name)](const std::string& text) { lab_[key] = text; }, help)
            ->type_name("")
            ->group(start_group);
    command
        .add_option("--point", point_, "",
                    "psi,chi,vn,vt,S just after an impact (a disk drops chi), see `swirl simulate --help`")
        ->group(start_group);
    command
        .add_option("--speed", speed_, "",
                    "random start at the container's centre, in R_c omega_s (default 1/7 R_c omega_s)")
        ->group(start_group);
    add_seed(command, seed_, "of the random start (default 1)", &seed_given_)->group(start_group);
}

void StartOptions::set(const std::string& name, const std::string& text) {
    if (name == "point") {
        point_ = text;
    } else if (name == "speed") {
        speed_ = text;
    } else if (name == "seed") {
        seed_ = seed_from("--seed", text);
        seed_given_ = true;
    } else {
        lab_[name] = text;
    }
}

namespace {

/// A point, a start in the laboratory, a random one: one way to give a start each.
int way_of(const std::string& name) {
    if (name == "point") return 0;
    return name == "speed" || name == "seed" ? 1 : 2;
}

}  // namespace

void StartOptions::take_from(const SceneOptions& scene) {
    const auto& in_file = scene.start_in_file();
    for (const auto& [name, text] : in_file)
        if (way_of(name) != way_of(in_file.begin()->first))
            throw BadInput(fmt::format("scene file '{}': [start] has {} and {}, which are two ways to give a start",
                                       scene.file(), in_file.begin()->first, name));
    const bool flags_have[] = {!point_.empty(), !speed_.empty() || (seed_given_ && !seed_is_apart_), !lab_.empty()};
    const auto wins = [&](int way) {
        for (int other = 0; other < 3; ++other)
            if (other != way && flags_have[other]) return false;
        return true;
    };
    for (const auto& [name, text] : in_file) {
        const bool given = (name == "speed" && !speed_.empty()) || (name == "seed" && seed_given_) || gives(name);
        if (wins(way_of(name)) && !given) set(name, text);
    }
    if (!scene.units()) return;
    length_ = scene.text("container-radius", length_);
    rate_ = scene.text("swirl-rate", rate_);
}

double StartOptions::speed() const {
    if (speed_.empty()) return paper_speed;
    const double value = number_from<double>("speed", speed_);
    if (!(value >= 0 && std::isfinite(value)))
        throw BadInput(fmt::format("speed = {} is outside its range: speed >= 0, finite", speed_));
    return value / (number_from<double>("container-radius", length_) * number_from<double>("swirl-rate", rate_));
}

void StartOptions::require_one_way() const {
    const bool lab = !lab_.empty();
    const bool point = !point_.empty();
    const bool random = !speed_.empty() || (seed_given_ && !seed_is_apart_);
    if (lab && point) throw BadInput("--point and a start in the laboratory (--x …) are both given; give one");
    if (random && (lab || point))
        throw BadInput("--speed and --seed make a random start; they can't be given with --point or --x …");
}

void StartOptions::require_seeds(std::uint64_t count) const {
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max() - (count - 1);
    if (seed_ > largest)
        throw BadInput(fmt::format("seed = {} is outside its range for {} runs: 0 to {}", seed_, count, largest));
}

}  // namespace swirl::apps
