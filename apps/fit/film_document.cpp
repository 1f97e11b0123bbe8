#include "apps/fit/film_document.hpp"

#include "apps/command_line/scene_options.hpp"
#include "apps/fit/left_out.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swirl::apps::fit {

namespace {

using analysis::FreeArc;
using studies::FilmImpact;

/// Where the swirl's centre is, in the columns' units.
Eigen::Vector2d origin_of(const FilmReport& report) {
    const Eigen::Vector2d& found = report.film.dish.origin;
    return report.source.zero + report.source.length * Eigen::Vector2d(found[0], report.source.mirror * found[1]);
}

/// γ of the floor with its interval at 95 %; not finite where it can't be told.
Settings drag_of(const studies::FilmFit& film) {
    const studies::FilmDrag& drag = film.drag;
    const analysis::DragFit& found = drag.with.drag;
    const double room = analysis::sure_drag * found.error;
    return {{"value", found.value},
            {"low", found.value - room},
            {"high", found.value + room},
            {"floor", std::string(name_of(drag.floor))},
            {"floor_decided", drag.floor_told()},
            {"restitution_shift", studies::unseen_drag_shift(film)}};
}

/// γ_r, likewise.
Settings spin_drag_of(const studies::FilmFit& film) {
    const analysis::DragFit& found = film.drag.with.spin;
    const double room = analysis::sure_drag * found.error;
    return {{"value", found.value}, {"low", found.value - room}, {"high", found.value + room}};
}

std::string drag_in_words(const studies::FilmFit& film) {
    const analysis::DragFit& drag = film.drag.with.drag;
    if (std::isnan(drag.value)) return "can't be told";
    const std::string words = fmt::format("{:.3g} +- {:.2g} of the velocity per 1/omega_s", drag.value, drag.error);
    if (film.arcs.drags.places == 0)
        return fmt::format("{}; arcs are straight (at the upper end of 95 % it would add some {:.1g} to e)", words,
                           studies::unseen_drag_shift(film));
    return words + (film.drag.floor == studies::Floor::dish ? ", of a floor that moves with the dish"
                                                            : ", of a table, which stands still");
}

std::string spin_drag_in_words(const studies::FilmFit& film) {
    const analysis::DragFit& drag = film.drag.with.spin;
    if (std::isnan(drag.value)) return "can't be told";
    return fmt::format("{:.3g} +- {:.2g} of the spin per 1/omega_s{}", drag.value, drag.error,
                       film.arcs.drags.angle == 0 ? "; arcs have a constant spin" : "");
}

Settings film_settings(const FilmReport& report) {
    const studies::FilmFit& film = report.film;
    const Eigen::Vector2d origin = origin_of(report);
    return {{"frames", static_cast<std::int64_t>(film.arcs.frames)},
            {"outliers", static_cast<std::int64_t>(film.arcs.outliers)},
            {"arcs", static_cast<std::int64_t>(film.arcs.arcs.size())},
            {"kinks", static_cast<std::int64_t>(film.impacts.size())},
            {"place_noise", film.arcs.place_noise},
            {"angle_noise", film.arcs.angle_noise},
            {"origin", std::vector<double>{origin[0], origin[1]}},
            {"swirl_rate", film.dish.rate * report.source.rate},
            {"swirl_phase", film.dish.phase},
            {"vertex", film.dish.mark},
            {"off_wall", film.dish.off_wall},
            {"arcs_drag", film.arcs.drags.places},
            {"arcs_spin_drag", film.arcs.drags.angle},
            {"floor_radius", film.arcs.floor.radius},
            {"floor_rate", film.arcs.floor.rate},
            {"floor_phase", film.arcs.floor.phase},
            {"alpha_on_wall", film.size ? film.size->alpha : analysis::nan},
            {"alpha_on_wall_error", film.size ? film.size->error : analysis::nan},
            {"noisier_films", static_cast<std::int64_t>(film.noisier)},
            {"restitution_shift", film.restitution_shift},
            {"friction_shift", film.friction_shift}};
}

/// Middles and velocities at the mean time as the body's, of which those of the arcs are without what a floor carries.
std::vector<FreeArc> in_laboratory(const analysis::FilmArcs& film) {
    std::vector<FreeArc> arcs = film.arcs;
    for (FreeArc& arc : arcs) {
        const Eigen::Vector3d place = film.place_on(arc, arc.mean_time),
                              velocity = film.velocity_on(arc, arc.mean_time);
        arc.middle = place, arc.velocity = velocity;
    }
    return arcs;
}

Table<FreeArc> arc_table() {
    using F = Field<FreeArc>;
    const auto of = [](Eigen::Vector3d FreeArc::*member, Eigen::Index axis) {
        return [member, axis](const FreeArc& arc) { return (arc.*member)[axis]; };
    };
    return {{"arc"},
            {F{"start", &FreeArc::start, "1/omega_s", "its first frame"},
             F{"end", &FreeArc::end, "1/omega_s", "its last frame"},
             F{"frames", [](const FreeArc& arc) { return static_cast<std::int64_t>(arc.count); }, "1", "on it"},
             F{"time", &FreeArc::mean_time, "1/omega_s", "mean of its frames"},
             F{"x", of(&FreeArc::middle, 0), "R_c", "of the centre at that time, y up"},
             F{"y", of(&FreeArc::middle, 1), "R_c", "of the centre at that time"},
             F{"angle", of(&FreeArc::middle, 2), "rad", "at that time, unwound"},
             F{"vx", of(&FreeArc::velocity, 0), "R_c omega_s", "in the laboratory, at that time"},
             F{"vy", of(&FreeArc::velocity, 1), "R_c omega_s", "in the laboratory"},
             F{"S", of(&FreeArc::velocity, 2), "1", "spin at that time"}}};
}

Table<analysis::FilmFrame> frame_table() {
    using F = Field<analysis::FilmFrame>;
    const auto of = [](Eigen::Index axis) {
        return [axis](const analysis::FilmFrame& frame) { return frame.place[axis]; };
    };
    return {{"frame"},
            {F{"time", &analysis::FilmFrame::time, "1/omega_s", "from the first one on"},
             F{"x", of(0), "R_c", "of the centre, y up; NaN: lost"}, F{"y", of(1), "R_c", "of the centre"},
             F{"angle", of(2), "rad", "as measured"}}};
}

Table<studies::SpinStep> simulated_table() {
    using F = Field<studies::SpinStep>;
    return {{"step"},
            {F{"time", &studies::SpinStep::time, "1/omega_s", "from which it is"},
             F{"S", &studies::SpinStep::spin, "1", "spin of the orbit of the scene that was found"}}};
}

Table<FilmImpact> kink_table() {
    using F = Field<FilmImpact>;
    return {
        {"kink"},
        {F{"time", [](const FilmImpact& k) { return k.kink.time; }, "1/omega_s", "where the arcs meet"},
         F{"time_error", [](const FilmImpact& k) { return k.kink.error; }, "1/omega_s", "its standard error"},
         F{"use", [](const FilmImpact& k) { return std::string(studies::names_of(k.use).name); }, "",
           "used, or why it was left out"},
         F{"gap", [](const FilmImpact& k) { return k.contact.gap; }, "R_c", "of the vertex on the wall; > 0: outside"},
         F{"next_gap", [](const FilmImpact& k) { return k.contact.next_gap; }, "R_c", "of the next vertex"},
         F{"distance", [](const FilmImpact& k) { return k.kink.distance; }, "1",
           "squared, of the arcs there, in units of its errors"}}};
}

}  // namespace

