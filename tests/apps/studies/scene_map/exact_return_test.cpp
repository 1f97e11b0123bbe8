// An orbit that repeats itself to the bit is recognised, whenever it begins to, and no other is.
#include "apps/studies/scene_map/exact_return.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace swirl::studies {
namespace {

PostImpactState<double> state(std::int64_t n) {
    const auto x = static_cast<double>(n);
    return {{std::cos(x), std::sin(x)}, {1, 0}, -0.1 * x, 0.2 * x, x};
}

TEST(ExactReturn, GivesAWholeNumberOfPeriods) {
    for (const std::int64_t period : {1, 2, 3, 7, 63, 64, 65, 100}) {
        for (const std::int64_t begins : {0, 1, 63, 64, 65, 500}) {
            ExactReturn exact;
            std::int64_t found = 0, n = 0;
            for (; n < 10'000 && found == 0; ++n)
                found = exact.after(state(n < begins ? n : begins + (n - begins) % period));
            ASSERT_GT(found, 0) << "period " << period << " from " << begins;
            EXPECT_EQ(found % period, 0) << "period " << period << " from " << begins;
            // Marks are set at powers of two: found within the doubling after the orbit repeats, and one period.
            EXPECT_LE(n, 4 * (begins + period) + 200);
        }
    }
}

TEST(ExactReturn, NothingIsFoundWhereNothingReturns) {
    ExactReturn exact;
    for (std::int64_t n = 0; n < 10'000; ++n) ASSERT_EQ(exact.after(state(n)), 0);
    ExactReturn nearly;  // one bit apart
    PostImpactState<double> z = state(3);
    for (int n = 0; n < 1000; ++n) {
        z.spin = std::nextafter(z.spin, 9.0);
        ASSERT_EQ(nearly.after(z), 0);
    }
}

}  // namespace
}  // namespace swirl::studies
