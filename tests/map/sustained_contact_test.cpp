// Sustained contact, whole orbits: energy balances, nothing leaves the container, and every orbit ends with a named
// outcome.
#include "tests/map/contact_scenes.hpp"
#include "tests/map/follow_contact.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <tuple>
#include <vector>

namespace swirl {
namespace {

using tests::Tally;

Scene<double> scene_of(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return tests::uniform_scene(sides, alpha, beta, mu, e, law);
}

void check_plastic_polygon(int sides, double until, int starts, std::mt19937_64& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<LabStart<double>> start(static_cast<std::size_t>(starts));
    for (auto& s : start) s = {0.4, 0, 0.4 * u(random), 0.4 * u(random), u(random), u(random)};
    std::vector<Tally> tallies(start.size());
    tbb::parallel_for(std::size_t{0}, start.size(), [&](std::size_t i) {
        tallies[i] = tests::follow(scene_of(sides, 0.5, 0.4, 0.2 * static_cast<double>(i % 5), 0), start[i], until);
    });
    long impacts = 0, pieces = 0;
    double outside = 0, balance = 0;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        const Tally& tally = tallies[i];
        EXPECT_TRUE(tally.outcome == Outcome::completed || tally.outcome == Outcome::in_contact)
            << sides << " sides, start " << i << ": " << name_of(tally.outcome) << " at t = " << tally.time;
        EXPECT_LE(tally.outside, 1e-12) << sides << " sides, start " << i;
        if (tally.exchanged > 0) balance = std::max(balance, std::abs(tally.balance) / tally.exchanged);
        outside = std::max(outside, tally.outside);
        impacts += tally.impacts;
        pieces += tally.pieces;
    }
    std::printf("e = 0, %2d sides: %ld impacts, %ld pieces of contact, outside by %.1e, balance of J %.1e\n", sides,
                impacts, pieces, outside, balance);
    EXPECT_LE(balance, 1e-9);
    EXPECT_GT(pieces, 0);
}

void check_plastic_polygons(double until, int starts) {
    std::mt19937_64 random(5);
    for (const int sides : {3, 4, 6, 12}) check_plastic_polygon(sides, until, starts, random);
}

TEST(PlasticPolygons, GoOnWithoutAStall) {
    check_plastic_polygons(200, 5);
}
TEST(PlasticPolygonsNightly, GoOnWithoutAStallForAHundredThousandTimeUnits) {
    check_plastic_polygons(1e5, 20);
}

/// An orbit's outcome, and the last events of its contacts.
Tally follow_scene(const Scene<double>& scene, double vx, double vy, double angle, double until) {
    return tests::follow(scene, {scene.beta, 0, vx, vy, angle, 0}, until, 1'000'000);
}

void expect_goes_on(const Tally& tally) {
    EXPECT_TRUE(tally.outcome == Outcome::completed || tally.outcome == Outcome::in_contact)
        << name_of(tally.outcome) << " at t = " << tally.time;
}

TEST(Neighbours, ThatMoveOutwardsFromTheWallStrikeAtOnce) {
    // They are outside by 1e-13 and would be back inside before the first moment examined.
    const auto scene =
        scene_of(4, 0.12258780038963203, 0.17039617652250127, 1.4930782370778422, 0.28325069853683554, Law::stronge);
    const Tally tally = follow_scene(scene, 0.013145127895567769, 0.14225107689545022, 3.156319074828724, 1000);
    EXPECT_LE(tally.outside, 1e-15);
    expect_goes_on(tally);
}

TEST(Neighbours, ThatAreOutsideBetweenTwoLooksStrike) {
    // A swing from edge to edge that goes too far by 8e-6, for a fortieth of a step; a slip that turns round.
    for (const auto& [scene, vx, vy, angle] :
         {std::tuple{scene_of(50, 0.97608948378345117, 0.44666920243550368, 1.7449815208099522, 0, Law::stronge),
                     -0.12998357684496356, -0.059265782842172703, 0.89632774093571277},
          std::tuple{scene_of(3, 0.17141008545796713, 0.0013397472815017204, 0.27727887373260257, 0.16662228081437142,
                              Law::newton),
                     -0.14208770075879187, -0.014807044215039629, 1.5576608303647883}}) {
        const Tally tally = follow_scene(scene, vx, vy, angle, 200);
        EXPECT_LE(tally.outside, 1e-12);
        expect_goes_on(tally);
    }
}

TEST(Neighbours, ReboundsBelowTheRoundingOfChiComeToAnEnd) {
    // The neighbour's rebounds shrink by 0.7 % and 3.4 % only: at 1e-8 their height is below the rounding of chi, and
    // they must go on shrinking.
    for (const auto& [scene, vx, vy, angle] :
         {std::tuple{scene_of(4, 0.41712226908475114, 0.43283562139156206, 0, 0.99294724955325364, Law::stronge),
                     -0.14268421102509951, 0.0070270327629084481, 4.2893516925134403},
          std::tuple{scene_of(3, 0.79128475430725587, 0.3056057361677636, 0, 0.96642109975151236, Law::newton),
                     0.10290581510475638, 0.099088629433108102, 1.9993280238152451}}) {
        const Tally tally = follow_scene(scene, vx, vy, angle, 1000);
        EXPECT_LE(tally.impacts, 20'000);
        EXPECT_EQ(tally.time, 1000);
    }
}

TEST(Neighbours, StrikingInTurnOnAVertexThatRestsComeToAnEnd) {
    // Falling by one ulp of chi would restore the energy that the strikes dissipate: 7e7 impacts per unit of time
    // without end.
    for (const auto& [scene, vx, vy, angle] : {std::tuple{scene_of(3, 0.2305, 0.8881, 0, 0.9), 0.13253878162171626,
                                                          -0.053306984828792633, 1.8834260572510948},
                                               std::tuple{scene_of(3, 0.2645, 1.1694, 0.02, 0.95), 0.088817989841380604,
                                                          0.11189069642218934, 2.3074061207662746}}) {
        const Tally tally = follow_scene(scene, vx, vy, angle, 50);
        EXPECT_LE(tally.impacts, 2000);
        EXPECT_EQ(tally.time, 50);
    }
}

TEST(Neighbours, WhoseFlightsShrinkToNothingStrikeAtOnce) {
    // e = 0: two vertices strike in turn, after 6e-5, 3e-9, 0; neither stays in contact, as both would leave.
    const auto scene = scene_of(3, 0.16461011689074043, 0.25485641651225677, 0, 0, Law::stronge);
    const Tally tally = follow_scene(scene, -0.018940639782931395, -0.14159595838130182, 5.6101918097274952, 60);
    expect_goes_on(tally);
    EXPECT_LE(std::abs(tally.balance), 1e-12);
}

TEST(Release, AtLargeFrictionIsResolved) {
    // The rounding of the gap's second derivative (zero here) is multiplied by mu: the third one makes it leave the
    // wall.
    const auto scene = scene_of(5, 0.58729167534569859, 1.1549464061924219, 707.61110839153741, 0);
    const Tally tally = follow_scene(scene, 0.10732384401654826, -0.094285501381801765, 1.5706488779670016, 60);
    expect_goes_on(tally);
}

TEST(Release, CloseToAStrikeOfTheNeighbourIsResolved) {
    // A vertex is released 1e-4 before its neighbour strikes: its gap is below 1e-16 all the way.
    const auto scene = scene_of(8, 0.36454827658835726, 0.866862777474248, 1.8310345267194184, 0.043470744687158516);
    const Tally tally = follow_scene(scene, 0.023506691470764139, -0.14090989575400453, 1.005305731755205, 300);
    EXPECT_EQ(tally.outcome, Outcome::completed) << name_of(tally.outcome) << " at t = " << tally.time;
}

TEST(Release, FiveMillionthsBeforeAStrikeOfTheNeighbourIsResolved) {
    const auto scene =
        scene_of(20, 0.64924916475612793, 0.099972223845483502, 1.340329544151627, 0.16642231990613229, Law::newton);
    const Tally tally = follow_scene(scene, -0.1421816906209733, 0.013875522241269108, 2.5455178191748407, 300);
    expect_goes_on(tally);
    EXPECT_GE(tally.time, 300);
}

TEST(Rocking, ThatFrictionStopsEndsAtRest) {
    // On this edge no sliding is consistent: the slip that remains of rocking must not end the contact.
    const auto scene = scene_of(4, 0.13418721697544064, 0.28448658488686412, 1.9592219650602412, 0, Law::newton);
    const Tally tally = follow_scene(scene, -0.11763498469767016, -0.081056607630007757, 5.9218009112310632, 300);
    expect_goes_on(tally);
}

}  // namespace
}  // namespace swirl
