// The batch has the scalar map's bits at every impact: all shapes, impact rules and instruction sets, random scenes.
#include "tests/map/batch/together.hpp"
#include "tests/sample_count.hpp"

#include <cstdint>
#include <iostream>
#include <set>
#include <string>

namespace {

using namespace swirl;
using namespace swirl::tests;

/// One shape and impact rule.
template <Shape shape_, ImpactRule rule_>
struct Family {
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
};

/// Scenes with as many impacts each: all the same bits, and not because the lanes left everything to the scalar code.
/// @return how many impacts were compared
template <class F>
long long expect_equal(std::uint64_t seed, int scenes, long long impacts) {
    const auto set = random_orbits<F::shape, F::rule>(seed, scenes, impacts);
    const Compared result = compare(set.orbits);
    std::cout << detail::name_of_instruction_set() << ": " << result.impacts << " impacts of " << scenes << " scenes, "
              << 100 * result.use.share_left() << " % left their lanes, " << 100 * result.use.lanes_in_use()
              << " % of the lanes in use\n";
    EXPECT_EQ(result.different, 0) << "of " << result.impacts << " impacts, " << detail::name_of_instruction_set();
    EXPECT_GT(result.impacts, scenes * impacts / 4) << "most orbits end early";
    // Of many scenes at most 44 % leave; a few may be such as leave nearly always.
    EXPECT_GT(result.by_lanes, scenes < 100 ? 0 : result.impacts / 2) << "the lanes leave too much";
    EXPECT_EQ(result.use.impacts, result.impacts);
    return result.impacts;
}

template <class F>
class BatchEquality : public testing::Test {};
template <class F>
class BatchEqualityNightly : public testing::Test {};

using Families =
    testing::Types<Family<Shape::disk, ImpactRule::frictionless>, Family<Shape::disk, ImpactRule::poisson>,
                   Family<Shape::polygon, ImpactRule::frictionless>, Family<Shape::polygon, ImpactRule::poisson>,
                   Family<Shape::polygon, ImpactRule::newton>, Family<Shape::polygon, ImpactRule::stronge>>;
TYPED_TEST_SUITE(BatchEquality, Families);
TYPED_TEST_SUITE(BatchEqualityNightly, Families);

TYPED_TEST(BatchEquality, HasTheBitsOfTheScalarMap) {
    expect_equal<TypeParam>(1, static_cast<int>(sample_count(300)), 500);
}

TYPED_TEST(BatchEquality, WithEveryInstructionSet) {
    std::set<std::string> names;  // what is not compiled for a set runs as the simplest one
    for (std::int64_t sets = hwy::SupportedTargets(); sets != 0; sets &= sets - 1) {
        const OnlySet only(sets & -sets);
        if (!names.insert(detail::name_of_instruction_set()).second) continue;
        expect_equal<TypeParam>(2, static_cast<int>(sample_count(100)), 200);
    }
    EXPECT_GT(names.size(), 1u) << "this processor has one instruction set only that Highway knows";
}

using Polygon = CollisionMap<double, Shape::polygon, ImpactRule::poisson>;

/// Many short orbits of one elastic scene, from states that leave the wall with −u_n = slowest … fastest.
Compared compare_starts(int sides, double slowest, double fastest, double spin, long long impacts) {
    const Scene<double> scene{sides, 0.4, 0.8, 0.5, 1, Law::poisson, uniform_inertia_factor<double>(sides)};
    Random random(7);
    Orbits<Polygon> set;
    for (long k = 0; k < sample_count(1000); ++k)
        set.add(scene, post_impact_state(random_point(random, scene, random.log_between(slowest, fastest), 1, spin)),
                impacts);
    return compare(set.orbits);
}

TEST(BatchEqualityOfStarts, HopsFarShorterThanTheCircumscribedCirclesReturn) {
    for (const int sides : {3, 6}) {
        const Compared hops = compare_starts(sides, 1e-7, 1e-2, 3, 20);
        std::cout << sides << " sides: " << hops.use.search_failed << " of " << hops.use.left
                  << " left after failed searches\n";
        EXPECT_EQ(hops.different, 0) << sides;
        EXPECT_GT(hops.by_lanes, hops.impacts / 2) << sides;
        EXPECT_GT(hops.use.search_failed, 0) << sides;
    }
}

TEST(BatchEqualityOfRods, HaveTheBitsOfTheScalarMap) {
    Random random(12);
    Orbits<Polygon> set;
    for (long k = 0; k < sample_count(300); ++k) {
        const double mu = random.log_between(0.01, 2), restitution = random.chance(0.5) ? 1 : random.between(0.3, 1);
        const Scene<double> scene = random_scene(random, rod_sides, mu, restitution, Law::poisson);
        set.add(scene, post_impact_state(random_point(random, scene, random.log_between(0.01, 2))), 300);
    }
    const Compared rods = compare(set.orbits);
    std::cout << rods.impacts << " impacts of rods, " << 100 * rods.use.share_left() << " % left their lanes\n";
    EXPECT_EQ(rods.different, 0);
    EXPECT_GT(rods.by_lanes, rods.impacts / 4);
}

TEST(BatchEqualityOfStarts, SpinsThatTurnTheBodyBeyondTheTables) {
    for (const double spin : {30.0, 300.0, 1e4}) {
        const Compared spins = compare_starts(6, 1e-3, 2, spin, 3);  // impacts soon slow the spin
        std::cout << "S to " << spin << ": " << spins.use.left << " of " << spins.impacts << " impacts left\n";
        EXPECT_EQ(spins.different, 0) << spin;
        EXPECT_GT(spins.by_lanes, 0) << spin;
        EXPECT_GT(spins.use.left, 0) << spin;
    }
}

/// 10⁷ impacts for each rule, of 1,000 scenes and, since some orbits end early, of as many more as that takes.
TYPED_TEST(BatchEqualityNightly, HasTheBitsOfTheScalarMap) {
    constexpr long long wanted = 10'000'000;
    long long compared = 0;
    for (std::uint64_t seed = 3; compared < wanted && seed < 7; ++seed)
        compared += expect_equal<TypeParam>(seed, 1000, 10'000);
    EXPECT_GE(compared, wanted);
}

}  // namespace
