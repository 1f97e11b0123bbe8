// Where an orbit starts, as users give it: in the laboratory, on the section, or at random.
#pragma once

#include "apps/command_line/flags.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/plain_names.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/studies/scene_map/start.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace swirl::apps {

/// --seed, or another flag: CLI11 would take −1 for 2⁶⁴ − 1. `given`, if there is one, is set when the flag is.
Flag add_seed(Flags& command, std::uint64_t& seed, const std::string& help, bool* given = nullptr,
              const std::string& flag = "--seed");

class StartOptions {
public:
    void add_to(Flags& command);

    /// True if the start is one of many possible ones: neither a laboratory state nor a point was given.
    bool is_random() const { return lab_.empty() && point_.empty(); }
    /// True if any flag of a start was given.
    bool given() const { return !is_random() || !speed_.empty() || seed_given_; }
    bool speed_given() const { return !speed_.empty(); }
    /// True if this number of a start in the laboratory, or the point, was given.
    bool gives(const std::string& name) const { return name == "point" ? !point_.empty() : lab_.count(name) != 0; }
    /// True if any flag of a start was given but --angle, which with --series names a column: angle_text().
    bool given_beside_angle() const {
        return lab_.size() > lab_.count("angle") || !point_.empty() || !speed_.empty() || seed_given_;
    }
    std::string angle_text() const { return lab_.count("angle") != 0 ? lab_.at("angle") : ""; }
    /// As if the flag `name` had been given (a record's start). @throws BadInput for a seed out of range
    void set(const std::string& name, const std::string& text);
    /// What the scene file says: its start, of which a flag replaces a number, and a flag of another way to give a
    /// start all; and its physical units, if it has any, in which numbers are from now on: lengths in that of R_c,
    /// velocities in that of R_c ω_s, --spin in that of ω_s; S of --point is a ratio.
    /// Call once after SceneOptions::read_file(). @throws BadInput
    void take_from(const SceneOptions& scene);
    /// Of the random start, in R_c ω_s. @throws BadInput
    double speed() const;
    std::uint64_t seed() const { return seed_; }

    /// @throws BadInput for a mixture of ways, or something that is not a number
    template <class T>
    Start<T> start(const Scene<T>& scene, std::uint64_t run = 0) const;

    /// --seed is no way to give a start, so that it may stand beside one: it seeds something else, too.
    void keep_seed_apart() { seed_is_apart_ = true; }

    void require_one_way() const;
    /// @throws BadInput if seed, seed + 1 … of so many runs do not all exist
    void require_seeds(std::uint64_t count) const;

private:
    std::map<std::string, std::string> lab_;
    std::string point_;
    std::string speed_;
    std::string length_ = "1", rate_ = "1";  ///< R_c and ω_s in the user's units
    std::uint64_t seed_ = 1;
    bool seed_given_ = false, seed_is_apart_ = false;
};

/// "psi,chi,vn,vt,S", or "psi,vn,vt,S" for a disk.
template <class T>
SectionPoint<T> section_point_from(const std::string& name, const std::string& text, bool disk) {
    const auto c = numbers_from<T>(name, text, disk ? 4 : 5);
    return disk ? SectionPoint<T>{c[0], T(0), c[1], c[2], c[3]} : SectionPoint<T>{c[0], c[1], c[2], c[3], c[4]};
}

template <class T>
Start<T> StartOptions::start(const Scene<T>& scene, std::uint64_t run) const {
    require_one_way();
    const T length = number_from<T>("container-radius", length_), rate = number_from<T>("swirl-rate", rate_);
    const T velocity = length * rate;
    if (!point_.empty()) {
        SectionPoint<T> z = section_point_from<T>("--point", point_, scene.is_disk());
        return SectionPoint<T>{z.psi, z.chi, z.vn / velocity, z.vt / velocity, z.spin};
    }
    if (is_random()) {
        const LabStart<double> s = random_start(static_cast<double>(scene.beta), speed(), seed_, run);
        return LabStart<T>{scene.beta, T(0), T(s.vx), T(s.vy), T(s.angle), T(0)};
    }
    LabStart<T> start;
    start.x = scene.beta;
    const auto read = [&](const char* name, T& value, const T& unit) {
        const auto found = lab_.find(name);
        if (found != lab_.end()) value = number_from<T>(name, found->second) / unit;
    };
    read("x", start.x, length);
    read("y", start.y, length);
    read("vx", start.vx, velocity);
    read("vy", start.vy, velocity);
    read("angle", start.angle, T(1));
    read("spin", start.spin, rate);
    return start;
}

}  // namespace swirl::apps
