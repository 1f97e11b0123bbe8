#include "apps/studies/tradeoff/compare_flights.hpp"

#include "apps/studies/parallel/pieces.hpp"
#include "map/numbers/quad.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace swirl::studies::tradeoff {

namespace {

constexpr std::size_t in_a_piece = 50;  // flights: some milliseconds of the top arithmetic

/// The contact that an arithmetic found, beside the top arithmetic's.
enum class FoundContact { first, missed, misordered };

/// What one arithmetic did on one flight.
struct FlightError {
    bool compared = false;
    FoundContact contact = FoundContact::first;
    double one = std::nan(""), ten = std::nan("");
    double condition = 1;
};

double angle_between(const Vec2<Quad>& a, const Vec2<Quad>& b) {
    using std::atan2;
    return std::abs(static_cast<double>(atan2(cross(a, b), dot(a, b))));
}

double relative_difference(const Quad& a, const Quad& b) {
    using std::fabs;
    const Quad size = std::max(Quad(1), fabs(b));
    return static_cast<double>(fabs(a - b) / size);
}

double error_of(const PostImpactState<Quad>& a, const PostImpactState<Quad>& exact) {
    return std::max({angle_between(a.psi, exact.psi), angle_between(a.chi, exact.chi),
                     relative_difference(a.vn, exact.vn), relative_difference(a.vt, exact.vt),
                     relative_difference(a.spin, exact.spin)});
}

bool is_flight(const ArithmeticStep& step) {
    return step.outcome == Outcome::completed && step.rounded.contacts.empty();
}

bool is_of_same_vertex(const ArithmeticStep& step, const ArithmeticStep& exact) {
    return step.rounded.collision.vertex_step == exact.rounded.collision.vertex_step;
}

FoundContact contact_of(const ArithmeticStep& step, const ArithmeticStep& exact) {
    if (!is_flight(step)) return FoundContact::missed;
    const Collision<double>&a = step.rounded.collision, &b = exact.rounded.collision;
    const double late = a.flight_time - b.flight_time;
    const double apart = std::min(late_contact, b.flight_time / 2);
    if (!(late <= apart)) return FoundContact::missed;
    if (late < -apart) return FoundContact::misordered;
    const bool is_another = !is_of_same_vertex(step, exact) && !a.simultaneous && !b.simultaneous;
    return is_another ? FoundContact::misordered : FoundContact::first;
}

/// The steps of an arithmetic from a drawn state: as many as asked for, fewer where it leaves flights, or is over.
std::vector<ArithmeticStep> steps_of(
    const ArithmeticMap& map, PostImpactState<Quad> z, int count,
    const std::function<bool()>& is_over = [] { return false; }) {
    std::vector<ArithmeticStep> steps;
    for (int k = 0; k < count; ++k) {
        steps.push_back(map.advance(z));
        if (is_over() || !is_flight(steps.back())) break;
        z = steps.back().after;
    }
    return steps;
}

/// Of a flight as short as rounding itself a contact half the flight later is the same one.
bool is_off_by_rounding(const ArithmeticStep& step, const ArithmeticStep& exact, double rounding) {
    const Collision<double>&a = step.rounded.collision, &b = exact.rounded.collision;
    const double most = most_roundings * rounding;
    return is_flight(step) && is_of_same_vertex(step, exact) &&
           std::fabs(a.flight_time - b.flight_time) <= most * std::max(1.0, b.flight_time) &&
           error_of(step.after, exact.after) <= most;
}

///   epsilon  of the arithmetic
FlightError compare(const std::vector<ArithmeticStep>& steps, const std::vector<ArithmeticStep>& exact,
                    double condition, double epsilon) {
    FlightError error;
    error.condition = condition;
    error.compared = is_flight(exact.front());
    if (!error.compared) return error;
    error.contact = contact_of(steps.front(), exact.front());
    if (error.contact != FoundContact::first && !is_off_by_rounding(steps.front(), exact.front(), epsilon * condition))
        return error;
    error.contact = FoundContact::first;
    // Of two vertices that strike at once either may be the first: the states after them are not to be compared.
    if (!is_of_same_vertex(steps.front(), exact.front())) return error;
    error.one = error_of(steps.front().after, exact.front().after);
    if (exact.size() < ten || steps.size() < ten || !is_flight(exact.back())) return error;
    for (std::size_t k = 1; k < ten; ++k)
        if (contact_of(steps[k], exact[k]) != FoundContact::first) return error;
    error.ten = error_of(steps.back().after, exact.back().after);
    return error;
}

ErrorSpread spread_of(std::vector<double> errors) {
    std::erase_if(errors, [](double error) { return std::isnan(error); });
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    return {errors[errors.size() / 2], errors[(errors.size() * 99 + 99) / 100 - 1], errors.back()};
}

/// All errors of one arithmetic: a list a piece, empty where the piece is missing.
using ArithmeticErrors = std::vector<std::vector<FlightError>>;

FlightComparison summary_of(const ArithmeticErrors& pieces, double epsilon) {
    FlightComparison found;
    std::vector<double> one, after_ten;
    for (const auto& piece : pieces) {
        for (const FlightError& error : piece) {
            found.flights += error.compared ? 1 : 0;
            found.missed += error.contact == FoundContact::missed ? 1 : 0;
            found.misordered += error.contact == FoundContact::misordered ? 1 : 0;
            one.push_back(error.one);
            after_ten.push_back(error.ten);
            if (!std::isnan(error.one))
                found.largest_in_condition =
                    std::fmax(found.largest_in_condition, error.one / (epsilon * error.condition));
        }
    }
    found.missed_rate = analysis::rate_interval(found.missed, found.flights);
    found.misordered_rate = analysis::rate_interval(found.misordered, found.flights);
    found.one = spread_of(std::move(one));
    found.tens = std::count_if(after_ten.begin(), after_ten.end(), [](double error) { return !std::isnan(error); });
    found.ten = spread_of(std::move(after_ten));
    return found;
}

/// Of what is left of the flights' share of the budget, what an arithmetic that is only compared with may take of it.
constexpr double share_of_one = 0.3;

/// What the pieces of work need: it outlives the call, as they may.
struct Work {
    using Clock = std::chrono::steady_clock;

