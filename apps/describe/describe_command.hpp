// `swirl describe`: what is known of a scene in closed form, before any orbit is followed.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/output/table.hpp"
#include "map/chords/chord_fate.hpp"
#include "map/steady/edge_rest.hpp"
#include "map/steady/scene_facts.hpp"
#include "map/steady/steady_modes.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::describe {

struct DescribeOptions {
    SceneOptions scene;
    OutputOptions output;
    std::optional<double> longest;  ///< --max-time as given
    double max_time = 12;           ///< in 1/ω_s

    void add_to(Flags& command);
};

extern const char* const describe_details;

/// A family, and one of its members.
struct DescribedFamily {
    SteadyFamily family;
    std::optional<SteadyMode> midway;  ///< at the middle of its flight times (S = 0 where S is free)
};

/// A chord or diameter, and where the swirl leads a body on it. NaN: does not apply.
struct DescribedChord {
    Chord chord;
    ChordSpeeds speeds;     ///< e = 1
    double growth = 0;      ///< K of a diameter that attracts
    double balance = 0;     ///< J* = v²/2 of a diameter with e < 1
    double limit_spin = 0;  ///< S* of a chord with a limit
};

struct Description {
    Scene<double> scene;
    SteadyOptions search;
    SceneFacts facts;
    SteadyModes steady;
    std::vector<DescribedFamily> families;  ///< those of `steady`
    std::vector<DescribedChord> chords;     ///< of a polygon with friction
    bool has_all_chords = true;
    std::vector<EdgeRest> rests;  ///< of a polygon on the wall, by rising ψ
    std::string none_exist;       ///< why there are no steady modes, where that is proven

    /// True if `steady` lists all up to the longest flight that was asked for.
    bool is_complete() const { return steady.complete_to >= search.longest_flight; }
};

/// @throws std::invalid_argument if a parameter is out of range
Description description_of(const Scene<double>& scene, double max_time);

/// Steady modes as rows; `d` coordinates in a record.
///   numbered  the list whose modes a table for people numbers, if any
Table<SteadyMode> mode_table(bool disk, std::size_t d, const std::vector<SteadyMode>* numbered = nullptr);
void write_modes(const RecordGroup& group, bool disk, const std::vector<SteadyMode>& modes);

void write_description_document(const DescribeOptions& options, const Description& d, const Settings& settings);
void print_description(const Description& d, const std::optional<Units>& units);
/// Groups scene, settings, facts (attributes), rim (of a disk), steady_modes, families, chords and rests (if there are
/// any).
void write_description_record(const RecordGroup& root, const Description& d, const Settings& settings);

/// Of a floor that drags: what is known of it alone (map/dragged/floor_facts.hpp) and its steady modes (dragged_modes),
/// to the document, the table and a record, which it finishes: groups scene, settings, floor (attributes) and
/// steady_modes.
int describe_floor(const DescribeOptions& options, const Scene<double>& scene, std::optional<RecordWriter>& record);

int describe(DescribeOptions& options);

}  // namespace swirl::apps::describe
