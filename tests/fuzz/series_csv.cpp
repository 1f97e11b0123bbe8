// A measured series: six choices of flags, then any text. It is refused, or its times rise and its values are finite or
// missing.
#include "apps/input/angle_stretch.hpp"
#include "apps/input/input_options.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace swirl::apps {
namespace {

using tests::fuzz::Bytes, tests::fuzz::require;

SeriesChoice choice_from(Bytes& bytes) {
    SeriesChoice choice;
    const char* const columns[] = {"", "S", "1", "2", "x", "t", "angle"};
    const char* const times[] = {"", "none", "t", "1", "2"};
    const double rates[] = {1, 2, 62.8, 1e-3, 1e75};
    const LongSteps steps[] = {LongSteps::maybe, LongSteps::lost_rows, LongSteps::long_flights};
    const int kind = bytes.below(4);
    const std::string column = columns[bytes.below(7)];
    choice.time = times[bytes.below(5)];
    choice.long_steps = steps[bytes.below(3)];
    const int angle = bytes.below(8);
    const double rate = rates[bytes.below(5)];
    if (kind == 1) choice.position = {column.empty() ? "x" : column, "2"};
    if (kind == 0) choice.column = column;
    if (kind < 2) choice.spacing = rate;
    if (kind < 2) return choice;
    choice.angle = column.empty() ? "2" : column;
    choice.degrees = angle % 2 == 1;
    choice.symmetry = angle < 2 ? 1 : angle;
    choice.swirl_rate = rate;
    return choice;
}

void require_series(const MeasuredSeries& series) {
    require(series.times.size() == series.values.size(), "as many times as values");
    require(std::is_sorted(series.times.begin(), series.times.end()), "times do not fall");
    for (const double time : series.times) require(std::isfinite(time), "times are finite");
    for (const double value : series.values) require(!std::isinf(value), "values are finite or missing");
    const auto missing = std::count_if(series.values.begin(), series.values.end(), [](double v) { return v != v; });
    require(static_cast<std::size_t>(missing) == series.missing, "missing values are counted");
    require(series.values.size() >= series.missing + 2, "two values at least");
    require(series.values.size() <= 4 * series.rows + 4, "gaps do not outgrow the file");
    require(series.spacing > 0 && std::isfinite(series.spacing), "the mean spacing is positive");
    require(!std::isnan(series.largest_deviation), "how uneven times are is a number");
    require(!series_in_words(series).empty(), "it can be told");
}

void require_stretch(const MeasuredAngle& angle) {
    const AngleStretch stretch = longest_stretch(angle);
    require(!stretch.angles.empty() && stretch.first + stretch.angles.size() <= angle.values.size(),
            "a stretch is part of its angle");
    for (const double value : stretch.angles) require(std::isfinite(value), "a stretch has no gaps");
}

}  // namespace
}  // namespace swirl::apps

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace swirl;
    using tests::fuzz::answers;
    tests::fuzz::Bytes bytes(data, size);
    apps::SeriesChoice choice = apps::choice_from(bytes);
    const tests::fuzz::MemoryFile file(bytes.rest());
    choice.file = file.name();
    apps::MeasuredSeries series;
    if (!answers([&] { series = apps::read_series(choice); })) return 0;
    apps::require_series(series);
    if (!series.angle.values.empty()) answers([&] { apps::require_stretch(series.angle); });
    apps::InputOptions options;
    options.transient = static_cast<std::int64_t>(size % 3);
    answers([&] { apps::require_series(options.part_asked_for(series, choice.file)); });
    return 0;
}
