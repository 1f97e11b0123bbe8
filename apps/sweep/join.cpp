#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/sweep/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps::sweep {

const char* const join_details =
    R"(Makes the record of the whole sweep from its shards, each given once, in any order. It has the same bytes as that of the
sweep without --shard.

Example:
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --alpha 0.4 --grid beta=0.1:0.9:4 --collisions 500 --shard 1/1 -o part.h5
  swirl join part.h5 -o whole.h5)";

void JoinOptions::add_to(Flags& command) {
    output.add_to(command);
    command.add_option("shards", shards, "SHARD.h5", "records that sweep --shard wrote");
}

namespace {

/// In the order of settings_of; the scene's stand after the first.
constexpr std::array before_scene{"swirl_version", "grid", "sample", "scenes"};
constexpr std::array after_scene{"runs",  "speed", "x",         "y",         "vx",         "vy",
                                 "angle", "spin",  "seed",      "transient", "collisions", "exhaustive",
                                 "risk",  "error", "threshold", "accuracy"};

/// The settings in the order of settings_of. @throws BadInput for one that is not known
Settings ordered(const std::string& path, const Settings& settings) {
    Settings sorted;
    const auto take = [&](const auto& names) {
        for (const char* name : names)
            for (const auto& entry : settings)
                if (entry.first == name) sorted.push_back(entry);
    };
    take(before_scene);
    take(scene_setting_names);
    take(after_scene);
    if (sorted.size() != settings.size())
        throw BadInput(fmt::format("record '{}' has settings that are not a sweep's", path));
    return sorted;
}

template <class T>
T setting(const std::string& path, const Settings& settings, const std::string& name) {
    for (const auto& [key, value] : settings)
        if (key == name)
            if (const T* typed = std::get_if<T>(&value)) return *typed;
    throw BadInput(fmt::format("record '{}' does not say its {}", path, name));
}

/// The sweep without results, and the scene's options.
Sweep sweep_from(const std::string& path, const ReadShard& read, SweepOptions& options) {
    Sweep sweep;
    sweep.settings = ordered(path, read.settings);
    sweep.units = read.units;
    sweep.runs = options.runs = setting<std::int64_t>(path, sweep.settings, "runs");
    GridForm form;
    form.seed = setting<std::uint64_t>(path, sweep.settings, "seed");
    for (const auto& [name, value] : sweep.settings) {
        const std::string text = flag_text_of(value).value_or("");
        if (name == "sample") form.sample = sample_from(text);
        if (name == "scenes") form.scenes = static_cast<std::size_t>(setting<std::int64_t>(path, sweep.settings, name));
        if (name == "inertia_factor" && text == "uniform") continue;  // the lamina's, which depends on N
        for (const char* of_scene : scene_setting_names)
            if (name == of_scene) options.scene.set(flag_name(name), text);
    }
    sweep.grid = grid_from(setting<std::vector<std::string>>(path, sweep.settings, "grid"), form);
    scene_of_cell(options.scene, sweep.grid, 0);
    if (sweep.runs < 1 || sweep.runs > 1'000'000)
        throw BadInput(fmt::format("record '{}': runs = {} is outside its range: 1 to 1000000", path, sweep.runs));
    sweep.results.resize(cell_count(sweep.grid) * static_cast<std::size_t>(sweep.runs));
    return sweep;
}

void require_all(const std::vector<ReadShard>& shards, const std::vector<std::string>& paths) {
    const auto of = static_cast<std::size_t>(shards.front().shard.of);
    std::vector<char> seen(of, 0);
    for (std::size_t i = 0; i < shards.size(); ++i) {
        const Shard& shard = shards[i].shard;
        if (shard.of != shards.front().shard.of || shard.number < 1 || shard.number > shard.of)
            throw BadInput(
                fmt::format("record '{}' is shard {}/{}, others are of {}", paths[i], shard.number, shard.of, of));
        const std::string differs = different_setting(shards.front().settings, shards[i].settings);
        if (!differs.empty())
            throw BadInput(fmt::format("record '{}' was made with {}, '{}' with {}", paths[i],
                                       setting_in_words(shards[i].settings, differs), paths[0],
                                       setting_in_words(shards.front().settings, differs)));
        if (seen[static_cast<std::size_t>(shard.number - 1)]++)
            throw BadInput(fmt::format("shard {}/{} is given twice, last as '{}'", shard.number, of, paths[i]));
    }
    const auto missing = std::find(seen.begin(), seen.end(), 0);
    if (missing != seen.end()) throw BadInput(fmt::format("shard {}/{} is missing", missing - seen.begin() + 1, of));
}

/// What the sample told is the same in each; of the means that were followed on each has its own.
std::vector<RiskEvidence> risk_of_all(const std::vector<ReadShard>& shards) {
    std::vector<RiskEvidence> all = shards.front().risk;
    for (std::size_t s = 1; s < shards.size(); ++s)
        for (std::size_t i = 0; i < std::min(all.size(), shards[s].risk.size()); ++i)
            all[i].means_followed += shards[s].risk[i].means_followed;
    return all;
}

}  // namespace

int join(JoinOptions& options) {
    if (options.shards.empty()) throw BadInput("no shards are given: swirl join SHARD... -o RECORD");
    if (options.output.record.empty()) throw BadInput("-o is missing: the record to write");
    options.output.command = "sweep";  // the record is a sweep's
    require_output(options.output, options.shards);
    std::vector<ReadShard> shards;
    try {
        for (const auto& path : options.shards) shards.push_back(read_shard_file(path));
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
    require_all(shards, options.shards);
    SweepOptions of_sweep;
    of_sweep.output = options.output;
    Sweep sweep = sweep_from(options.shards.front(), shards.front(), of_sweep);
    std::vector<char> done(sweep.results.size(), 0);
    for (std::size_t i = 0; i < shards.size(); ++i) put(options.shards[i], shards[i], sweep.runs, sweep, done);
    sweep.risk = risk_of_all(shards);
    note_interruptions();
    const bool all = find_steady_modes(of_sweep, sweep);
    finish_up();
    if (!all) return exit_interrupted;
    find_basins(sweep);
    write_sweep(of_sweep, sweep);
    if (options.output.json)
        write_sweep_document(sweep);
    else if (!options.output.quiet)
        print_sweep(sweep);
    return exit_done;
}

}  // namespace swirl::apps::sweep
