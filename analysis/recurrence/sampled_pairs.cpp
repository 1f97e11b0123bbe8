#include "analysis/recurrence/sampled_pairs.hpp"

#include "analysis/random_draws.hpp"
#include "analysis/special_values.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace swirl::analysis::recurrence {

namespace {

constexpr std::uint64_t stream_of_pairs = 0x7061697273;  // "pairs"
constexpr std::uint64_t block = 4096;                    // pairs that one piece of work sums up

struct Line {
    std::uint64_t points = 0;       ///< recurrent ones in lines of at least the minimal length
    double lines = 0, squares = 0;  ///< sums of g and g² over them

    void operator+=(const Line& other) {
        points += other.points;
        lines += other.lines;
        squares += other.squares;
    }
};

struct Sums {
    std::uint64_t recurrent = 0;
    Line diagonal, vertical;

    void operator+=(const Sums& other) {
        recurrent += other.recurrent;
        diagonal += other.diagonal;
        vertical += other.vertical;
    }
};

/// floor(bits · count / 2⁶⁴): uniform below count, but for a bias of count/2⁶⁴.
std::uint64_t below(std::uint64_t bits, std::uint64_t count) {
    return static_cast<std::uint64_t>((static_cast<unsigned __int128>(bits) * count) >> 64);
}

/// The pairs i + W ≤ j of n points, by number: j runs first, i from the last to 0.
struct PairNumbers {
    std::uint64_t rows, window;  ///< n − W, W

    std::uint64_t count() const { return rows * (rows + 1) / 2; }
    std::pair<std::uint64_t, std::uint64_t> pair(std::uint64_t number) const {
        auto t = static_cast<std::uint64_t>((std::sqrt(8 * static_cast<double>(number) + 1) - 1) / 2);
        while (t * (t + 1) / 2 > number) --t;
        while ((t + 1) * (t + 2) / 2 <= number) ++t;
        const std::uint64_t i = rows - 1 - t;
        return {i, i + window + (number - t * (t + 1) / 2)};
    }
};

class Sampler {
public:
    Sampler(const Points& points, double threshold, std::uint64_t seed, const Settings& settings)
        : points_(points),
          settings_(settings),
          bound_(key_bound(threshold, settings.norm, settings.strict, points.dimension)),
          seed_(seed),
          window_(static_cast<std::uint64_t>(theiler_window(settings, false))),
          numbers_{points.count - window_, window_} {}

    Sums sum(std::uint64_t first, std::uint64_t end) const {
        Sums sums;
        for (std::uint64_t k = first; k < end; ++k) {
            const auto bits = random_bits({k, 0, 0, 0}, {seed_, stream_of_pairs});
            auto [i, j] = numbers_.pair(below(bits[0], numbers_.count()));
            if (bits[1] % 2 == 1) std::swap(i, j);
            if (!recurs(i, j)) continue;
            ++sums.recurrent;
            add(sums.diagonal, settings_.min_diagonal, [&, i = i, j = j](std::uint64_t most, bool back) {
                return steps(most, back ? std::min(i, j) : points_.count - 1 - std::max(i, j),
                             [&](std::uint64_t s) { return back ? recurs(i - s, j - s) : recurs(i + s, j + s); });
            });
            add(sums.vertical, settings_.min_vertical, [&, i = i, j = j](std::uint64_t most, bool back) {
                return steps(most, room_in_column(i, j, back),
                             [&](std::uint64_t s) { return recurs(back ? i - s : i + s, j); });
            });
        }
        return sums;
    }

private:
    bool recurs(std::uint64_t i, std::uint64_t j) const {
        return pair_key(points_, i, points_, j, settings_.norm) <= bound_;
    }

    /// How many rows column j has before or behind row i up to the window, or the matrix' border.
    std::uint64_t room_in_column(std::uint64_t i, std::uint64_t j, bool back) const {
        if (i > j) return back ? i - j - window_ : points_.count - 1 - i;
        return back ? i : j - i - window_;
    }

    /// How many points of a line follow one another, `most` or the room that there is at most.
    template <class Recurs>
    static std::uint64_t steps(std::uint64_t most, std::uint64_t room, const Recurs& recurs_at) {
        std::uint64_t count = 0;
        while (count < std::min(most, room) && recurs_at(count + 1)) ++count;
        return count;
    }

