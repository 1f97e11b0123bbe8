#include "apps/fit/falls_document.hpp"

#include "apps/fit/left_out.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

namespace swirl::apps::fit {

namespace {

using studies::FilmImpact;
using studies::SubsetFit;

/// In the table's lengths.
Eigen::Vector2d gravity_of(const FallsReport& report) {
    return report.source.body.radius * report.falls.arcs.fall.gravity;
}

/// R_p over the given one, at 95 %.
analysis::FittedNumber size_on_plate(const studies::FallsFit& falls) {
    if (!falls.body) return {};
    const double room = 1.96 * falls.body->error;
    return {falls.body->size, falls.body->size - room, falls.body->size + room};
}

Settings falls_settings(const FallsReport& report) {
    const studies::FallsFit& falls = report.falls;
    const double radius = report.source.body.radius;
    const Eigen::Vector2d gravity = gravity_of(report), error = radius * falls.fall.error;
    const analysis::FittedNumber size = size_on_plate(falls);
    return {{"falls", static_cast<std::int64_t>(report.source.falls.size())},
            {"frames", static_cast<std::int64_t>(falls.arcs.frames)},
            {"outliers", static_cast<std::int64_t>(falls.arcs.outliers)},
            {"arcs", static_cast<std::int64_t>(falls.arcs.arcs.size())},
            {"kinks", static_cast<std::int64_t>(falls.impacts.size())},
            {"place_noise", radius * falls.arcs.place_noise},
            {"angle_noise", falls.arcs.angle_noise},
            {"unmodelled_acceleration", radius * falls.arcs.wandering[0]},
            {"unmodelled_spin_acceleration", falls.arcs.wandering[2]},
            {"gravity", std::vector<double>{gravity[0], gravity[1]}},
            {"gravity_error", std::vector<double>{error[0], error[1]}},
            {"gravity_of_arcs", radius * falls.gravity_of_arcs},
            {"drag", falls.fall.drag.value},
            {"drag_error", falls.fall.drag.error},
            {"spin_drag", falls.fall.spin.value},
            {"spin_drag_error", falls.fall.spin.error},
            {"arcs_drag", falls.fall.model.drags.places},
            {"arcs_spin_drag", falls.fall.model.drags.angle},
            {"division", falls.division},
            {"impact_time", falls.arcs.impact_time},
            {"plate_height", radius * falls.plate_height()},
            {"plate_tilt", falls.plate.tilt},
            {"vertex", falls.plate.mark},
            {"vertex_of_impacts", falls.unmarked ? falls.unmarked->mark : falls.plate.mark},
            {"angle_turned", falls.angle_turned},
            {"off_plate", radius * falls.plate.off_plate},
            {"polygon_radius", radius},
            {"radius_on_plate", radius * size.value},
            {"radius_on_plate_low", radius * size.low},
            {"radius_on_plate_high", radius * size.high},
            {"resampled", falls.by_falls ? "falls" : "impacts"},
            {"predicted_in_scatter", falls.predicted_in_scatter},
            {"noisier_films", static_cast<std::int64_t>(falls.noisier)},
            {"restitution_shift", falls.restitution_shift},
            {"friction_shift", falls.friction_shift}};
}

Table<SubsetFit> subset_table() {
    using F = Field<SubsetFit>;
    const auto of = [](analysis::FittedNumber SubsetFit::*number, double analysis::FittedNumber::*end) {
        return [number, end](const SubsetFit& subset) { return subset.*number.*end; };
    };
    using N = analysis::FittedNumber;
    return {
        {"subset"},
        {F{"part", &SubsetFit::name, "", "of the impacts"}.coordinate().shown("  part", "  {:<14}"),
         F{"falls", [](const SubsetFit& s) { return static_cast<std::int64_t>(s.falls); }, "1", "it has"}.shown(
             "falls", " {:>5}"),
         F{"impacts", [](const SubsetFit& s) { return static_cast<std::int64_t>(s.impacts); }, "1", "it has"}.shown(
             "impacts", " {:>7}"),
         F{"restitution", of(&SubsetFit::restitution, &N::value), "1", "e; NaN: fewer than 8 impacts"}.shown(
             "e", " {:>7.4f}"),
         F{"restitution_low", of(&SubsetFit::restitution, &N::low), "1", "of its interval at 95 %"}.shown("from",
                                                                                                          " {:>7.4f}"),
         F{"restitution_high", of(&SubsetFit::restitution, &N::high), "1", "of its interval"}.shown("to", " {:>7.4f}"),
         F{"friction", of(&SubsetFit::friction, &N::value), "1", "mu; NaN: it has no upper end"}.shown("mu",
                                                                                                       " {:>7.4f}"),
         F{"friction_low", of(&SubsetFit::friction, &N::low), "1", "of its interval at 95 %"}.shown("from",
                                                                                                    " {:>7.4f}"),
         F{"friction_high", of(&SubsetFit::friction, &N::high), "1", "of its interval"}.shown("to", " {:>7.4f}")}};
}

struct FallFrame {
    std::size_t fall;
    analysis::FilmFrame frame;
};

Table<FallFrame> fall_frame_table() {
    using F = Field<FallFrame>;
    const auto of = [](Eigen::Index axis) {
        return [axis](const FallFrame& frame) { return frame.frame.place[axis]; };
    };
    return {{"frame"},
            {F{"fall", [](const FallFrame& f) { return static_cast<std::int64_t>(f.fall); }, "1", "number of its file"},
             F{"time", [](const FallFrame& f) { return f.frame.time; }, "1", "from its first frame on"},
             F{"x", of(0), "1", "of the centre, y up; NaN: lost"}, F{"y", of(1), "1", "of the centre"},
             F{"angle", of(2), "rad", "as measured"}}};
}

struct FallKink {
    std::size_t fall;
    double start;
    Eigen::Vector3d place;
    double radius;
    FilmImpact found;
};

Table<FallKink> fall_kink_table() {
    using F = Field<FallKink>;
    return {{"kink"},
            {F{"fall", [](const FallKink& k) { return static_cast<std::int64_t>(k.fall); }, "1", "number of its file"},
             F{"time", [](const FallKink& k) { return k.found.kink.time - k.start; }, "1", "where the arcs meet"},
             F{"time_error", [](const FallKink& k) { return k.found.kink.error; }, "1", "its standard error"},
             F{"x", [](const FallKink& k) { return k.place[0]; }, "1", "of the centre there"},
             F{"y", [](const FallKink& k) { return k.place[1]; }, "1", "of the centre there"},
             F{"angle", [](const FallKink& k) { return k.place[2]; }, "rad", "there"},
             F{"use", [](const FallKink& k) { return std::string(studies::names_of(k.found.use).name); }, "",
               "used, or why it was left out; the wall is the plate"},
             F{"gap", [](const FallKink& k) { return k.radius * k.found.contact.gap; }, "1",
               "of the vertex on the plate; > 0: beyond it"},
             F{"next_gap", [](const FallKink& k) { return k.radius * k.found.contact.next_gap; }, "1",
               "of the next vertex"},
             F{"distance", [](const FallKink& k) { return k.found.kink.distance; }, "1",
               "squared, of the arcs there, in units of its errors"}}};
}

/// A free arc by what the body does at the middle of it: parabolas, or what a drag makes of them, follow from that.
struct FallArc {
    std::size_t fall;
    double start, end, time;
    Eigen::Vector3d place, velocity;
};

Table<FallArc> fall_arc_table() {
    using F = Field<FallArc>;
    const auto of = [](Eigen::Vector3d FallArc::*numbers, Eigen::Index axis) {
        return [numbers, axis](const FallArc& arc) { return (arc.*numbers)[axis]; };
    };
    return {
        {"arc"},
        {F{"fall", [](const FallArc& a) { return static_cast<std::int64_t>(a.fall); }, "1", "number of its file"},
         F{"start", &FallArc::start, "1", "of its first frame, from the fall's first on"},
         F{"end", &FallArc::end, "1", "of its last one"}, F{"time", &FallArc::time, "1", "the mean of its frames'"},
         F{"x", of(&FallArc::place, 0), "1", "of the centre then"}, F{"y", of(&FallArc::place, 1), "1", ""},
         F{"angle", of(&FallArc::place, 2), "rad", ""}, F{"vx", of(&FallArc::velocity, 0), "1", "of the centre then"},
         F{"vy", of(&FallArc::velocity, 1), "1", ""}, F{"S", of(&FallArc::velocity, 2), "1", "spin then"}}};
}

/// In the table's lengths and axes.
Eigen::Vector3d place_of(const FallsReport& report, Eigen::Vector3d place) {
    place.head<2>() = report.source.body.radius * (place.head<2>() + report.falls.origin);
    return place;
}

/// In the order of the files; those of one file are in the order of time already.
template <class Row>
std::vector<Row> by_file(std::vector<Row> rows) {
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.fall < b.fall; });
    return rows;
}

