// The tree of --refine: borders as sharp as on the full grid, interiors cheap, and where nothing differs nothing is
// asked.
#include "apps/studies/grids/refine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <set>
#include <vector>

namespace swirl::studies::grids {
namespace {

struct Tree {
    std::vector<char> visited;
    std::vector<std::size_t> source;
    std::size_t looked_at = 0, wrong = 0;
    int waves = 0;
};

Tree refined(const Lattice& lattice, const std::function<std::int64_t(std::size_t)>& verdict) {
    Tree tree;
    tree.visited.assign(lattice.size(), 0);
    for (auto next = coarse_points(lattice); !next.empty(); next = next_points(lattice, tree.visited, verdict)) {
        for (const std::size_t place : next) {
            EXPECT_EQ(tree.visited[place], 0);  // nothing is asked twice
            tree.visited[place] = 1;
        }
        ++tree.waves;
    }
    tree.source = sources(lattice, tree.visited);
    for (std::size_t i = 0; i < tree.source.size(); ++i) {
        EXPECT_LT(tree.source[i], lattice.size());
        if (tree.source[i] >= lattice.size()) break;
        EXPECT_EQ(tree.visited[tree.source[i]], 1);
        tree.looked_at += tree.visited[i] != 0;
        tree.wrong += verdict(i) != verdict(tree.source[i]);
    }
    return tree;
}

TEST(Refine, NothingIsAskedWhereNothingDiffers) {
    const Lattice lattice{{17, 33}, 3};  // coarse 3 × 5
    const Tree tree = refined(lattice, [](std::size_t) { return 7; });
    EXPECT_EQ(tree.looked_at, 15u);
    EXPECT_EQ(tree.waves, 1);
    EXPECT_EQ(tree.wrong, 0u);
}

TEST(Refine, ACircleIsAsSharpAsOnTheFullGrid) {
    const std::size_t n = 16 * 16 + 1;
    const Lattice lattice{{n, n}, 4};
    const auto verdict = [&](std::size_t place) {
        const std::size_t row = place / n, column = place % n;
        const double x = static_cast<double>(row) / (n - 1), y = static_cast<double>(column) / (n - 1);
        return std::int64_t{std::hypot(x - 0.45, y - 0.55) < 0.3};
    };
    const Tree tree = refined(lattice, verdict);
    std::printf("%zu of %zu points in %d waves, %zu wrong\n", tree.looked_at, lattice.size(), tree.waves, tree.wrong);
    EXPECT_EQ(tree.wrong, 0u);
    EXPECT_LT(tree.looked_at, lattice.size() / 8);
}

/// A strip that the coarse grid meets at one edge only: it is followed from there through squares that were left whole.
TEST(Refine, ATongueIsFollowedBeyondTheCoarseGrid) {
    const std::size_t n = 8 * 16 + 1;
    const Lattice lattice{{n, n}, 4};
    const auto verdict = [&](std::size_t place) {
        const std::size_t row = place / n, column = place % n;
        const auto x = static_cast<double>(row), y = static_cast<double>(column);
        return std::int64_t{std::abs(y - 40) < 10 * (1 - x / static_cast<double>(n))};  // narrows to nothing
    };
    const Tree tree = refined(lattice, verdict);
    EXPECT_EQ(tree.wrong, 0u);
    EXPECT_LT(tree.looked_at, lattice.size() / 3);
}

/// Bumps that rise out of a border into the squares above it, between their corners and their sides' middles: they are
/// seen at the points that the squares below have on the common side.
TEST(Refine, ABorderThatBendsIntoASquareBetweenItsCornersIsFollowed) {
    const std::size_t n = 8 * 16 + 1;
    const Lattice lattice{{n, n}, 4};
    for (const double height : {2.0, 3.0, 6.0}) {
        const auto verdict = [&](std::size_t place) {
            const std::size_t row = place / n, column = place % n;
            const auto x = static_cast<double>(row), y = static_cast<double>(column);
            const double along = std::fmod(x, 16.0) - 4;
            return std::int64_t{y < 62.5 + 2 * height * std::exp(-along * along / 4)};
        };
        const Tree tree = refined(lattice, verdict);
        EXPECT_EQ(tree.wrong, 0u) << height;
        EXPECT_LT(tree.looked_at, lattice.size() / 3) << height;
    }
}

TEST(Refine, OneAxisAndThreeAreTreesToo) {
    const Lattice line{{65}, 5};
    const Tree border = refined(line, [](std::size_t place) { return std::int64_t{place > 37}; });
    EXPECT_EQ(border.wrong, 0u);
    EXPECT_EQ(border.looked_at, 3u + 5u);  // bisection
    const Lattice cube{{17, 17, 17}, 2};
    const Tree plane = refined(
        cube, [](std::size_t place) { return std::int64_t{place / 289 + (place / 17) % 17 + place % 17 > 20}; });
    EXPECT_EQ(plane.wrong, 0u);
    EXPECT_LT(plane.looked_at, cube.size());
}

}  // namespace
}  // namespace swirl::studies::grids
