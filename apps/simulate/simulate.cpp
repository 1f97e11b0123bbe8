#include "apps/simulate/simulate.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/simulate/impact_sinks.hpp"
#include "apps/simulate/samples.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace swirl::apps::simulate {

const char* const simulate_details =
    R"(Outcomes: completed; no-contact (the body never meets the wall again: proven); in-contact (e < 1: the body came to
stay on the wall, with no impact for 1,000 time units); resting (e = 1: held on the wall from the start; beta = 0: slower
than 1e-75); diverged (Newton's law with friction creates energy without end); unresolved (one flight outlasted the search
for its contact, or no contact motion was consistent); interrupted. All but the first exit with 3, interrupted with 130.

All contacts are listed, whatever --skip and --every leave out of the impacts. J after an impact is J after the one before
plus jacobi_restitution + jacobi_friction of the impact, and jacobi_friction + landing_jacobi of the contacts between.

Examples:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 20
  swirl simulate --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --collisions 100000 --every 10 -o disk.h5
  swirl simulate --sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5 --time 50 --sample 0.1 --json)";

namespace {

/// Everything that takes impacts.
class Sinks {
public:
    Sinks(const SimulateOptions& options, const Scene<double>& scene, RecordWriter* record, JsonWriter* json) {
        if (record != nullptr) {
            record_.emplace(record->root().group("collisions"), scene.is_disk());
            contacts_.emplace(record->root().group("contacts"));
            if (options.sample) record_samples_.emplace(record->root().group("samples"));
        }
        if (json != nullptr) {
            json_.emplace(*json, scene.is_disk());
            if (options.sample) json_samples_.emplace(*json);
        }
        if (json == nullptr && record == nullptr && !options.output.quiet) table_.emplace(scene.is_disk());
    }

    void add(const ImpactRow& row) {
        if (record_) record_->add(row);
        if (json_) json_->add(row);
        if (table_) table_->add(row);
    }

    void add(const ContactRow& row) {
        if (contacts_) contacts_->add(row);
        if (json_) json_->add(row);
        if (table_) table_->add(row);
    }

    void add(const SampleRow& row) {
        if (record_samples_) record_samples_->add(row);
        if (json_samples_) json_samples_->add(row);
    }

    void finish() {
        if (json_) json_->finish();
        if (json_samples_) json_samples_->finish();
    }

private:
    std::optional<RecordImpacts> record_;
    std::optional<RecordContacts> contacts_;
    std::optional<JsonImpacts> json_;
    std::optional<TableImpacts> table_;
    std::optional<RecordSamples> record_samples_;
    std::optional<JsonSamples> json_samples_;
};

/// Takes the samples of an orbit that is being followed, if there are to be any.
class Samples {
public:
    template <class T, class AnyStart>
    Samples(const SimulateOptions& options, const Scene<T>& scene, const AnyStart& start)
        : skip_(options.skip), until_(options.time.value_or(std::numeric_limits<double>::infinity())) {
        if (!options.sample) return;
        cutter_.emplace(scene, start);
        sampler_.emplace(*options.sample);
    }

    ContactSink sink() { return cutter_ ? cutter_->sink() : ContactSink{}; }

    template <class T>
    void passed(const SceneOrbit<T>& orbit, bool struck, Sinks& sinks) {
        if (!cutter_) return;
        const auto& trajectory = cutter_->passed(orbit, struck);
        if (skip_ > 0 && orbit.impacts() <= skip_) {
            if (struck) sampler_->pass_over(static_cast<double>(orbit.frame().time.unwound()));
            return;
        }
        sampler_->take(cutter_->scene(), trajectory, until_, [&](const SampleRow& row) { sinks.add(row); });
    }

private:
    std::int64_t skip_;
    double until_;
    std::optional<TrajectorySegmenter> cutter_;
    std::optional<Sampler> sampler_;
};

struct Ending {
    std::string outcome;
    std::int64_t impacts = 0;
    double time = 0;
    double mean_spin = 0;  ///< ∫S dt / t from the first impact to the last; of fewer than two: S of the last flight
};

/// Keeps count of an orbit.
class Count {
public:
    explicit Count(double spin) : spin_(spin) {}

    double time() const { return ending_.time; }

    template <class T>
    void strike(const SceneOrbit<T>& orbit) {
        if (orbit.impacts() > 1) {
            flown_ += static_cast<double>(orbit.collision().flight_time);
            turned_ += static_cast<double>(orbit.return_step().turned);
        }
        ending_.impacts = orbit.impacts();
        ending_.time = static_cast<double>(orbit.frame().time.unwound());
        spin_ = static_cast<double>(orbit.post_impact().spin);
    }

    /// Contact after the last impact.
    void stand(const std::vector<ContactRow>& contacts) {
        if (contacts.empty()) return;
        for (const ContactRow& row : contacts) turned_ += row.turned();
        flown_ += contacts.back().t_end - ending_.time;
        ending_.time = contacts.back().t_end;
    }

