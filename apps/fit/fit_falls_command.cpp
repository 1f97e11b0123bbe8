#include "apps/fit/fit_falls_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/fit/fit_notes.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::fit {

namespace {

using studies::FallsFitOutcome;
using studies::KinkUse;

/// Of a body with so many sides.
double side_of(const studies::BodyOnPlate& body, double radius) {
    return 2 * body.size * radius * std::sin(std::numbers::pi / body.sides);
}

std::string size_in_words(const studies::BodyOnPlate& body, double radius) {
    const double side = side_of(body, radius) / body.size;
    return fmt::format(
        "vertices lie on the plate with --side {:.4g} +- {:.1g} (--polygon-radius {:.4g}), not with {:.4g} (robust "
        "standard deviation off it {:.2g}, by noise {:.2g})",
        side_of(body, radius), side * body.error, body.size * radius, side, body.scatter * radius,
        body.expected * radius);
}

std::string shape_in_words(const studies::BodyOnPlate& shape, double radius) {
    if (shape.sides == disk_sides)
        return fmt::format("they are on one as --sides disk is, off it by {:.2g}", shape.scatter * radius);
    return fmt::format("they are on one with --sides {} --side {:.4g}, off it by {:.2g}", shape.sides,
                       side_of(shape, radius), shape.scatter * radius);
}

std::string vertex_in_words(const studies::FallsFit& falls, const studies::FallenBody& body) {
    return fmt::format("vertices are {:.3g} +- {:.1g} rad from --vertex {:.5g}; impacts show one at {:.5g}",
                       studies::mark_off(falls, body), std::sqrt(falls.unmarked->errors(1, 1)), *body.mark,
                       falls.unmarked->mark);
}

std::string another_gravity_in_words(const studies::FallsFit& falls, double given, double radius) {
    return fmt::format("free arcs tell a gravity of {:.4g} +- {:.1g} along -y, --gravity says {:.4g}",
                       radius * falls.gravity_of_arcs, radius * falls.gravity_of_arcs_error, given);
}

std::string why_no_law(const studies::FallsFit& falls) {
    using Outcome = analysis::ImpactFitOutcome;
    const std::size_t impacts = falls.count(KinkUse::used);
    if (falls.fit.outcome == Outcome::gains_energy) return risen_energy(falls.fit);
    if (falls.fit.outcome == Outcome::no_inertia || falls.fit.outcome == Outcome::inertia_absurd)
        return fmt::format(
            "{} impacts hardly change the spin, so that momentum does not tell I/m; give --inertia-factor K", impacts);
    return fmt::format("no law could be fitted to {} impacts", impacts);
}

void require_fitted(const FallsReport& report) {
    const studies::FallsFit& falls = report.falls;
    const double radius = report.source.body.radius;
    const auto count = [&](KinkUse use) { return falls.count(use); };
    const auto refuse = [&](const std::string& why) {
        throw BadInput(fmt::format("falls: {} frames on {} arcs: {}", falls.arcs.frames, falls.arcs.arcs.size(), why));
    };
    switch (falls.outcome) {
        case FallsFitOutcome::fitted:
            return;
        case FallsFitOutcome::no_gravity:
            throw BadInput(fmt::format(
                "falls: no {} stretches of {} frames or more fall alike, so that gravity can't be told; give "
                "--gravity G",
                analysis::fewest_falling, analysis::fewest_falling_frames));
        case FallsFitOutcome::falls_up:
            throw BadInput(fmt::format("falls: bodies fall towards larger y{}, by {:.4g} per time squared; {} --y-down",
                                       report.source.y_down ? " once it is turned" : "",
                                       radius * falls.fall.model.gravity[1],
                                       report.source.y_down ? "leave out" : "give"));
        case FallsFitOutcome::another_size:
            refuse(size_in_words(*falls.body, radius) + "; --side, --polygon-radius or --scale is not the films'");
            break;
        case FallsFitOutcome::another_shape:
            refuse(fmt::format("impacts are on no common straight plate with the --sides that are given{}: {}",
                               falls.body ? fmt::format(" (off it by {:.2g})", falls.body->scatter * radius) : "",
                               shape_in_words(*falls.shape, radius)));
            break;
        case FallsFitOutcome::another_gravity:
            throw BadInput(fmt::format("falls: {}; --gravity, --scale, --fps or --y-down is not the films'",
                                       another_gravity_in_words(falls, *report.source.setting.gravity, radius)));
        case FallsFitOutcome::another_mark:
            refuse(vertex_in_words(falls, report.source.body) + "; leave --vertex out, and the impacts tell it");
            break;
        case FallsFitOutcome::few_kinks:
            refuse(
                fmt::format("too few of {} frames or more meet; {} or more impacts are needed, with {} frames between "
                            "them",
                            analysis::fewest_frames, studies::fewest_kinks, analysis::fewest_frames));
            break;
        case FallsFitOutcome::no_plate:
            refuse(
                fmt::format("{} of {} impacts are on no common straight plate; one of --side, --sides, --scale, "
                            "--vertex, --gravity, --y-down is not the films'",
                            count(KinkUse::off_the_wall), falls.impacts.size()));
            break;
        case FallsFitOutcome::few_impacts:
            refuse(fmt::format(
                "{} impacts can be used, {} or more are needed; of {} kinks {} do not meet, {} are off "
                "the plate, {} have two vertices on it, {} an arc that stays on it",
                count(KinkUse::used), analysis::fewest_impacts, falls.impacts.size(), count(KinkUse::no_meeting),
                count(KinkUse::off_the_wall), count(KinkUse::two_vertices), count(KinkUse::stays_on_wall)));
            break;
        case FallsFitOutcome::no_law:
            refuse(why_no_law(falls));
            break;
    }
}

/// Momentum alone against the uniform body's I/m.
void note_inertia(std::vector<std::string>& notes, const FallsReport& report) {
    const double uniform = report.source.body.inertia;
    const analysis::FittedNumber& found = report.falls.fit.inertia;
    if (report.source.body.inertia_known || (uniform >= found.low && !(uniform > found.high))) return;
    notes.push_back(fmt::format(
        "momentum alone tells I/m = {:.4g} [{:.4g}, {:.4g}], {:.3g} times that of a uniform body of this size, {:.4g}: "
        "e and mu are those with the former; --inertia-factor gives another",
        found.value, found.low, found.high, found.value / uniform, uniform));
}

void note_size(std::vector<std::string>& notes, const FallsReport& report) {
    const studies::FallsFit& falls = report.falls;
    if (!studies::has_another_size(falls, studies::least_fallen_size_error)) return;
    notes.push_back(fmt::format("{}: {}", size_in_words(*falls.body, report.source.body.radius),
                                falls.body->is_sharp()
                                    ? "--side or --scale is not the films', and e and mu are off by some of that"
                                    : "corners may be round, or --side or --scale is not the films'"));
}

void note_given(std::vector<std::string>& notes, const FallsReport& report) {
    const studies::FallsFit& falls = report.falls;
    const studies::FallenBody& body = report.source.body;
    if (studies::has_another_gravity(falls, report.source.setting, body.radius, studies::least_gravity_error))
        notes.push_back(fmt::format("{}: e and mu are those with the latter",
                                    another_gravity_in_words(falls, *report.source.setting.gravity, body.radius)));
    if (studies::has_another_mark(falls, body, studies::least_mark_error))
        notes.push_back(fmt::format("{}: e and mu are those with the given one", vertex_in_words(falls, body)));
    if (falls.angle_turned)
        notes.push_back(
            "the angle is taken in the other sense: as it was given momentum contradicts it (it was measured "
            "clockwise, "
            "or the places are mirrored, as of a camera behind the plate)");
}

std::string files_in_words(const std::vector<std::string>& files) {
    constexpr std::size_t most = 3;
    std::vector<std::string> quoted;
    for (std::size_t i = 0; i < std::min(most, files.size()); ++i) quoted.push_back(fmt::format("'{}'", files[i]));
    return fmt::format("{}{}", fmt::join(quoted, ", "),
                       files.size() > most ? fmt::format(" and {} more", files.size() - most) : "");
}

/// Single falls that contradict the others. @throws BadInput for one that runs backwards
void note_single_falls(std::vector<std::string>& notes, const FallsReport& report,
                       const std::vector<std::string>& files) {
    std::vector<std::string> rising, elsewhere;
    std::size_t rises = 0;
    const std::vector<studies::FallEvidence> evidence = studies::evidence_of(report.falls);
    for (std::size_t k = 0; k < evidence.size(); ++k) {
        if (evidence[k].is_backward())
            throw BadInput(
                fmt::format("falls '{}': energy surely rises at all of its {} impacts, and no wall adds any: time runs "
                            "backwards in it",
                            files[k], evidence[k].used));
        rises += evidence[k].rising;
        if (evidence[k].rising > 0) rising.push_back(files[k]);
        if (evidence[k].is_elsewhere()) elsewhere.push_back(files[k]);
    }
    if (!rising.empty())
        notes.push_back(
            fmt::format("energy surely rises at {} impact{} ({}), and no wall adds any: time runs backwards "
                        "there, or errors are larger than is seen",
                        rises, rises == 1 ? "" : "s", files_in_words(rising)));
    if (!elsewhere.empty())
        notes.push_back(fmt::format(
            "no impact of {} is on the plate that the other falls show: its lengths, axes, angle or clock may "
            "not be theirs",
            files_in_words(elsewhere)));
}

void note_left_out(std::vector<std::string>& notes, const studies::FallsFit& falls) {
    const auto count = [&](KinkUse use) { return falls.counts[static_cast<std::size_t>(use)]; };
    const std::size_t twice = count(KinkUse::no_meeting) + count(KinkUse::two_vertices);
    if (twice + count(KinkUse::stays_on_wall) > 0)
        notes.push_back(
            fmt::format("{} kinks are more than one impact within a few frames, or of two vertices, and {} have "
                        "contact that lasts, "
                        "sliding or rolling, before or after them: nothing is told of these",
                        twice, count(KinkUse::stays_on_wall)));
}

}  // namespace

