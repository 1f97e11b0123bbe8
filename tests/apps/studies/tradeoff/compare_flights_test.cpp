// Contacts that are passed over and contacts that are out of order, told apart on arithmetics that are made up.
#include "apps/studies/tradeoff/compare_flights.hpp"
#include "apps/studies/scene_map/in_digits.hpp"
#include "map/numbers/quad.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <thread>
#include <vector>

namespace swirl::studies::tradeoff {
namespace {

/// Every step ends like this: at time 1 with vertex 1 is where the first contact is.
template <Outcome outcome, int hundredths, int vertex, bool simultaneous>
ArithmeticMap ending(const Scene<double>&, std::span<const PostImpactState<double>>) {
    ArithmeticMap map;
    map.advance = [](const PostImpactState<Quad>& from) {
        ArithmeticStep step;
        step.outcome = outcome;
        step.after = from;
        step.rounded.collision.flight_time = 0.01 * hundredths;
        step.rounded.collision.vertex_step = vertex;
        step.rounded.collision.simultaneous = simultaneous;
        return step;
    };
    return map;
}

PostImpactState<Quad> begin(const Scene<double>&, const PostImpactState<double>& state) {
    return state_in<Quad>(state);
}

/// An arithmetic that finds the vertex at half the flight later, and S off by 1.
ArithmeticMap off_in_spin(const Scene<double>& scene, std::span<const PostImpactState<double>> states) {
    ArithmeticMap map = ending<Outcome::completed, 2, 1, false>(scene, states);
    map.advance = [advance = map.advance](const PostImpactState<Quad>& from) {
        ArithmeticStep step = advance(from);
        step.after.spin += 1;
        return step;
    };
    return map;
}

template <Outcome outcome, int hundredths, int vertex, bool simultaneous = false>
Arithmetic arithmetic() {
    return {"", "", false, 0x1p-52, &ending<outcome, hundredths, vertex, simultaneous>, &begin};
}

ComparedFlights compared(std::span<const Arithmetic> arithmetics, double budget, double condition = 1) {
    DrawnFlight flight;
    flight.condition = condition;
    flight.state = {{1, 0}, {1, 0}, -1, 0, 0};
    return compare_flights(Scene<double>{}, std::vector(3, flight), arithmetics, Budget(budget), {});
}

TEST(CompareFlights, AContactThatIsPassedOverIsMissedAndOneInAnothersPlaceIsOutOfOrder) {
    constexpr Outcome hit = Outcome::completed;
    const std::array arithmetics = {arithmetic<Outcome::no_contact, 100, 1>(),  // none
                                    arithmetic<hit, 103, 1>(),                  // the same vertex later
                                    arithmetic<hit, 150, 2>(),                  // another vertex, much later
                                    arithmetic<hit, 101, 2>(),        // another vertex at nearly the same time
                                    arithmetic<hit, 97, 1>(),         // where there is none yet
                                    arithmetic<hit, 101, 1>(),        // the first, not well
                                    arithmetic<hit, 100, 2, true>(),  // two at once
                                    arithmetic<hit, 100, 1>()};
    const auto found = compared(arithmetics, 60).arithmetics;
    ASSERT_EQ(found.size(), 7u);
    const std::array<std::int64_t, 7> missed = {3, 3, 3, 0, 0, 0, 0}, misordered = {0, 0, 0, 3, 3, 0, 0};
    for (std::size_t r = 0; r < found.size(); ++r) {
        EXPECT_EQ(found[r]->flights, 3) << r;
        EXPECT_EQ(found[r]->missed, missed[r]) << r;
        EXPECT_EQ(found[r]->misordered, misordered[r]) << r;
        EXPECT_EQ(std::isnan(found[r]->one.largest), missed[r] + misordered[r] > 0 || r == 6) << r;
        EXPECT_EQ(found[r]->missed_rate.least > 0, missed[r] > 0) << r;
        EXPECT_EQ(found[r]->misordered_rate.least > 0, misordered[r] > 0) << r;
    }
}

/// A flight of 0.01 whose contact is found 0.01 later: nothing is within half of it.
TEST(CompareFlights, OfAShortFlightAContactHalfAFlightLaterIsAnother) {
    constexpr Outcome hit = Outcome::completed;
    const std::array arithmetics = {arithmetic<hit, 2, 1>(), arithmetic<hit, 1, 1>()};
    EXPECT_EQ(compared(arithmetics, 60).arithmetics.front()->missed, 3);
}

/// Unless rounding, 50 ε c, is as long: at c = 10¹³ that is 0.1 beside the 0.01 of the flight, at 10¹¹ 0.001.
TEST(CompareFlights, OfAFlightAsShortAsRoundingAContactHalfAFlightLaterIsTheSame) {
    constexpr Outcome hit = Outcome::completed;
    const std::array arithmetics = {arithmetic<hit, 2, 1>(), arithmetic<hit, 2, 2>(),
                                    Arithmetic{"", "", false, 0x1p-52, &off_in_spin, &begin}, arithmetic<hit, 1, 1>()};
    const auto well = compared(arithmetics, 60, 1e13).arithmetics;
    EXPECT_EQ(well[0]->missed + well[0]->misordered, 0);
    EXPECT_EQ(well[0]->one.largest, 0);
    EXPECT_EQ(well[1]->missed, 3);  // another vertex
    EXPECT_EQ(well[2]->missed, 3);  // another impact
    EXPECT_EQ(compared(arithmetics, 60, 1e11).arithmetics[0]->missed, 3);
}

/// Takes a fifth of a second for a step.
ArithmeticMap slow(const Scene<double>& scene, std::span<const PostImpactState<double>> states) {
    ArithmeticMap map = ending<Outcome::completed, 100, 1, false>(scene, states);
    map.advance = [advance = map.advance](const PostImpactState<Quad>& z) {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        return advance(z);
    };
    return map;
}

TEST(CompareFlights, AnArithmeticThatTakesTheTimeOfAllIsLeftOutAlone) {
    const std::array arithmetics = {Arithmetic{"", "", false, 0x1p-52, &slow, &begin},
                                    arithmetic<Outcome::completed, 100, 1>(), arithmetic<Outcome::completed, 100, 1>()};
    const ComparedFlights found = compared(arithmetics, 0.5);
    EXPECT_FALSE(found.arithmetics[0].has_value());
    EXPECT_FALSE(found.whole);
    ASSERT_TRUE(found.arithmetics[1].has_value());
    EXPECT_EQ(found.arithmetics[1]->flights, 3);
    EXPECT_EQ(found.flights, 3);
}

}  // namespace
}  // namespace swirl::studies::tradeoff