std::vector<FallArc> arcs_of(const FallsReport& report) {
    const studies::FallsFit& falls = report.falls;
    const double radius = report.source.body.radius;
    const Eigen::Vector3d units(radius, radius, 1);
    std::vector<FallArc> arcs;
    for (const analysis::FreeArc& arc : falls.arcs.arcs) {
        const std::size_t fall = falls.fall_at(arc.mean_time);
        const double start = falls.starts[fall];
        arcs.push_back({fall, arc.start - start, arc.end - start, arc.mean_time - start,
                        place_of(report, falls.arcs.place_on(arc, arc.mean_time)),
                        units.cwiseProduct(falls.arcs.velocity_on(arc, arc.mean_time))});
    }
    return by_file(std::move(arcs));
}

std::vector<FallKink> kinks_of(const FallsReport& report) {
    std::vector<FallKink> kinks;
    for (const FilmImpact& found : report.falls.impacts) {
        const std::size_t fall = report.falls.fall_at(found.kink.time);
        kinks.push_back(
            {fall, report.falls.starts[fall], place_of(report, found.kink.place), report.source.body.radius, found});
    }
    return by_file(std::move(kinks));
}

std::vector<FallFrame> frames_of(const FallsReport& report) {
    std::vector<FallFrame> frames;
    for (std::size_t fall = 0; fall < report.source.falls.size(); ++fall)
        for (const analysis::FilmFrame& frame : report.source.falls[fall]) frames.push_back({fall, frame});
    return frames;
}