FitReport fit_of_falls(FilmOptions& film, const FallsOptions& options, const analysis::ImpactFitSettings& settings) {
    FallsReport falls;
    falls.source = read_falls(film, options);
    exit_when_interrupted();
    const studies::FallenBody& body = falls.source.body;
    falls.falls = studies::fit_falls(falls.source.falls, falls.source.period, body, falls.source.setting, settings);
    require_fitted(falls);
    FitReport report;
    report.fit = falls.falls.fit;
    report.inertia_given = body.inertia_known;
    report.rows = falls.falls.impacts.size();
    report.left_out = report.rows - report.fit.impacts.size();
    ImpactTable table;
    table.has_errors = true;
    report.notes = falls.source.notes;
    const std::vector<std::string> notes = notes_of(report.fit, table);
    report.notes.insert(report.notes.end(), notes.begin(), notes.end());
    note_size(report.notes, falls);
    note_inertia(report.notes, falls);
    note_given(report.notes, falls);
    note_single_falls(report.notes, falls, options.files);
    note_left_out(report.notes, falls.falls);
    report.settings = {{"columns", film.series.flags()},
                       {"resamples", static_cast<std::int64_t>(settings.resamples)},
                       {"parts", static_cast<std::int64_t>(settings.parts)},
                       {"seed", settings.seed},
                       {"inertia_factor", body.inertia / (body.radius * body.radius)},
                       {"gravity", falls.source.setting.gravity.value_or(std::nan(""))}};
    report.falls = std::move(falls);
    return report;
}

}  // namespace swirl::apps::fit