    Scene<double> scene;
    std::vector<DrawnFlight> flights;
    std::span<const Arithmetic> arithmetics;
    std::vector<ArithmeticMap> maps;
    std::vector<ArithmeticErrors> errors;  ///< [arithmetic][piece]
    const Budget* budget;
    double most_of_one = 0;                              ///< seconds that one arithmetic may take
    mutable std::vector<std::atomic<Clock::rep>> taken;  ///< by each arithmetic so far

    /// An arithmetic that none is recommended of, and that took so long that the others would not be done.
    bool is_left_out(std::size_t r) const {
        return !arithmetics[r].is_exact &&
               std::chrono::duration<double>(Clock::duration(taken[r])).count() > most_of_one;
    }

    FlightError compare_one(std::size_t r, const DrawnFlight& flight, int count,
                            const std::vector<ArithmeticStep>& exact) const {
        if (is_left_out(r)) return {};
        auto last = Clock::now();
        const auto steps = steps_of(maps[r], arithmetics[r].begin(scene, flight.state), count, [&] {
            const auto now = Clock::now();
            taken[r] += (now - std::exchange(last, now)).count();
            return is_left_out(r);
        });
        return is_left_out(r) ? FlightError{} : compare(steps, exact, flight.condition, arithmetics[r].epsilon);
    }

    /// The errors of each arithmetic on a piece's flights; nothing once the budget is spent.
    std::vector<std::vector<FlightError>> piece(std::size_t number) const {
        std::vector<std::vector<FlightError>> found(errors.size());
        for (std::size_t i = number * in_a_piece; i < std::min(flights.size(), (number + 1) * in_a_piece); ++i) {
            if (budget->is_spent(counted_share)) return {};
            const DrawnFlight& flight = flights[i];
            const int count = flight.begins_ten ? ten : 1;
            const auto exact = steps_of(maps.back(), arithmetics.back().begin(scene, flight.state), count);
            for (std::size_t r = 0; r < found.size(); ++r) found[r].push_back(compare_one(r, flight, count, exact));
        }
        return found;
    }
};

}  // namespace

ComparedFlights compare_flights(const Scene<double>& scene, const std::vector<DrawnFlight>& flights,
                                std::span<const Arithmetic> arithmetics, const Budget& budget,
                                const RunControl& control) {
    const std::size_t pieces = (flights.size() + in_a_piece - 1) / in_a_piece;
    const double left = counted_share * budget.seconds() - budget.spent();
    const auto work =
        std::make_shared<Work>(Work{scene,
                                    flights,
                                    arithmetics,
                                    {},
                                    std::vector<ArithmeticErrors>(arithmetics.size() - 1, ArithmeticErrors(pieces)),
                                    &budget,
                                    share_of_one * left,
                                    std::vector<std::atomic<Work::Clock::rep>>(arithmetics.size())});
    for (const Arithmetic& arithmetic : arithmetics) work->maps.push_back(arithmetic.make(scene, {}));
    ComparedFlights compared;
    compared.whole = run_pieces(pieces, "tradeoff: errors", control, [work](std::size_t number) -> KeepResult {
        auto found = work->piece(number);
        if (found.empty()) return {};
        return [work, number, found = std::move(found)]() mutable {
            for (std::size_t r = 0; r < found.size(); ++r) work->errors[r][number] = std::move(found[r]);
        };
    });
    for (std::size_t r = 0; r + 1 < arithmetics.size(); ++r) {
        compared.arithmetics.emplace_back();
        if (work->is_left_out(r))
            compared.whole = false;
        else
            compared.arithmetics.back() = summary_of(work->errors[r], arithmetics[r].epsilon);
        if (compared.arithmetics.back()) compared.flights = compared.arithmetics.back()->flights;
    }
    return compared;
}

}  // namespace swirl::studies::tradeoff
