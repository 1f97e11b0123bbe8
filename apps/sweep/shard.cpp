#include "apps/sweep/shard.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/sweep/run_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <variant>

namespace swirl::apps::sweep {

namespace {

constexpr std::int64_t most_shards = 1'000'000;

bool is_one(const Shard& shard) {
    return 1 <= shard.number && shard.number <= shard.of && shard.of <= most_shards;
}

std::vector<std::int64_t> cells_in_shard(const Sweep& sweep) {
    std::vector<std::int64_t> cells;
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c)
        if (sweep.is_visited(c)) cells.push_back(static_cast<std::int64_t>(c));
    return cells;
}

}  // namespace

Shard shard_from(const std::string& text) {
    const auto slash = text.find('/');
    const auto number = [&](std::size_t begin, std::size_t end, std::int64_t& value) {
        const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
        return error == std::errc() && stop == text.data() + end;
    };
    Shard shard;
    const bool whole =
        slash != std::string::npos && number(0, slash, shard.number) && number(slash + 1, text.size(), shard.of);
    if (!whole || !is_one(shard))
        throw BadInput(fmt::format("shard = {} is outside its range: i/n with 1 <= i <= n <= {}", text, most_shards));
    return shard;
}

void take_shard(const Shard& shard, Sweep& sweep) {
    sweep.shard = shard;
    sweep.visited.assign(cell_count(sweep.grid), 0);
    for (auto c = static_cast<std::size_t>(shard.number - 1); c < sweep.visited.size();
         c += static_cast<std::size_t>(shard.of))
        sweep.visited[c] = 1;
}

void write_shard(const SweepOptions& options, const Sweep& sweep) {
    RecordWriter record =
        create_record(options.output, "A shard of the modes of a swirled polygon across parameters", sweep.units);
    write_attributes(record.root().group("settings"), sweep.settings);
    const RecordGroup group = record.root().group("shard");
    group.attribute("number", sweep.shard->number);
    group.attribute("of", sweep.shard->of);
    const std::vector<std::int64_t> cells = cells_in_shard(sweep);
    std::vector<RunResult> results;
    for (const std::int64_t cell : cells)
        for (const RunResult& run : sweep.cell(static_cast<std::size_t>(cell))) results.push_back(run);
    group.dimension("cell", cells.size());
    group.dimension("run", static_cast<std::uint64_t>(sweep.runs));
    if (!cells.empty()) {
        group.write<std::int64_t>("cell", {"cell"}, cells, {"1", "number of the cell in the whole sweep", {}});
        write_run_columns(group, {"cell", "run"}, results);
    }
    write_risk(record.root(), sweep.risk);
    record.finish();
}

ReadShard read_shard_file(const std::string& path) {
    const RecordReader record(path);
    if (!record.contains("/shard")) throw BadInput(fmt::format("record '{}' is no shard of a sweep", path));
    ReadShard read;
    read.shard.number = record.attribute<std::int64_t>("/shard", "number");
    read.shard.of = record.attribute<std::int64_t>("/shard", "of");
    if (!is_one(read.shard))
        throw BadInput(fmt::format("record '{}' says that it is shard {}/{}, which is none", path, read.shard.number,
                                   read.shard.of));
    for (const auto& name : record.attributes("/settings"))
        read.settings.emplace_back(name, record.attribute("/settings", name));
    if (record.contains("/units"))
        read.units = Units{record.attribute<double>("/units", "length"), record.attribute<double>("/units", "time"),
                           record.attribute<double>("/units", "mass")};
    read.risk = read_risk(record);
    if (!record.contains("/shard/cell")) return read;
    read.cells = record.read<std::int64_t>("/shard/cell");
    read.results = read_run_columns(record, "/shard");
    return read;
}

void take_runs(std::span<const RunResult> runs, std::size_t cell, char is_done, Sweep& sweep, std::vector<char>& done) {
    const std::size_t first = cell * static_cast<std::size_t>(sweep.runs);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        sweep.results[first + r] = runs[r];
        done[first + r] = is_done;
    }
}

