// One description of a result gives its JSON, its record and its table.
#include "apps/output/write_table.hpp"
#include "apps/record/record_reader.hpp"
#include "tests/apps/record/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace swirl::tests {
namespace {

using apps::Field;
using apps::JsonWriter;
using apps::no_column;
using apps::Table;

enum class Colour { red, green };
std::string_view name_of(Colour colour) {
    return colour == Colour::red ? "red" : "green";
}

struct Ball {
    std::int64_t number = 0;
    double mass = 0;
    Colour colour = Colour::red;
    std::uint64_t seed = 0;
    std::vector<double> bounces;
    std::int64_t period = 0;
};

const std::vector<Ball> balls = {{1, 0.5, Colour::green, 18446744073709551615u, {1, 2}, 0},
                                 {2, 2.25, Colour::red, 7, {3}, 4}};

Table<Ball> ball_table(bool with_mass = true) {
    using F = Field<Ball>;
    const auto period = [](const Ball& ball) { return ball.period > 0 ? std::optional(ball.period) : std::nullopt; };
    return {{"ball"},
            {F{"number", &Ball::number, "1", "number of the ball"}.coordinate().shown("no", "{:>3}"),
             F{"mass", &Ball::mass, "kg", "mass at rest"}.shown("mass", " {:>8.3f}").when(with_mass),
             F{"colour", &Ball::colour, "", "colour"}.flags({"red", "green"}).shown("colour", "  {}"),
             F{"seed", &Ball::seed, "", "seed"}.stored_as(apps::ElementType::string),
             F{"bounces", &Ball::bounces, "m", "heights"}.along({"bounce"}, 2).json_if([](const Ball& b) {
                 return b.number == 1;
             }),
             F{"period", &Ball::period, "1", "period"}.json_as(period).shown("period", apps::dash_for_zero(" {:>6}")),
             {"place", [](JsonWriter& json, const Ball& ball) { json.array(std::vector<double>(1, ball.mass)); }}},
            {"seed"},
            {"number", "period", "mass"}};
}

std::string json_of(const Table<Ball>& table) {
    std::string text;
    JsonWriter json(text);
    json.begin_object();
    write_json(json, "balls", table, balls);
    json.end_object();
    json.finish();
    return text;
}

TEST(Table, JsonHasAnObjectPerRow) {
    EXPECT_EQ(json_of(ball_table()),
              R"({"balls": [
    {"number": 1, "mass": 0.5, "colour": "green", "seed": 18446744073709551615, "bounces": [1, 2], "period": null, )"
              R"("place": [0.5]},
    {"number": 2, "mass": 2.25, "colour": "red", "seed": 7, "period": 4, "place": [2.25]}
  ]}
)");
    EXPECT_EQ(json_of(ball_table(false)).find("mass"), std::string::npos);
}

TEST(Table, JsonListsHaveAFieldEach) {
    std::string text;
    JsonWriter json(text);
    json.begin_object();
    write_lists(json, Table<Ball>{{"ball"}, {{"mass", &Ball::mass, no_column}, {"colour", &Ball::colour, no_column}}},
                balls);
    json.end_object();
    json.finish();
    EXPECT_EQ(text, "{\"mass\": [0.5, 2.25], \"colour\": [\"green\", \"red\"]}\n");
}

