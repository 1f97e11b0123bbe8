// What `swirl fit --falls` writes of the falls: arcs, gravity, plate, kinks, and parts of the impacts.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/fit/fallen_bodies.hpp"
#include "apps/record/record_writer.hpp"

#include <string>
#include <vector>

namespace swirl::apps::fit {

struct FallsReport {
    FallenBodies source;
    studies::FallsFit falls;
};

void write_json(JsonWriter& json, const FallsReport& report);
void write_record(const RecordGroup& root, const FallsReport& report);
void print_falls(const FallsReport& report);
void print_subsets(const FallsReport& report);

}  // namespace swirl::apps::fit
