#include "apps/classify/runs_document.hpp"

#include "apps/modes/kind_document.hpp"
#include "apps/modes/verdict_document.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

namespace swirl::apps::classify {

namespace {

/// How many runs have each value, in the enumerators' order.
template <class Enum>
std::map<Enum, std::size_t> counts_of(const std::vector<RunVerdict>& runs, Enum RunVerdict::*member) {
    std::map<Enum, std::size_t> counts;
    for (const auto& run : runs) ++counts[run.*member];
    return counts;
}

double share(std::size_t count, const RunsFound& found) {
    return static_cast<double>(count) / static_cast<double>(found.runs.size());
}

/// The attractor of every run.
std::vector<std::int64_t> places_of(const RunsFound& found) {
    std::vector<std::int64_t> places(found.runs.size());
    for (std::size_t a = 0; a < found.attractors.size(); ++a)
        for (const std::size_t r : found.attractors[a].runs) places[r] = static_cast<std::int64_t>(a);
    return places;
}

void write_shares(JsonWriter& json, const RunsFound& found) {
    json.key("modes");
    json.begin_object();
    for (const auto& [mode, count] : counts_of(found.runs, &RunVerdict::mode))
        json.member(name_of(mode), share(count, found));
    json.end_object();
    json.key("kinds");
    json.begin_object();
    for (const auto& [kind, count] : counts_of(found.runs, &RunVerdict::kind))
        json.member(name_of(kind), share(count, found));
    json.end_object();
}

void write_attractors(JsonWriter& json, const RunsFound& found) {
    json.key("attractors");
    json.begin_array(JsonLayout::rows);
    for (const auto& attractor : found.attractors) {
        const RunVerdict& first = found.runs[attractor.runs.front()];
        json.begin_object();
        json.member("share", share(attractor.runs.size(), found));
        json.member("mode", name_of(first.mode));
        write_kind(json, first.kind);
        json.member("outcome", name_of(first.outcome));
        write_period(json, first.period);
        json.member("mean_S", attractor.mean_spin);
        json.member("mean_S_error", attractor.mean_spin_error);
        json.member("largest_exponent", attractor.largest_exponent);
        json.member("recurrence_rate", attractor.recurrence_rate);
        json.member("seed", first.seed);
        json.end_object();
    }
    json.end_array();
}

void write_each(JsonWriter& json, const RunsFound& found) {
    const auto places = places_of(found);
    json.key("runs");
    json.begin_array(JsonLayout::rows);
    for (std::size_t r = 0; r < found.runs.size(); ++r) {
        const RunVerdict& run = found.runs[r];
        json.begin_object();
        json.member("seed", run.seed);
        json.member("attractor", places[r]);
        json.member("mode", name_of(run.mode));
        write_kind(json, run.kind);
        json.member("outcome", name_of(run.outcome));
        write_period(json, run.period);
        json.member("mean_S", run.mean_spin);
        json.member("mean_S_per_impact", run.mean_spin_per_impact);
        json.member("recurrence_rate", run.recurrence_rate);
        json.member("largest_exponent", run.largest_exponent);
        json.member("largest_exponent_error", run.largest_exponent_error);
        json.end_object();
    }
    json.end_array();
}

template <class T, class Item>
std::vector<T> column(const std::vector<Item>& items, const std::function<T(const Item&)>& value) {
    std::vector<T> values;
    values.reserve(items.size());
    for (const auto& item : items) values.push_back(value(item));
    return values;
}

struct NumberColumn {
    const char* name;
    double RunVerdict::*member;
    Description description;
};

void write_runs_group(const RecordGroup& group, const RunsFound& found) {
    const std::vector<std::string> along{"run"};
    const auto words = [&](const char* name, const std::function<std::string(const RunVerdict&)>& word) {
        group.write_strings(name, along, column<std::string, RunVerdict>(found.runs, word));
    };
    const auto integers = [&](const char* name, const std::function<std::int64_t(const RunVerdict&)>& value,
                              const char* what) {
        group.write<std::int64_t>(name, along, column<std::int64_t, RunVerdict>(found.runs, value), {"1", what, {}});
    };
    group.dimension("run", found.runs.size());
    // Text, because a seed takes all of 64 bits.
    words("seed", [](const RunVerdict& run) { return fmt::format("{}", run.seed); });
    group.write<std::int64_t>("attractor", along, places_of(found), {"1", "place in the group attractors", {}});
    words("mode", [](const RunVerdict& run) { return std::string(name_of(run.mode)); });
    words("kind", [](const RunVerdict& run) { return std::string(name_of(run.kind)); });
    words("outcome", [](const RunVerdict& run) { return std::string(name_of(run.outcome)); });
    integers(
        "period", [](const RunVerdict& run) { return run.period; }, "period, 0: none");
    integers(
        "impacts", [](const RunVerdict& run) { return run.impacts; }, "impacts followed");
    const NumberColumn numbers[] = {
        {"mean_S", &RunVerdict::mean_spin, {"omega_s", "time mean of S", {}}},
        {"mean_S_per_impact", &RunVerdict::mean_spin_per_impact, {"omega_s", "mean of S over impacts", {}}},
        {"recurrence_rate", &RunVerdict::recurrence_rate, {"1", "RC of S", {}}},
        {"largest_exponent", &RunVerdict::largest_exponent, {"1", "largest Lyapunov exponent per impact", {}}},
        {"largest_exponent_error", &RunVerdict::largest_exponent_error, {"1", "its standard error", {}}}};
    for (const auto& n : numbers)
        group.write<double>(
            n.name, along, column<double, RunVerdict>(found.runs, [&](const RunVerdict& run) { return run.*n.member; }),
            n.description);
}

void write_attractors_group(const RecordGroup& group, const RunsFound& found) {
    const std::vector<std::string> along{"attractor"};
    const auto first = [&](const Attractor& attractor) -> const RunVerdict& {
        return found.runs[attractor.runs.front()];
    };
    const auto words = [&](const char* name, const std::function<std::string(const Attractor&)>& word) {
        group.write_strings(name, along, column<std::string, Attractor>(found.attractors, word));
    };
    const auto numbers = [&](const char* name, const std::function<double(const Attractor&)>& value,
                             const Description& description) {
        group.write<double>(name, along, column<double, Attractor>(found.attractors, value), description);
    };
    group.dimension("attractor", found.attractors.size());
    words("seed", [&](const Attractor& a) { return fmt::format("{}", first(a).seed); });
    words("mode", [&](const Attractor& a) { return std::string(name_of(first(a).mode)); });
    words("kind", [&](const Attractor& a) { return std::string(name_of(first(a).kind)); });
    words("outcome", [&](const Attractor& a) { return std::string(name_of(first(a).outcome)); });
    group.write<std::int64_t>(
        "period", along,
        column<std::int64_t, Attractor>(found.attractors, [&](const Attractor& a) { return first(a).period; }),
        {"1", "period, 0: none", {}});
    numbers("share", [&](const Attractor& a) { return share(a.runs.size(), found); }, {"1", "share of the runs", {}});
    numbers("mean_S", [](const Attractor& a) { return a.mean_spin; }, {"omega_s", "mean of the runs' time means", {}});
    numbers("mean_S_error", [](const Attractor& a) { return a.mean_spin_error; },
            {"omega_s", "its standard error over the runs", {}});
    numbers("largest_exponent", [](const Attractor& a) { return a.largest_exponent; },
            {"1", "mean over the runs, per impact", {}});
    numbers("recurrence_rate", [](const Attractor& a) { return a.recurrence_rate; }, {"1", "mean over the runs", {}});
}

}  // namespace

void write_runs_document(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found) {
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    write_json(json, "scene", scene_settings(scene));
    write_json(json, "start", start_settings(options.start, scene));
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    write_verdict(json, found.first, options.settings);
    write_shares(json, found);
    write_attractors(json, found);
    write_each(json, found);
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
}

void write_runs(const RecordGroup& root, const ClassifyCommandOptions& options, const Scene<double>& scene,
                const RunsFound& found) {
    write_attributes(root.group("scene"), scene_settings(scene));
    write_attributes(root.group("start"), start_settings(options.start, scene));
    write_verdict(root.group("mode"), found.first, options.settings);
    write_attractors_group(root.group("attractors"), found);
    const RecordGroup runs = root.group("runs");
    runs.attribute("wanted", options.runs);  // more than there are if interrupted
    write_runs_group(runs, found);
}

void print_runs(const Scene<double>& scene, const RunsFound& found) {
    fmt::print("{}\n  {} runs:", describe(scene), found.runs.size());
    for (const auto& [mode, count] : counts_of(found.runs, &RunVerdict::mode))
        fmt::print(" {} {:.4g} %", name_of(mode), 100 * share(count, found));
    fmt::print("\n  {:>8}  {:<13} {:<20} {:>6} {:>14} {:>9} {:>11} {:>11}  {}\n", "share", "mode", "kind", "period",
               "mean S", "error", "exponent", "RC", "seed");
    for (const auto& attractor : found.attractors) {
        const RunVerdict& first = found.runs[attractor.runs.front()];
        fmt::print("  {:>6.2f} %  {:<13} {:<20} {:>6} {:>14.8g} {:>9.2g} {:>11.4g} {:>11.4g}  {}\n",
                   100 * share(attractor.runs.size(), found), name_of(first.mode), name_of(first.kind),
                   first.period > 0 ? fmt::format("{}", first.period) : "-", attractor.mean_spin,
                   attractor.mean_spin_error, attractor.largest_exponent, attractor.recurrence_rate, first.seed);
    }
    fmt::print("the first of them, seed {}:\n{}", found.runs[found.attractors.front().runs.front()].seed,
               table_of(found.first));
}

}  // namespace swirl::apps::classify
