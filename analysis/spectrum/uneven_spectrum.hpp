// Lines of samples at uneven times by least squares, each with the others subtracted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

/// a cos ωt + b sin ωt, t from the middle of the samples' times.
struct FittedLine {
    double omega = 0, a = 0, b = 0;
    double power() const { return (a * a + b * b) / 2; }
};

/// What is left of samples when lines are subtracted, and the lines.
class LineFit {
public:
    /// times strictly rising, as many values, 8 or more. The mean of the values is subtracted.
    LineFit(std::span<const double> times, std::span<const double> values);

    const std::vector<double>& residual() const { return residual_; }
    const std::vector<FittedLine>& lines() const { return lines_; }
    const std::vector<double>& times() const { return times_; }  ///< from their middle on

    /// Subtracts the line of least squares near ω, whose frequency is refined by less than `reach`.
    void add(double omega, double reach);
    /// Takes the last line back.
    void take_back();
    /// Refines every line in turn, and the mean, `sweeps` times.
    void refine(double reach, int sweeps);

    /// Standard deviation over mean of a line's power in `parts` equal parts of the time, the others subtracted; NaN
    /// where a part has fewer than three of its periods, or than 8 samples.
    double spread(const FittedLine& line, std::size_t parts) const;

private:
    std::vector<double> times_, residual_;
    std::vector<FittedLine> lines_;

    void put(const FittedLine& line, double factor);
    FittedLine fitted(FittedLine line, double reach, int steps) const;
};

}  // namespace swirl::analysis
