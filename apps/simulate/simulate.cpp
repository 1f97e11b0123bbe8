#include "apps/simulate/simulate.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/simulate/follow_impacts.hpp"
#include "apps/studies/scene_map/accuracy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <variant>

namespace swirl::apps::simulate {

const char* const simulate_details =
    R"(The table lists the state just after each impact, in units of R_c, 1/omega_s and m, or in m, s and kg where the scene is
given in them. S is a ratio and has no unit. n is the unit normal from the container's centre to the contact; the tangent
points counter-clockwise.
  psi     angle of the contact about the container's centre, less that of the swirl: arg n - omega_s t
  chi     angle of the contact about the body's centre, less arg n (a disk has none)
  vn, vt  velocity of the body's centre in the laboratory, along n (outwards) and along the tangent
  S       omega_p/omega_s, the body's spin over the swirl's. S > 0: with the swirl, counter-clockwise
          seen from above (y up)
  p, q    impulse of the wall on the body: p against n, q along the tangent
  J       energy in the frame that turns with the swirl: E - omega_s L
  vertex  number of the vertex that struck; * marks that another one struck at the same time
  mode    contact mode: sliding, c-sticking, r-sticking, c-reversed, r-reversed or frictionless

The outcome says how the orbit ended. All but the first exit with code 3, interrupted with 130.
  completed          it has the impacts, or the time, that were asked for
  no-contact         the body never meets the wall again (proven)
  in-contact         e < 1: the body stays on the wall; it had no impact for 1,000/omega_s
  contact-cut-short  the same for a shorter time, since it moves on the wall too fast to be followed
  resting            e = 1: it lay on the wall from the start; beta = 0: it is slower than 1e-75
  diverged           Newton's law with friction creates energy without end, or the next impact would
                     overflow (an inertia factor far below rounding)
  unresolved         the search for one contact gave up, or no motion on the wall was consistent
  riding             --drag or --floor-friction on a dish: the body goes along with it and never meets the wall again (proven)
  contact-of-corner  --corner: a rounded corner came to stay on the wall; how it rolls or slides there is not followed
  interrupted        the user ended it

--camera FPS writes what a tracker would make of a film of it: -o FILE.csv has a line a frame, the body's centre, a mark at
vertex 0 and the direction from the one to the other, rounded, with --noise, without the share --lose of the frames;
--pixels P gives an image's axes. --seed also seeds the noise.

--noise-restitution, --noise-mu and --noise-wall let e, mu and the direction of the wall's normal vary from impact to impact,
normally distributed, e reflected into [0, 1] and mu at 0; each number of an impact has its own draw of --seed.

--skip and --every leave out impacts; contacts are always listed. J after an impact is J after the one before plus
jacobi_restitution + jacobi_friction of the impact, plus jacobi_friction + landing_jacobi of the contacts between them.

Examples:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 20
  swirl simulate --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --collisions 100000 --every 10 -o disk.h5
  swirl simulate --sides disk --alpha 0.3 --beta 0 --mu 1000 --restitution 1 --tangential-restitution 1 --x 0.1 --vy 0.8 --spin 2
  swirl simulate --sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5 --time 50 --sample 0.1 --json
  swirl simulate --sides 6 --alpha 0.4 --corner 0.05 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 20
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --noise-restitution 0.02 --noise-wall 0.01 --seed 2
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --time 300 --camera 5 --noise 0.002 --lose 0.01 -o film.csv)";

