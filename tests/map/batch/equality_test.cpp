// The batch has the scalar map's bits at every impact: all shapes, impact rules and instruction sets, random scenes.
#include "tests/map/batch/together.hpp"
#include "tests/sample_count.hpp"

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
template <class F>
void expect_equal(std::uint64_t seed, int scenes, long long impacts) {
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

/// 1,000 scenes, 10⁷ impacts for each rule.
TYPED_TEST(BatchEqualityNightly, HasTheBitsOfTheScalarMap) {
    expect_equal<TypeParam>(3, 1000, 10'000);
}

}  // namespace
