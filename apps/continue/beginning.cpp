#include "apps/continue/beginning.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/modes/verdict_in_words.hpp"
#include "apps/orbits/recorded_cycles.hpp"
#include "apps/studies/modes/followed_orbit.hpp"
#include "map/orbit/orbit.hpp"

#include <fmt/format.h>

namespace swirl::apps::continuation {

namespace {

void require_one_way(const ContinueOptions& options) {
    const bool from_record = !options.record.empty();
    if (from_record && !options.from.empty()) throw BadInput("a RECORD and --from are both given; give one");
    if (!from_record && options.from.empty())
        throw BadInput("--from is missing: psi,chi,vn,vt,S near a point of the cycle, or attractor, or a RECORD");
    if (from_record && options.scene.given())
        throw BadInput("a scene is given, but the record has its own; leave one out");
    if (options.orbit && !from_record) throw BadInput("--orbit goes with a RECORD, whose cycles it numbers");
    const bool settles = options.from == from_attractor;
    if (options.start.given() && !settles) throw BadInput("a start is given; it goes with --from attractor");
    if (options.its_period && (from_record || settles))
        throw BadInput("--period goes with a point of --from; a record's cycle, or an attractor, has its own");
}

Beginning of_record(const ContinueOptions& options) {
    const orbits::CyclePlace place = orbits::cycle_of_record(options.record, options.orbit);
    warn_without_checksum(options.record, options.output.quiet);
    return {place.scene, static_cast<int>(place.points.size()), place.points,
            orbits::point_as_flag(place.points.front(), place.scene.is_disk()), ""};
}

Beginning of_attractor(ContinueOptions& options) {
    options.start.take_from(options.scene);
    const auto scene = options.scene.scene<double>(Extensions::followed);
    exit_when_interrupted();
    const SettledCycle settled =
        settled_cycle(scene, options.start.start<double>(scene), options.output.accuracy(), interruption());
    exit_when_interrupted();
    if (!settled.point) return {scene, 1, {}, options.from, no_cycle_in_words(settled.named.verdict)};
    return {scene, settled.period, {*settled.point}, orbits::point_as_flag(*settled.point, scene.is_disk()), ""};
}

}  // namespace

Beginning beginning_of(ContinueOptions& options) {
    require_one_way(options);
    if (options.along.starts_with("drag=") && !options.scene.has("drag")) options.scene.set("drag", "0");
    if (options.along.starts_with("corner=") && !options.scene.has("corner") && !options.scene.has("corner-radius"))
        options.scene.set("corner", "0");
    if (!options.record.empty()) return of_record(options);
    if (options.from == from_attractor) return of_attractor(options);
    const auto scene = options.scene.scene<double>(Extensions::followed);
    const auto z = section_point_from<double>("--from", options.from, scene.is_disk());
    require_leaving(make_body(scene), z);
    return {scene, static_cast<int>(options.its_period.value_or(1)), {z}, options.from, ""};
}

}  // namespace swirl::apps::continuation
