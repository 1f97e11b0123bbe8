// `swirl classify` on what is not a scene: a record of an orbit, or a measured series.
#pragma once

#include "apps/classify/classify_record.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/input/measured_series.hpp"

#include <optional>
#include <string>

namespace swirl::apps::classify {

struct ClassifyInput {
    std::string record;
    SeriesChoice series;
    double noise = 0;

    /// After the command's own --transient, --collisions, --threshold and --max-period.
    void add_to(Flags& command);

    /// The record's orbit, if a record was given, whose scene and start are set. @throws BadInput if it holds none
    std::optional<RecordedOrbit> recorded(SceneOptions& scene, StartOptions& start) const;

    /// A series, or a record without a scene. @throws BadInput if flags gave a scene, too
    bool is_series(const SceneOptions& scene, const StartOptions& start) const;

private:
    friend int classify_measured(const ClassifyInput& input, const SceneOptions& scene, const StartOptions& start,
                                 const OutputOptions& output, bool verbose);
    std::optional<Flag> transient_, collisions_, threshold_, max_period_;
};

extern const char* const classify_series_details;

///   scene, start  have --swirl-rate and --angle, if anything
///   verbose  the table has all of the evidence
/// @return the exit code
int classify_measured(const ClassifyInput& input, const SceneOptions& scene, const StartOptions& start,
                      const OutputOptions& output, bool verbose);

}  // namespace swirl::apps::classify
