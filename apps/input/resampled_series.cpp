#include "apps/input/resampled_series.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace swirl::apps {

analysis::Resampled resampled(const std::string& spacing, const std::vector<double>& times,
                              const std::vector<double>& values, Settings& done) {
    analysis::ResampleOptions how;
    how.spacing = number_from<double>("resample", spacing);
    how.low_pass = true;
    if (!(how.spacing > 0 && std::isfinite(how.spacing)))
        throw BadInput(fmt::format("resample = {} is outside its range: resample > 0, finite", spacing));
    analysis::Resampled even = analysis::resample(times, values, how);
    done = {{"spacing", even.series.spacing},
            {"interpolation", std::string(name_of(how.interpolation))},
            {"gap_factor", how.gap_factor},
            {"gaps", static_cast<std::int64_t>(even.gaps)},
            {"missing_fraction", even.missing_fraction},
            {"samples", static_cast<std::int64_t>(even.series.values.size())},
            {"low_pass", even.low_pass},
            {"own_nyquist", even.own_nyquist}};
    return even;
}

std::string resampling_in_words(const analysis::Resampled& series) {
    std::string words = fmt::format("resampled by straight lines to a spacing of {:g}; {} gaps are left open",
                                    series.series.spacing, series.gaps);
    if (series.low_pass == 0) return words;
    const bool coarser = series.low_pass < series.own_nyquist;
    return words + fmt::format("; a low-pass took out what is above {:.6g}, {}", series.low_pass,
                               coarser ? "which the new grid would fold below it"
                                       : "the highest frequency that the rows can show");
}

}  // namespace swirl::apps