Scene<double> scene_of(const DishFilm& source, const analysis::ImpactFit& fit) {
    Scene<double> scene;
    scene.sides = source.scene.sides;
    scene.alpha = source.scene.alpha, scene.beta = source.scene.beta;
    scene.inertia_factor = source.inertia_factor;
    scene.mu = fit.friction_open ? std::max(1.0, 2 * fit.friction.low) : fit.friction.value;
    scene.restitution = fit.restitution.value;
    scene.law = law_from(fit.laws[fit.best].name);
    return scene;
}

std::vector<std::string> commands_on(const FilmOptions& options, const DishFilm& source, const studies::FilmFit& film) {
    const analysis::ImpactFit& fit = film.fit;
    const Scene<double> scene = scene_of(source, fit);
    std::string body = fmt::format("--sides {} --alpha {} --beta {}",
                                   scene.is_disk() ? "disk" : fmt::format("{}", scene.sides), scene.alpha, scene.beta);
    if (options.shape.count("inertia-factor") != 0)
        body += fmt::format(" --inertia-factor {}", options.shape.at("inertia-factor"));
    body += fmt::format(" --law {}", fit.laws[fit.best].name);
    const analysis::Drags& drags = film.arcs.drags;  // below 0 by noise alone
    if (drags.any())
        body += fmt::format(" --drag {:.5g} --spin-drag {:.5g} --floor {}", std::max(drags.places, 0.0),
                            std::max(drags.angle, 0.0), name_of(film.drag.floor));
    const double least = std::max(fit.friction.low, 1e-4);
    const double most = fit.friction_open ? scene.mu : std::max(fit.friction.high, 1.01 * least);
    const double high = fit.restitution.high, low = std::min(fit.restitution.low, 0.9999 * high);
    return {fmt::format("swirl classify {} --mu {:.5g} --restitution {:.5g}", body, scene.mu, scene.restitution),
            fmt::format("swirl sweep {} --grid mu={:.5g}:{:.5g}:5 --grid restitution={:.5g}:{:.5g}:5", body, least,
                        most, low, high)};
}