TEST(Table, RecordHasADatasetPerField) {
    const ScratchFolder folder;
    const auto path = folder / "balls.h5";
    apps::RecordWriter record(path, {"balls", "1", "generic"});
    const auto group = record.root().group("balls");
    group.dimension("bounce", 2);
    write_record(group, ball_table(), balls);
    record.finish();
    const apps::RecordReader reader(path);
    EXPECT_EQ(reader.datasets("/balls"),
              (std::vector<std::string>{"ball", "bounces", "colour", "mass", "period", "seed"}));
    EXPECT_EQ(reader.read<std::int64_t>("/balls/ball"), (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(reader.read<double>("/balls/mass"), (std::vector<double>{0.5, 2.25}));
    EXPECT_EQ(reader.info("/balls/mass").description.units, "kg");
    EXPECT_EQ(reader.info("/balls/mass").description.long_name, "mass at rest");
    EXPECT_EQ(reader.read<std::uint8_t>("/balls/colour"), (std::vector<std::uint8_t>{1, 0}));
    EXPECT_EQ(reader.read<std::int64_t>("/balls/period"), (std::vector<std::int64_t>{0, 4}));
    EXPECT_EQ(reader.read_strings("/balls/seed"), (std::vector<std::string>{"18446744073709551615", "7"}));
    const auto bounces = reader.read<double>("/balls/bounces");
    ASSERT_EQ(bounces.size(), 4u);
    EXPECT_EQ(bounces[2], 3);
    EXPECT_TRUE(std::isnan(bounces[3])) << "a short list is filled up";
}

/// Rows that fill several pieces, along one dimension and along two, whose inner one divides no piece; with lists.
TEST(Table, LongColumnsAreWhole) {
    constexpr std::size_t outer = 71, inner = 73, length = 3;
    std::vector<Ball> many;
    for (std::size_t i = 0; i < outer * inner; ++i) {
        Ball ball = balls[0];
        ball.mass = static_cast<double>(i);
        ball.bounces = {ball.mass, -ball.mass, 0.5};
        many.push_back(ball);
    }
    const auto fields = [] {
        return std::vector<Field<Ball>>{{"mass", &Ball::mass, "kg", "mass at rest"},
                                        Field<Ball>{"bounces", &Ball::bounces, "s", "when"}.along({"bounce"}, length)};
    };
    const ScratchFolder folder;
    const auto path = folder / "balls.h5";
    apps::RecordWriter record(path, {"balls", "1", "generic"});
    const auto line = record.root().group("line"), plane = record.root().group("plane");
    line.dimension("bounce", length);
    write_record(line, Table<Ball>{{"ball"}, fields()}, many);
    plane.dimension("bounce", length);
    plane.dimension("row", outer);
    plane.dimension("column", inner);
    write_columns(plane, Table<Ball>{{"row", "column"}, fields()}, many);
    record.finish();
    const apps::RecordReader reader(path);
    for (const std::string group : {"/line", "/plane"}) {
        const auto masses = reader.read<double>(group + "/mass"), bounces = reader.read<double>(group + "/bounces");
        ASSERT_EQ(masses.size(), many.size()) << group;
        ASSERT_EQ(bounces.size(), length * many.size()) << group;
        for (std::size_t i = 0; i < many.size(); ++i) {
            ASSERT_EQ(masses[i], many[i].mass) << group << ' ' << i;
            for (std::size_t k = 0; k < length; ++k) ASSERT_EQ(bounces[length * i + k], many[i].bounces[k]) << group;
        }
    }
}

TEST(Table, AColumnHasUnitsAndAMeaningOrIsMarkedAsNone) {
    using Mass = decltype(&Ball::mass);
    static_assert(std::is_constructible_v<Field<Ball>, const char*, Mass, const char*, const char*>);
    static_assert(std::is_constructible_v<Field<Ball>, const char*, Mass, apps::NoColumn>);
    static_assert(!std::is_constructible_v<Field<Ball>, const char*, Mass, const char*>);
    static_assert(!std::is_constructible_v<Field<Ball>, const char*, Mass>);
    const ScratchFolder folder;
    const auto path = folder / "balls.h5";
    const Table<Ball> table{{"ball"}, {{"mass", &Ball::mass, no_column}, {"number", &Ball::number, "1", "number"}}};
    apps::RecordWriter record(path, {"balls", "1", "generic"});
    write_record(record.root().group("balls"), table, balls);
    write_attributes(record.root().group("ball"), table, balls[0]);
    record.finish();
    const apps::RecordReader reader(path);
    EXPECT_EQ(reader.datasets("/balls"), std::vector<std::string>{"number"});
    EXPECT_EQ(reader.attribute<double>("/ball", "mass"), 0.5);
}

TEST(Table, RowsThatComeOneByOneMakeTheSameDatasets) {
    const ScratchFolder folder;
    const auto path = folder / "balls.h5";
    apps::RecordWriter record(path, {"balls", "1", "generic"});
    const Table<Ball> table{
        {"ball"},
        {Field<Ball>{"number", &Ball::number, "1", "number"}.coordinate(), {"mass", &Ball::mass, "kg", "mass"}}};
    apps::RecordRows<Ball> rows(record.root().group("balls"), table);
    for (const auto& ball : balls) rows.add(ball);
    record.finish();
    const apps::RecordReader reader(path);
    EXPECT_EQ(reader.read<std::int64_t>("/balls/ball"), (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(reader.read<double>("/balls/mass"), (std::vector<double>{0.5, 2.25}));
}

TEST(Table, PeopleSeeWhatIsShownInItsOwnOrder) {
    const auto table = shown_fields(ball_table());
    EXPECT_EQ(heading_of(table), " no period     mass  colour\n");
    EXPECT_EQ(line_of(table, balls[0]), "  1      -    0.500  green\n");
    EXPECT_EQ(line_of(table, balls[1]), "  2      4    2.250  red\n");
    EXPECT_EQ(line_of(shown_fields(ball_table(false)), balls[1]), "  2      4  red\n")
        << "an order may name what is left out";
}

TEST(Table, OneRowAsLinesListsItsFiniteNumbers) {
    Ball ball = balls[0];
    EXPECT_EQ(lines_of(ball_table(), ball), "  mass                                           0.5\n");
    ball.mass = std::numeric_limits<double>::infinity();
    EXPECT_EQ(lines_of(ball_table(), ball), "");
}

TEST(Table, AnOrderOfUnknownNamesIsRefused) {
    auto table = ball_table();
    table.first_in_table = {"weight"};
    EXPECT_THROW(shown_fields(table), std::logic_error);
}

TEST(Table, ATextThatIsNoFlagIsRefused) {
    const ScratchFolder folder;
    apps::RecordWriter record(folder / "balls.h5", {"balls", "1", "generic"});
    const Table<Ball> table{{"ball"}, {Field<Ball>{"colour", &Ball::colour, "", "colour"}.flags({"red", "blue"})}};
    EXPECT_THROW(write_record(record.root().group("balls"), table, balls), std::logic_error);
}

TEST(Table, ShowsNumbersInTheUsersUnitsAndADashForWhatIsNotThere) {
    struct Motion {
        double time, speed, angle;
    };
    const Table<Motion> table{{"motion"},
                              {Field<Motion>{"t", &Motion::time, "1/omega_s", "time"}.shown("t", " {:>6.2f}"),
                               Field<Motion>{"v", &Motion::speed, "R_c omega_s", "speed"}.shown("v", " {:>6.2f}"),
                               Field<Motion>{"psi", &Motion::angle, "rad", "angle"}.shown("psi", " {:>6.2f}")}};
    const Motion motion{3, 0.5, std::numeric_limits<double>::quiet_NaN()};
    const auto line = [&](const std::optional<apps::Units>& units) {
        return line_of(shown_fields(in_units(table, units)), motion);
    };
    EXPECT_EQ(line({}), "   3.00   0.50      -\n");
    EXPECT_EQ(line(apps::Units{2, 0.25, 8}), "   0.75   4.00      -\n");
}

TEST(Units, ScaleByWhatTheUnitsOfAColumnSay) {
    const apps::Units units{2, 0.25, 8};  // R_c, 1/omega_s, m
    const auto scale = [&](const char* unit) { return apps::physical_scale(units, unit); };
    EXPECT_EQ(scale("R_c"), 2);
    EXPECT_EQ(scale("omega_s"), 4);
    EXPECT_EQ(scale("1/omega_s"), 0.25);
    EXPECT_EQ(scale("R_c omega_s"), 8);
    EXPECT_EQ(scale("m R_c^2 omega_s^2"), 8 * 4 * 16);
    for (const char* none : {"", "1", "rad", "s", "R_c rad", "omega"}) EXPECT_FALSE(scale(none)) << none;
}

}  // namespace
}  // namespace swirl::tests
