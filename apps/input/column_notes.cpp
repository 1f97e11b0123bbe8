#include "apps/input/column_notes.hpp"

#include "apps/input/column_names.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace swirl::apps {

namespace {

/// What the values of an angle span, and its steps from row to row.
struct AngleSteps {
    double low = std::numeric_limits<double>::infinity();
    double span = 0;
    std::vector<double> sizes;

    explicit AngleSteps(const std::vector<double>& values) {
        double high = -low, last = std::nan("");
        for (const double value : values) {
            if (std::isnan(value)) continue;
            low = std::min(low, value), high = std::max(high, value);
            if (!std::isnan(last)) sizes.push_back(std::abs(value - last));
            last = value;
        }
        if (high >= low) span = high - low;
    }
    std::ptrdiff_t longer_than(double size) const {
        return std::count_if(sizes.begin(), sizes.end(), [size](double step) { return step > size; });
    }
};

/// A turn of degrees, of which rows step back by half and more: no angle in radians, unwound or not, does.
bool come_round_at_360(const AngleSteps& steps) {
    return steps.span <= 360 && steps.longer_than(180) > 0;
}

/// The values stay within 1/N of a turn, and jump by nearly as much again and again: a tracker that cannot tell a
/// polygon's sides apart. 0: they don't.
int symmetry_seen(const AngleSteps& steps, double turn) {
    constexpr int most = 12, fewest_jumps = 3;
    constexpr double margin = 0.05, of_a_jump = 0.8;  // of the span
    if (!(steps.span > 0) || steps.longer_than(of_a_jump * steps.span) < fewest_jumps) return 0;
    const double sides = std::round(turn / steps.span);
    return sides >= 2 && sides <= most && std::abs(steps.span * sides / turn - 1) <= margin ? static_cast<int>(sides)
                                                                                            : 0;
}

/// The values turn back at both ends of a quarter or half of a turn, again and again, and never jump: an acute angle,
/// or an arc cosine.
bool is_folded(const AngleSteps& steps, const std::vector<double>& values, double turn) {
    constexpr double margin = 0.01, at_end = 0.05, of_a_jump = 0.5;  // of the span
    constexpr int fewest = 3;
    if (!(steps.span > 0) || steps.longer_than(of_a_jump * steps.span) > 0) return false;
    const double parts = turn / steps.span;
    if (std::abs(parts / 2 - 1) > margin && std::abs(parts / 4 - 1) > margin) return false;
    int turned = 0, last = 0;  // from one end to the other
    for (const double value : values) {
        const double place = (value - steps.low) / steps.span;
        const int end = place < at_end ? -1 : place > 1 - at_end ? 1 : 0;
        if (end != 0 && end != last) ++turned, last = end;
    }
    return turned > 2 * fewest;
}

/// The notes on one column.
class ColumnNotes {
public:
    ColumnNotes(const DelimitedFile& file, const SeriesChoice& choice, std::size_t column, MeasuredSeries& series)
        : choice_(choice),
          series_(series),
          name_(column_name(file, column)),
          unit_(unit_of_column(file, column)),
          is_rate_(turning_rate_of(file, column).has_value()) {}

    /// Of --angle.
    void note_angle(const std::vector<double>& values) {
        note_unit();
        const AngleSteps steps(values);
        const double turn = 2 * pi<double>() / series_.angle_unit;
        if (!choice_.degrees && (names_degrees(unit_) || !radians_in(unit_))) note_degrees(steps);
        if (const int sides = choice_.symmetry == 1 ? symmetry_seen(steps, turn) : 0; sides > 0)
            add(
                fmt::format("stays within 1/{} of a turn and jumps by as much: if the tracker knows the angle but for "
                            "that, --symmetry {} says so",
                            sides, sides));
        if (is_folded(steps, values, turn))
            add("turns back at both ends of what it spans, again and again: of an acute angle or an arc cosine the "
                "sense of turns is lost");
    }

    /// Of a column of which the values are analysed.
    void note_no_spin() {
        if (unit_ == "%" && choice_.scale == 1)
            add("is in percent by its unit, and is read as it stands: --scale 0.01 makes a number of it");
        if (is_rate_ && !choice_.has_swirl_rate())
            add("is a rate of turn by its unit, and is read as it stands: over --swirl-rate W it is S");
        else if (names_angle(name_) && !is_rate_)
            add(fmt::format("is an angle by its name, and is read as it stands: --angle {} takes its rate, S",
                            in_one_word(name_)));
    }

private:
    void add(const std::string& words) { series_.notes.push_back(fmt::format("column {} {}", name_, words)); }

    /// Degrees are said by the flag; of what is unwound in radians the values say nothing against them.
    void note_unit() {
        const std::optional<double> named = radians_in(unit_);
        const bool is_other = named && !names_degrees(unit_);
        if (choice_.degrees) {
            series_.angle_unit = pi<double>() / 180;
            if (is_other) add(fmt::format("is read in degrees, though its unit is {}: leave --degrees out", unit_));
        } else if (is_other && *named != 1) {
            series_.angle_unit = *named;
            add(fmt::format("is read in {}, its unit", unit_));
        }
    }

    void note_degrees(const AngleSteps& steps) {
        if (const bool is_named = names_degrees(unit_); is_named || come_round_at_360(steps))
            add(fmt::format("is read in radians, though its {} degrees: --degrees says so",
                            is_named ? "unit is" : "values come round at 360 as do"));
        else if (steps.span > more_than_turn)
            add(fmt::format("is read in radians, over {:.3g} turns, and no unit is named: of degrees --degrees says so",
                            steps.span / (2 * pi<double>())));
    }

    const SeriesChoice& choice_;
    MeasuredSeries& series_;
    std::string name_, unit_;
    bool is_rate_;
};

}  // namespace

void note_column(const DelimitedFile& file, const SeriesChoice& choice, std::size_t column,
                 const std::vector<double>& values, MeasuredSeries& series) {
    ColumnNotes notes(file, choice, column, series);
    if (!choice.angle.empty())
        notes.note_angle(values);
    else if (!choice.is_angle() && choice.position.empty() && !file.header.empty())
        notes.note_no_spin();
}

}  // namespace swirl::apps