    Ending end(std::string_view outcome) {
        ending_.mean_spin = flown_ > 0 ? turned_ / flown_ : spin_;
        ending_.outcome = outcome;
        return ending_;
    }

private:
    Ending ending_;
    double spin_;
    double turned_ = 0, flown_ = 0;
};

template <class T>
Ending follow(const SimulateOptions& options, SceneOrbit<T>& orbit, double spin, Samples& samples, Sinks& sinks) {
    const std::int64_t limit = options.limit();
    const double until = options.time.value_or(std::numeric_limits<double>::infinity());
    Progress progress("simulate", options.time.value_or(static_cast<double>(limit)), options.output.quiet);
    Count count(spin);
    const ContactSink sink = samples.sink();
    while (options.time || orbit.impacts() < limit) {
        const int vertex = orbit.frame().vertex;
        const bool struck = orbit.advance(options.time ? until - count.time() : contact_horizon, sink);
        samples.passed(orbit, struck, sinks);
        const auto contacts = contact_rows(orbit, count.time(), vertex);
        for (const ContactRow& row : contacts) sinks.add(row);
        const bool beyond = struck && static_cast<double>(orbit.frame().time.unwound()) > until;
        if (!struck || beyond) {
            count.stand(contacts);
            const bool stood = orbit.outcome() == Outcome::in_contact && count.time() >= until * (1 - 1e-12);
            return count.end(is_interrupted()  ? "interrupted"
                             : beyond || stood ? "completed"
                                               : name_of(orbit.outcome()));
        }
        count.strike(orbit);
        const std::int64_t kept = orbit.impacts() - 1 - options.skip;
        if (kept >= 0 && kept % options.every == 0) sinks.add(impact_row(orbit));
        if (orbit.impacts() % 1024 != 0) continue;
        progress.at(options.time ? count.time() : static_cast<double>(orbit.impacts()));
        if (is_interrupted()) break;
    }
    return count.end(is_interrupted() ? "interrupted" : name_of(orbit.outcome()));
}

template <class T>
Ending run_in(const SimulateOptions& options, Sinks& sinks) {
    const Scene<T> scene = options.scene.template scene<T>();
    const Start<T> start = options.start.template start<T>(scene);
    SceneOrbit<T> orbit(scene, start);
    return std::visit(
        [&](const auto& s) {
            Samples samples(options, scene, s);
            return follow(options, orbit, static_cast<double>(s.spin), samples, sinks);
        },
        start);
}

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
    if (options.time && !(*options.time > 0 && std::isfinite(*options.time)))
        throw BadInput(fmt::format("time = {} is outside its range: time > 0, finite", *options.time));
    if (options.sample && !(*options.sample >= least_sample_step && std::isfinite(*options.sample)))
        throw BadInput(
            fmt::format("sample = {} is outside its range: {:g} or more, finite", *options.sample, least_sample_step));
    if (options.sample && !options.output.json && options.output.record.empty())
        throw BadInput("--sample goes into a document or a record: give --json or -o FILE.h5");
    if (!options.time && options.skip >= options.limit())
        throw BadInput(
            fmt::format("skip = {} leaves nothing of {} collisions: give less", options.skip, options.limit()));
}

}  // namespace

void SimulateOptions::add_to(CLI::App& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--collisions", collisions, "follow K impacts (default 100)")
        ->type_name("K")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}));
    command.add_option("--time", time, "follow until time T, in 1/omega_s")->type_name("T");
    command.add_option("--skip", skip, "leave out the first K impacts")
        ->type_name("K")
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000'000}));
    command.add_option("--every", every, "list every K-th impact (default 1)")
        ->type_name("K")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}));
    command
        .add_option("--sample", sample,
                    "also x, y, angle and S at the multiples of DT, in flight and in contact: `samples`")
        ->type_name("DT");
}

int simulate(SimulateOptions& options) {
    options.scene.read_file();
    check_limits(options);
    const Scene<double> scene = options.scene.scene<double>();
    const auto units = options.scene.units();
    const Accuracy accuracy = options.output.accuracy();
    check_start(options, scene);
    note_interruptions();

    std::optional<RecordWriter> record;
    if (!options.output.record.empty())
        record.emplace(open_record(options.output.record, "Orbit of a swirled polygon"));
    std::optional<JsonWriter> json;
    if (options.output.json) {
        json.emplace(stdout);
        json->begin_object(JsonLayout::rows);
        write_json(*json, "scene", scene_settings(scene));
        write_json(*json, "start", start_settings(options.start, scene));
        if (units) write_json(*json, "units", unit_settings(*units));
    }
    Sinks sinks(options, scene, record ? &*record : nullptr, json ? &*json : nullptr);
    const Ending ending = accuracy == Accuracy::double_precision ? run_in<double>(options, sinks)
                          : accuracy == Accuracy::extended       ? run_in<long double>(options, sinks)
                                                                 : run_in<Quad>(options, sinks);
    sinks.finish();
    const Settings result = {
        {"outcome", ending.outcome}, {"impacts", ending.impacts}, {"time", ending.time}, {"mean_S", ending.mean_spin}};
    const Settings settings = {options.time ? Settings::value_type{"time", *options.time}
                                            : Settings::value_type{"collisions", options.limit()},
                               {"skip", options.skip},
                               {"every", options.every},
                               {"accuracy", options.output.accuracy_name}};
    if (record) {
        const RecordGroup root = record->root();
        write_attributes(root.group("scene"), scene_settings(scene));
        write_attributes(root.group("start"), start_settings(options.start, scene));
        write_attributes(root.group("settings"), settings);
        write_attributes(root.group("result"), result);
        if (units) write_attributes(root.group("units"), unit_settings(*units));
        record->finish();
    }
    if (json) {
        json->member("outcome", std::string_view(ending.outcome));
        write_json(*json, "settings", settings);
        write_json(*json, "result", result);
        json->member("swirl_version", std::string_view(version()));
        json->end_object();
        json->finish();
    } else if (!options.output.quiet) {
        fmt::print("{}: {} after {} impacts, t = {:.10g}, time mean of S = {:.8g}\n", describe(scene), ending.outcome,
                   ending.impacts, ending.time, ending.mean_spin);
    }
    if (ending.outcome == "interrupted") return exit_interrupted;
    return ending.outcome == "completed" ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::simulate
