// Named conventions and presets, on matrices small enough to check by eye, and what happens to bad input.
#include "analysis/recurrence/measures.hpp"
#include "analysis/recurrence/rates.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

BinaryMatrix matrix_of(const std::vector<std::string>& rows) {
    BinaryMatrix m{rows.size(), rows[0].size(), {}};
    for (const auto& row : rows)
        for (char c : row) m.entries.push_back(c == 'x');
    return m;
}

using Counts = std::vector<std::uint64_t>;

std::string error_of(const auto& action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

// One column, by eye: lines of 1, 3 and 2 points; white lines of 2, 1 and 2, and 1 at either border.
const std::vector<std::string> column{".", "x", ".", ".", "x", "x", "x", ".", "x", "x", "."};

TEST(RecurrenceTimes, OfOneColumnByEachDefinition) {
    Settings s;
    EXPECT_EQ(count_lines(matrix_of(column), s).recurrence_time, (Counts{0, 0, 0, 2}));  // 2 + 0 + 1 and 1 + 1 + 1
    s.recurrence_time = RecurrenceTime::line_starts;
    EXPECT_EQ(count_lines(matrix_of(column), s).recurrence_time, (Counts{0, 0, 0, 1, 1}));
    s.recurrence_time = RecurrenceTime::white_lines;
    EXPECT_EQ(count_lines(matrix_of(column), s).recurrence_time, (Counts{0, 1, 1}));
    s.border_white_lines = true;
    EXPECT_EQ(count_lines(matrix_of(column), s).recurrence_time, (Counts{0, 3, 1}));
}

TEST(BorderLines, AreDiscardedWhenAsked) {
    const BinaryMatrix m = matrix_of({"x..x", ".x..", "..x.", "x..."});
    Settings s;
    EXPECT_EQ(count_lines(m, s).diagonal, (Counts{0, 2, 0, 1}));
    EXPECT_EQ(count_lines(m, s).vertical, (Counts{0, 5}));
    s.border_lines = BorderLines::discarded;
    EXPECT_EQ(count_lines(m, s).diagonal, (Counts{0}));
    EXPECT_EQ(count_lines(m, s).vertical, (Counts{0, 2}));
}

// Series 0 0 1 0 at threshold 0.5: rows 'xx.x', 'xx.x', '..x.', 'xx.x'.
const std::vector<double> series{0, 0, 1, 0};

TEST(Presets, DifferInWhatTheWindowIsAppliedTo) {
    const auto of = [](const char* name) {
        const Settings s = preset(name);
        return measures(count_lines(embed_series(series), 0.5, s), s);
    };
    // Outside the main diagonal 6 points of 12 pairs; 10 points of 16 pairs in all.
    EXPECT_DOUBLE_EQ(of("RecurrenceAnalysis.jl").RR, 6.0 / 12);
    EXPECT_DOUBLE_EQ(of("CRP Toolbox").RR, 6.0 / 12);
    EXPECT_DOUBLE_EQ(of("pyunicorn").RR, 10.0 / 16);
    EXPECT_DOUBLE_EQ(of("PyRQA").RR, 10.0 / 16);
    // Diagonals off the main one: (1,0) | (3,1) | (3,0), single points each; no line of two.
    EXPECT_EQ(of("pyunicorn").DET, 0);
    // Columns with the main diagonal: 'xx.x' three times, '..x.' once: 6 points of 10 in lines of two.
    EXPECT_DOUBLE_EQ(of("pyunicorn").LAM, 6.0 / 10);
    EXPECT_DOUBLE_EQ(of("PyRQA").LAM, 6.0 / 10);
    // Without it: '.x.x', 'x..x', '....', 'xx..': one line of two among 6 points.
    EXPECT_DOUBLE_EQ(of("RecurrenceAnalysis.jl").LAM, 2.0 / 6);
    EXPECT_DOUBLE_EQ(of("CRP Toolbox").LAM, 2.0 / 6);
}

TEST(Presets, PyRqaDividesDetByAllPointsPyunicornByThoseOutsideTheWindow) {
    const std::vector<double> constant(5, 1.0);  // diagonals of 1 ... 4 points in each triangle; 25 points
    const auto det = [&](const char* name) {
        const Settings s = preset(name);
        return measures(count_lines(embed_series(constant), 0.5, s), s).DET;
    };
    EXPECT_DOUBLE_EQ(det("pyunicorn"), 18.0 / 20);
    EXPECT_DOUBLE_EQ(det("PyRQA"), 18.0 / 25);
}

TEST(Presets, UnknownNameListsTheKnownOnes) {
    EXPECT_EQ(error_of([] { preset("matlab"); }),
              "convention = matlab: must be one of RecurrenceAnalysis.jl, pyunicorn, PyRQA, CRP Toolbox");
    for (const std::string& name : preset_names()) EXPECT_NO_THROW(preset(name));
    EXPECT_NO_THROW(preset("pyrqa"));
}

TEST(Entropy, InTheNamedLogarithm) {
    Settings s;
    const LineHistograms lines = count_lines(matrix_of(column), s);
    const double natural = measures(lines, s).VENTR;  // one line of 2, one of 3
    EXPECT_DOUBLE_EQ(natural, std::log(2.0));
    s.logarithm = Logarithm::binary;
    EXPECT_DOUBLE_EQ(measures(lines, s).VENTR, 1);
    s.logarithm = Logarithm::decimal;
    EXPECT_DOUBLE_EQ(measures(lines, s).VENTR, std::log10(2.0));
}

TEST(Measures, WithoutLinesAveragesAreZeroAndEntropiesUndefinedOrZero) {
    Settings s;
    const LineHistograms lines = count_lines(embed_series(std::vector<double>{0, 1, 2, 3}), 0.1, s);
    const Measures m = measures(lines, s);
    for (double zero : {m.RR, m.DET, m.L, m.Lmax, m.LAM, m.TT, m.Vmax, m.MRT}) EXPECT_EQ(zero, 0);
    for (double undefined : {m.DIV, m.ENTR, m.VENTR, m.RTE, m.TREND}) EXPECT_TRUE(std::isnan(undefined));
    s.empty_is_zero = true;
    const Measures z = measures(lines, s);
    for (double zero : {z.DIV, z.ENTR, z.VENTR, z.RTE}) EXPECT_EQ(zero, 0);
}

TEST(Strict, LeavesOutDistancesEqualToTheThreshold) {
    Settings s;
    s.theiler = 0;
    EXPECT_EQ(count_lines(embed_series(std::vector<double>{0, 1}), 1.0, s).points, 4u);
    s.strict = true;
    EXPECT_EQ(count_lines(embed_series(std::vector<double>{0, 1}), 1.0, s).points, 2u);
    EXPECT_EQ(count_lines(embed_series(std::vector<double>{0, 1}), 0.0, s).points, 0u);
}

TEST(BadInput, NamesValueAndRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(error_of([&] { embed_series(std::vector<double>{1, nan}); }), "series value 1 = nan: must be finite");
    EXPECT_EQ(error_of([&] { embed_series(series, 0); }), "dimension = 0: must be >= 1");
    EXPECT_EQ(error_of([&] { embed_series(series, 2, 0); }), "delay = 0: must be >= 1");
    EXPECT_EQ(error_of([&] { embed_series(series, 3, 2); }),
              "series length = 4: must be > 4 = (dimension - 1) * delay");
    EXPECT_EQ(error_of([&] { embed_series(series, 1, 1, -1); }), "period = -1: must be finite and >= 0 (0: no angle)");
    EXPECT_EQ(error_of([&] { section_points(series, 3); }),
              "number of values = 4: must be a positive multiple of the dimension 3");
    EXPECT_EQ(error_of([&] { count_lines(embed_series(series), -1.0); }), "threshold = -1: must be >= 0");
    EXPECT_EQ(error_of([&] { count_lines(embed_series(series), nan); }), "threshold = nan: must be >= 0");
    Settings s;
    s.theiler = -1;
    EXPECT_EQ(error_of([&] { count_lines(embed_series(series), 1.0, s); }), "theiler = -1: must be >= 0");
    s = {};
    s.min_diagonal = 0;
    EXPECT_EQ(error_of([&] { count_lines(embed_series(series), 1.0, s); }), "min-diagonal = 0: must be >= 1");
    EXPECT_EQ(error_of([&] { threshold_of_rate(embed_series(series), 1.5); }),
              "recurrence-rate = 1.5: must be in (0, 1]");
    EXPECT_EQ(error_of([&] { threshold_of_deviation(embed_series(series), -1); }),
              "threshold-std = -1: must be finite and >= 0");
    EXPECT_EQ(error_of([&] { count_cross_lines(embed_series(series), embed_series(series, 2), std::vector{1.0}); }),
              "dimension = 2 of the second series: must be 1, that of the first");
}

}  // namespace
}  // namespace swirl::analysis::recurrence
