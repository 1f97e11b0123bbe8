#include "apps/fit/fit_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/fit/fit_document.hpp"
#include "apps/fit/fit_falls_command.hpp"
#include "apps/fit/fit_film_command.hpp"
#include "apps/fit/fit_notes.hpp"
#include "apps/fit/impact_table.hpp"
#include "apps/studies/fits/impact_laws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::fit {

const char* const fit_details =
    R"(A table of measured impacts (--impacts), a film of the body in the dish (--series), or films of falls on a
straight plate (--falls).

A table has a row an impact: the velocity of the body's centre and its spin before and after, and the
offset from the centre to the contact. The wall lies along x, y points from it to the body, angles
are counter-clockwise; any units. Columns: vx_before vy_before spin_before vx_after vy_after
spin_after, and rx ry or n3 d3 (the contact's velocity is vy + n3 spin along y and vx + d3 spin along
x); rows with flags > 0 are left out. With the columns velocity_error_before spin_error_before
velocity_error_after spin_error_after each impact weighs by its own errors.

A film is read as by `classify --series`: --position X Y, the body's centre in the laboratory, and
its angle by --angle or --marks (whose first point is the centre where no --position says another).
The body's shape, R_c and the swirl's radius and rate say where the wall is; phase and centre of the
swirl, and how the angle's mark lies to a vertex, are fitted to the impacts. Straight lines of
constant spin are fitted between kinks; a kink is an impact if its lines meet on the wall at one
vertex and leave the wall: the others are left out, and counted. I/m is the shape's (--inertia-factor
where it is no uniform lamina), and a note says if momentum contradicts it. Three films with as much
noise again are fitted, too: what that does to e and mu is in their intervals. At the end stand the
commands that classify the scene found, and sweep over the uncertainty of e and mu.

A floor may drag (`drag`, of the velocity per 1/omega_s): it moves with the dish, or stands still under
a ring that is moved about (--floor table); the places tell which, if they can, and a note says where a
--floor that is given is not the one. The spin's own decay (`spin_drag`) is by the angle alone. Where the
drag is surely above 0, arcs bend by both, and e and mu are those with them; else arcs are straight. The
impacts also tell the body's alpha: a note says where it is surely another than the given one, by 0.001
or more, and from 0.01 on, or where nothing can be fitted, the film is refused, since 1 % in alpha moves
e by 0.03.

Falls are films of one body that falls on a plate, a file each, with the same flags for their columns and
the body's size (--side L, or --polygon-radius R). Arcs are parabolas of one gravity (--gravity G, or what
they tell), slowed by a drag where that is sure; kinks at which one vertex is on the plate are impacts. The
plate's height and tilt and the vertex' mark are fitted to them, and I/m is what momentum tells beside that of
a uniform body, unless --inertia-factor gives it. Where arcs bend by more than noise they are divided more
coarsely, and velocities are those of their ends. Resamples draw falls. Parts of the falls are fitted apart.
Double impacts and contact that lasts are left out. Clear impacts also tell the body's size and sides: where they are
surely others than the given ones, a note says so, or the falls are refused; so it is with --gravity, --vertex, the
angle's sense and the direction of time. Files with the same rows, or that fall otherwise than the others, are refused.

Momentum comes first: k dS = r_x dv_y - r_y dv_x holds whatever the law, and tells k = I/m, how well
the velocities were measured, and which sign was taken in the other sense: the fit says so and goes
on with what momentum asks for. Then e and mu of each law by total least squares with Tukey's
biweight, 95 % intervals by a bootstrap over impacts in which the law is chosen anew, or from the
profile where mu has no upper end. A law is decided if the others are worse by 2.24 standard errors.

`predicted` is the share of impacts that a fit without them predicts within the noise that momentum
shows: 95 % of an exact law with parameters known exactly; a fit's own error leaves 92 % of 100
impacts, 88 % of 30. The figure of the record (swirl plot) has the profiles, and what
single impacts ask for against their speeds.

With a table of your own, impacts.csv: `swirl fit --impacts impacts.csv`, with `--inertia 4.6e-4` where I/m was measured. With
films of falls: `swirl fit --falls fall*.csv --position x y --angle theta --fps 250 --sides 4 --side 0.06`. The examples make the
film that they fit.

Examples:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.2 --restitution 0.7 --speed 1 --time 300 --camera 5 --noise 0.002 -o film.csv
  swirl fit --series film.csv --marks x y mark_x mark_y --sides 6 --alpha 0.4 --beta 0.5
  swirl fit --series film.csv --marks x y mark_x mark_y --sides 6 --alpha 0.398 --beta 0.5 --floor table)";