void write_json(JsonWriter& json, const FilmReport& report) {
    write_json(json, "drag", drag_of(report.film));
    write_json(json, "spin_drag", spin_drag_of(report.film));
    write_json(json, "film", film_settings(report));
    write_json(json, "kinks_left_out", counts_of(report.film));
    json.list("commands", report.commands, JsonLayout::rows);
}

void write_record(const RecordGroup& root, const FilmReport& report) {
    const RecordGroup group = root.group("film");
    write_attributes(group, film_settings(report));
    write_attributes(group.group("left_out"), counts_of(report.film));
    write_attributes(group.group("drag"), drag_of(report.film));
    write_attributes(group.group("spin_drag"), spin_drag_of(report.film));
    write_record(root.group("frames"), frame_table(), report.source.frames);
    write_record(root.group("arcs"), arc_table(), in_laboratory(report.film.arcs));
    write_record(root.group("kinks"), kink_table(), report.film.impacts);
    write_record(root.group("simulated"), simulated_table(), report.simulated);
}

void print_film(const FilmReport& report) {
    const studies::FilmFit& film = report.film;
    const Eigen::Vector2d origin = origin_of(report);
    fmt::print("{} frames{}, {} arcs, {} impacts between them\n", film.arcs.frames,
               film.arcs.outliers > 0 ? fmt::format(" ({} outliers)", film.arcs.outliers) : "", film.arcs.arcs.size(),
               film.impacts.size());
    fmt::print("  tracker         noise {:.3g} R_c of a place, {:.3g} rad of an angle\n", film.arcs.place_noise,
               film.arcs.angle_noise);
    fmt::print("  swirl           about ({:.6g}, {:.6g}), rate {:.7g} rad per unit of time\n", origin[0], origin[1],
               film.dish.rate * report.source.rate);
    fmt::print("  wall            impacts are {:.2g} R_c off it{}\n", film.dish.off_wall,
               film.size
                   ? fmt::format(", and on it best with alpha = {:.4g} +- {:.1g}", film.size->alpha, film.size->error)
                   : "");
    fmt::print("{}\n", wrapped(fmt::format("  floor's drag    {}", drag_in_words(film)), 18));
    fmt::print("  spin's drag     {}\n", spin_drag_in_words(film));
    print_used(film);
}

void print_commands(const FilmReport& report) {
    fmt::print("the scene that was found:\n");
    for (const std::string& command : report.commands) fmt::print("{}", help_in_columns("  " + command));
}

}  // namespace swirl::apps::fit
