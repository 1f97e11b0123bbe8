// Every number under "Recurrence" in the project's references, to the printed digits; each test names its source.
#include "analysis/recurrence/lines.hpp"
#include "analysis/recurrence/measures.hpp"
#include "tests/references/reference_file.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

// RecurrenceAnalysis.jl, test/rqa_rna_analytic.jl: rows and columns from 1.
BinaryMatrix cross_matrix_10_by_11() {
    constexpr int ones[][2] = {{1, 1}, {2, 2}, {3, 2},  {6, 2},   {7, 2},  {8, 2}, {6, 3}, {7, 3},  {10, 3},
                               {2, 4}, {4, 4}, {1, 5},  {2, 5},   {3, 5},  {5, 5}, {9, 5}, {10, 5}, {2, 6},
                               {3, 6}, {6, 6}, {7, 6},  {10, 6},  {3, 7},  {8, 7}, {4, 8}, {1, 9},  {5, 9},
                               {7, 9}, {9, 9}, {9, 10}, {10, 10}, {3, 11}, {7, 11}};
    BinaryMatrix matrix{10, 11, std::vector<std::uint8_t>(110, 0)};
    for (const auto& one : ones) matrix.entries[static_cast<std::size_t>((one[0] - 1) * 11 + one[1] - 1)] = 1;
    return matrix;
}

std::vector<double> read_series(const std::string& name) {
    std::ifstream file(tests::reference_path(name));
    std::vector<double> series;
    for (double value; file >> value;) series.push_back(value);
    return series;
}

using Counts = std::vector<std::uint64_t>;

TEST(RecurrenceAnalysisJl, CrossMatrix10By11) {
    Settings s;
    s.trend_border = 1;
    const LineHistograms lines = count_lines(cross_matrix_10_by_11(), s);
    EXPECT_EQ(lines.diagonal, (Counts{0, 11, 7, 1, 0, 1}));
    EXPECT_EQ(lines.vertical, (Counts{0, 15, 6, 2}));
    EXPECT_EQ(lines.recurrence_time, (Counts{0, 3, 1, 4, 4}));
    const Measures m = measures(lines, s);
    EXPECT_DOUBLE_EQ(m.RR, 33.0 / 110);
    EXPECT_DOUBLE_EQ(m.DET, 22.0 / 33);
    EXPECT_DOUBLE_EQ(m.L, 22.0 / 9);
    EXPECT_EQ(m.Lmax, 5);
    EXPECT_EQ(m.DIV, 0.2);
    EXPECT_NEAR(m.ENTR, 0.684, 0.0005);  // three printed digits
    EXPECT_DOUBLE_EQ(m.LAM, 18.0 / 33);
    EXPECT_DOUBLE_EQ(m.TT, 18.0 / 8);
    EXPECT_EQ(m.Vmax, 3);
    EXPECT_DOUBLE_EQ(m.MRT, 33.0 / 12);
    EXPECT_NEAR(m.RTE, 1.286, 0.0005);
    EXPECT_NEAR(m.TREND, -33.8, 0.05);
}

// RecurrenceAnalysis.jl's values with a Theiler window of 2 (a cross matrix: RR over the full matrix there).
TEST(RecurrenceAnalysisJl, CrossMatrixWithTheilerWindow) {
    Settings s;
    s.theiler = 2;
    s.trend_border = 1;
    s.rate_pairs = RatePairs::all;
    const LineHistograms lines = count_lines(cross_matrix_10_by_11(), s);
    EXPECT_EQ(lines.diagonal, (Counts{0, 9, 4, 0, 0, 1}));
    EXPECT_EQ(lines.vertical, (Counts{0, 10, 3, 2}));
    EXPECT_EQ(lines.recurrence_time, (Counts{0, 1, 0, 3, 0, 0, 0, 2}));
    const Measures m = measures(lines, s);
    EXPECT_DOUBLE_EQ(m.RR, 22.0 / 110);
    EXPECT_DOUBLE_EQ(m.DET, 13.0 / 22);
    EXPECT_DOUBLE_EQ(m.L, 13.0 / 5);
    EXPECT_NEAR(m.ENTR, 0.500, 0.0005);
    EXPECT_DOUBLE_EQ(m.LAM, 12.0 / 22);
    EXPECT_DOUBLE_EQ(m.TT, 12.0 / 5);
    EXPECT_DOUBLE_EQ(m.MRT, 24.0 / 6);
    EXPECT_NEAR(m.RTE, 1.011, 0.0005);
    EXPECT_NEAR(m.TREND, -17.9, 0.05);
}

