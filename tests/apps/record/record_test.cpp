// What is written comes back, and what cannot be written is refused.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/record/record_reader.hpp"
#include "apps/record/record_writer.hpp"
#include "tests/apps/record/sample_record.hpp"
#include "tests/apps/record/scratch_folder.hpp"

namespace swirl::tests {
namespace {

using apps::ElementType;
using apps::growing;
using apps::RecordReader;
using apps::RecordWriter;

const apps::RecordHeader header{"a test", "0.1.0", "x86-64"};
const apps::Description number{"1", "a number", {}};

using Names = std::vector<std::string>;

TEST(Record, AttributesOfEveryTypeComeBack) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const RecordReader reader(folder / "a.h5");
    EXPECT_EQ(reader.schema_version(), apps::record_schema_version);
    EXPECT_EQ(reader.attribute<std::string>("/", "title"), "a sample");
    EXPECT_EQ(reader.attribute<std::string>("/", "swirl_version"), "0.1.0");
    EXPECT_EQ(reader.attribute<std::string>("/", "instruction_set"), "x86-64");
    EXPECT_EQ(reader.attribute<std::uint64_t>("/", "seed"), 18446744073709551615U);
    EXPECT_EQ(reader.attribute<double>("/", "alpha"), 0.4);
    EXPECT_EQ(reader.attribute<std::int64_t>("/", "sides"), 6);
    EXPECT_EQ(reader.attribute<bool>("/", "quiet"), true);
    EXPECT_EQ(reader.attribute<std::string>("/", "law"), "poisson");
    EXPECT_EQ(reader.attribute<std::vector<std::int64_t>>("/", "grid"), (std::vector<std::int64_t>{41, 41}));
    EXPECT_EQ(reader.attribute<Names>("/", "names"), (Names{"α", "β", ""}));
    EXPECT_TRUE(reader.attribute<std::vector<double>>("/", "nothing").empty());
    const auto start = reader.attribute<std::vector<double>>("/", "start");
    ASSERT_EQ(start.size(), 3U);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(start[1]), std::bit_cast<std::uint64_t>(-0.0));
    EXPECT_EQ(start[2], 1e-320);
    EXPECT_EQ(reader.attributes("/").size(), 13U);
    EXPECT_FALSE(reader.has_attribute("/", "no such"));
}

TEST(Record, GroupsDatasetsAndDimensionsAreListed) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const RecordReader reader(folder / "a.h5");
    EXPECT_EQ(reader.groups(), (Names{"empty", "impacts", "sweep"}));
    EXPECT_EQ(reader.groups("/sweep"), Names{"cells"});
    EXPECT_EQ(reader.datasets(), (Names{"mean_S", "mode", "share"}));
    // "impact" and "axis" are dimensions without coordinates, "alpha" has one.
    EXPECT_EQ(reader.datasets("/impacts"), (Names{"contact_mode", "position", "simultaneous", "t", "turns", "vertex"}));
    EXPECT_EQ(reader.datasets("/sweep/cells"), (Names{"alpha", "beta", "mean_S", "z"}));
    EXPECT_TRUE(reader.contains("/sweep/cells/z"));
    EXPECT_FALSE(reader.contains("/no/such"));
    const apps::DatasetInfo z = reader.info("/sweep/cells/z");
    EXPECT_EQ(z.type, ElementType::float64);
    EXPECT_EQ(z.shape, (std::vector<std::uint64_t>{3, 4, 5, 2}));
    EXPECT_EQ(z.dimensions, (Names{"alpha", "beta", "run", "coordinate"}));
    EXPECT_EQ(z.description.units, "1");
    EXPECT_EQ(z.description.long_name, "final section point");
    const apps::DatasetInfo mode = reader.info("/impacts/contact_mode");
    EXPECT_EQ(mode.type, ElementType::uint8);
    EXPECT_EQ(mode.description.flag_meanings, (Names{"sliding", "c-sticking"}));
    EXPECT_EQ(reader.info("/impacts/simultaneous").type, ElementType::boolean);
    EXPECT_EQ(reader.info("/sweep/cells/alpha").dimensions, Names{"alpha"});
    EXPECT_TRUE(reader.info("/mean_S").shape.empty());
    EXPECT_EQ(reader.info("/empty/S").shape, std::vector<std::uint64_t>{0});
}

