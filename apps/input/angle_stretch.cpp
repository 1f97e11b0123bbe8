#include "apps/input/angle_stretch.hpp"

#include "analysis/within_period.hpp"
#include "apps/command_line/errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::apps {

namespace {

/// How it turns from row to row.
struct Turns {
    double mean = 0, largest_deviation = 0;
    double step = 0;  ///< mean, of time
};

Turns turns_of(const MeasuredAngle& angle) {
    std::vector<double> turns;
    Turns all;
    for (std::size_t i = 1; i < angle.values.size(); ++i) {
        const double turn = analysis::within_period(angle.values[i] - angle.values[i - 1], angle.period);
        if (std::isnan(turn)) continue;
        turns.push_back(turn);
        all.mean += turn;
        all.step += angle.times[i] - angle.times[i - 1];
    }
    if (turns.empty()) throw BadInput("angle: no two rows without a gap between them");
    all.mean /= static_cast<double>(turns.size());
    all.step /= static_cast<double>(turns.size());
    for (const double turn : turns) all.largest_deviation = std::max(all.largest_deviation, std::abs(turn - all.mean));
    return all;
}

struct Range {
    std::size_t first = 0, count = 0, bridged = 0;
};

/// What longest_stretch() bridges: from row `before` to row `row`, neither of which is lost.
bool can_bridge(const MeasuredAngle& angle, const Turns& turns, std::size_t before, std::size_t row, std::size_t most) {
    const std::size_t lost = row - before - 1;
    const double rows = static_cast<double>(lost) + 1;
    const bool known = lost == 0 || rows * turns.largest_deviation <= sure_turn * angle.period / 2;
    return lost <= most && known && angle.times[row] - angle.times[before] <= (rows + 0.75) * turns.step;
}

/// Across `rows` steps: its class nearest to so many mean turns.
double turn_across(const MeasuredAngle& angle, const Turns& turns, double turn, std::size_t rows) {
    const double usual = rows == 1 ? 0 : turns.mean * static_cast<double>(rows);
    return usual + analysis::within_period(turn - usual, angle.period);
}

/// The longest run of rows of which at most `most` at a time are lost.
Range longest_range(const MeasuredAngle& angle, const Turns& turns, std::size_t most) {
    Range best, range;
    std::size_t last = 0;  // row that is not lost
    for (std::size_t i = 0; i < angle.values.size(); ++i) {
        if (std::isnan(angle.values[i])) continue;
        if (range.count == 0 || !can_bridge(angle, turns, last, i, most)) range = {i, 0, 0};
        range.bridged += range.count == 0 ? 0 : i - last - 1;
        range.count = i - range.first + 1;
        last = i;
        if (range.count > best.count) best = range;
    }
    return best;
}

/// Each angle the one of its class nearest to where the turn leads, so that nothing adds up but whole periods.
std::vector<double> unwrapped(const MeasuredAngle& angle, const Turns& turns, const Range& range) {
    std::vector<double> result{angle.values[range.first]};
    for (std::size_t i = range.first + 1; i < range.first + range.count; ++i) {
        if (std::isnan(angle.values[i])) continue;
        const double before = result.back();
        const std::size_t rows = i - range.first - result.size() + 1;
        const double turn = turn_across(angle, turns, angle.values[i] - before, rows);
        const double now =
            angle.values[i] + angle.period * std::round((before + turn - angle.values[i]) / angle.period);
        for (std::size_t k = 1; k < rows; ++k)
            result.push_back(before + (now - before) * static_cast<double>(k) / static_cast<double>(rows));
        result.push_back(now);
    }
    return result;
}

double roughness(const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t i = 2; i < x.size(); ++i) {
        const double second = x[i] - 2 * x[i - 1] + x[i - 2];
        sum += second * second;
    }
    return sum;
}

/// The even times that fit best (least squares), and the angles there.
void put_on_even_times(const std::vector<double>& times, AngleStretch& stretch) {
    const double n = static_cast<double>(stretch.angles.size()), middle = (n - 1) / 2;
    double mean = 0, products = 0, squares = 0;
    for (std::size_t i = 0; i < stretch.angles.size(); ++i)
        mean += (times[stretch.first + i] - times[stretch.first]) / n;
    for (std::size_t i = 0; i < stretch.angles.size(); ++i) {
        const double k = static_cast<double>(i) - middle;
        products += k * (times[stretch.first + i] - times[stretch.first] - mean);
        squares += k * k;
    }
    stretch.spacing = products / squares;
    const double rate = (stretch.angles.back() - stretch.angles.front()) /
                        (times[stretch.first + stretch.angles.size() - 1] - times[stretch.first]);
    std::vector<double> moved = stretch.angles;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const double even = mean + (static_cast<double>(i) - middle) * stretch.spacing;
        const double deviation = times[stretch.first + i] - times[stretch.first] - even;
        stretch.largest_deviation = std::max(stretch.largest_deviation, std::abs(deviation) / stretch.spacing);
        moved[i] -= rate * deviation;
    }
    if (2 * roughness(moved) < roughness(stretch.angles)) stretch.angles = std::move(moved);
}

}  // namespace

AngleStretch longest_stretch(const MeasuredAngle& angle) {
    const Turns turns = turns_of(angle);
    Range range = longest_range(angle, turns, most_bridged);
    if (static_cast<double>(range.bridged) > most_made_up * static_cast<double>(range.count))
        range = longest_range(angle, turns, 0);
    AngleStretch stretch;
    stretch.first = range.first;
    stretch.bridged = range.bridged;
    stretch.angles = unwrapped(angle, turns, range);
    put_on_even_times(angle.times, stretch);
    return stretch;
}

BridgedSpin bridged_spin(const MeasuredSeries& series) {
    const MeasuredAngle& angle = series.angle;
    const Turns turns = turns_of(angle);
    BridgedSpin spin{series.values, 0};
    std::size_t last = angle.values.size();  // row that is not lost; none yet
    for (std::size_t i = 0; i < angle.values.size(); ++i) {
        if (std::isnan(angle.values[i])) continue;
        const bool bridges = last < i && i > last + 1 && can_bridge(angle, turns, last, i, most_bridged);
        if (bridges) {
            const double turn = turn_across(angle, turns, angle.values[i] - angle.values[last], i - last);
            const double mean = turn / (series.swirl_rate * (angle.times[i] - angle.times[last]));
            std::fill(spin.values.begin() + static_cast<std::ptrdiff_t>(last),
                      spin.values.begin() + static_cast<std::ptrdiff_t>(i), mean);
            spin.bridged += i - last - 1;
        }
        last = i;
    }
    if (static_cast<double>(spin.bridged) > most_made_up * static_cast<double>(angle.values.size()))
        return {series.values, 0};
    return spin;
}

}  // namespace swirl::apps