namespace {

/// Finds bad starts before any output is begun.
void check_start(const SimulateOptions& options, const Scene<double>& scene) {
    const auto start = options.start.start<double>(scene);
    const auto body = make_body(scene);
    if (const auto* lab = std::get_if<LabStart<double>>(&start))
        flight_from(body, *lab);
    else
        require_leaving(body, std::get<SectionPoint<double>>(start));
}

void check_limits(const SimulateOptions& options) {
    if (options.collisions && options.time) throw BadInput("--collisions and --time are both given; give one");
    const auto time = [units = options.scene.units()](double t) { return in_units(t, units, "1/omega_s"); };
    if (options.time && !(*options.time > 0 && std::isfinite(*options.time)))
        throw BadInput(fmt::format("time = {} is outside its range: time > 0, finite", time(*options.time)));
    if (options.sample && !(*options.sample >= least_sample_step && std::isfinite(*options.sample)))
        throw BadInput(fmt::format("sample = {} is outside its range: {:g} or more, finite", time(*options.sample),
                                   time(least_sample_step)));
    options.film.check(options.output, options.sample.has_value());
    if (options.sample && !options.output.json && options.output.record.empty())
        throw BadInput("--sample goes into a document or a record: give --json or -o FILE.h5");
    if (!options.time && options.skip >= options.limit())
        throw BadInput(
            fmt::format("skip = {} leaves nothing of {} collisions: give less", options.skip, options.limit()));
}

Settings settings_of(const SimulateOptions& options) {
    Settings settings = {options.time ? Settings::value_type{"time", *options.time}
                                      : Settings::value_type{"collisions", options.limit()},
                         {"skip", options.skip},
                         {"every", options.every},
                         {"accuracy", options.output.accuracy_name}};
    add_noise_settings(settings, options.noise.noise(options.start, options.output));
    if (!options.film.fps) return settings;
    settings.emplace_back("camera", *options.film.fps);
    settings.emplace_back("noise", options.film.noise);
    settings.emplace_back("lose", options.film.lose);
    settings.emplace_back("seed", options.start.seed());
    return settings;
}

Settings result_of(const Ending& ending) {
    return {
        {"outcome", ending.outcome}, {"impacts", ending.impacts}, {"time", ending.time}, {"mean_S", ending.mean_spin}};
}

void write_run(const RecordGroup& root, const SimulateOptions& options, const Scene<double>& scene,
               const Ending& ending) {
    write_scene(root, scene, &options.start);
    write_attributes(root.group("settings"), settings_of(options));
    write_attributes(root.group("result"), result_of(ending));
}

}  // namespace

void SimulateOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    add_whole_number(command, "--collisions", collisions, "K", 1, most_impacts, "follow K impacts (default 100)");
    command.add_option("--time", time, "T", "follow until time T, in 1/omega_s (SI units: s)");
    add_whole_number(command, "--skip", skip, "K", 0, most_impacts, "leave out the first K impacts");
    add_whole_number(command, "--every", every, "K", 1, most_impacts, "list every K-th impact (default 1)");
    command.add_option("--sample", sample, "DT",
                       "list the body at all multiples of DT (as T), in flight and in contact: `samples`");
    film.add_to(command);
    noise.add_to(command);
}

int simulate(SimulateOptions& options) {
    options.scene.read_file(options.output.quiet);
    if (options.film.fps) options.start.keep_seed_apart();
    options.noise.keep_seed_apart(options.start);
    options.start.take_from(options.scene);
    for (auto* time : {&options.time, &options.sample})
        if (*time) *time = without_units(**time, options.scene.units(), "1/omega_s");
    check_limits(options);
    const Scene<double> scene = options.scene.scene<double>(Extensions::followed);
    baseline_for(scene, options.output.accuracy());  // what is wrong with it is reported before any work
    if (options.noise.noise(options.start, options.output).is_any()) without_rounding(scene, "noise at impacts");
    check_start(options, scene);
    note_interruptions();

    std::optional<RecordWriter> record;
    std::optional<Film> film;
    if (options.film.fps) {
        options.sample = Film::step_of(options.film, options.scene.units());
        film.emplace(options.film, scene, options.scene, options.start.seed(), options.output);
    } else {
        record =
            open_record(options.output, "Orbit of a swirled polygon", {options.scene.file()}, options.scene.units());
    }
    std::optional<JsonWriter> json;
    if (options.output.json) {
        json.emplace(document_writer());
        json->begin_object(JsonLayout::rows);
        write_scene(*json, scene, options.scene, &options.start);
    }
    Sinks sinks(options, scene, record ? &*record : nullptr, json ? &*json : nullptr, film ? &*film : nullptr);
    const Ending ending = follow_impacts(options, sinks);
    finish_up();
    sinks.finish();
    if (film) film->finish();
    if (record) {
        write_run(record->root(), options, scene, ending);
        record->finish();
    }
    if (json) {
        json->member("outcome", ending.outcome);
        write_json(*json, "settings", settings_of(options));
        write_json(*json, "result", result_of(ending));
        json->member("swirl_version", version());
        json->end_object();
        json->finish();
    } else if (!options.output.quiet) {
        const auto units = options.scene.units();
        fmt::print("{}\n{}{} after {} impacts, t = {:.10g}{}, time mean of S = {:.8g}\n", scene_in_words(scene),
                   units_in_words(units), ending.outcome, ending.impacts, in_units(ending.time, units, "1/omega_s"),
                   units ? " s" : "", ending.mean_spin);
        if (film)
            fmt::print("film: {} frames in {}, {} lost\n", film->written(), printable(options.output.record),
                       film->lost());
    }
    if (ending.outcome == "interrupted") return exit_interrupted;
    return ending.outcome == "completed" ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::simulate
