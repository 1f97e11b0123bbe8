#include "analysis/recurrence/image.hpp"

#include "analysis/recurrence/columns.hpp"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace swirl::analysis::recurrence {
namespace {

std::size_t count_bits(const std::vector<std::uint64_t>& words, std::size_t begin, std::size_t end) {
    std::size_t total = 0;
    for (std::size_t q = begin; q < end;) {
        const std::size_t bits = std::min(64 - (q & 63), end - q);
        const std::uint64_t mask = (~std::uint64_t{0} >> (64 - bits)) << (q & 63);
        total += static_cast<std::size_t>(std::popcount(words[q >> 6] & mask));
        q += bits;
    }
    return total;
}

}  // namespace

Image cross_recurrence_image(const Points& rows, const Points& columns, double threshold, std::size_t pixels,
                             const Settings& settings) {
    require_same_space(rows, columns);
    if (pixels < 1 || pixels > std::min(rows.count, columns.count))
        throw std::invalid_argument("pixels = " + std::to_string(pixels) + ": must be in 1 ... " +
                                    std::to_string(std::min(rows.count, columns.count)));
    const double bound = key_bound(threshold, settings.norm, settings.strict, rows.dimension);
    const detail::SortedRows sorted = detail::sort_rows(rows, settings.norm);
    Image image{pixels, std::vector<double>(pixels * pixels, 0)};
    const auto edge = [pixels](const Points& points, std::size_t a) {
        return a == pixels ? points.count : points.point_from(points.rows() * a / pixels);
    };
    tbb::parallel_for(std::size_t{0}, pixels, [&](std::size_t b) {
        detail::ColumnScratch scratch = detail::make_scratch(sorted);
        std::vector<std::uint64_t> words(rows.count / 64 + 1);
        std::uint64_t* const frame = words.data();
        std::vector<std::size_t> points(pixels, 0);
        const std::size_t first = edge(columns, b), last = edge(columns, b + 1);
        for (std::size_t c = first; c < last; ++c) {
            std::fill(words.begin(), words.end(), 0);
            detail::fill_column(sorted, columns, c, {&bound, 1}, 0, {&frame, 1}, scratch);
            for (std::size_t a = 0; a < pixels; ++a) points[a] += count_bits(words, edge(rows, a), edge(rows, a + 1));
        }
        for (std::size_t a = 0; a < pixels; ++a) {
            const std::size_t pairs = (edge(rows, a + 1) - edge(rows, a)) * (last - first);
            image.density[a * pixels + b] = static_cast<double>(points[a]) / static_cast<double>(pairs);
        }
    });
    return image;
}

Image recurrence_image(const Points& points, double threshold, std::size_t pixels, const Settings& settings) {
    return cross_recurrence_image(points, points, threshold, pixels, settings);
}

}  // namespace swirl::analysis::recurrence
