#include "apps/branches/branches.hpp"
#include "apps/orbits/orbits_command.hpp"
#include "apps/system/shooting_map.hpp"

#include <cmath>
#include <limits>

namespace swirl::apps::orbits {

namespace {

constexpr const char* polygon_names[] = {"psi", "chi", "vn", "vt", "S"};
constexpr const char* disk_names[] = {"psi", "vn", "vt", "S"};

void write_family(JsonWriter& json, const analysis::ShootingMap& map, const analysis::Cycle& cycle) {
    json.key("family");
    if (!cycle.is_family()) {
        json.null();
        return;
    }
    json.begin_object();
    json.member("dimension", static_cast<std::int64_t>(cycle.tangents.cols()));
    json.key("tangents");
    json.begin_array();
    for (Eigen::Index j = 0; j < cycle.tangents.cols(); ++j) write_point(json, {}, cycle.tangents.col(j));
    json.end_array();
    if (cycle.tangents.cols() == 1) {
        const FamilyRange range = range_of(map, cycle);
        json.member("least_S", range.least_spin);
        json.member("most_S", range.most_spin);
        json.member("shortest_return_time", range.shortest);
        json.member("longest_return_time", range.longest);
        json.member("closed", range.closed);
    }
    json.end_object();
}

void write_cycle(JsonWriter& json, const analysis::ShootingMap& map, const analysis::Cycle& cycle) {
    json.begin_object();
    json.member("period", static_cast<std::int64_t>(cycle.period()));
    json.key("points");
    json.begin_array();
    for (const auto& z : cycle.points) write_point(json, {}, z);
    json.end_array();
    json.member("return_time", cycle.return_time);
    json.member("mean_S", cycle.mean);
    json.member("mean_S_per_impact", mean_spin_per_impact(cycle));
    write_multipliers(json, cycle.multipliers);
    json.member("index", std::int64_t{cycle.index});
    json.member("stability", analysis::name_of(cycle.stability));
    json.member("residual", cycle.residual);
    write_word(json, "word", cycle.word);
    write_family(json, map, cycle);
    json.end_object();
}

constexpr const char* none_reason =
    "no cycle exists: with e < 1 every impact lowers J (without friction) or the energy (without swirl)";

}  // namespace

Settings orbits_settings(const OrbitsOptions& options) {
    const auto [first, last] = options.periods();
    return {{"first_period", std::int64_t{first}},
            {"last_period", std::int64_t{last}},
            {"near", options.near},
            {"pin", options.pin},
            {"starts", options.candidates.starts},
            {"trajectories", options.candidates.trajectories},
            {"collisions", options.candidates.collisions},
            {"seed", options.candidates.seed}};
}

void write_orbits_document(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found) {
    const auto map = shooting_map_of(scene);
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    write_json(json, "scene", scene_settings(scene));
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    json.key("orbits");
    json.begin_array(JsonLayout::rows);
    for (const auto& cycle : found.cycles) write_cycle(json, map, cycle);
    json.end_array();
    json.member("candidates", found.tried);
    json.member("converged", found.converged);
    if (found.none_exist) json.member("none_exist", none_reason);
    if (!options.near.empty()) {
        json.member("iterations", std::int64_t{found.iterations});
        json.member("residual", found.reached);
        json.key("distance");
        if (found.cycles.empty())
            json.null();
        else
            json.value(found.distance);
    }
    if (!found.limits.empty()) {
        json.key("limits");
        json.begin_array();
        for (const auto& limit : found.limits) json.value(std::string_view(limit));
        json.end_array();
    }
    json.member("outcome", found.interrupted ? "interrupted" : "completed");
    write_json(json, "settings", orbits_settings(options));
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
}

void print_orbits(const Scene<double>& scene, const FoundOrbits& found) {
    fmt::print("{}\n  {} candidates, {} led to a cycle{}\n", describe(scene), found.tried, found.converged,
               found.interrupted ? "; interrupted" : "");
    for (const auto& limit : found.limits) fmt::print("  {}\n", limit);
    if (std::isfinite(found.distance)) fmt::print("  nearest point of a cycle at {:.3g} from --near\n", found.distance);
    if (found.cycles.empty()) {
        fmt::print("  {}\n", found.none_exist ? none_reason : "no cycle found");
        return;
    }
    fmt::print("  {:>6} {:>16} {:>16} {:>14} {:>9} {:>14}  stability\n", "period", "S", "mean S", "return time",
               "residual", "|multiplier|");
    for (const auto& c : found.cycles)
        fmt::print("  {:>6} {:>16.12f} {:>16.12f} {:>14.10f} {:>9.1e} {:>14.10f}  {}{}\n", c.period(),
                   c.points.front().tail(1)[0], c.mean, c.return_time, c.residual, std::abs(c.multipliers.front()),
                   analysis::name_of(c.stability),
                   c.is_family() ? fmt::format(", a family of {}", c.tangents.cols()) : "");
}

void write_orbits_record(RecordWriter& record, const OrbitsOptions& options, const Scene<double>& scene,
                         const FoundOrbits& found) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), scene_settings(scene));
    write_attributes(root.group("settings"), orbits_settings(options));
    const RecordGroup group = root.group("orbits");
    const std::size_t count = found.cycles.size(), d = scene.is_disk() ? 4 : 5;
    if (count > 0) {
        std::size_t longest = 1;
        for (const auto& c : found.cycles) longest = std::max(longest, c.period());
        group.dimension("orbit", count);
        group.dimension("multiplier_index", d);
        group.dimension("phase", longest);
        group.dimension("coordinate", d);
        std::vector<std::string> names(scene.is_disk() ? disk_names : polygon_names,
                                       (scene.is_disk() ? disk_names : polygon_names) + d);
        group.write_strings("coordinate", {"coordinate"}, names);
        std::vector<std::int64_t> period, index, family;
        std::vector<double> spin, time, residual, re, im, points;
        std::vector<std::string> stability;
        for (const auto& c : found.cycles) {
            period.push_back(static_cast<std::int64_t>(c.period()));
            index.push_back(c.index);
            family.push_back(c.tangents.cols());
            spin.push_back(c.mean);
            time.push_back(c.return_time);
            residual.push_back(c.residual);
            stability.emplace_back(analysis::name_of(c.stability));
            for (const auto& m : c.multipliers) {
                re.push_back(m.real());
                im.push_back(m.imag());
            }
            for (std::size_t i = 0; i < longest; ++i)
                for (std::size_t j = 0; j < d; ++j)
                    points.push_back(i < c.period() ? c.points[i][static_cast<Eigen::Index>(j)]
                                                    : std::numeric_limits<double>::quiet_NaN());
        }
        group.write<std::int64_t>("period", {"orbit"}, period, {"1", "k", {}});
        group.write<std::int64_t>("index", {"orbit"}, index, {"1", "multipliers outside the unit circle", {}});
        group.write<std::int64_t>("family", {"orbit"}, family, {"1", "parameters of the family; 0: isolated", {}});
        group.write<double>("mean_S", {"orbit"}, spin, {"omega_s", "time mean of S", {}});
        group.write<double>("return_time", {"orbit"}, time, {"1/omega_s", "sum of the flights", {}});
        group.write<double>("residual", {"orbit"}, residual, {"1", "largest |F(z_i) - z_(i+1)|", {}});
        group.write_strings("stability", {"orbit"}, stability);
        group.write<double>("multiplier_re", {"orbit", "multiplier_index"}, re, {"1", "real part", {}});
        group.write<double>("multiplier_im", {"orbit", "multiplier_index"}, im, {"1", "imaginary part", {}});
        group.write<double>("points", {"orbit", "phase", "coordinate"}, points,
                            {"1", "section points; NaN beyond the period", {}});
    }
    record.finish();
}

}  // namespace swirl::apps::orbits
