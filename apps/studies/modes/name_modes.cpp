#include "apps/studies/modes/naming.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace swirl::studies {

namespace {

/// An orbit on its way to its name.
template <int D>
struct Naming {
    std::size_t place;  ///< among the starts
    Scene<double> scene;
    SceneMap<D> map;
    OrbitBegin begin;
    analysis::ClassifyOptions settings;
    analysis::SettlingOrbit<SceneMap<D>> orbit;
    bool at_look = false;  ///< followed to a look alone
    bool waits = false;    ///< the steps that it wants were not taken together
    int refusals = 0;      ///< how often that was so

    /// Steps that cost too much for others to wait for are taken alone from here on.
    bool goes_alone() const {
        constexpr int most_refusals = 4;
        return refusals >= most_refusals;
    }
    bool is_over() const { return orbit.wanted().count == 0; }
    void step_alone(const analysis::Stop& stop) {
        orbit.take(map, stop);
        orbit.look(map);
    }

    NamedMode named(OrbitSamples* samples) {
        return at_look ? named_at_look(map, scene, begin, orbit.orbit(), settings, samples)
                       : name_from(map, scene, begin, orbit.orbit(), settings, samples);
    }
};

/// Those that take their next steps together, of one shape and impact rule.
template <int D>
using Together = std::vector<Naming<D>*>;

template <int D>
std::vector<Together<D>> groups_of(std::vector<Naming<D>>& orbits) {
    std::vector<Together<D>> groups;
    for (Naming<D>& orbit : orbits) {
        if (orbit.goes_alone() || orbit.is_over()) continue;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Together<D>& group) {
            return orbit.map.goes_together_with(group.front()->map);
        });
        if (same == groups.end())
            groups.push_back({&orbit});
        else
            same->push_back(&orbit);
    }
    return groups;
}

/// Lets a group take the steps that it wants. What is not taken is left for them to take alone.
template <int D>
void take_together(const Together<D>& group) {
    std::vector<KeptSteps> kept;
    std::vector<LaneOrbit<D>> lanes;
    kept.reserve(group.size());
    for (Naming<D>* naming : group) {
        const analysis::WantedSteps wanted = naming->orbit.wanted();
        lanes.push_back(naming->map.lane_orbit(naming->orbit.state(), wanted.count));
        LaneOrbit<D>& lane = lanes.back();
        lane.most_excess = std::min(lane.most_excess, wanted.most - static_cast<double>(wanted.count));
        if (!wanted.kept) continue;
        auto& tail = naming->orbit.orbit().tail;
        kept.push_back({tail.states, tail.durations, tail.integrals, tail.letters});
        lane.kept = &kept.back();
    }
    group.front()->map.follow_together(lanes);
    for (std::size_t i = 0; i < group.size(); ++i) {
        group[i]->waits = !lanes[i].taken;
        if (!lanes[i].taken) {
            ++group[i]->refusals;
            continue;
        }
        group[i]->orbit.taken(lanes[i].z, lanes[i].excess, lanes[i].derivative_is_zero);
        group[i]->orbit.look(group[i]->map);
    }
}

/// The next steps of all that go together; the few of a small group go alone to their end. False if it was stopped.
template <int D>
bool go_on_together(std::vector<Naming<D>>& orbits, const analysis::Stop& stop) {
    for (const Together<D>& group : groups_of(orbits)) {
        if (stop && stop()) return false;
        if (group.size() >= fewest_together) {
            take_together(group);
            continue;
        }
        for (Naming<D>* naming : group)
            while (!naming->is_over()) naming->step_alone(stop);
    }
    return true;
}

/// Gives what `name` says of a start, unless it was stopped.
template <class Name>
void give(std::size_t place, const NamingOptions& options, const TakeNamed& take, const Name& name) {
    OrbitSamples samples;
    const NamedMode named = name(options.samples ? &samples : nullptr);
    if (named.finished) take(place, named, samples);
}

/// Names orbits that may take their steps together.
template <int D>
void name_all(std::vector<Naming<D>>& orbits, const NamingOptions& options, const TakeNamed& take) {
    const analysis::Stop& stop = options.stop;
    while (!orbits.empty()) {
        if (!go_on_together(orbits, stop)) return;
        for (Naming<D>& naming : orbits) {
            if (naming.waits && !naming.is_over()) naming.step_alone(stop);
            naming.waits = false;
            while (naming.goes_alone() && !naming.is_over()) naming.step_alone(stop);
            if (!naming.is_over()) continue;
            give(naming.place, options, take, [&](OrbitSamples* samples) { return naming.named(samples); });
        }
        std::erase_if(orbits, [](const Naming<D>& naming) { return naming.is_over(); });
    }
}

/// An orbit to be followed with others; nothing where the start has none, or is followed in another way.
template <int D>
std::optional<Naming<D>> naming_of(std::size_t place, const SceneStart& start, const NamingOptions& options) {
    const analysis::ClassifyOptions settings = settings_for(start.scene, options.settings);
    const SceneMap<D> map(start.scene);
    const OrbitBegin begin = begin_orbit(map, start.start);
    if (begin.outcome != Outcome::completed) return {};
    Naming<D> naming{place, start.scene, map,
                     begin, settings,    settling<D>(begin.state, steps_before(begin, settings), settings)};
    if (!naming.orbit.keeps_states()) return {};
    naming.at_look = options.look > 0;
    if (!naming.at_look) return naming;
    const StepsToLook steps = steps_to(options.look);
    analysis::ClassifyOptions to_look = settings;
    to_look.collisions = steps.tail;
    naming.orbit = settling<D>(begin.state, steps.before, to_look);
    return naming;
}

}  // namespace

std::size_t most_named_together() {
    return has_lanes() ? 32 : 1;
}

void name_modes(std::span<const SceneStart> starts, const NamingOptions& options, const TakeNamed& take) {
    const analysis::ClassifyOptions& settings = options.settings;
    std::vector<Naming<disk_dimension>> disks;
    std::vector<Naming<polygon_dimension>> polygons;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Scene<double>& scene = starts[i].scene;
        bool together = options.accuracy == Accuracy::double_precision && !settings.exhaustive &&
                        !is_dissipative_without_drive(scene);
        const auto add = [&]<int D>(std::vector<Naming<D>>& orbits) {
            auto naming = naming_of<D>(i, starts[i], options);
            together = naming.has_value();
            if (together) orbits.push_back(std::move(*naming));
        };
        if (together) scene.is_disk() ? add(disks) : add(polygons);
        if (together) continue;
        give(i, options, take, [&](OrbitSamples* samples) { return name_alone(starts[i], options, samples); });
    }
    name_all(disks, options, take);
    name_all(polygons, options, take);
}

}  // namespace swirl::studies
