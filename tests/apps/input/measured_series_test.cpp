#include "apps/input/measured_series.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/input/measured_motion.hpp"
#include "tests/apps/input/written_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace swirl::apps;
using swirl::tests::WrittenFile;
using testing::HasSubstr;
using Numbers = std::vector<double>;

MeasuredSeries read(const std::string& content, const std::string& column = "", const std::string& time = "",
                    double spacing = 1) {
    const WrittenFile file(content);
    SeriesChoice choice;
    choice.file = file.path();
    choice.column = column;
    choice.time = time;
    choice.spacing = spacing;
    return read_series(choice);
}

std::string refusal(const std::string& content, const std::string& column = "", const std::string& time = "") {
    try {
        read(content, column, time);
    } catch (const BadInput& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(MeasuredSeries, OneColumnIsTheValuesAtUnitSpacing) {
    const auto series = read("3\n1\n2\n");
    EXPECT_EQ(series.values, (Numbers{3, 1, 2}));
    EXPECT_EQ(series.times, (Numbers{0, 1, 2}));
    EXPECT_EQ(series.column, "1");
    EXPECT_EQ(series.time, "");
    EXPECT_TRUE(series.even);
    EXPECT_EQ(read("3\n1\n2\n", "", "", 0.5).times, (Numbers{0, 0.5, 1}));
}

TEST(MeasuredSeries, WithoutAHeaderTheFirstOfSeveralColumnsIsTheTime) {
    const auto series = read("10 1 5\n20 2 6\n30 3 7\n");
    EXPECT_EQ(series.times, (Numbers{10, 20, 30}));
    EXPECT_EQ(series.values, (Numbers{5, 6, 7}));
    EXPECT_EQ(read("10 1 5\n20 2 6\n", "1", "none").values, (Numbers{10, 20}));
    EXPECT_EQ(read("10 1 5\n20 2 6\n", "1", "2").times, (Numbers{1, 2}));
}

TEST(MeasuredSeries, AHeadersTimeMayComeAnywhereWithAUnit) {
    for (const std::string name : {"t", "Time", "time [s]", "t_ms", "T"}) {
        const auto series = read("a," + name + "\n7,1\n8,2\n");
        EXPECT_EQ(series.time, name);
        EXPECT_EQ(series.column, "a");
    }
    for (const std::string name : {"theta", "timer", "t2"}) EXPECT_EQ(read(name + ",b\n7,1\n8,2\n").time, "") << name;
}

TEST(MeasuredSeries, TheSpinIsTakenBeforeTheLastColumn) {
    EXPECT_EQ(read("t,S,x\n0,1,2\n1,3,4\n").column, "S");
    EXPECT_EQ(read("t,y,x\n0,1,2\n1,3,4\n").column, "x");
    EXPECT_EQ(read("t,S,x\n0,1,2\n1,3,4\n", "x").column, "x");
}

TEST(MeasuredSeries, GapsStayAndAreCounted) {
    const auto series = read("t,S\n0,1\n1,\n2,nan\n3,4\n");
    EXPECT_EQ(series.missing, 2u);
    EXPECT_TRUE(std::isnan(series.values[1]) && std::isnan(series.values[2]));
    EXPECT_THAT(refusal("t,S\n0,1\n1,\n"), HasSubstr("1 values; at least 2"));
}

TEST(MeasuredSeries, TimesThatAreEvenUpToPrintingAreEven) {
    // 30 frames a second in whole milliseconds: half a millisecond off, and the grid through both ends as much again.
    std::string frames = "t,S\n";
    for (int i = 0; i < 60; ++i)
        frames += std::to_string(std::lround(i * 1000 / 30.0)) + "," + std::to_string(i) + "\n";
    EXPECT_TRUE(read(frames).even);
    EXPECT_LE(read(frames).largest_deviation, 0.03);
    EXPECT_GT(read(frames).largest_deviation, 0);
}

TEST(MeasuredSeries, ARowThatIsLostBetweenEvenTimesIsAGap) {
    std::string dropped = "t,S\n";
    for (int i = 0; i < 60; ++i)
        if (i != 20 && i != 40 && i != 41)
            dropped += std::to_string(std::lround(i * 1000 / 30.0)) + "," + std::to_string(i) + "\n";
    const auto series = read(dropped);
    EXPECT_TRUE(series.even);
    EXPECT_EQ(series.rows, 57u);
    EXPECT_EQ(series.missing, 3u);
    EXPECT_EQ(series.gaps, 2u);
    ASSERT_EQ(series.values.size(), 60u);
    for (std::size_t i = 0; i < 60; ++i) {
        EXPECT_NEAR(series.times[i], static_cast<double>(i) * 1000 / 30, 0.5 + 1e-9);
        if (i == 20 || i == 40 || i == 41)
            EXPECT_TRUE(std::isnan(series.values[i]));
        else
            EXPECT_EQ(series.values[i], static_cast<double>(i));
    }
}

TEST(MeasuredSeries, ALongBreakIsOneMissingSampleAndUnevenTimesStay) {
    std::string broken = "t,S\n";
    for (int i = 0; i < 60; ++i) broken += std::to_string(i < 30 ? i : i + 1'000'000'000) + ",1\n";
    const auto series = read(broken);
    EXPECT_EQ(series.values.size(), 61u);  // no thousand million rows of nothing
    EXPECT_EQ(series.gaps, 1u);
    EXPECT_TRUE(std::isnan(series.values[30]));
    EXPECT_EQ(series.times[30], 30);
    EXPECT_EQ(read("t,S\n0,1\n1,2\n3,3\n4,4\n6,5\n").missing, 0u);
}

TEST(MeasuredSeries, LongStepsOfImpactsAreFlights) {
    // One flight in eleven takes twice as long.
    std::string impacts = "t,S\n";
    for (int i = 0, t = 0; i < 200; t += i % 11 == 10 ? 2 : 1, ++i)
        impacts += std::to_string(t) + "," + std::to_string(i % 10) + "\n";
    const WrittenFile file(impacts);
    SeriesChoice choice;
    choice.file = file.path();
    for (const LongSteps meaning : {LongSteps::maybe, LongSteps::long_flights}) {  // 9 % are no lost frames
        choice.long_steps = meaning;
        EXPECT_EQ(read_series(choice).missing, 0u);
    }
    choice.long_steps = LongSteps::lost_rows;
    EXPECT_EQ(read_series(choice).missing, 18u);
}

TEST(MeasuredSeries, FramesLostFromTimesOfFewDigitsAreFound) {
    std::string film = "t,theta\n";
    for (int i = 0; i < 600; ++i) {
        if (i == 100 || i == 200 || i == 201) continue;
        film += std::to_string(std::round(i * 100 / 30.0) / 100) + ",0.5\n";
    }
    const WrittenFile file(film);
    SeriesChoice choice;
    choice.file = file.path();
    choice.angle = "theta";
    const auto series = read_series(choice);
    EXPECT_EQ(series.angle.values.size(), 600u);
    EXPECT_EQ(series.gaps, 2u);
    EXPECT_NEAR(series.spacing, 1 / 30.0, 2e-5);
}

TEST(MeasuredSeries, TheLastDigitOfValues) {
    EXPECT_EQ(decimal_resolution({1, 20, -3}), 1);
    EXPECT_EQ(decimal_resolution({0.25, 1e-3, std::nan("")}), 1e-3);
    EXPECT_EQ(decimal_resolution({359.9999, 0.1}), 1e-4);
    EXPECT_EQ(decimal_resolution({1 / 3.0, 0.1}), 0);
    EXPECT_EQ(decimal_resolution({std::sqrt(2.0) * 1e5}), 0);
}

TEST(MeasuredSeries, TheStepThatValuesWereRoundedTo) {
    EXPECT_NEAR(rounding_step({0.1234, 3.0001, std::nan(""), -2.5}), 1e-4, 1e-12);
    EXPECT_NEAR(rounding_step({101.5, 640, 33.5, 7}), 0.5, 1e-12);                 // middles of boxes
    EXPECT_NEAR(rounding_step({0.12 + 0.7, 0.5 + 0.7, 0.32 + 0.7}), 0.02, 1e-12);  // from another origin
    EXPECT_EQ(rounding_step({1 / 3.0, 0.1, std::sqrt(2.0)}), 0);
    EXPECT_EQ(rounding_step({4, 4, 4}), 0);
    EXPECT_EQ(rounding_step({}), 0);
}

TEST(MeasuredSeries, TimesMustRise) {
    EXPECT_THAT(refusal("t,S\n0,1\n1,2\n1,3\n"), HasSubstr("line 4: time 1 repeats 1 of line 3"));
    EXPECT_THAT(refusal("t,S\n0,1\n2,2\n1,3\n"), HasSubstr("line 4: time 1 falls behind 2 of line 3"));
    EXPECT_THAT(refusal("t,S\n0,1\nnan,2\n"), HasSubstr("line 3: 'nan' in column t is not a number"));
    EXPECT_EQ(read("t,S\n0,1\n0,2\n", "", "none").values, (Numbers{1, 2}));
}

// S of an angle lies halfway between its times; halves of the last digit are rounded to the same time.
TEST(MeasuredSeries, TimesOfAnAngleMustBeToldApart) {
    for (const std::string end : {"1.0000000000000011,5", "1.0000000000000011,5\n2,5.5"}) {
        const WrittenFile file("t,angle\n1.0000000000000007,3\n1.0000000000000009,4\n" + end + "\n");
        SeriesChoice choice;
        choice.file = file.path();
        choice.angle = "angle";
        EXPECT_THAT(
            [&] { read_series(choice); },
            testing::ThrowsMessage<BadInput>(HasSubstr("have the same time after rounding, 1.0000000000000009")));
    }
}

TEST(MeasuredSeries, ValuesAreOfASizeThatCanBeReckonedWith) {
    EXPECT_THAT(refusal("t,S\n0,1\n1,-1e308\n2,1\n"), HasSubstr("line 3: -1e+308 in column S is outside its range: "
                                                                "-1e+75 to 1e+75; the line reads '1,-1e308'"));
    EXPECT_THAT(refusal("t,S\n-1e308,1\n1e308,2\n"), HasSubstr("line 2: -1e+308 in column t"));
    EXPECT_THAT(refusal("1e-200\n-3e-200\n2e-200\n"),
                HasSubstr("the largest value of column 1, 3e-200, is outside its range: 0, or 1e-75 to 1e+75"));
    EXPECT_EQ(read("1e75\n-1e75\n").values, (Numbers{1e75, -1e75}));
    EXPECT_EQ(read("1e-200\n1e-75\n0\n").values, (Numbers{1e-200, 1e-75, 0}));
    EXPECT_EQ(read("0\n0\n").values, (Numbers{0, 0}));
    EXPECT_THROW(part_of(read("1\n1e-200\n2e-200\n"), 1, 2), BadInput);
    EXPECT_THROW(read("1\n2\n", "", "", 1e308), BadInput);
}

TEST(MeasuredSeries, APartIsDescribedByItself) {
    const auto series = read("t,S\n0,1\n1,2\n2,\n4,5\n");
    const auto part = part_of(series, 0, 2);
    EXPECT_EQ(part.values, (Numbers{1, 2}));
    EXPECT_EQ(part.missing, 0u);
    EXPECT_TRUE(part.even);
    EXPECT_FALSE(series.even);
    EXPECT_THROW(part_of(series, 1, 2), BadInput);  // one value
}

TEST(MeasuredSeries, TheCircleFittedToItsPointsIsTheCircle) {
    Numbers x, y;
    for (int i = 0; i < 7; ++i) {  // less than half of it
        x.push_back(300 + 40 * std::cos(0.3 * i));
        y.push_back(-200 + 40 * std::sin(0.3 * i));
    }
    x.push_back(std::nan(""));
    y.push_back(0);
    const auto circle = fitted_circle(x, y);
    EXPECT_NEAR(circle.centre[0], 300, 1e-10);
    EXPECT_NEAR(circle.centre[1], -200, 1e-10);
    EXPECT_NEAR(circle.radius, 40, 1e-10);
    EXPECT_LT(circle.residual, 1e-10);
    EXPECT_THROW(fitted_circle({0, 1, 2}, {0, 2, 4}), BadInput);
    EXPECT_THROW(fitted_circle({0, 1}, {0, 2}), BadInput);
}

TEST(MeasuredSeries, AFilmMayHaveAFewRoundedTimes) {
    std::string film = "t,S\n", flights = "t,S\n";
    double time = 0;
    for (int i = 0; i < 1000; ++i) {
        film += std::to_string(time) + ",1\n";
        time += i < 100 && i % 11 == 5 ? 0.105 : 0.1;
        flights += std::to_string(i * 0.1 + (i % 2) * 0.006) + ",1\n";  // steps of 0.106 and 0.094: a cycle of two
    }
    EXPECT_FALSE(read(film).even);
    EXPECT_TRUE(read(film).is_film());
    EXPECT_FALSE(read(flights).is_film());
}

TEST(MeasuredSeries, NamesTellPointsAndTheirLikelihoods) {
    const WrittenFile file(
        "frame,tip.x,tip.y,tip.likelihood,X_Arena0_Ind1,Y_Arena0_Ind1,vx,vy,bbox_x_min,bbox_y_min,x\n"
        "0,1,2,3,4,5,6,7,8,9,10\n");
    const auto points = points_in(read_delimited(file.path()));
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].x, 1u);
    EXPECT_EQ(points[0].y, 2u);
    EXPECT_EQ(points[0].likelihood, 3u);
    EXPECT_EQ(points[1].x, 4u);
    EXPECT_EQ(points[1].y, 5u);
}

}  // namespace
