// What the commands that read records find in them, as docs/command-line.md has it.
#include "tests/fuzz/made_record.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace swirl::tests::fuzz {

namespace {

using Items = std::vector<Item>;

Item number(const char* group, const char* name, double value, Stored stored = Stored::float64) {
    return {group, name, true, stored, {}, {value}};
}
Item whole(const char* group, const char* name, double value) {
    return number(group, name, value, Stored::int64);
}
Item text(const char* group, const char* name, const char* value) {
    return {group, name, true, Stored::text, {}, {}, {value}};
}
Item column(const char* group, const char* name, std::vector<std::uint64_t> shape, std::vector<double> values,
            Stored stored = Stored::float64) {
    return {group, name, false, stored, std::move(shape), std::move(values)};
}
Item words(const char* group, const char* name, std::vector<std::string> values) {
    return {group, name, false, Stored::text, {values.size()}, {}, std::move(values)};
}

void put_scene(Items& items, const char* group = "/scene") {
    const Items scene = {whole(group, "sides", 6),
                         number(group, "alpha", 0.4),
                         number(group, "beta", 0.5),
                         number(group, "mu", 0.5),
                         number(group, "restitution", 0.9),
                         text(group, "law", "poisson"),
                         number(group, "inertia_factor", 5.0 / 12)};
    items.insert(items.end(), scene.begin(), scene.end());
}

Items orbit() {
    Items items = {whole("/settings", "skip", 0),
                   whole("/settings", "every", 1),
                   text("/settings", "accuracy", "double"),
                   text("/result", "outcome", "completed"),
                   whole("/result", "impacts", 4),
                   number("/units", "length", 2),
                   number("/units", "time", 1),
                   number("/units", "mass", 1),
                   column("/contacts", "t_start", {1}, {0.5})};
    put_scene(items);
    for (const char* name : {"x", "y", "vx", "vy", "angle", "spin"}) items.push_back(number("/start", name, 0.1));
    for (const char* name : {"t", "psi", "chi", "vn", "vt", "spin"})
        items.push_back(column("/collisions", name, {4}, {0.1, 0.2, 0.3, 0.4}));
    return items;
}

Items series() {
    const char* const g = "/series";
    return {text(g, "column", "angle"),
            text(g, "time", "t"),
            text(g, "quantity", "S of an angle"),
            whole(g, "rows", 4),
            number(g, "swirl_rate", 1),
            number(g, "largest_turn", 0.1),
            number(g, "angle_period", 6.2),
            number(g, "angle_resolution", 0),
            column(g, "time", {3}, {0.5, 1.5, 2.5}),
            column(g, "value", {3}, {0.1, 0.2, 0.3}),
            column(g, "angle_time", {4}, {0, 1, 2, 3}),
            column(g, "angle", {4}, {0, 0.1, 0.3, 0.6})};
}

const std::vector<double> cycles = {0.1, 0.01, -0.5, 0.8, -0.9, 0.2, 0.02, -0.4, 0.7, -0.8,
                                    0.3, 0.03, -0.3, 0.6, -0.7, 0,   0,    0,    0,   0};

Items branches() {
    const char* const g = "/special";
    Items items = {text("/settings", "along", "beta"),
                   column(g, "points", {2, 2, 5}, cycles),
                   column(g, "period", {2}, {2, 1}, Stored::int64),
                   words(g, "kind", {"flip", "neimark-sacker"}),
                   column(g, "parameter", {2}, {0.4, 0.5}),
                   column(g, "form_angle", {2}, {0, 1})};
    put_scene(items);
    return items;
}

Items boundaries() {
    const char* const g = "/curves";
    Items items = {text("/settings", "first", "beta"),
                   text("/settings", "second", "mu"),
                   column(g, "points", {2, 2, 5}, cycles),
                   column(g, "period", {2}, {2, 1}, Stored::int64),
                   column(g, "curve", {2}, {0, 1}, Stored::int64),
                   column(g, "first", {2}, {0.4, 0.5}),
                   column(g, "second", {2}, {0.4, 0.5}),
                   column(g, "angle", {2}, {0, 1}),
                   words("/curve_ends", "kind", {"flip", "grazing"}),
                   column(g, "touch", {2}, {0, 1}, Stored::uint8),
                   column(g, "touching_vertex", {2}, {0, 2}, Stored::int64),
                   column(g, "touch_time", {2}, {0, 0.3}),
                   column(g, "flight_times", {2, 2}, {1, 1, 1, 1}),
                   column(g, "vertex_steps", {2, 2}, {1, 2, 3, 0})};
    put_scene(items);
    return items;
}

Items found_cycles() {
    Items items = {column("/orbits", "points", {2, 2, 5}, cycles),
                   column("/orbits", "period", {2}, {2, 1}, Stored::int64)};
    put_scene(items);
    return items;
}

Items followed_cycles() {
    Items items = {text("/settings", "along", "beta"), column("/branches", "points", {2, 2, 5}, cycles),
                   column("/branches", "period", {2}, {2, 1}, Stored::int64),
                   column("/branches", "parameter", {2}, {0.4, 0.5})};
    put_scene(items);
    return items;
}

Items shard() {
    const char* const g = "/shard";
    Items items = {whole(g, "number", 1),
                   whole(g, "of", 2),
                   whole("/settings", "runs", 1),
                   number("/units", "length", 2),
                   number("/units", "time", 1),
                   number("/units", "mass", 1),
                   column(g, "cell", {2}, {0, 2}, Stored::int64)};
    put_scene(items, "/settings");
    for (const char* name : {"run_mode", "run_kind", "run_outcome"})
        items.push_back(column(g, name, {2, 1}, {1, 2}, Stored::uint8));
    for (const char* name : {"run_period", "run_impacts"})
        items.push_back(column(g, name, {2, 1}, {1, 2}, Stored::int64));
    for (const char* name : {"run_mean_S", "run_mean_S_per_impact", "run_recurrence_rate", "run_largest_exponent"})
        items.push_back(column(g, name, {2, 1}, {0.1, 0.2}));
    return items;
}

}  // namespace

std::vector<Item> items_of_command(int command) {
    Items (*const all[])() = {orbit, series, branches, boundaries, found_cycles, followed_cycles, shard};
    static_assert(std::size(all) == reading_commands);
    Items items = all[command]();
    items.push_back(whole("/", "schema_version", 1));
    return items;
}

}  // namespace swirl::tests::fuzz
