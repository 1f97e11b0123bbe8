#include "apps/boundaries/boundaries_command.hpp"

#include "apps/boundaries/read_planes.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::apps::boundaries {

namespace {
constexpr int default_max_period = 4;

/// With --all more lines are added where these miss curves.
int lines_each_way(const BoundariesOptions& options) {
    return options.lines.value_or(options.all ? 6 : 12);
}

}  // namespace

const char* const boundaries_details =
    R"(Follows the curves in a plane of two parameters on which cycles bifurcate: fold, flip and neimark-sacker, each once, by
pseudo-arclength on minimally augmented systems. The curves begin at the special points of branches of cycles (period <=
--max-period) along --lines lines through the plane each way (diagrams as of `swirl bifurcate`; every branch is followed,
stable or not), or at those of a record (--from: of continue, bifurcate --branches or boundaries). Along them the
coefficient of the normal form is listed (`swirl continue --help`).

--all begins at every cycle on the lines, attracting or not: all fixed points with a flight time up to --max-time, from their
two equations (`swirl describe`), and with --max-period K > 1 the cycles that a search finds at two places on each line
(`swirl orbits`; how many it missed is estimated). Lines are added beside each line that alone meets some curve, down to a
quarter of the spacing: a closed curve, or a short one, between lines may still be missed. Where the only impact of a fixed
point vanishes (vanishing-impact: at alpha + beta = 1, beyond which a body can turn without a touch, or at a flight time of
2 pi) no curve is followed. A map of modes shows attracting cycles alone, and their curves take a fraction of the time: so
--attracting is the default.

Points of codimension 2 are cusp, generalised-flip, chenciner, 1:1, 1:2, 1:3, 1:4, fold-flip, fold-neimark-sacker,
flip-neimark-sacker and double-neimark-sacker. A curve of another kind that crosses there is followed, too, and so is the
neimark-sacker curve that ends at a 1:1 or 1:2.

A curve ends for one of these reasons:
  plane          it leaves the plane
  closed         it comes back to its beginning
  1:1, 1:2       of neimark-sacker: the pair of multipliers is real from there on
  halved         the cycle becomes one of half its period
  grazing, two-vertices, stick-slip, landing
                 a border of the map (border where none of these is seen)
  not-converged  no point was found to go on with
  most-points    it has 5,000 points each way

Curves on which a cycle meets a border are followed, too, with the times of impacts as unknowns:
  grazing        a vertex touches within a flight, or the impact of one vanishes
  two-vertices   another vertex is on the wall as one strikes
  stick-slip     the contact mode of an impact changes
A curve of folds or flips that ends on a border does so in a point fold-grazing, flip-two-vertices ...; where the border
belongs to the cycle with the vanishing impact the point is called fold- or flip-vanishing-impact. The curves that begin
there are followed; at a flip also the border of the doubled cycle. Landing is not followed.

--against MAP.h5 compares with a sweep over the same two parameters. It names the attracting cycles that the curves predict
and no run came to (too-few-starts, or transient: a run has no verdict), and those that a run came to and no curve leads to
(curve-missing), after curves were sought from these, too. Members of families and cells outside the plane are not compared.

The curves solve the smooth equations of a cycle's word (which vertices strike, in which contact mode) in double and search
for no contact, so there is no other --accuracy. `swirl plot` draws the record, alone or over the record of a sweep.

Examples:
  swirl boundaries --sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.3:0.6 --plane beta=0.3:0.6 --max-period 1 --lines 2
  swirl boundaries --sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.4:0.6 --plane beta=0.2:0.4 --lines 1 -o curves.h5
  swirl boundaries --sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.4:0.5 --plane beta=0.4:0.5 --all --max-period 1 --lines 2 --max-time 3)";

void BoundariesOptions::add_to(Flags& command) {
    scene.add_to(command);
    output.add_to(command);
    command.add_option("--plane", plane, "", "NAME=A:B, twice: " + parameters_in_words(RangesOver::plain_scenes))
        ->offer(parameters_to_offer(RangesOver::plain_scenes))
        ->allow_extra_args(false);
    add_whole_number(command, "--max-period", max_period, "K", 1, 64,
                     "longest period of the cycles on lines (default 4)");
    add_whole_number(command, "--lines", lines, "L", 1, 10'000,
                     "lines through the plane each way (default 12, with --all 6)");
    command.add_flag("--all", all, "begin at all fixed points on the lines, attracting or not");
    command.add_flag("--attracting", attracting, "begin at what orbits on the lines settle on (default)");
    command.add_option("--max-time", longest, "T",
                       "longest flight time of --all fixed points, in 1/omega_s (SI units: s; default 12/omega_s)");
    add_file(command, "--from", from, "FILE.h5",
             "a record whose special points the curves begin at, in place of lines");
    add_file(command, "--against", against, "FILE.h5",
             "a sweep's record over the same plane, to be compared cell by cell");
    command.add_option("--longest-step", longest_step, "H",
                       "along a curve, in the plane's widths, 1e-6 to 1 (default 0.02)");
}

