// The equally spaced signal of an orbit, a record or a series.
#pragma once

#include "apps/spectrum/spectrum_command.hpp"

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::spectrum {

struct SpectrumSignal {
    bool enough = true;  ///< false: the orbit ended before there was a flight to average
    double spacing = 1;
    double duration = 0;                          ///< that the signal covers
    std::vector<double> values;                   ///< NaN where missing
    std::vector<std::complex<double>> positions;  ///< instead of values, if the observable is position
    double cycle_time = 1;                        ///< time of frequency 1
    double period = 0;                            ///< of the cycle that S(t) is, in time; 0: none is known
    std::size_t samples_of_period = 0;            ///< where a period is a whole number of bins, else 0
    std::size_t bridged = 0;                      ///< of a measured angle: lost rows that were
    std::vector<std::string> notes;
    std::optional<OrbitColumns> orbit;
    std::optional<MeasuredSeries> series;
    Settings resampled;   ///< empty: the samples are as measured
    bool uneven = false;  ///< the values are at the times of `series`
    double highest = 0;   ///< frequency that the samples of a series can show; 0: all of its spectrum
};

/// Is S(t) asked for, not a position?
bool is_spin(const SpectrumOptions& options);

/// An orbit: S(t), constant in flight and smooth in contact, or the body's positions, averaged exactly over equal bins,
/// from the first impact kept to the last; S of a cycle over bins that divide its period, as many periods as there are,
/// so that the jumps of S fold onto the cycle's own frequencies and nowhere else. A series: its samples, as they are
/// or, with --resample, on another grid. @throws BadInput
SpectrumSignal signal_of(SpectrumOptions& options);

}  // namespace swirl::apps::spectrum
