#include "apps/fit/fit_film_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/fit/fit_notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::fit {

namespace {

using studies::FilmFitOutcome;
using studies::KinkUse;

/// Of a body that is near the wall in the frames themselves.
std::string sustained_contact(const studies::FilmFit& film) {
    if (!(film.frames_off_wall < studies::near_wall)) return "";
    return fmt::format(
        " (the later frames are {:.2g} R_c off the wall, with {:.3g} frames on a straight line: the "
        "body stays on the wall, or its flights are too short or low for this camera)",
        film.frames_off_wall, static_cast<double>(film.arcs.frames) / static_cast<double>(film.arcs.arcs.size()));
}

std::string size_in_words(const studies::SizeFit& size, double given) {
    return fmt::format("the body lies on the wall with alpha = {:.4g} +- {:.1g}, not with {:.4g}, which {} {:.2g} R_c",
                       size.alpha, size.error, given,
                       given < size.alpha ? "leaves it clear of the wall by" : "puts it beyond the wall by",
                       std::abs(given - size.alpha));
}

/// Of impacts that no law describes: what momentum says of kappa, if it is another.
std::string inertia_in_words(const analysis::ImpactFit& fit, double alpha) {
    if (!contradicts_momentum(fit, true)) return "";
    const double square = alpha * alpha;
    return fmt::format(
        "; momentum contradicts I/m = {:.4g}, kappa = {:.4g}: it alone gives kappa = {:.4g} [{:.4g}, {:.4g}] "
        "(--inertia-factor)",
        fit.inertia.value, fit.inertia.value / square, fit.balance.value / square, fit.balance.low / square,
        fit.balance.high / square);
}

void note_size(std::vector<std::string>& notes, const FilmReport& report) {
    if (!studies::has_another_size(report.film, report.source.scene, studies::least_size_error)) return;
    notes.push_back(fmt::format(
        "{}: its size, R_c or --scale is not the film's, and e and mu are off by several times their intervals",
        size_in_words(*report.film.size, report.source.scene.alpha)));
}

std::string floor_in_words(studies::Floor floor) {
    return floor == studies::Floor::dish ? "one that moves with the dish" : "a table, which stands still";
}

/// Of a sure drag: whether the arcs tell the floor.
void note_floor(std::vector<std::string>& notes, const studies::FilmDrag& drag, bool given) {
    const auto other = drag.floor == studies::Floor::dish ? studies::Floor::table : studies::Floor::dish;
    if (given && drag.floor_contradicted())
        notes.push_back(
            fmt::format("--floor {} is not what the film shows: its places are nearer to the arcs of {} (chi^2 is less "
                        "by {:.3g}); e and mu are those of the floor that was given",
                        name_of(drag.floor), floor_in_words(other), -drag.worse_by));
    if (given || drag.floor_told()) return;
    const analysis::DragFit& there = drag.on_the_other;
    notes.push_back(fmt::format(
        "whether the floor moves with the dish or stands still can't be told from these arcs: e and mu are those of "
        "--floor {}; on {}, the drag {}: see --floor {}",
        name_of(drag.floor), floor_in_words(other),
        std::isnan(there.value) ? "can't be told" : fmt::format("would be {:.3g} +- {:.2g}", there.value, there.error),
        name_of(other)));
}

/// A spin that decays otherwise than the floor's drag has it.
void note_spin_drag(std::vector<std::string>& notes, const analysis::DraggedArcs& found) {
    constexpr double surely = 3;  // standard errors: 1 film of 400 by noise
    const analysis::DragFit &drag = found.drag, &spin = found.spin;
    if (!(std::abs(spin.value - drag.value) > surely * std::hypot(spin.error, drag.error))) return;
    notes.push_back(
        fmt::format("the spin decays by {:.3g} +- {:.2g}, not by the floor's drag, {:.3g} +- {:.2g}: a "
                    "uniform film of fluid gives one number to both",
                    spin.value, spin.error, drag.value, drag.error));
}

void note_drag(std::vector<std::string>& notes, const studies::FilmFit& film, bool floor_given, bool floors_differ) {
    const analysis::DragFit& drag = film.drag.with.drag;
    if (std::isnan(drag.value))
        notes.push_back(
            fmt::format("the floor's drag can't be told: {} arcs between two impacts are long enough and "
                        "clear of the wall, {} are needed",
                        drag.parts, analysis::fewest_parts));
    else if (drag.value < -analysis::sure_drag * drag.error)
        notes.push_back(
            fmt::format("the body speeds up between impacts, which no floor's drag does: --beta, --scale "
                        "or the times may not be the film's"));
    note_spin_drag(notes, film.drag.with);
    if (!film.arcs.drags.any()) return;
    notes.push_back(fmt::format("{}: arcs, e and mu are those with this drag, and the commands have it",
                                film.arcs.drags.places != 0 ? "the floor drags" : "the spin decays between impacts"));
    if (film.arcs.drags.places != 0 && floors_differ) note_floor(notes, film.drag, floor_given);
}

void require_fitted(const studies::FilmFit& film, double alpha, const std::string& file) {
    const auto count = [&](KinkUse use) { return film.counts[static_cast<std::size_t>(use)]; };
    switch (film.outcome) {
        case FilmFitOutcome::fitted:
            return;
        case FilmFitOutcome::another_size:
            throw BadInput(fmt::format("series '{}': {}; its size, --container-radius or --scale is not the film's{}",
                                       file, size_in_words(*film.size, alpha), sustained_contact(film)));
        case FilmFitOutcome::few_kinks:
            throw BadInput(
                fmt::format("series '{}': {} frames on {} straight lines, of which too few of {} frames or more meet; "
                            "{} or more impacts are needed, with {} frames between them{}",
                            file, film.arcs.frames, film.arcs.arcs.size(), analysis::fewest_frames,
                            studies::fewest_kinks, analysis::fewest_frames, sustained_contact(film)));
        case FilmFitOutcome::no_wall:
            throw BadInput(
                fmt::format("series '{}': impacts are scattered by {:.2g} R_c about the wall; one of --scale, "
                            "--container-radius, --alpha, --beta, --sides, --swirl-rate (its sign), --y-down is not "
                            "the film's",
                            file, film.dish.off_wall));
        case FilmFitOutcome::few_impacts:
            throw BadInput(fmt::format(
                "series '{}': {} impacts can be used, {} or more are needed; of {} kinks {} do not meet, {} are off "
                "the wall, {} have two vertices on it, {} an arc that stays on it{}",
                file, count(KinkUse::used), analysis::fewest_impacts, film.impacts.size(), count(KinkUse::no_meeting),
                count(KinkUse::off_the_wall), count(KinkUse::two_vertices), count(KinkUse::stays_on_wall),
                sustained_contact(film)));
        case FilmFitOutcome::no_law:
            if (film.fit.outcome == analysis::ImpactFitOutcome::gains_energy)
                throw BadInput(fmt::format("series '{}': {}", file, risen_energy(film.fit)));
            throw BadInput(
                fmt::format("series '{}': to {} impacts no law could be fitted: the best predicts {:.0f} % of them, "
                            "and they scatter "
                            "about it {:.2g} times as widely as they were measured{}{}",
                            file, count(KinkUse::used), 100 * film.fit.predicted, film.fit.scatter,
                            inertia_in_words(film.fit, alpha), sustained_contact(film)));
    }
}

}  // namespace