void put(const std::string& path, const ReadShard& read, std::int64_t runs, Sweep& sweep, std::vector<char>& done) {
    const auto each = static_cast<std::size_t>(runs);
    const std::size_t cells = cell_count(sweep.grid);
    const auto is_its = [&](std::int64_t c) {
        return c >= 0 && static_cast<std::size_t>(c) < cells && c % read.shard.of == read.shard.number - 1;
    };
    const auto expected =
        (cells + static_cast<std::size_t>(read.shard.of - read.shard.number)) / static_cast<std::size_t>(read.shard.of);
    if (read.cells.size() != expected || read.results.size() != expected * each ||
        !std::all_of(read.cells.begin(), read.cells.end(), is_its))
        throw BadInput(
            fmt::format("record '{}' does not hold the cells of shard {}/{}", path, read.shard.number, read.shard.of));
    for (std::size_t i = 0; i < read.cells.size(); ++i)
        take_runs(std::span(read.results).subspan(i * each, each), static_cast<std::size_t>(read.cells[i]), 1, sweep,
                  done);
}

std::string different_setting(const Settings& wanted, const Settings& found) {
    const auto holds = [](const Settings& settings, const auto& entry) {
        return std::find(settings.begin(), settings.end(), entry) != settings.end();
    };
    for (const auto& entry : wanted)
        if (!holds(found, entry)) return entry.first;
    for (const auto& entry : found)
        if (!holds(wanted, entry)) return entry.first;
    return "";
}

std::string setting_in_words(const Settings& settings, const std::string& name) {
    constexpr std::size_t longest = 60;
    const auto found = std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.first == name; });
    if (found == settings.end()) return "no " + name;
    std::string text = settings_text({*found});
    text.pop_back();  // the end of its line
    return text.size() > longest ? "another " + name : text;
}

std::int64_t runs_of_same_sweep(const std::string& path, const Settings& wanted, const Settings& found) {
    const auto without_runs = [](Settings settings) {
        std::erase_if(settings, [](const auto& setting) { return setting.first == "runs"; });
        return settings;
    };
    const auto runs_in = [](const Settings& settings) {
        for (const auto& [name, value] : settings)
            if (name == "runs")
                if (const auto* runs = std::get_if<std::int64_t>(&value)) return *runs;
        return std::int64_t{0};
    };
    const std::string differs = different_setting(without_runs(wanted), without_runs(found));
    const std::int64_t runs = runs_in(found), wanted_runs = runs_in(wanted);
    // The sample is one of all runs: with more of them it is another.
    const bool is_of_all =
        std::any_of(wanted.begin(), wanted.end(), [](const auto& setting) { return setting.first == "risk"; });
    const bool as_many = is_of_all ? runs == wanted_runs : 1 <= runs && runs <= wanted_runs;
    if (differs.empty() && as_many) return runs;
    const std::string name = differs.empty() ? "runs" : differs;
    throw BadInput(
        fmt::format("record '{}' was made with {}, here is {}: give the same{}, or another file, or replace it "
                    "with --force",
                    path, setting_in_words(found, name), setting_in_words(wanted, name),
                    differs.empty() && !is_of_all ? " or more" : ""));
}

bool read_shard(const std::string& path, Sweep& sweep, std::vector<char>& done) {
    const ReadShard read = read_shard_file(path);
    if (read.shard.number != sweep.shard->number || read.shard.of != sweep.shard->of)
        throw BadInput(
            fmt::format("record '{}' is shard {}/{}, not {}/{}: give that, or another file, or replace it with "
                        "--force",
                        path, read.shard.number, read.shard.of, sweep.shard->number, sweep.shard->of));
    const std::int64_t runs = runs_of_same_sweep(path, sweep.settings, read.settings);
    put(path, read, runs, sweep, done);
    sweep.risk = read.risk;
    return runs == sweep.runs;
}

}  // namespace swirl::apps::sweep
