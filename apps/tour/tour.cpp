#include "apps/tour/tour.hpp"

#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/modes/verdict_document.hpp"
#include "apps/modes/verdict_in_words.hpp"

#include <fmt/format.h>
#include <array>
#include <cstddef>
#include <optional>

namespace swirl::apps::tour {

const char* const tour_details =
    R"(Names the modes of a hexagon that is chaotic, one that is quasi-steady, one that is steady, a disk with and without friction,
and one that comes to roll on the wall (e < 1).

Example:
  swirl tour -o swirl-tour.h5)";

namespace {

struct Stop {
    const char* name;
    int sides;
    double alpha, beta, mu, restitution;
};

constexpr std::array<Stop, 6> stops = {{
    {"hexagon-chaotic", 6, 0.3, 0.1, 0.1, 1.0},
    {"hexagon-quasi-steady", 6, 0.635, 0.5, 0.5, 0.95},
    {"hexagon-steady", 6, 0.4, 0.5, 0.5, 0.9},
    {"disk-with-friction", disk_sides, 0.3, 0.1, 0.5, 1.0},
    {"disk-without-friction", disk_sides, 0.3, 0.1, 0.0, 1.0},
    {"disk-that-rolls", disk_sides, 0.4, 0.3, 0.4, 0.9},
}};

Scene<double> scene_of(const Stop& stop) {
    return validated(Scene<double>{stop.sides, stop.alpha, stop.beta, stop.mu, stop.restitution, Law::poisson,
                                   uniform_inertia_factor<double>(stop.sides)});
}

void print_stop(const TourOptions& options, const Stop& stop, const Scene<double>& scene, const NamedMode& named) {
    if (options.verbose)
        fmt::print("{}: {}\n{}\n", stop.name, scene_in_words(scene), table_of(named, true));
    else
        fmt::print("{:<22} {:<40} mean S {}  {} after {} impacts\n", stop.name, mode_in_words(named.verdict),
                   mean_in_words(named.verdict.mean, named.mean_errors), name_of(named.outcome), named.impacts);
}

}  // namespace

void TourOptions::add_to(Flags& command) {
    output.add_to(command);
    command.add_flag("--exhaustive", exhaustive,
                     "follow every orbit through 20,000 impacts, whatever its verdict needs");
    command.add_flag("--verbose", verbose, "the table lists the numbers and the evidence of each verdict")
        ->group("Output");
}

int tour(TourOptions& options) {
    const Accuracy accuracy = options.output.accuracy();
    std::optional<RecordWriter> record = open_record(options.output, "Modes of swirled polygons and disks", {});
    std::optional<JsonWriter> json;
    if (options.output.json) {
        json.emplace(document_writer());
        json->begin_object(JsonLayout::rows);
    }
    analysis::ClassifyOptions settings;
    settings.exhaustive = options.exhaustive;
    Progress progress("tour", stops.size(), options.output.quiet);
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const Scene<double> scene = scene_of(stops[i]);
        const Start<double> start = random_start(scene.beta, paper_speed, 1, 0);
        const NamedMode named = name_mode(scene, start, settings, accuracy);
        progress.at(static_cast<double>(i + 1));
        if (record) {
            const RecordGroup group = record->root().group(stops[i].name);
            write_attributes(group.group("scene"), scene_settings(scene));
            group.attribute("speed", paper_speed);
            group.attribute("seed", 1);
            write_verdict(group, named, settings);
        }
        if (json) {
            json->key(stops[i].name);
            json->begin_object();
            write_json(*json, "scene", scene_settings(scene));
            write_verdict(*json, named, settings);
            json->end_object();
        } else if (!options.output.quiet) {
            print_stop(options, stops[i], scene, named);
        }
    }
    if (json) {
        json->end_object();
        json->finish();
    }
    if (record) {
        record->finish();
        if (!options.output.quiet) report(fmt::format("record: {}", options.output.record));
    }
    return exit_done;
}

}  // namespace swirl::apps::tour
