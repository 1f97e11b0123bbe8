#include "apps/simulate/follow_impacts.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/studies/scene_map/in_digits.hpp"
#include "map/orbit/dry_path.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace swirl::apps::simulate {

namespace {

/// Takes the samples of an orbit that is being followed, if there are to be any.
class Samples {
public:
    template <class T, class AnyStart>
    Samples(const SimulateOptions& options, const Scene<T>& scene, const AnyStart& start)
        : skip_(options.skip), until_(options.time.value_or(std::numeric_limits<double>::infinity())) {
        if (!options.sample) return;
        cutter_.emplace(scene, start);
        if constexpr (std::is_same_v<T, double>) cutter_->take_paths_from(dry_paths(scene));
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
SceneOrbit<T> orbit_of(const SimulateOptions& options, const Scene<T>& scene, const Start<T>& start) {
    if constexpr (std::is_same_v<T, double>)
        if (const ImpactNoise noise = options.noise.noise(options.start, options.output); noise.is_any())
            return {scene, noisy_orbit(scene, start, noise)};
    return {scene, start, baseline_for(scene, options.output.accuracy())};
}

template <class T>
Ending run_in(const SimulateOptions& options, Sinks& sinks) {
    const Scene<T> scene = options.scene.template scene<T>(Extensions::followed);
    const Start<T> start = options.start.template start<T>(scene);
    SceneOrbit<T> orbit = orbit_of(options, scene, start);
    return std::visit(
        [&](const auto& s) {
            Samples samples(options, scene, s);
            return follow(options, orbit, static_cast<double>(s.spin), samples, sinks);
        },
        start);
}

}  // namespace

Ending follow_impacts(const SimulateOptions& options, Sinks& sinks) {
    return with_number_of(options.output.accuracy(), [&]<class T>(const T&) { return run_in<T>(options, sinks); });
}

}  // namespace swirl::apps::simulate
