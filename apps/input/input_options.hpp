// What a command analyses: the orbit of a scene, a record of one, or a measured series.
#pragma once

#include "apps/command_line/flags.hpp"
#include "apps/input/measured_series.hpp"
#include "apps/input/orbit_columns.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

enum class InputKind { scene, record, series };

struct InputOptions {
    SceneOptions scene;
    StartOptions start;
    std::string record;  ///< a file that swirl simulate -o wrote
    SeriesChoice series;
    std::optional<std::int64_t> transient, collisions;

    /// Adds the flags: a scene's, a start's, the record (also as a positional), the series'.
    void add_to(Flags& command);

    /// The one kind that was given. @throws BadInput for two, or none
    InputKind kind() const;

    /// The files that are read; empty names are none, "-" is standard input.
    std::vector<std::string> files() const { return {scene.file(), record, series.file}; }

    /// Of a scene 10,000 impacts after 10,000 (what the classification needs); of a record or series all there is.
    ImpactRange range() const;

    /// The columns `names` of the orbit that was asked for. kind() must not be series.
    OrbitColumns orbit(const OutputOptions& output, const std::vector<std::string>& names);

    /// The series, --transient and --collisions applied to its samples.
    MeasuredSeries measured() const;

    /// --transient and --collisions applied to the samples of a series. `name` is for messages. @throws BadInput if it
    /// has fewer
    MeasuredSeries part_asked_for(const MeasuredSeries& whole, const std::string& name) const;
};

/// With --angle and --swirl-rate, which are flags of start and scene.
SeriesChoice whole_choice(const SeriesChoice& series, const SceneOptions& scene, const StartOptions& start);

/// The text under --help that every command with these options shares.
extern const char* const input_details;

/// What documents say of the orbit: scene, start, units if physical, outcome, impacts, every.
void write_orbit(JsonWriter& json, const OrbitColumns& orbit);
void write_orbit(const RecordGroup& root, const OrbitColumns& orbit);

/// What documents say of a series: column, time, samples, missing, spacing, even, ….
Settings series_settings(const MeasuredSeries& series);

/// True if the file is a record that holds a measured series and no orbit. @throws BadInput if it is no record
bool is_series_record(const std::string& file);
/// The series that write_series() wrote.
MeasuredSeries read_series_record(const std::string& file);

/// Writes the series itself, group `series`: a record holds what made it, but no path.
void write_series(const RecordGroup& root, const MeasuredSeries& series);

}  // namespace swirl::apps