// pyunicorn's tests: x_j(t) = sin(pi t / 10 + j pi / 2), t = 0 ... 9, j = 0 ... 5: ten points of six coordinates.
TEST(Pyunicorn, SineExample) {
    std::vector<double> points;
    for (int t = 0; t < 10; ++t)
        for (int j = 0; j < 6; ++j) points.push_back(std::sin(M_PI * t / 10 + j * M_PI / 2));
    Settings s = preset("pyunicorn");
    s.norm = Norm::maximum;
    const Measures m = measures(count_lines(section_points(points, 6), 0.8, s), s);
    EXPECT_NEAR(m.RR, 0.48, 1e-15);
    EXPECT_NEAR(m.DET, 0.8947, 0.00005);
    EXPECT_NEAR(m.L, 8.5, 1e-14);
    EXPECT_NEAR(m.LAM, 1, 1e-15);
    EXPECT_NEAR(m.TT, 4.8, 1e-14);
    EXPECT_NEAR(m.MRT, 4.0, 1e-14);
}

// The published values have 16 or 17 digits: ratios of the same integers agree to the last bit or two (4 ulp); an
// entropy is a sum of a few hundred rounded terms in another order: 1e-13 relative.
void expect_entropy(double ours, double published) {
    EXPECT_NEAR(ours, published, 1e-13 * published);
}

Measures rossler(const std::string& file, Norm norm, RatePairs pairs = RatePairs::outside_window) {
    Settings s;
    s.norm = norm;
    s.theiler = 1;
    s.rate_pairs = pairs;
    return measures(count_lines(embed_series(read_series(file), 3, 6), 1.2, s), s);
}

TEST(RecurrenceAnalysisJlAndCrpToolbox, Rossler250Euclidean) {
    const Measures m = rossler("rossler_250.txt", Norm::euclidean);
    EXPECT_DOUBLE_EQ(m.RR, 0.03808105520689288);
    EXPECT_DOUBLE_EQ(m.DET, 0.9990689013035382);
    EXPECT_DOUBLE_EQ(m.L, 18.1864406779661);
    EXPECT_EQ(m.Lmax, 237);
    expect_entropy(m.ENTR, 3.044979404476836);
    EXPECT_DOUBLE_EQ(m.LAM, 0.9548417132216015);
    EXPECT_DOUBLE_EQ(m.TT, 3.8408239700374533);
}

TEST(RecurrenceAnalysisJlAndCrpToolbox, Rossler250MaximumNorm) {
    const Measures m = rossler("rossler_250.txt", Norm::maximum);
    EXPECT_DOUBLE_EQ(m.RR, 0.05485232067510549);
    EXPECT_DOUBLE_EQ(m.DET, 0.9941822882999354);
    EXPECT_DOUBLE_EQ(m.L, 17.477272727272727);
    expect_entropy(m.ENTR, 3.1418178182603116);
    EXPECT_DOUBLE_EQ(m.LAM, 0.9786683904330963);
    EXPECT_DOUBLE_EQ(m.TT, 4.791139240506329);
}

TEST(RecurrenceAnalysisJlAndCrpToolbox, Rossler3000) {
    const Measures m = rossler("rossler_3000.txt", Norm::euclidean);
    EXPECT_DOUBLE_EQ(m.RR, 0.034497548278147744);
    EXPECT_DOUBLE_EQ(m.DET, 0.998194195442617);
    EXPECT_DOUBLE_EQ(m.L, 18.085206543485935);
    EXPECT_EQ(m.Lmax, 758);
    expect_entropy(m.ENTR, 3.6108687203622942);
    EXPECT_DOUBLE_EQ(m.LAM, 0.9889573102606075);
    EXPECT_DOUBLE_EQ(m.TT, 5.380358341873697);
}

TEST(RecurrenceAnalysisJlAndCrpToolbox, Rossler3000WithTheMainDiagonalInTheDenominator) {
    EXPECT_DOUBLE_EQ(rossler("rossler_3000.txt", Norm::euclidean, RatePairs::all).RR, 0.034486002913931495);
}

}  // namespace
}  // namespace swirl::analysis::recurrence
