// `swirl boundaries`: the curves that bound modes in a plane of two parameters.
#pragma once

#include "apps/boundaries/plane_options.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/studies/bifurcation_curves/against.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::boundaries {

struct BoundariesOptions {
    SceneOptions scene;
    OutputOptions output;
    std::vector<std::string> plane;
    std::optional<int> max_period, lines;  ///< 4 and 12 unless the starting points are of a record
    std::string from, against;
    double longest_step = 0.02;

    void add_to(Flags& command);
};

extern const char* const boundaries_details;

Settings settings_of(const BoundariesOptions& options, const Plane& plane);

void write_curves_document(const BoundariesOptions& options, const Scene<double>& scene, const Plane& plane,
                           const PlaneCurves& found, const std::optional<Agreement>& agreement);
void write_curves_record(RecordWriter& record, const BoundariesOptions& options, const Scene<double>& scene,
                         const Plane& plane, const PlaneCurves& found);
void print_curves(const Plane& plane, const PlaneCurves& found);
void write_agreement(JsonWriter& json, const Plane& plane, const Agreement& agreement);
void print_agreement(const Plane& plane, const Agreement& agreement);

int boundaries(BoundariesOptions& options);

}  // namespace swirl::apps::boundaries
