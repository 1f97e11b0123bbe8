// What `swirl describe` says of a floor that drags.
#include "apps/describe/describe_command.hpp"
#include "apps/output/write_table.hpp"
#include "map/dragged/dragged_modes.hpp"
#include "map/dragged/floor_facts.hpp"
#include "map/steady/scene_facts.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>

namespace swirl::apps::describe {

namespace {

struct DescribedFloor {
    Scene<double> scene;
    SceneFacts facts;
    FloorFacts floor;
    std::optional<Units> units;
};

constexpr double absent = std::numeric_limits<double>::quiet_NaN();  // null in JSON

std::string riding_in_words(const DescribedFloor& d) {
    const double room = d.floor.riding_room, radius = d.floor.riding_radius;
    if (d.scene.drag == 0) return "none comes to ride: gamma = 0 leaves its velocity as it is";
    if (!d.floor.rides) return fmt::format("none: it would reach {:.6g} R_c beyond the wall", -room);
    const auto length = [&](double r) { return with_unit(r, d.units, "R_c") + (d.units ? "" : " R_c"); };
    const std::string spin = d.scene.turning_drag() > 0 ? "S = 0" : "S as it was";
    if (d.scene.floor == Floor::table)
        return fmt::format("rests on the table, {}, up to {} from the swirl's centre", spin, length(room));
    return fmt::format("rides on a circle of {}, {}, whose centre is up to {} from the dish's", length(radius), spin,
                       length(room));
}

std::string locking_in_words(const DescribedFloor& d) {
    if (!d.floor.locking_ratio) return "-";
    if (!d.floor.locked)
        return fmt::format("no: (gamma + kappa gamma_r) rho is {:.6g} of the swirl's most", *d.floor.locking_ratio);
    const LockedRolling& locked = *d.floor.locked;
    if (!locked.holds) return fmt::format("no: friction holds it from mu = {:.6g} on", locked.friction);
    const std::string found = fmt::format("yes: psi = {:.9g}, S = {:.9g}", locked.psi, locked.spin);
    if (d.scene.restitution < 1) return found;
    return found + (locked.bounce_decay > 0 ? "; bounces on it die away" : "; bounces on it grow");
}

Table<DescribedFloor> floor_table() {
    using F = Field<DescribedFloor>;
    const auto locked = [](double LockedRolling::*member) {
        return [member](const DescribedFloor& d) { return d.floor.locked ? (*d.floor.locked).*member : absent; };
    };
    const auto widest = [](const DescribedFloor& d) { return d.scene.is_disk() ? absent : d.facts.widest_chi; };
    const auto ratio = [](const DescribedFloor& d) { return d.floor.locking_ratio.value_or(absent); };
    const auto rolls = [](const DescribedFloor& d) { return d.floor.locked && d.floor.locked->holds; };
    return {{},
            {F{"widest_chi", widest, "rad", "largest |chi|"}.shown("largest |chi|, chi_m", "{:.6g}"),
             {"riding_radius", [](const DescribedFloor& d) { return d.floor.riding_radius; }, "R_c",
              "of the circle of a body that meets the wall no more"},
             {"riding_room", [](const DescribedFloor& d) { return d.floor.riding_room; }, "R_c",
              "distance of that circle's centre up to which it touches nothing"},
             {"rides", [](const DescribedFloor& d) { return d.floor.rides; }, "1", "is there a body that rides?"},
             F{"riding", riding_in_words, no_column}.table_only().shown("a body without impacts", "{}"),
             {"locking_ratio", ratio, "1", "of a rolling disk's drag to the swirl's most: locked up to 1"},
             {"rolls_locked", rolls, "1", "does a disk roll locked to the swirl?"},
             {"locked_psi", locked(&LockedRolling::psi), "rad", "psi there"},
             {"locked_S", locked(&LockedRolling::spin), "1", "S there"},
             {"locked_force", locked(&LockedRolling::force), "m R_c omega_s^2", "of the wall there"},
             {"locked_friction", locked(&LockedRolling::friction), "1", "friction that it needs"},
             {"locked_bounce_decay", locked(&LockedRolling::bounce_decay), "omega_s",
              "rate at which v^3 of an elastic disk's bounces on it falls"},
             F{"locking", locking_in_words, no_column}.table_only().shown("a disk rolls locked to the swirl", "{}")}};
}

void print_floor(const DescribedFloor& d, const DraggedModes& found) {
    fmt::print("{}\n{}{}", scene_in_words(d.scene), units_in_words(d.units),
               shown_lines_of(in_units(floor_table(), d.units), d));
    fmt::print("  steady modes by impacts with tau <= {}, on a grid: {}\n",
               with_unit(found.searched_to, d.units, "1/omega_s"), found.modes.size());
    if (!found.modes.empty())
        print_table(in_units(mode_table(d.scene.is_disk(), 0, &found.modes), d.units), found.modes);
}

}  // namespace

int describe_floor(const DescribeOptions& options, const Scene<double>& scene, std::optional<RecordWriter>& record) {
    const DescribedFloor d{scene, scene_facts(scene), floor_facts(scene), options.scene.units()};
    const bool disk = scene.is_disk();
    const DraggedModesOptions search{.longest_flight = options.max_time};
    const DraggedModes found = dragged_modes(scene, search);
    const Settings settings = {{"max_time", search.longest_flight},
                               {"fastest_spin", search.fastest_spin},
                               {"accuracy", options.output.accuracy_name}};
    if (record) {
        write_scene(record->root(), scene);
        write_attributes(record->root().group("settings"), settings);
        write_attributes(record->root().group("floor"), floor_table(), d);
        write_modes(record->root().group("steady_modes"), disk, found.modes);
        record->finish();
    }
    if (options.output.json)
        print_document([&](JsonWriter& json) {
            write_scene(json, scene, options.scene);
            json.key("floor");
            write_object(json, floor_table(), d);
            write_json(json, "steady_modes", mode_table(disk, 0), found.modes);
            json.member("searched_to", found.searched_to);
            write_json(json, "settings", settings);
        });
    else if (!options.output.quiet)
        print_floor(d, found);
    return exit_done;
}

}  // namespace swirl::apps::describe
