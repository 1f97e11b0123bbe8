#include "tests/apps/record/sample_record.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "apps/record/record_writer.hpp"

namespace swirl::tests {

namespace {

using apps::growing;
using apps::RecordGroup;

void write_root(const RecordGroup& root) {
    root.attribute("seed", std::uint64_t{18446744073709551615U});
    root.attribute("alpha", 0.4);
    root.attribute("sides", 6);
    root.attribute("quiet", true);
    root.attribute("law", "poisson");
    root.attribute("start", std::vector<double>{0.5, -0.0, 1e-320});
    root.attribute("grid", std::vector<std::int64_t>{41, 41});
    root.attribute("names", std::vector<std::string>{"α", "β", ""});
    root.attribute("nothing", std::vector<double>{});
    root.dimension("mode", 3);
    root.write_strings("mode", {"mode"}, std::vector<std::string>{"steady", "quasi-steady", "chaotic"},
                       {"", "mode", {}});
    root.write<double>("share", {"mode"}, {0.25, 0.25, 0.5}, {"1", "share of the runs in each mode", {}});
    root.write<double>("mean_S", {}, {1.5}, {"1", "time mean of the spin over the swirl's rate", {}});
}

void write_impacts(const RecordGroup& group) {
    group.dimension("impact", growing);
    group.dimension("axis", 2);
    const auto t = group.column<double>("t", {"impact"}, {"1", "time of the impact", {}});
    auto position = group.column<double>("position", {"impact", "axis"}, {"1", "the centre, lab frame", {}});
    auto vertex = group.column<std::int32_t>("vertex", {"impact"}, {"1", "vertex that struck", {}});
    auto mode = group.column<std::uint8_t>("contact_mode", {"impact"}, {"", "contact mode", {"sliding", "c-sticking"}});
    auto simultaneous = group.column<bool>("simultaneous", {"impact"}, {"1", "another vertex struck, too", {}});
    auto turns = group.column<std::int64_t>("turns", {"impact"}, {"1", "turns", {}});
    auto time = t;
    for (int i = 0; i < sample_rows; ++i) {
        time.append(0.5 * i);
        position.append(std::vector<double>{std::sqrt(i), -1.0 * i});
        vertex.append(i % 6);
        mode.append(static_cast<std::uint8_t>(i % 2));
        simultaneous.append(i % 3 == 0);
        turns.append(std::int64_t{1} << (i % 63));
    }
    group.attribute("coordinates", "t");
}

void write_grid(const RecordGroup& group) {
    group.dimension("alpha", 3);
    group.dimension("beta", 4);
    group.dimension("run", 5);
    group.dimension("coordinate", 2);
    group.write<double>("alpha", {"alpha"}, {0.1, 0.2, 0.3}, {"1", "polygon radius over container radius", {}});
    group.write<double>("beta", {"beta"}, {0.0, 0.5, 1.0, 5.0}, {"1", "swirl radius over container radius", {}});
    std::vector<double> values(120);
    std::iota(values.begin(), values.end(), 0.0);
    values[7] = NAN;
    group.write<double>("z", {"alpha", "beta", "run", "coordinate"}, values, {"1", "final section point", {}});
    group.write<double>("mean_S", {"alpha", "beta"}, std::span(values).first(12), {"1", "mean spin", {}});
}

}  // namespace

void write_sample_record(const std::filesystem::path& path) {
    apps::RecordWriter writer(path, {"a sample", "0.1.0", "x86-64"});
    write_root(writer.root());
    write_impacts(writer.root().group("impacts"));
    write_grid(writer.root().group("sweep").group("cells"));
    const RecordGroup empty = writer.root().group("empty");
    empty.dimension("impact", growing);
    empty.write<double>("S", {"impact"}, std::vector<double>{}, {"1", "spin", {}});
    writer.finish();
}

}  // namespace swirl::tests
