// `swirl spectrum`: the power spectrum of an orbit, a record or a measured series.
#pragma once

#include "apps/input/input_options.hpp"

#include <cstdint>
#include <string>

namespace swirl::apps::spectrum {

struct SpectrumOptions {
    InputOptions input;
    OutputOptions output;
    std::string observable = "S";      ///< S, x, y or position (x + iy, two-sided)
    std::string frame = "laboratory";  ///< of positions
    std::string window = "hann";
    std::string detrend = "mean";
    std::int64_t bins = 0;      ///< of an orbit; 0: automatic
    std::int64_t segments = 0;  ///< of Welch's method; 0: automatic, about 16
    double overlap = 0.5;
    bool compensate = false;
    std::string resample;  ///< spacing of a measured series; empty: its times are as they are

    void add_to(Flags& command);
};

extern const char* const spectrum_details;

/// @return the exit code
int find_spectrum(SpectrumOptions& options);

}  // namespace swirl::apps::spectrum