    /// Adds the line through a recurrent pair.
    ///   walk  counts its points before it (true) or behind it, up to a number
    template <class Walk>
    static void add(Line& sums, int least, const Walk& walk) {
        const auto shortest = static_cast<std::uint64_t>(least);
        const std::uint64_t most = std::max(longest_followed, shortest), before = walk(most, true);
        const std::uint64_t length = before < most ? before + walk(most, false) + 1 : most + 1;
        if (length < shortest) return;
        const double g = length <= most  ? 1 / static_cast<double>(length)
                         : before < most ? 1 / static_cast<double>(most)
                                         : 0;
        ++sums.points;
        sums.lines += g;
        sums.squares += g * g;
    }

    const Points& points_;
    const Settings& settings_;
    double bound_;
    std::uint64_t seed_, window_;
    PairNumbers numbers_;
};

double share_error(std::uint64_t found, std::uint64_t of) {
    const double n = static_cast<double>(of), p = (static_cast<double>(found) + 2) / (n + 4);
    return std::sqrt(p * (1 - p) / n);
}

/// Mean length of the lines, and its standard error. Two points in lines of the minimal length are added to those that
/// were met, for the error alone: what they would change is not known, where all that were met have one length.
std::pair<double, double> mean_length(const Line& line, int least) {
    if (!(line.lines > 0)) return {nan, nan};
    const double points = static_cast<double>(line.points), length = points / line.lines;
    const double squares = points - 2 * length * line.lines + length * length * line.squares;
    const double unseen = 1 - length / least;
    return {length, std::sqrt(std::max(squares, 0.0) + 2 * unseen * unseen) / line.lines};
}

Measures nothing() {
    Measures m;
    for (double Measures::*member :
         {&Measures::RR, &Measures::DET, &Measures::L, &Measures::Lmax, &Measures::DIV, &Measures::ENTR, &Measures::LAM,
          &Measures::TT, &Measures::Vmax, &Measures::VENTR, &Measures::MRT, &Measures::RTE, &Measures::TREND})
        m.*member = nan;
    return m;
}

}  // namespace

std::string obstacle_to_sampling(const Settings& settings) {
    if (theiler_window(settings, false) < 1)
        return "theiler = 0: the main diagonal is one line of all points; allowed: 1 or more";
    if (settings.rate_pairs != RatePairs::outside_window || !settings.window_on_rate || !settings.window_on_vertical ||
        settings.determinism_of_all_points)
        return "this convention divides by points within the Theiler window";
    if (settings.border_lines != BorderLines::counted)
        return "border-lines = discarded: a line's ends may be out of sight";
    return "";
}

SampledPairs sample_pairs(const Points& points, double threshold, std::uint64_t pairs, std::uint64_t seed,
                          const Settings& settings) {
    if (const std::string obstacle = obstacle_to_sampling(settings); !obstacle.empty())
        throw std::invalid_argument(obstacle);
    if (pairs == 0) throw std::invalid_argument("sample-pairs = 0: must be 1 or more");
    if (!points.row_numbers.empty()) throw std::invalid_argument("pairs are drawn of points without gaps");
    const auto window = static_cast<std::uint64_t>(theiler_window(settings, false));
    if (window >= points.count)
        throw std::invalid_argument("theiler = " + std::to_string(window) + ": must be < " +
                                    std::to_string(points.count) + ", the number of points");
    const Sampler sampler(points, threshold, seed, settings);
    std::vector<Sums> blocks((pairs + block - 1) / block);
    tbb::parallel_for(std::size_t{0}, blocks.size(),
                      [&](std::size_t b) { blocks[b] = sampler.sum(b * block, std::min((b + 1) * block, pairs)); });
    Sums sums;
    for (const Sums& part : blocks) sums += part;
    SampledPairs found{pairs, sums.recurrent, nothing(), nothing()};
    found.measures.RR = static_cast<double>(sums.recurrent) / static_cast<double>(pairs);
    found.errors.RR = share_error(sums.recurrent, pairs);
    if (sums.recurrent == 0) return found;
    const auto recurrent = static_cast<double>(sums.recurrent);
    found.measures.DET = static_cast<double>(sums.diagonal.points) / recurrent;
    found.measures.LAM = static_cast<double>(sums.vertical.points) / recurrent;
    found.errors.DET = share_error(sums.diagonal.points, sums.recurrent);
    found.errors.LAM = share_error(sums.vertical.points, sums.recurrent);
    std::tie(found.measures.L, found.errors.L) = mean_length(sums.diagonal, settings.min_diagonal);
    std::tie(found.measures.TT, found.errors.TT) = mean_length(sums.vertical, settings.min_vertical);
    return found;
}

}  // namespace swirl::analysis::recurrence
