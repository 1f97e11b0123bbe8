// A spectrum as JSON, as a record, and as lines for people.
#pragma once

#include "analysis/spectrum/lines.hpp"
#include "apps/spectrum/spectrum_signal.hpp"

#include <vector>

namespace swirl::apps::spectrum {

struct SpectrumReport {
    const SpectrumOptions& options;
    const SpectrumSignal& signal;
    analysis::PowerSpectrum spectrum;
    std::vector<analysis::SpectralPeak> peaks;
    analysis::LineShare share;
    double entropy;
    bool uneven = false;  ///< of samples at uneven times: Lomb and Scargle's, else Welch's
};

void write_json(const SpectrumReport& report);
void write_record(const RecordGroup& root, const SpectrumReport& report);
void print_table(const SpectrumReport& report);

}  // namespace swirl::apps::spectrum