Settings settings_of(const BoundariesOptions& options, const Plane& plane) {
    Settings settings{
        {"first", plane.axes[0].name},
        {"first_low", plane.axes[0].low},
        {"first_high", plane.axes[0].high},
        {"second", plane.axes[1].name},
        {"second_low", plane.axes[1].low},
        {"second_high", plane.axes[1].high},
        {"max_period", std::int64_t{options.from.empty() ? options.max_period.value_or(default_max_period) : 0}},
        {"lines", std::int64_t{options.from.empty() ? lines_each_way(options) : 0}},
        {"longest_step", options.longest_step}};
    if (options.all) settings.push_back({"max_time", options.max_time()});
    return settings;
}

namespace {

LineOptions lines_of(const BoundariesOptions& options, std::size_t longest) {
    LineOptions lines;
    lines.lines = lines_each_way(options);
    lines.max_period = static_cast<int>(longest);
    if (options.all) lines.cycles = LineCycles::all;
    lines.max_time = options.max_time();
    lines.control = run_control(options.output);
    return lines;
}

/// Where a run of the map came to a cycle that no curve leads to, curves are sought from it, once: a narrow region may
/// lie between all lines.
Agreement search_and_compare(CurveSearch& search, const Scene<double>& scene, const Plane& plane,
                             const MappedPlane& map, const LineOptions& options) {
    Agreement first = compare(scene, plane, search.found().curves, map, options.max_period, interruption());
    const auto runs = missing_runs(first);
    if (runs.empty() || is_interrupted()) return first;
    search.follow(starting_points_of_runs(scene, plane, runs, map.starts, options));
    Agreement agreement = compare(scene, plane, search.found().curves, map, options.max_period, interruption());
    agreement.led_by_runs = first.missing_cells - std::min(agreement.missing_cells, first.missing_cells);
    return agreement;
}

/// What no combination of flags allows.
void check(const BoundariesOptions& options) {
    options.output.require_double("boundaries works in double");
    if (!(options.longest_step >= 1e-6 && options.longest_step <= 1))  // NaN passes a range of the parser
        throw BadInput(fmt::format("longest-step = {:g} is outside its range: 1e-6 to 1", options.longest_step));
    if (!options.from.empty() && (options.max_period || options.lines))
        throw BadInput(fmt::format("--{} is of diagrams along lines; --from begins at a record's points in their place",
                                   options.max_period ? "max-period" : "lines"));
    if (options.all && options.attracting) throw BadInput("--all and --attracting are both given; give one");
    if (!options.from.empty() && (options.all || options.attracting))
        throw BadInput(fmt::format("--{} is of lines; --from begins at a record's points in their place",
                                   options.all ? "all" : "attracting"));
    if (options.longest && !options.all) throw BadInput("--max-time goes with --all");
    options.max_time();
}

void print_all(const Plane& plane, const FoundCurves& found, const std::optional<Agreement>& agreement) {
    print_curves(plane, found);
    if (agreement) print_agreement(plane, *agreement);
}

}  // namespace

int boundaries(BoundariesOptions& options) {
    options.scene.read_file(options.output.quiet);
    const Plane plane = plane_from(options.plane);
    const Scene<double> scene = scene_of(options.scene, plane);
    check(options);
    std::optional<MappedPlane> map;
    if (!options.against.empty()) {
        map = mapped_plane(options.against, scene, plane);
        warn_without_checksum(options.against, options.output.quiet);
    }
    const auto on_lines = static_cast<std::size_t>(options.max_period.value_or(default_max_period));
    std::vector<StartingPoint> starting_points;
    if (!options.from.empty()) {
        starting_points = starting_points_of_record(options.from, scene, plane);
        warn_without_checksum(options.from, options.output.quiet);
    }
    std::optional<RecordWriter> record =
        open_record(options.output, "Curves of bifurcations of a swirled polygon",
                    {options.scene.file(), options.from, options.against}, options.scene.units());
    note_interruptions();
    if (options.from.empty() && !options.all)
        starting_points = starting_points_on_lines(scene, plane, lines_of(options, on_lines));
    std::size_t longest = 1;
    for (const StartingPoint& start : starting_points) longest = std::max(longest, start.points.size());
    if (options.from.empty() && (map || options.all))  // the map's runs, and later lines, have cycles not met yet
        longest = std::max(longest, on_lines);
    CurveSearch search(scene, plane, {options.longest_step, longest, run_control(options.output), options.all});
    FoundCurves found;
    if (options.all)
        found.survey = follow_all_curves(search, scene, plane, lines_of(options, on_lines));
    else
        search.follow(starting_points);
    std::optional<Agreement> agreement;
    if (map) agreement = search_and_compare(search, scene, plane, *map, lines_of(options, longest));
    found.curves = search.found();
    found.curves.whole = !is_interrupted();
    if (is_interrupted()) agreement.reset();  // of some cells only
    finish_up();
    if (record) {
        write_curves_record(*record, options, scene, plane, found);
        record->finish();
    }
    if (options.output.json)
        write_curves_document(options, scene, plane, found, agreement);
    else if (!options.output.quiet)
        print_all(plane, found, agreement);
    return is_interrupted() ? exit_interrupted : exit_done;
}

}  // namespace swirl::apps::boundaries
