// What is analysed of a measured motion: gaps in its times, S of an angle, a distance of a position.
#pragma once

#include <cstddef>
#include <vector>

namespace swirl::apps {

/// What a step of 2, 3, … times the usual one means.
enum class LongSteps {
    lost_rows,     ///< samples are missing
    maybe,         ///< the same where it happens seldom: less than 8 times, or in 1 % of the steps. A cycle of impacts
                   ///< with one long flight has one in every period, of which a verdict needs 8
    long_flights,  ///< rows are impacts: nothing is missing
};

/// Where times are otherwise even (nine steps in ten within a tenth of their median or, of lost_rows, within the last
/// digit that the times have), a step of 2, 3, … such steps (to a quarter of one) has lost the samples between: rows of
/// NaN are put there, at their times; for more than there are rows in all (or, of lost_rows, a step that is no
/// multiple) a single one, so that nothing reaches across. Uneven times stay as they are.
///   columns  as long as `times`, and kept so
/// @return how many rows were put in. O(rows).
std::size_t fill_lost_rows(std::vector<double>& times, std::vector<std::vector<double>>& columns, LongSteps meaning);

/// The largest of 1, 0.1, … 10⁻¹² that all values are multiples of, as far as their rounding tells; 0 if none is.
/// Missing values are left out. O(values).
double decimal_resolution(const std::vector<double>& values);

/// The largest step that values lie on, from the first of them on: so many times a decimal digit, down to 10⁻⁹ of the
/// largest difference (0.5: the middles of boxes of pixels). 0 if there is none, or nothing but one value. Missing
/// values are left out. O(values).
double rounding_step(const std::vector<double>& values);

/// So many runs of missing values.
std::size_t count_gaps(const std::vector<double>& values);

/// Times of an angle's rows that are even but for their last digits: the angle may have been taken at even times, whose
/// digits a clock rounded, or at the times as they stand. They are put on the even times that fit best (least squares)
/// if none is half a step or more away, unless θ_i − S (t_i − even time), S the mean turn over the mean step, has less
/// than half the sum of squared second differences that θ_i has. O(rows).
/// @return by how much of a step at most; 0: they stayed as they were
double even_out_times(std::vector<double>& times, const std::vector<double>& angles, double period);

/// S = Δθ / (ω_s Δt) between neighbouring rows, at the times half-way; NaN beside a missing angle. An angle is known
/// modulo `period`: Δθ is its representative in [−period/2, period/2), which is the true one if the body turns by less
/// than half a period from row to row.
struct AngleRates {
    std::vector<double> times, values;
    double largest_turn = 0;  ///< the largest |Δθ| / (period/2): near 1 the unwrapping is a guess
};
AngleRates rates_of_angle(const std::vector<double>& times, const std::vector<double>& angles, double period,
                          double swirl_rate);

/// Makes rates of an angle equal, to their mean, where what the angles were rounded to in double explains how they
/// differ: a body that turns evenly has no spectrum. O(rates).
void level_rounding(AngleRates& rates, const std::vector<double>& angles, double swirl_rate);

}  // namespace swirl::apps
