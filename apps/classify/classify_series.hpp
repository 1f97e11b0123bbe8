// `swirl classify` on what is not a scene: a record, whose scene and start are followed on, or a measured series.
#pragma once

#include "apps/command_line/cli_names.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/input/measured_series.hpp"

#include <string>

namespace swirl::apps::classify {

struct ClassifyInput {
    std::string record;
    SeriesChoice series;
    std::string rows;  ///< impacts or samples; empty: samples if there are times and they are even
    double noise = 0;

    /// After the command's own --transient, --collisions, --threshold and --max-period.
    void add_to(CLI::App& command);

    /// Takes scene and start from the record, if one was given. @throws BadInput if it holds no orbit
    void take_record(SceneOptions& scene, StartOptions& start, bool quiet) const;

    /// A series, or a record without a scene. @throws BadInput if flags gave a scene, too
    bool is_series(const SceneOptions& scene, const StartOptions& start) const;

private:
    friend int classify_measured(const ClassifyInput& input, const OutputOptions& output);
    CLI::Option *transient_ = nullptr, *collisions_ = nullptr, *threshold_ = nullptr, *max_period_ = nullptr;
};

extern const char* const classify_series_details;

/// @return the exit code
int classify_measured(const ClassifyInput& input, const OutputOptions& output);

}  // namespace swirl::apps::classify