TEST(Record, DatasetsOfEveryTypeComeBack) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const RecordReader reader(folder / "a.h5");
    const auto t = reader.read<double>("/impacts/t");
    const auto position = reader.read<double>("/impacts/position");
    const auto vertex = reader.read<std::int32_t>("/impacts/vertex");
    const auto mode = reader.read<std::uint8_t>("/impacts/contact_mode");
    const auto simultaneous = reader.read<bool>("/impacts/simultaneous");
    const auto turns = reader.read<std::int64_t>("/impacts/turns");
    ASSERT_EQ(t.size(), std::size_t{sample_rows});
    ASSERT_EQ(position.size(), 2 * std::size_t{sample_rows});
    for (std::size_t i = 0; i < sample_rows; ++i) {
        ASSERT_EQ(t[i], 0.5 * static_cast<double>(i));
        ASSERT_EQ(position[2 * i], std::sqrt(static_cast<double>(i)));
        ASSERT_EQ(position[2 * i + 1], -1.0 * static_cast<double>(i));
        ASSERT_EQ(vertex[i], static_cast<std::int32_t>(i % 6));
        ASSERT_EQ(mode[i], i % 2);
        ASSERT_EQ(simultaneous[i], i % 3 == 0);
        ASSERT_EQ(turns[i], std::int64_t{1} << (i % 63));
    }
    EXPECT_EQ(reader.read<std::int64_t>("/impacts/vertex")[5], 5);  // into a wider type
    EXPECT_EQ(reader.read_strings("/mode"), (Names{"steady", "quasi-steady", "chaotic"}));
    EXPECT_EQ(reader.read<double>("/mean_S"), std::vector<double>{1.5});
    EXPECT_TRUE(reader.read<double>("/empty/S").empty());
    const auto z = reader.read<double>("/sweep/cells/z");
    EXPECT_TRUE(std::isnan(z[7]));
    EXPECT_EQ(z[119], 119.0);
}

TEST(Record, PartsOfADatasetAreRead) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const RecordReader reader(folder / "a.h5");
    EXPECT_EQ(reader.read<double>("/impacts/t", {{16383}, {3}}), (std::vector<double>{8191.5, 8192.0, 8192.5}));
    EXPECT_EQ(reader.read<double>("/sweep/cells/z", {{1, 2, 0, 1}, {2, 1, 2, 1}}),
              (std::vector<double>{61.0, 63.0, 101.0, 103.0}));
    EXPECT_TRUE(reader.read<double>("/impacts/t", {{sample_rows}, {0}}).empty());
    EXPECT_EQ(message_of<apps::RecordError>([&] {
                  (void)reader.read<double>("/impacts/t", {{39999}, {2}});
              }),
              "cannot read dataset '/impacts/t' of record '" + (folder / "a.h5").string() +
                  "': offset [39999] and count [2] lie outside its shape [40000]");
}

TEST(Record, RandomDoublesKeepTheirBits) {
    const ScratchFolder folder;
    std::mt19937_64 random(20240817);
    std::vector<double> values(50000);
    for (double& value : values) value = std::bit_cast<double>(random());
    RecordWriter writer(folder / "a.h5", header);
    writer.root().dimension("i", 50);
    writer.root().dimension("j", 1000);
    writer.root().write<double>("x", {"i", "j"}, values, number);
    writer.finish();
    const auto read = RecordReader(folder / "a.h5").read<double>("/x");
    ASSERT_EQ(read.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_EQ(std::bit_cast<std::uint64_t>(read[i]), std::bit_cast<std::uint64_t>(values[i]));
    }
}

TEST(Record, RowsLargerThanAChunkComeBack) {
    const ScratchFolder folder;
    std::vector<double> values(3 * 300 * 200);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    RecordWriter writer(folder / "a.h5", header);
    writer.root().dimension("n", growing);
    writer.root().dimension("row", 300);
    writer.root().dimension("column", 200);
    auto image = writer.root().column<double>("image", {"n", "row", "column"}, number);
    for (int n = 0; n < 3; ++n)
        image.append(std::span<const double>(values).subspan(static_cast<std::size_t>(n) * 60000, 60000));
    writer.finish();
    EXPECT_EQ(RecordReader(folder / "a.h5").read<double>("/image"), values);
}

