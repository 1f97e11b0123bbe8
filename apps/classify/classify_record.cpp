#include "apps/classify/classify_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace swirl::apps::classify {

namespace {

constexpr std::int64_t fewest = 64;

/// It has no next impact: the verdict is on what follows the last one.
bool has_ended(const OrbitColumns& columns) {
    return columns.outcome != "completed" && columns.outcome != "interrupted";
}

/// An edited record may say anything of itself. @throws BadInput unless its columns are as long as it says
void require_rows(const std::string& file, const OrbitColumns& columns) {
    const auto rows = std::ssize(columns.values.back());
    const std::int64_t skipped = columns.range.transient, impacts = columns.impacts, every = columns.every;
    const bool counted = every > 0 && skipped >= 0 && impacts > skipped && (impacts - skipped - 1) / every + 1 == rows;
    const auto as_long = [&](const std::vector<double>& column) { return std::ssize(column) == rows; };
    if (!counted || !std::all_of(columns.values.begin(), columns.values.end(), as_long))
        throw BadInput(
            fmt::format("record '{}' is not whole: of {} impacts it leaves out {} and lists one in {}, in {} rows",
                        file, impacts, skipped, every, rows));
}

/// The row of the tail's first impact; in a thinned record the last that is not later.
std::size_t first_row(const RecordedOrbit& orbit) {
    return static_cast<std::size_t>((orbit.first - orbit.columns.range.transient) / orbit.columns.every);
}

/// Is what was followed the orbit that was recorded: every row of the tail, bit for bit, or the end?
bool repeats(const RecordedOrbit& orbit, const NamedMode& named, const OrbitSamples& samples) {
    const OrbitColumns& columns = orbit.columns;
    if (named.outcome != Outcome::completed)
        return named.impacts >= columns.impacts && (!has_ended(columns) || name_of(named.outcome) == columns.outcome);
    for (std::size_t row = 0; row < columns.values.back().size(); ++row) {
        const std::int64_t i = columns.range.transient + static_cast<std::int64_t>(row) * columns.every - orbit.first;
        if (i < 0 || i >= std::ssize(samples.points)) continue;
        const auto& point = samples.points[static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < columns.values.size(); ++c)
            if (point[static_cast<Eigen::Index>(c)] != columns.values[c][row]) return false;
    }
    return !has_ended(columns);
}

SectionPoint<double> recorded_point(const OrbitColumns& columns, std::size_t row) {
    std::vector<double> z;
    for (const auto& column : columns.values) z.push_back(column[row]);
    if (columns.disk) return {z[0], 0, z[1], z[2], z[3]};
    return {z[0], z[1], z[2], z[3], z[4]};
}

}  // namespace

RecordedOrbit recorded_orbit(const std::string& file, std::optional<std::int64_t> transient,
                             std::optional<std::int64_t> collisions, SceneOptions& scene, StartOptions& start) {
    const bool disk = read_orbit(file, {}, {"S"}).disk;
    RecordedOrbit orbit;
    orbit.columns =
        disk ? read_orbit(file, {}, {"psi", "vn", "vt", "S"}) : read_orbit(file, {}, {"psi", "chi", "vn", "vt", "S"});
    require_rows(file, orbit.columns);
    set_from_record(orbit.columns, scene, start);
    const std::int64_t skipped = orbit.columns.range.transient, listed = orbit.columns.impacts - skipped;
    const std::int64_t left_out = transient.value_or(skipped > 0 ? 0 : listed / 2);
    orbit.first = skipped + left_out;
    orbit.collisions = collisions.value_or(listed - left_out);
    if (has_ended(orbit.columns)) {
        orbit.collisions = std::max(orbit.collisions, fewest);
    } else if (orbit.collisions < fewest || left_out + orbit.collisions > listed) {
        throw BadInput(fmt::format(
            "record '{}' holds {} impacts; a verdict on it with --transient {} needs {} or more (swirl classify with "
            "its scene and start follows the orbit further)",
            file, listed, left_out, left_out + std::max(orbit.collisions, fewest)));
    }
    return orbit;
}

NamedMode name_recorded(const Scene<double>& scene, const Start<double>& start, const RecordedOrbit& orbit,
                        analysis::ClassifyOptions settings, Accuracy accuracy, OrbitSamples* seen) {
    OrbitSamples samples;
    analysis::ClassifyOptions whole = settings;  // all impacts, to compare them with the record's
    whole.exhaustive = true;
    NamedMode named = name_mode(scene, start, whole, accuracy, {}, &samples);
    if (repeats(orbit, named, samples)) {
        if (!settings.exhaustive) return name_mode(scene, start, settings, accuracy, {}, seen);
        if (seen) *seen = std::move(samples);
        return named;
    }
    const std::size_t row = std::min(first_row(orbit), orbit.columns.values.back().size() - 1);
    settings.transient = 0;
    named = name_mode(scene, recorded_point(orbit.columns, row), settings, accuracy, {}, seen);
    named.impacts += orbit.columns.range.transient + static_cast<std::int64_t>(row) * orbit.columns.every + 1;
    named.verdict.evidence.push_back(
        {"orbit from the start repeats the record", 0, 1,
         fmt::format("followed from its start in {} it parts from the record (made in another accuracy, or by another "
                     "version): judged from the state that the record holds after the transient",
                     name_of(accuracy)),
         "nothing: this does not decide, it says which orbit was judged"});
    return named;
}

}  // namespace swirl::apps::classify
