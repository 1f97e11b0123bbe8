#include "apps/fit/fit_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/number_checks.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/fit/fit_document.hpp"
#include "apps/fit/fit_notes.hpp"
#include "apps/fit/impact_table.hpp"
#include "apps/studies/fits/impact_laws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace swirl::apps::fit {

const char* const fit_details =
    R"(A table of measured impacts, a row each: the velocity of the body's centre and its spin before and
after, and the offset from the centre to the contact. The wall lies along x, y points from it to the
body, angles are counter-clockwise; any units. Columns: vx_before vy_before spin_before vx_after
vy_after spin_after, and rx ry or n3 d3 (the contact's velocity is vy + n3 spin along y and vx + d3
spin along x); rows with flags > 0 are left out.

Momentum comes first: k dS = r_x dv_y - r_y dv_x holds whatever the law, and tells k = I/m, how well
the velocities were measured, and which sign was taken in the other sense: the fit says so and goes
on with what momentum asks for. Then e and mu of each law by total least squares with Tukey's
biweight, 95 % intervals by a bootstrap over impacts in which the law is chosen anew, or from the
profile where mu has no upper end. A law is decided if the others are worse by 2.24 standard errors.

`predicted` is the share of impacts that a fit without them predicts within the noise that momentum
shows: 95 % of an exact law with parameters known exactly; a fit's own error leaves 92 % of 100
impacts, 88 % of 30. The figure of the record (swirl plot) has the profiles, and what
single impacts ask for against their speeds.

Examples:
  swirl fit --impacts impacts.csv
  swirl fit --impacts impacts.csv --inertia 4.6e-4 --json -o fit.h5)";

void FitOptions::add_to(Flags& command) {
    add_file(command, "--impacts", impacts, "a table of measured impacts (text, a header with the columns' names)")
        ->type_name("FILE")
        .required();
    command.add_option("--inertia", inertia, "I/m in the table's units (default: what momentum tells)")->type_name("K");
    command.add_option("--resamples", resamples, "of the bootstrap (default 200)")
        ->type_name("B")
        ->transform(whole_number(20, 100'000));
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

}  // namespace

int fit(FitOptions& options) {
    options.output.require_double("fit works in double");
    analysis::ImpactFitSettings settings;
    settings.inertia = inertia_of(options);
    settings.resamples = static_cast<std::size_t>(options.resamples);
    settings.seed = options.seed;
    settings.threads = options.output.threads;
    std::optional<RecordWriter> record =
        open_record(options.output, "Law of impact from measurements", {options.impacts});
    const ImpactTable table = read_impacts(options.impacts);
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