TEST(Record, ReadingNamesWhatIsNotThere) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const RecordReader reader(folder / "a.h5");
    const std::string name = "'" + (folder / "a.h5").string() + "': ";
    const auto message = [](const auto& action) { return message_of<apps::RecordError>(action); };
    EXPECT_EQ(message([&] { (void)reader.read<double>("/no/such"); }),
              "cannot read '/no/such' of record " + name + "there is nothing of that name");
    EXPECT_EQ(message([&] { (void)reader.read<double>("/impacts"); }),
              "cannot read '/impacts' of record " + name + "it is not a dataset");
    EXPECT_EQ(message([&] { (void)reader.groups("/impacts/t"); }),
              "cannot read '/impacts/t' of record " + name + "it is not a group");
    EXPECT_EQ(message([&] { (void)reader.read<std::int32_t>("/impacts/t"); }),
              "cannot read dataset '/impacts/t' of record " + name + "its type is another");
    EXPECT_EQ(message([&] { (void)reader.read<std::int32_t>("/impacts/turns"); }),
              "cannot read dataset '/impacts/turns' of record " + name + "its type is another");
    EXPECT_EQ(message([&] { (void)reader.attribute("/", "no such"); }),
              "cannot read attribute 'no such' of record " + name + "there is none of that name");
    EXPECT_EQ(message([&] { (void)reader.attribute<double>("/", "law"); }),
              "cannot read attribute 'law' of record " + name + "its type is another");
}

TEST(Record, MisuseIsRefused) {
    const ScratchFolder folder;
    RecordWriter writer(folder / "a.h5", header);
    const apps::RecordGroup root = writer.root();
    root.dimension("n", 4);
    root.dimension("g", growing);
    root.write<double>("x", {"n"}, {1, 2, 3, 4}, number);
    root.attribute("a", 1);
    const std::vector<double> three{1, 2, 3};
    using Bad = std::invalid_argument;
    EXPECT_THROW(root.attribute("a", 2), Bad);
    EXPECT_THROW(root.dimension("n", 5), Bad);
    EXPECT_THROW(root.dimension("x", 5), Bad);
    EXPECT_THROW((void)root.group("x"), Bad);
    EXPECT_THROW((void)root.group("a/b"), Bad);
    EXPECT_THROW((void)root.group(""), Bad);
    EXPECT_THROW((void)root.column<double>("x", {"n"}, number), Bad);
    EXPECT_THROW((void)root.column<double>("y", {"no such"}, number), Bad);
    EXPECT_THROW((void)root.column<double>("y", {"n", "g"}, number), Bad);
    EXPECT_THROW((void)root.column<double>("y", {"n", "n"}, number), Bad);
    EXPECT_THROW((void)root.column<double>("n", {"g"}, number), Bad);
    EXPECT_THROW((void)root.column<double>("y", {"n"}, {"seconds", "", {}}), Bad);
    EXPECT_THROW((void)root.column<double>("y", {"n"}, {"", "", {"two words"}}), Bad);
    auto y = root.column<double>("y", {"n"}, number);
    EXPECT_THROW(y.append(std::vector<double>(5)), Bad);
    auto pairs = root.column<double>("pairs", {"g", "n"}, number);
    EXPECT_THROW(pairs.append(three), Bad);
    EXPECT_THROW(writer.finish(), Bad) << "y is not full";
    y.append(std::vector<double>(4));
    auto other = root.column<double>("other", {"g"}, number);
    other.append(1.0);
    EXPECT_EQ(message_of<Bad>([&] { writer.finish(); }),
              "record '" + (folder / "a.h5").string() + "': dataset '/other': has 1 rows where 'pairs' has 0");
    pairs.append(std::vector<double>(4));
    writer.finish();
    EXPECT_THROW(root.attribute("late", 1), std::logic_error);
}

}  // namespace
}  // namespace swirl::tests
