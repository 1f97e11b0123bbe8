// `swirl boundaries`: the curves that bound modes in a plane of two parameters.
#pragma once

#include "apps/boundaries/plane_options.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/studies/bifurcation_curves/against.hpp"
#include "apps/studies/bifurcation_curves/all_curves.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::boundaries {

struct BoundariesOptions {
    SceneOptions scene;
    OutputOptions output;
    std::vector<std::string> plane;
    std::optional<int> max_period, lines;  ///< 4, and 12 or 6, unless the starting points are of a record
    bool all = false, attracting = false;  ///< which cycles on lines are followed
    std::optional<double> longest;         ///< flight time of fixed points with `all`, in the scene's units
    std::string from, against;
    double longest_step = 0.02;

    void add_to(Flags& command);
    double max_time() const { return scene.longest_flight(longest, 12, 1e4); }  ///< in 1/ω_s. @throws BadInput
};

/// The curves, and what the lines that they were sought from say of those that were missed; with --all alone.
struct FoundCurves {
    PlaneCurves curves;
    std::optional<LineSurvey> survey;
};

extern const char* const boundaries_details;

Settings settings_of(const BoundariesOptions& options, const Plane& plane);

void write_curves_document(const BoundariesOptions& options, const Scene<double>& scene, const Plane& plane,
                           const FoundCurves& found, const std::optional<Agreement>& agreement);
void write_curves_record(RecordWriter& record, const BoundariesOptions& options, const Scene<double>& scene,
                         const Plane& plane, const FoundCurves& found);
void print_curves(const Plane& plane, const FoundCurves& found);
void write_agreement(JsonWriter& json, const Plane& plane, const Agreement& agreement);
void print_agreement(const Plane& plane, const Agreement& agreement);

int boundaries(BoundariesOptions& options);

}  // namespace swirl::apps::boundaries
