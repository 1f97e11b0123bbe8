// What every JSON document and every record states about its origin: version, scene, start, units.
#pragma once

#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/record/record_writer.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps {

/// Named settings of a run, in the order in which they are written.
using Settings = std::vector<std::pair<std::string, AttributeValue>>;

/// The scene's parameters by the names of docs/command-line.md, "Scene"; sides is a number, or "disk".
Settings scene_settings(const Scene<double>& scene);
/// A start in the laboratory, on the section, or at random (speed, seed).
Settings start_settings(const StartOptions& options, const Scene<double>& scene);
Settings unit_settings(const Units& units);

void write_json(JsonWriter& json, std::string_view key, const Settings& settings);
void write_attributes(const RecordGroup& group, const Settings& settings);

/// A record to be written, opened before any work. @throws BadInput if it can't be created
RecordWriter open_record(const std::string& path, const std::string& title);

/// The version and the instruction set that equal bits are promised for.
std::string version();
std::string instruction_set();

/// "hexagon α = 0.4 …" in one line, for tables and titles.
std::string describe(const Scene<double>& scene);

}  // namespace swirl::apps
