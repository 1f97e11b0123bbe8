#include "apps/certify/certify_command.hpp"

#include "apps/certify/certificate_file.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/modes/verdict_in_words.hpp"
#include "apps/orbits/recorded_cycles.hpp"
#include "apps/studies/cycles/near_orbit.hpp"
#include "apps/studies/modes/followed_orbit.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/orbit/orbit.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace swirl::apps::certify {

const char* const certify_details =
    R"(Proves cycles by interval arithmetic: an explicit box holds exactly one cycle with this word, no vertex touches earlier on
any of its flights, every impact is in its contact mode, the period is the smallest, and each multiplier lies in a disc.
What is not proven says which inequality failed and by how much.
  stability  attracting, saddle or repelling, as the discs prove it; neutral: a family (one multiplier is
             exactly 1, the others inside), whose member has the S or flight time under phase; undecided:
             a disc meets the unit circle
  radius     the largest half-width of the box
The scene's numbers are decimals, 0.4 is 4/10; a point's and a box's are the doubles that are shown.

The cycles are those of a record of orbits, classify, describe, continue or bifurcate (--orbit I: row I alone, as `swirl
show` numbers them), the one near a point (--near, --period), or what the start settles on (--from attractor; exit code 3 if
that is no cycle). --all proves all fixed points with a flight time up to --max-time and that there are no others, and
lists what it cannot decide.

--plane NAME=A:B --plane NAME=C:D cuts a plane of two parameters into cells on which the number of fixed points with a flight
time up to --max-time, and how many multipliers of each lie outside the unit circle, are proven to be the same for all
parameters. What is not proven is halved, down to --resolution: a cover of the curves on which fixed points appear, end or
change their stability. The table has the proven share of the plane by the number of halvings, with seconds of cores, then
by the number of fixed points and of attracting ones; doubt names what is not certain of a cell (equations, longest-flight,
contact-mode, clearance, stability). A polygon, mu > 0,
beta > 0, restitution < 1. `swirl plot` draws the record.

--along NAME=A:B follows the branch of each of the cycles along alpha, beta, mu, restitution or inertia-factor, in boxes that
overlap: for every value in a box there is one cycle of the branch, with the same word and period, and as many multipliers
outside the unit circle. It goes on through folds, and ends where the range does, or an impact leaves its contact mode, or
another vertex touches: which, and between which two values. Between boxes of different stability a fold, flip or
Neimark-Sacker point is enclosed and proven to be quadratic, or crossed with a speed that is not 0. RECORD --branches covers the
branches of a record of continue or bifurcate so, over the range that was asked for, and says which share of their length is
proven. No families (a disk, or no friction, at restitution = 1).

--chaos takes parallelepipeds on the section about the points of the cycles with one multiplier outside the unit circle, and
about those of orbits that lead from one to another in --link-length impacts or fewer, and proves that F carries each over
the next, stretched across it in one direction and squeezed into it in the others. Then every path from set to set is some
orbit's, and the paths' entropy is a lower bound of the map's. Beside it stands the largest Lyapunov exponent, a number
without proof. Of a disk without friction --near says the level of J, too. Exit code 3 if no entropy > 0 is proven. `swirl
plot` draws the record: where the sets are, and how they are carried over one of them.

The document is the certificate. --check proves it again from its numbers alone, by other equations; that --all found all
fixed points is not part of that. Of chaos it proves what sets and coverings say (with vertex_step and contact_mode), that
the sets over which one is carried have no common point, growth and entropy; it does not look at exponent, cycles (their
multiplier, too), connections, pieces and settings, and begins at flight_time and image whatever they are.

The exit code is 0 if all is proven (--all: and complete), 3 if some is not. With --check it is 3 if what is stated could
not be proven, 2 if the file is no certificate or was changed after it was written.

Examples:
  swirl certify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --near=-0.084,0.028,-0.554,0.89,-0.979
  swirl certify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --all --period 1 --max-time 12
  swirl certify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --all --max-time 2 --along alpha=0.38:0.42
  swirl certify --sides disk --alpha 0.3 --beta 0.5 --mu 0 --restitution 1 --near=3.1415927,-0.144,0.048,0 --chaos
  swirl certify --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --near=3.1416,0,-0.127,0,-1.667 --chaos
  swirl certify --sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.3:0.31 --plane beta=0.5:0.51 --max-time 2)";

void CertifyOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command, false);
    add_file(command, "record", record, "RECORD.h5", "a record that holds cycles, with their scene");
    add_whole_number(command, "--orbit", orbit, "I", 1, most_impacts,
                     "which of the record's cycles, from 1 (default all)");
    command.add_option("--from", from, "", "attractor: the cycle that the start settles on")->offer({"attractor"});
    command.add_option("--near", near, "", "psi,chi,vn,vt,S: the cycle near this point (a disk drops chi)");
    add_whole_number(command, "--period", its_period, "K", 1, 256, "of that cycle (default 1)");
    command.add_flag("--all", all, "all fixed points, with proof that there are no others");
    command.add_option("--max-time", longest, "T",
                       "longest flight time, in 1/omega_s (SI units: s; default 12/omega_s, of --plane 6/omega_s)");
    command.add_option("--along", along, "", "NAME=A:B: the branches of these cycles, proven along a parameter")
        ->offer(parameters_to_offer(RangesOver::plain_scenes));
    command.add_flag("--branches", branches, "the branches of the RECORD, along its parameter");
    command.add_flag("--chaos", chaos,
                     "sets about these cycles that the map carries over each other: a proven entropy");
    add_whole_number(command, "--link-length", link_length, "K", 2, 40,
                     "of --chaos: most impacts of an orbit from cycle to cycle (default 12)");
    command.add_option("--plane", plane, "", "NAME=A:B, twice: " + parameters_in_words(RangesOver::plain_scenes))
        ->offer(parameters_to_offer(RangesOver::plain_scenes))
        ->allow_extra_args(false);
    command.add_option("--resolution", resolution, "R",
                       "no cell of --plane is halved below this share of the plane's sides (default 1/256)");
    add_file(command, "--check", check, "CERT.json", "prove a certificate again");
    add_file(command, "-o,--output", certificate, "CERT.json",
             "write the document, a certificate, to a file; of --plane and --chaos a record unless it ends in .json")
        ->group("Output");
    command.add_flag("--force", output.force, "replace an existing file that is no certificate")->group("Output");
}

namespace {

void require_one_input(const CertifyOptions& options) {
    options.output.require_double("certify works in interval arithmetic");
    const int given = (options.record.empty() ? 0 : 1) + (options.near.empty() ? 0 : 1) + (options.all ? 1 : 0) +
                      (options.check.empty() ? 0 : 1) + (options.from.empty() ? 0 : 1) +
                      (options.plane.empty() ? 0 : 1);
    if (given != 1)
        throw BadInput(
            "give one of: a RECORD, --near psi,chi,vn,vt,S, --from attractor, --all, --plane, --check CERT.json");
    if (!options.from.empty() && options.from != "attractor")
        throw BadInput(fmt::format("from = {} is not known: attractor (of a point: --near)", options.from));
    if (options.start.given() && options.from.empty())
        throw BadInput("a start is given; it goes with --from attractor");
    if (options.orbit && !options.check.empty())
        throw BadInput("--orbit and --check are both given: all cycles of a certificate are proven again");
    if (options.orbit && options.record.empty()) throw BadInput("--orbit goes with a RECORD, whose cycles it numbers");
    const bool scene_is_there = !options.record.empty() || !options.check.empty();
    if (scene_is_there && options.scene.given())
        throw BadInput("a scene is given, but the record or certificate has its own; leave one out");
    if (options.all && options.period() != 1)
        throw BadInput(fmt::format("period = {}: --all proves fixed points, period 1", options.period()));
    if (options.its_period && options.near.empty() && !options.all)
        throw BadInput("--period goes with --near; a record's cycles have their own");
    if (options.longest && !options.all && options.plane.empty())
        throw BadInput("--max-time goes with --all or --plane");
    if (options.branches && (options.record.empty() || options.orbit || !options.along.empty()))
        throw BadInput("--branches goes with a RECORD alone: its branches, along its parameter");
    if (!options.along.empty() && (!options.plane.empty() || !options.check.empty()))
        throw BadInput("--along goes with cycles: a RECORD, --near, --from attractor or --all");
    if (options.chaos &&
        (!options.plane.empty() || !options.check.empty() || !options.along.empty() || options.branches))
        throw BadInput("--chaos goes with cycles: a RECORD, --near, --from attractor or --all");
    if (options.link_length && !options.chaos) throw BadInput("--link-length goes with --chaos");
    if (options.resolution && options.plane.empty()) throw BadInput("--resolution goes with --plane");
    if (!options.check.empty() && !options.certificate.empty())
        throw BadInput("--check and --output are both given; --check writes nothing");
}

Certified certified_record(const CertifyOptions& options) {
    orbits::RecordCycles cycles = orbits::cycles_of_record(options.record);
    warn_without_checksum(options.record, options.output.quiet);
    if (options.orbit) cycles.places = {orbits::cycle_of_record(options.record, options.orbit)};
    const std::size_t asked = cycles.places.size();
    Certified certified{cycles.scene, cycles.along, prove_cycles(cycles.places, run_control(options.output)), {}, true};
    certified.whole = certified.orbits.size() == asked;
    return certified;
}

Certified certified_near(const Scene<double>& scene, const SectionPoint<double>& z, int period) {
    const auto map = shooting_map_of(scene);
    const auto found = cycles::find_near(scene, map, Accuracy::double_precision, z, period, period, interruption());
    Certified certified{scene, {}, {}, {}, !found.cycles.empty(), !is_interrupted()};
    for (const analysis::Cycle& cycle : found.cycles) {
        CyclePlace place{scene, {}};
        for (const auto& point : cycle.points) place.points.push_back(section_point_of(point));
        certified.orbits.push_back(proven_at(place));
        certified.orbits.back().number = certified.orbits.size();
    }
    return certified;
}

Certified certified_near(const CertifyOptions& options, const Scene<double>& scene) {
    const auto z =
        section_point_from<double>("--near", point_without_units(options.near, options.scene.units()), scene.is_disk());
    require_leaving(make_body(scene), z);
    return certified_near(scene, z, options.period());
}

/// What the start settles on.
Certified certified_attractor(const CertifyOptions& options, const Scene<double>& scene) {
    const SettledCycle settled =
        settled_cycle(scene, options.start.start<double>(scene), Accuracy::double_precision, interruption());
    if (settled.point) return certified_near(scene, *settled.point, settled.period);
    if (!is_interrupted()) report(no_cycle_in_words(settled.named.verdict));
    return {scene, {}, {}, {}, false, !is_interrupted()};
}

Certified certified_all(const CertifyOptions& options, const Scene<double>& scene) {
    Certified certified{scene, {}, {}, proof::all_fixed_points(scene, options.max_time(), interruption()), true};
    certified.whole = certified.all->complete() || !is_interrupted();
    for (const proof::CycleProof& proof : certified.all->proven)
        certified.orbits.push_back({certified.orbits.size() + 1, scene, 1, proof.points.front(), proof});
    return certified;
}

}  // namespace