void FitOptions::add_to(Flags& command) {
    add_file(command, "--impacts", impacts, "FILE",
             "a table of measured impacts (text, a header with the columns' names)");
    film.add_to(command);
    falls.add_to(command);
    command.add_option("--inertia", inertia, "K", "I/m in the units of --impacts (default: what momentum tells)");
    add_whole_number(command, "--resamples", resamples, "B", 20, 100'000, "of the bootstrap (default 200)");
    add_seed(command, seed, "of the bootstrap and of the parts that are held out (default 1)");
    output.add_to(command);
}

namespace {

std::optional<double> inertia_of(const FitOptions& options) {
    if (options.inertia.empty()) return std::nullopt;
    const double k = number_from<double>("inertia", options.inertia);
    if (!(k > 0) || !std::isfinite(k))
        throw BadInput(fmt::format("inertia = {} is outside its range: inertia > 0, finite", options.inertia));
    return k;
}

/// One sentence on each ending that is none of a fit. @throws BadInput where the table is at fault
void require_fitted(const analysis::ImpactFit& fit, const FitOptions& options) {
    using Outcome = analysis::ImpactFitOutcome;
    const auto refuse = [&](const std::string& why) {
        throw BadInput(fmt::format("impacts '{}': {}", options.impacts, why));
    };
    switch (fit.outcome) {
        case Outcome::fitted:
            return;
        case Outcome::no_offsets:
            refuse("the offset from the centre to the contact is 0 at most of them, and an impact there turns nothing");
            break;
        case Outcome::no_inertia:
            refuse("the spin hardly changes, so that momentum does not tell I/m; give --inertia K");
            break;
        case Outcome::receding:
            refuse(
                "most contacts move away from the wall before the impact; y is to point from the wall to the body, "
                "vy_before + rx spin_before < 0");
            break;
        case Outcome::gains_energy:
            refuse(risen_energy(fit));
            break;
        case Outcome::inertia_absurd: {
            const double square = fit.length * fit.length;
            if (options.inertia.empty())
                refuse(
                    fmt::format("momentum makes I/m {:.3g}, where contacts are some {:.3g} from the centre: it does "
                                "not hold for this table",
                                fit.inertia.value, fit.length));
            throw BadInput(
                fmt::format("inertia = {} is outside its range: {:.3g} to {:.3g}, 1e-6 to 1e6 times the "
                            "square of the contacts' offset",
                            options.inertia, 1e-6 * square, 1e6 * square));
        }
        case Outcome::not_fitted:
            refuse("no law describes them: their distance from each is beyond the numbers");
            break;
    }
}

FitReport fit_of_table(const FitOptions& options, analysis::ImpactFitSettings& settings) {
    const ImpactTable table = read_impacts(options.impacts);
    settings.stated_errors = table.has_errors;
    exit_when_interrupted();
    FitReport report;
    report.fit = analysis::fit_impacts(table.impacts, studies::impact_laws(), settings);
    require_fitted(report.fit, options);
    report.rows = table.rows;
    report.inertia_given = settings.inertia.has_value();
    report.left_out = table.flagged + table.missing + report.fit.left_out;
    report.notes = notes_of(report.fit, table);
    report.settings = {{"resamples", options.resamples},
                       {"parts", static_cast<std::int64_t>(settings.parts)},
                       {"seed", options.seed},
                       {"inertia", settings.inertia.value_or(std::nan(""))}};
    return report;
}

void require_one_input(const FitOptions& options) {
    const bool of_film = options.film.given(), of_falls = options.falls.given(), of_table = !options.impacts.empty();
    if (of_film + of_falls + of_table > 1)
        throw BadInput(of_falls ? "--falls and --impacts or --series are both given; give one"
                                : "--impacts and --series are both given; give one");
    if (!of_table && !options.inertia.empty() && (of_film || of_falls))
        throw BadInput("--inertia is a table's; of a film --inertia-factor says it");
    if (!of_film && !of_falls && !of_table)
        throw BadInput("nothing to fit: give --impacts FILE, or a film by --series FILE, or --falls FILE...");
    if (of_table) options.film.require_none();
    if (!of_falls) options.falls.require_none();
}

FitReport report_of(FitOptions& options, analysis::ImpactFitSettings& settings) {
    if (options.falls.given()) return fit_of_falls(options.film, options.falls, settings);
    return options.film.given() ? fit_of_film(options.film, settings) : fit_of_table(options, settings);
}

}  // namespace

int fit(FitOptions& options) {
    options.output.require_double("fit works in double");
    require_one_input(options);
    if (!options.output.quiet) tell_interruption();
    analysis::ImpactFitSettings settings;
    settings.inertia = inertia_of(options);
    settings.resamples = static_cast<std::size_t>(options.resamples);
    settings.seed = options.seed;
    settings.threads = options.output.threads;
    std::vector<std::string> inputs = options.falls.files;
    inputs.insert(inputs.end(), {options.impacts, options.film.series.file});
    std::optional<RecordWriter> record = open_record(options.output, "Law of impact from measurements", inputs);
    const FitReport report = report_of(options, settings);
    if (record) {
        write_record(record->root(), report);
        record->finish();
    }
    if (options.output.json)
        write_json(report);
    else if (!options.output.quiet)
        print_report(report);
    return exit_done;
}

}  // namespace swirl::apps::fit
