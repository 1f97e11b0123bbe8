// Recurrence quantification measures from line histograms. Definitions and references: README.md.
#pragma once

#include "analysis/recurrence/lines.hpp"

namespace swirl::analysis::recurrence {

/// All of them are pure numbers except TREND (recurrence rate per 1000 samples). Without lines of the kind, averages
/// and longest lengths are 0, entropies NaN (0 with settings.empty_is_zero). DET and LAM without any point are 0.
/// Entropies are those of the histogram of lengths, in settings.logarithm.
struct Measures {
    double RR = 0;     ///< recurrence rate
    double DET = 0;    ///< share of the points that lie in diagonal lines of at least min_diagonal
    double L = 0;      ///< mean length of those lines
    double Lmax = 0;   ///< the longest
    double DIV = 0;    ///< 1 / Lmax; NaN (0 with empty_is_zero) without lines
    double ENTR = 0;   ///< entropy of their lengths
    double LAM = 0;    ///< share of the points that lie in vertical lines of at least min_vertical
    double TT = 0;     ///< trapping time: mean length of those lines
    double Vmax = 0;   ///< the longest
    double VENTR = 0;  ///< entropy of their lengths
    double MRT = 0;    ///< mean recurrence time
    double RTE = 0;    ///< entropy of the recurrence times
    double TREND = 0;  ///< slope of the recurrence rate against the distance from the main diagonal; NaN if undefined
};

/// Cost: O(n). The settings must be those that the lines were counted with.
Measures measures(const LineHistograms& lines, const Settings& settings = {});

}  // namespace swirl::analysis::recurrence