AskedCycles asked_cycles(const CertifyOptions& options) {
    if (!options.record.empty()) {
        const orbits::RecordCycles cycles = orbits::cycles_of_record(options.record);
        warn_without_checksum(options.record, options.output.quiet);
        if (options.orbit) return {cycles.scene, {orbits::cycle_of_record(options.record, options.orbit)}};
        return {cycles.scene, cycles.places};
    }
    AskedCycles asked{options.scene.scene<double>(), {}};
    const Certified certified = options.all            ? certified_all(options, asked.scene)
                                : options.from.empty() ? certified_near(options, asked.scene)
                                                       : certified_attractor(options, asked.scene);
    for (const CertifiedOrbit& orbit : certified.orbits)
        asked.places.push_back({asked.scene, orbit.proof.points, orbit.number});
    asked.found = certified.found;
    asked.complete = !certified.all || certified.all->complete();
    return asked;
}

CertifyFiles open_files(const CertifyOptions& options, const std::string& title) {
    constexpr std::string_view suffix = ".json";
    const std::string& name = options.certificate;
    const bool is_certificate =
        name.size() >= suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
    const std::vector<std::string> inputs = {options.record, options.scene.file()};
    OutputOptions output = options.output;
    if (!is_certificate) output.record = name;
    CertifyFiles files;
    files.certificate = open_certificate(is_certificate ? name : std::string(), options.output.force, inputs);
    files.record = open_record(output, title, inputs, options.scene.units());
    return files;
}

void give(const CertifyOptions& options, OutputFile* certificate, const std::function<std::string()>& text,
          const std::function<void()>& print) {
    const std::string made = certificate != nullptr || options.output.json ? text() : std::string();
    if (certificate != nullptr) write_certificate(*certificate, made);
    if (options.output.json)
        print_text(made);
    else if (!options.output.quiet)
        print();
}

void write_reason(JsonWriter& json, const std::string& reason) {
    json.key("reason");
    reason.empty() ? json.null() : json.value(reason);
}

int certify(CertifyOptions& options) {
    require_one_input(options);
    proof::require_interval_arithmetic();
    if (!options.check.empty()) return check_certificate(options);
    if (!options.plane.empty()) return certify_plane(options);
    if (!options.along.empty() || options.branches) return certify_branches(options);
    if (options.chaos) return certify_chaos(options);
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const bool needs_scene = options.record.empty();
    const Scene<double> scene = needs_scene ? options.scene.scene<double>() : Scene<double>{};
    if (options.all) options.max_time();  // refused before the file is opened
    const std::unique_ptr<OutputFile> file =
        open_certificate(options.certificate, options.output.force, {options.record, options.scene.file()});
    note_interruptions();
    Certified certified = !needs_scene           ? certified_record(options)
                          : options.all          ? certified_all(options, scene)
                          : options.from.empty() ? certified_near(options, scene)
                                                 : certified_attractor(options, scene);
    finish_up();
    give(
        options, file.get(), [&] { return with_checksum(certificate_text(options, certified)); },
        [&] { print_certified(options, certified); });
    if (!certified.whole) return exit_interrupted;
    const bool as_asked = certified.found && certified.proven() == certified.orbits.size() &&
                          (!certified.all || certified.all->complete());
    return as_asked ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::certify
