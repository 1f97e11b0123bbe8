#include "apps/input/row_order.hpp"

#include "apps/input/bodies.hpp"
#include "apps/input/column_names.hpp"
#include "apps/input/series_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

namespace swirl::apps {

namespace {

/// The column by which rows are ordered in time, whether it rises or not.
std::optional<std::size_t> column_of_order(const DelimitedFile& file, const SeriesChoice& choice) {
    if (file.columns < 2 || file.header.empty() || !choice.time.empty()) return std::nullopt;
    if (std::any_of(file.header.begin(), file.header.end(), names_time)) return std::nullopt;
    for (bool (*const names)(const std::string&) : {may_name_time, names_frame})
        for (std::size_t k = 0; k < file.header.size(); ++k)
            if (names(file.header[k]) && has_only_times(file, k)) return k;
    return std::nullopt;
}

/// It rises for long, falls by nearly all that it spans, and rises again.
bool goes_round(const std::vector<double>& times) {
    constexpr double nearly_all = 0.7;
    constexpr std::size_t rises_for = 8;  // rows, in the mean
    const auto [low, high] = std::minmax_element(times.begin(), times.end());
    std::size_t falls = 0;
    bool all_far = true;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] > times[i - 1]) continue;
        ++falls;
        all_far = all_far && times[i - 1] - times[i] >= nearly_all * (*high - *low);
    }
    return all_far && rises_for * falls <= times.size();
}

bool repeat(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return std::adjacent_find(times.begin(), times.end()) != times.end();
}

}  // namespace

std::shared_ptr<const DelimitedFile> rows_in_order(std::shared_ptr<const DelimitedFile> file,
                                                   const SeriesChoice& choice, std::vector<std::string>& notes) {
    const auto column = column_of_order(*file, choice);
    if (!column) return file;
    const std::vector<double> times = times_of(*file, *column).values;
    if (rises(times) || repeat(times) || goes_round(times) || bodies_in(*file, column, times).column) return file;
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
    auto sorted = std::make_shared<DelimitedFile>(*file);
    for (std::size_t i = 0; i < order.size(); ++i) sorted->rows[i] = file->rows[order[i]];
    notes.push_back(
        fmt::format("the rows are not in the order of column {}: they are sorted by it", column_name(*file, *column)));
    return sorted;
}

}  // namespace swirl::apps