FitReport fit_of_film(FilmOptions& options, const analysis::ImpactFitSettings& settings) {
    FitReport report;
    FilmReport film;
    film.source = read_film(options);
    exit_when_interrupted();
    const std::optional<studies::Floor> floor = options.known_floor();
    film.film = studies::fit_film(film.source.frames, film.source.period, film.source.scene,
                                  {film.source.origin, floor, film.source.least_noise}, settings);
    require_fitted(film.film, film.source.scene.alpha, options.series.file);
    film.commands = commands_on(options, film.source, film.film);
    film.simulated = studies::simulated_spin(scene_of(film.source, film.film.fit), film.film);
    report.fit = film.film.fit;
    report.inertia_given = true;
    report.rows = film.film.impacts.size();
    report.left_out = report.rows - report.fit.impacts.size();
    ImpactTable table;
    table.has_errors = true;
    report.notes = film.source.notes;
    const std::vector<std::string> notes = notes_of(report.fit, table);
    report.notes.insert(report.notes.end(), notes.begin(), notes.end());
    note_size(report.notes, film);
    note_drag(report.notes, film.film, floor.has_value(), film.source.scene.beta != 0);
    report.settings = {{"columns", options.series.flags()},
                       {"resamples", static_cast<std::int64_t>(settings.resamples)},
                       {"parts", static_cast<std::int64_t>(settings.parts)},
                       {"seed", settings.seed},
                       {"inertia_factor", film.source.inertia_factor},
                       {"floor", options.floor.empty() ? "unknown" : options.floor}};
    report.film = std::move(film);
    return report;
}

}  // namespace swirl::apps::fit