std::string gravity_in_words(const FallsReport& report) {
    const Eigen::Vector2d gravity = gravity_of(report);
    constexpr double degrees = 180 / std::numbers::pi;
    if (report.source.setting.gravity) return fmt::format("{:.5g} given", gravity.norm());
    return fmt::format("{:.5g} +- {:.2g} by {} free arcs, {:.2g} degrees off -y", gravity.norm(),
                       report.source.body.radius * report.falls.fall.error[1], report.falls.fall.arcs,
                       degrees * std::abs(std::atan2(gravity[0], -gravity[1])));
}

std::string drag_in_words(const analysis::DragFit& drag) {
    if (std::isnan(drag.value)) return "can't be told";
    return fmt::format("{:.3g} +- {:.2g}{}", drag.value, drag.error, drag.surely_drags() ? "" : ", as if 0");
}

}  // namespace

void write_json(JsonWriter& json, const FallsReport& report) {
    write_json(json, "falls", falls_settings(report));
    write_json(json, "kinks_left_out", counts_of(report.falls));
    write_json(json, "subsets", subset_table(), report.falls.subsets);
}

void write_record(const RecordGroup& root, const FallsReport& report) {
    const RecordGroup group = root.group("falls");
    write_attributes(group, falls_settings(report));
    write_attributes(group.group("left_out"), counts_of(report.falls));
    write_record(root.group("frames"), fall_frame_table(), frames_of(report));
    write_record(root.group("arcs"), fall_arc_table(), arcs_of(report));
    write_record(root.group("kinks"), fall_kink_table(), kinks_of(report));
    write_record(root.group("subsets"), subset_table(), report.falls.subsets);
}

void print_falls(const FallsReport& report) {
    const studies::FallsFit& falls = report.falls;
    const double radius = report.source.body.radius;
    fmt::print("{} falls, {} frames{}, {} arcs, {} impacts between them\n", report.source.falls.size(),
               falls.arcs.frames, falls.arcs.outliers > 0 ? fmt::format(" ({} outliers)", falls.arcs.outliers) : "",
               falls.arcs.arcs.size(), falls.impacts.size());
    fmt::print("  tracker         noise {:.3g} of a place, {:.3g} rad of an angle\n", radius * falls.arcs.place_noise,
               falls.arcs.angle_noise);
    fmt::print("  gravity         {}\n", gravity_in_words(report));
    fmt::print("  drag            {} of the velocity per unit of time; of the spin {}\n",
               drag_in_words(falls.fall.drag), drag_in_words(falls.fall.spin));
    fmt::print("  plate           at y = {:.4g} + {:.3g} x; vertices are {:.2g} off it at impacts\n",
               radius * falls.plate_height() / std::cos(falls.plate.tilt), std::tan(falls.plate.tilt),
               radius * falls.plate.off_plate);
    if (falls.body) {
        const analysis::FittedNumber size = size_on_plate(falls);
        fmt::print("  polygon radius  {:.4g} given; by clear impacts {:.4g} [{:.4g}, {:.4g}]\n", radius,
                   radius * size.value, radius * size.low, radius * size.high);
    }
    print_used(falls);
}

void print_subsets(const FallsReport& report) {
    fmt::print("{:.1f} % of held-out impacts lie within the scatter of the impacts about the law\n",
               100 * report.falls.predicted_in_scatter);
    if (report.falls.subsets.empty()) return;
    fmt::print("parts of the impacts, intervals at 95 % (resamples draw {}):\n",
               report.falls.by_falls ? "falls" : "impacts");
    print_table(subset_table(), report.falls.subsets);
}

}  // namespace swirl::apps::fit
