// The period that an orbit keeps while its map changes slowly, and when it leaves it.
//
// Formula: period k is kept once |z_i − z_{i−k}| ≤ δ for max(m k, n₀) steps in a row, of the smallest such k ≤ K (whose
// points do not come together meanwhile: the distance that divisors of k lead back to has not halved); it is left at
// the first step with |z_i − z_{i−k}| > δ, or once a divisor of k would be kept: an orbit may come over to a cycle of a
// part of its period step by step. (The largest coordinate of the difference, angles as angles.)
#pragma once

#include "analysis/classification/tail.hpp"
#include "analysis/section_map.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis {

struct KeptPeriodOptions {
    int longest = 16;         ///< K
    double tolerance = 1e-3;  ///< δ
    /// m: an orbit that passes a cycle leaves it before it has gone round so often, unless it is near it to |λ|⁻⁸ δ.
    std::int64_t rounds = 8;
    std::int64_t fewest = 32;  ///< n₀, steps: rounds of a short cycle
};

enum class PeriodEvent { none, kept, left };

/// Watches an orbit step by step. With δ above what the map's change moves the cycle by in a period, and below what
/// tells its points apart: two points of a cycle within δ are one. Cost: until a period is kept K distances a step,
/// then one.
template <SectionMap M>
class KeptPeriod {
public:
    using Point = Vector<M::dimension>;

    explicit KeptPeriod(const KeptPeriodOptions& options)
        : options_(options),
          points_(static_cast<std::size_t>(options.longest)),
          counts_(static_cast<std::size_t>(options.longest) + 1, 0),
          parted_(static_cast<std::size_t>(options.longest) + 1, 0) {}

    /// 0: none is kept.
    int period() const { return period_; }

    /// Takes the next point. After `left`, `period()` is 0, and what follows is looked at as of a new orbit's.
    PeriodEvent add(const M& map, const Point& point) {
        const int found = look_for(map, point);
        PeriodEvent event = PeriodEvent::none;
        if (period_ > 0 && (counts_[static_cast<std::size_t>(period_)] == 0 || found != 0)) {
            event = PeriodEvent::left;
            period_ = 0;
            seen_ = 0;
            std::fill(counts_.begin(), counts_.end(), 0);
        } else if (found != 0) {
            event = PeriodEvent::kept;
            period_ = found;
            std::fill(counts_.begin(), counts_.end(), 0);
            counts_[static_cast<std::size_t>(found)] = 1;
        }
        at(seen_) = point;
        ++seen_;
        return event;
    }

    /// The last `period()` points, the earliest first.
    std::vector<Point> last_period() const {
        std::vector<Point> points;
        for (std::int64_t i = seen_ - period_; i < seen_; ++i) points.push_back(at(i));
        return points;
    }

private:
    const Point& at(std::int64_t i) const { return points_[static_cast<std::size_t>(i % options_.longest)]; }
    Point& at(std::int64_t i) { return points_[static_cast<std::size_t>(i % options_.longest)]; }

    /// The least distance of the point from those that divisors of k lead back to: those of k itself are parted by it.
    /// A cycle that is approached alternately looks like one of twice its period while this falls.
    double parting(const M& map, const Point& point, int k) const {
        double least = infinity;
        for (int divisor = 1; divisor < k; ++divisor)
            if (k % divisor == 0) least = std::min(least, distance(map, point, at(seen_ - divisor)));
        return least;
    }

    /// Counts k, and says whether that makes it a period. While a period is kept these are it and its divisors.
    int look_for(const M& map, const Point& point) {
        for (int k = 1; k <= options_.longest && k <= seen_; ++k) {
            if (period_ > 0 && period_ % k != 0) continue;
            std::int64_t& count = counts_[static_cast<std::size_t>(k)];
            const double away = distance(map, point, at(seen_ - k), options_.tolerance);
            count = away <= options_.tolerance ? count + 1 : 0;
            if (k == period_ || count == 0) continue;
            if (count == 1) parted_[static_cast<std::size_t>(k)] = parting(map, point, k);
            if (count < std::max(options_.rounds * k, options_.fewest)) continue;
            if (parting(map, point, k) >= parted_[static_cast<std::size_t>(k)] / 2) return k;
            count = 0;  // its points still come together
        }
        return 0;
    }

    KeptPeriodOptions options_;
    std::vector<Point> points_;         ///< the last K, point i at i mod K
    std::vector<std::int64_t> counts_;  ///< of k: steps in a row that came back after k
    std::vector<double> parted_;        ///< of k: `parting` when its count began
    std::int64_t seen_ = 0;
    int period_ = 0;
};

}  // namespace swirl::analysis
