#include "apps/studies/grids/refine.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace swirl::studies::grids {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Calls use(digits) for all combinations of one value a digit below its radix, the last fastest.
template <class Use>
void for_each(const std::vector<std::size_t>& radix, const Use& use) {
    std::vector<std::size_t> digits(radix.size(), 0);
    if (std::any_of(radix.begin(), radix.end(), [](std::size_t r) { return r == 0; })) return;
    for (;;) {
        use(digits);
        std::size_t k = radix.size();
        while (k-- > 0) {
            if (++digits[k] < radix[k]) break;
            digits[k] = 0;
        }
        if (k == none) return;
    }
}

std::size_t index_of(const Lattice& lattice, const std::vector<std::size_t>& at) {
    std::size_t index = 0;
    for (std::size_t k = 0; k < at.size(); ++k) index = index * lattice.points[k] + at[k];
    return index;
}

/// The 3^d points of a square of some size, as differences of indices from its lower corner.
struct Stencil {
    struct Point {
        std::size_t away;    ///< from the lower corner
        std::size_t corner;  ///< of the corner below it, half a side rounded down
        bool is_corner;
    };
    std::vector<Point> points;
};

Stencil stencil_of(const Lattice& lattice, std::size_t side) {
    Stencil stencil;
    for_each(std::vector<std::size_t>(lattice.points.size(), 3), [&](const std::vector<std::size_t>& halves) {
        std::vector<std::size_t> at, below;
        bool corner = true;
        for (const std::size_t h : halves) {
            at.push_back(h * (side / 2));
            below.push_back(h / 2 * side);
            corner = corner && h != 1;
        }
        stencil.points.push_back({index_of(lattice, at), index_of(lattice, below), corner});
    });
    return stencil;
}

/// A square of the tree by its lower corner.
struct Square {
    std::vector<std::size_t> at;
    std::size_t side;
};

/// use(stencil, square) for all squares of the tree's sizes, the largest first.
template <class Use>
void for_each_square(const Lattice& lattice, const Use& use) {
    for (std::size_t side = lattice.coarse_stride(); side > 1; side /= 2) {
        const Stencil stencil = stencil_of(lattice, side);
        std::vector<std::size_t> squares;
        for (const std::size_t points : lattice.points) squares.push_back((points - 1) / side);
        for_each(squares, [&](std::vector<std::size_t> at) {
            for (std::size_t& coordinate : at) coordinate *= side;
            use(stencil, Square{std::move(at), side});
        });
    }
}

/// A box of points, first ... end - 1 along each axis.
struct Range {
    std::vector<std::size_t> first, end;
};

/// The square, and a quarter of its side around it; of one axis the square, for no border bends there.
Range around(const Lattice& lattice, const Square& square) {
    const std::size_t margin = square.at.size() > 1 ? square.side / 4 : 0;
    Range range;
    for (std::size_t k = 0; k < square.at.size(); ++k) {
        range.first.push_back(square.at[k] - std::min(margin, square.at[k]));
        range.end.push_back(std::min(square.at[k] + square.side + margin + 1, lattice.points[k]));
    }
    return range;
}

/// Is there a point in the range, `index` along the axes before this one, for which is(index)?
template <class Is>
bool any_of(const Lattice& lattice, const Range& range, const Is& is, std::size_t axis = 0, std::size_t index = 0) {
    if (axis == lattice.points.size()) return is(index);
    for (std::size_t i = range.first[axis]; i < range.end[axis]; ++i)
        if (any_of(lattice, range, is, axis + 1, index * lattice.points[axis] + i)) return true;
    return false;
}

}  // namespace

std::size_t Lattice::size() const {
    std::size_t size = 1;
    for (const std::size_t n : points) size *= n;
    return size;
}

std::vector<std::size_t> coarse_points(const Lattice& lattice) {
    std::vector<std::size_t> counts, indices;
    for (const std::size_t n : lattice.points) counts.push_back((n - 1) / lattice.coarse_stride() + 1);
    for_each(counts, [&](std::vector<std::size_t> at) {
        for (std::size_t& coordinate : at) coordinate *= lattice.coarse_stride();
        indices.push_back(index_of(lattice, at));
    });
    return indices;
}

std::vector<std::size_t> next_points(const Lattice& lattice, std::span<const char> visited,
                                     const std::function<std::int64_t(std::size_t)>& verdict) {
    std::vector<std::size_t> next;
    std::vector<std::int64_t> verdicts(visited.size());
    for (std::size_t index = 0; index < visited.size(); ++index)
        if (visited[index]) verdicts[index] = verdict(index);
    for_each_square(lattice, [&](const Stencil& stencil, const Square& square) {
        const std::size_t corner = index_of(lattice, square.at);
        for (const auto& point : stencil.points)  // else within a square that is left whole
            if (point.is_corner && !visited[corner + point.away]) return;
        const auto differs = [&](std::size_t index) { return visited[index] && verdicts[index] != verdicts[corner]; };
        if (!any_of(lattice, around(lattice, square), differs)) return;
        for (const auto& point : stencil.points)
            if (!visited[corner + point.away]) next.push_back(corner + point.away);
    });
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
}

std::vector<std::size_t> sources(const Lattice& lattice, std::span<const char> visited) {
    std::vector<std::size_t> source(lattice.size(), none);
    for (std::size_t i = 0; i < source.size(); ++i)
        if (visited[i]) source[i] = i;
    for_each_square(lattice, [&](const Stencil& stencil, const Square& square) {
        const std::size_t corner = index_of(lattice, square.at);
        for (const auto& point : stencil.points) {
            std::size_t& here = source[corner + point.away];
            if (here == none) here = source[corner + point.corner];
        }
    });
    return source;
}

}  // namespace swirl::studies::grids
