#include "apps/simulate/simulate.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/simulate/impact_sinks.hpp"

#include <cmath>
#include <optional>

namespace swirl::apps {

const char* const simulate_details =
    R"(Outcomes: completed; no-contact (the body never meets the wall again: proven); in-contact (e < 1: the body came to
stay on the wall, with no impact for 1,000 time units); resting (e = 1: held on the wall from the start; beta = 0: slower
than 1e-75); diverged (Newton's law with friction creates energy without end); unresolved (one flight outlasted the search for its contact, or no contact motion was consistent);
interrupted. All but the first exit with 3, interrupted with 130.

Examples:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 20
  swirl simulate --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --collisions 100000 --every 10 -o disk.h5)";

namespace {

/// Everything that takes impacts.
class Sinks {
public:
    Sinks(const SimulateOptions& options, const Scene<double>& scene, RecordWriter* record, JsonWriter* json) {
        if (record != nullptr) {
            record_.emplace(record->root().group("collisions"), scene.is_disk());
            contacts_.emplace(record->root().group("contacts"));
        }
        if (json != nullptr)
            json_.emplace(*json, scene.is_disk());
        else if (!(options.output.quiet || record != nullptr))
            table_.emplace(scene.is_disk());
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

    void finish() {
        if (json_) json_->finish();
    }

private:
    std::optional<RecordImpacts> record_;
    std::optional<RecordContacts> contacts_;
    std::optional<JsonImpacts> json_;
    std::optional<TableImpacts> table_;
};

struct Ending {
    std::string outcome;
    std::int64_t impacts = 0;
    double time = 0;
    double mean_spin = 0;  ///< ∫S dt / t from the first impact to the last; of fewer than two: S of the last flight
};

template <class Map>
Ending follow(const SimulateOptions& options, Orbit<Map>& orbit, double spin, Sinks& sinks) {
    const std::int64_t limit = options.limit();
    const bool by_time = options.time.has_value();
    Progress progress("simulate", by_time ? *options.time : static_cast<double>(limit), options.output.quiet);
    Ending ending;
    double turned = 0;
    double flown = 0;
    bool cut = false;
    while (by_time || orbit.impacts() < limit) {
        const bool first = orbit.impacts() == 0;
        const int vertex = orbit.frame().vertex;
        const bool struck = orbit.advance(by_time ? *options.time - ending.time : contact_horizon);
        const auto contacts = contact_rows(orbit, ending.time, vertex);
        for (const ContactRow& row : contacts) sinks.add(row);
        if (!struck) {
            for (const ContactRow& row : contacts) turned += row.turned();
            if (!contacts.empty()) flown += contacts.back().t_end - ending.time;
            if (!contacts.empty()) ending.time = contacts.back().t_end;
            const bool reached = by_time && ending.time >= *options.time * (1 - 1e-12);
            if (reached && orbit.outcome() == Outcome::in_contact) ending.outcome = "completed";
            break;
        }
        const double now = static_cast<double>(orbit.frame().time.unwound());
        if (by_time && now > *options.time) {
            ending.outcome = "completed";
            break;
        }
        if (!first) {
            flown += static_cast<double>(orbit.collision().flight_time);
            turned += static_cast<double>(orbit.passage().turned);
        }
        ending.impacts = orbit.impacts();
        ending.time = now;
        spin = static_cast<double>(orbit.launch().spin);
        const std::int64_t kept = orbit.impacts() - 1 - options.skip;
        if (kept >= 0 && kept % options.every == 0) sinks.add(impact_row(orbit));
        if (orbit.impacts() % 1024 == 0) {
            progress.at(by_time ? now : static_cast<double>(orbit.impacts()));
            if ((cut = is_interrupted())) break;
        }
    }
    ending.mean_spin = flown > 0 ? turned / flown : spin;
    if (cut || is_interrupted())
        ending.outcome = "interrupted";
    else if (ending.outcome.empty())
        ending.outcome = std::string(name_of(orbit.outcome()));
    return ending;
}

template <class T>
Ending run_in(const SimulateOptions& options, Sinks& sinks) {
    const Scene<T> scene = options.scene.template scene<T>();
    const Start<T> start = options.start.template start<T>(scene);
    return with_collision_map(scene, [&](const auto& map) {
        return std::visit(
            [&](const auto& s) {
                Orbit orbit(map, s);
                return follow(options, orbit, static_cast<double>(s.spin), sinks);
            },
            start);
    });
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
    if (!options.time && options.skip >= options.limit())
        throw BadInput(fmt::format("skip = {} leaves nothing of {} collisions: give less", options.skip, options.limit()));
}

}  // namespace

void SimulateOptions::add_to(CLI::App& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--collisions", collisions, "follow K impacts (default 100)")
        ->type_name("K")->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}));
    command.add_option("--time", time, "follow until time T, in 1/omega_s")->type_name("T");
    command.add_option("--skip", skip, "leave out the first K impacts")
        ->type_name("K")->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000'000}));
    command.add_option("--every", every, "list every K-th impact (default 1)")
        ->type_name("K")->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}));
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
    if (!options.output.record.empty()) record.emplace(open_record(options.output.record, "Orbit of a swirled polygon"));
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
                        : accuracy == Accuracy::extended         ? run_in<long double>(options, sinks)
                                                                 : run_in<Quad>(options, sinks);
    sinks.finish();
    const Settings result = {{"outcome", ending.outcome}, {"impacts", ending.impacts}, {"time", ending.time},
                             {"mean_S", ending.mean_spin}};
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

}  // namespace swirl::apps
