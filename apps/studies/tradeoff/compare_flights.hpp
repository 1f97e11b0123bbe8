// Every arithmetic on the same flights, against the top one.
#pragma once

#include "analysis/classification/escape_rate.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/tradeoff/arithmetic.hpp"
#include "apps/studies/tradeoff/drawn_flights.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace swirl::studies::tradeoff {

/// Of the errors of many flights. NaN where there are none.
struct ErrorSpread {
    double median = std::nan(""), most_of = std::nan(""), largest = std::nan("");  ///< most_of: of 99 % at most that
};

/// The error of a flight is the largest difference among the section coordinates just after its impact, angles as
/// angles, velocities and spin relative to their size where that is above 1. Errors are of first contacts that were
/// found, of the same vertex; those that were not found are counted.
struct FlightComparison {
    std::int64_t flights = 0;  ///< that both could be asked for: no contact in the top arithmetic's step
    /// Passed over: no contact was found, or one that is later than the first by more than `late_contact`
    /// or half the flight, and by more than rounding (`most_roundings`).
    std::int64_t missed = 0;
    /// Another vertex' contact was taken for the first, at nearly its time (unless two touch within rounding of each
    /// other), or one that is earlier by more than that.
    std::int64_t misordered = 0;
    analysis::RateInterval missed_rate, misordered_rate;
    ErrorSpread one, ten;  ///< after one flight, and after ten in a row
    std::int64_t tens = 0;
    double largest_in_condition = std::nan("");  ///< of error/(ε condition), ε the arithmetic's own
};

/// A contact at a time that is farther off than this is another contact, and so is one that is farther off than half
/// the flight: 1.1° of the swirl, more than a search in steps of 0.01 is late by.
inline constexpr double late_contact = 0.02;

/// ε c, c the step's condition: a step whose error is below so many of these is known as well as its arithmetic's
/// numbers allow.
inline constexpr double most_roundings = 50;

struct ComparedFlights {
    /// One an arithmetic but for the last, with which they are compared; none of an arithmetic that would have taken
    /// the time of all.
    std::vector<std::optional<FlightComparison>> arithmetics;
    std::int64_t flights = 0;  ///< compared
    bool whole = true;         ///< false: the budget was spent before all drawn ones were
};

/// Equal flights give equal results, whatever the number of threads.
ComparedFlights compare_flights(const Scene<double>& scene, const std::vector<DrawnFlight>& flights,
                                std::span<const Arithmetic> arithmetics, const Budget& budget,
                                const RunControl& control);

}  // namespace swirl::studies::tradeoff
