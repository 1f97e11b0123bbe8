#include "map/intervals/krawczyk.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace swirl::intervals {

BallVector middles(const BallVector& box) {
    BallVector result;
    for (const Ball& x : box) result.push_back(exact_middle(x));
    return result;
}

BallVector boxes(const BallVector& middle, const std::vector<double>& radii) {
    BallVector result;
    for (std::size_t i = 0; i < middle.size(); ++i) result.push_back(middle[i] + around(0, radii[i]));
    return result;
}

Eigen::MatrixXd approximate_inverse(const Linearisation& at) {
    const auto n = static_cast<Eigen::Index>(at.rows.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < at.rows.size(); ++i)
        for (const auto& [column, entry] : at.rows[i]) matrix(i, column) += middle(entry);
    return Eigen::MatrixXd(matrix.partialPivLu().inverse());
}

BallVector krawczyk_image(const BallSystem& system, const BallVector& middle, const BallVector& box,
                          const Eigen::MatrixXd& inverse) {
    const BallVector at_middle = system(middle).values;
    const auto rows = system(box).rows;
    const std::size_t n = middle.size();
    if (at_middle.size() != n || rows.size() != n) return BallVector(n, Ball(1) / between(-1, 1));  // nothing is known
    BallVector away;
    for (std::size_t j = 0; j < n; ++j) away.push_back(box[j] - middle[j]);
    BallVector image;
    for (std::size_t i = 0; i < n; ++i) {
        Ball point = middle[i];
        BallVector left(n);  // a row of I − C G′
        left[i] = Ball(1);
        for (std::size_t j = 0; j < n; ++j) {
            const Ball factor(-inverse(i, j));
            if (is_exact_zero(factor)) continue;
            point.add_product(factor, at_middle[j]);
            for (const auto& [column, entry] : rows[j]) left[column].add_product(factor, entry);
        }
        for (std::size_t j = 0; j < n; ++j) point.add_product(left[j], away[j]);
        image.push_back(std::move(point));
    }
    return image;
}

bool lies_inside(const BallVector& inner, const BallVector& outer) {
    for (std::size_t i = 0; i < inner.size(); ++i)
        if (!contains_interior(outer[i], inner[i])) return false;
    return true;
}

namespace {

/// Newton's method from a box's middle. @return where it ends; nothing if it leaves numbers
std::optional<BallVector> zero_near(const BallSystem& system, BallVector middle) {
    constexpr int most = 30;
    for (int k = 0; k < most; ++k) {
        const Linearisation at = system(middle);
        const Eigen::MatrixXd inverse = approximate_inverse(at);
        if (!inverse.allFinite()) return {};
        double longest = 0;
        for (std::size_t i = 0; i < middle.size(); ++i) {
            double change = 0;
            for (std::size_t j = 0; j < middle.size(); ++j)
                change += inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
                          intervals::middle(at.values[j]);
            if (!std::isfinite(change)) return {};
            longest = std::max(longest, std::abs(change));
            middle[i] = Ball(intervals::middle(middle[i]) - change);
        }
        if (longest < 1e-15) break;
    }
    return middle;
}

/// A small box within `box` that holds a zero: the one of `box`. Newton's method begins in the middle of `near`.
std::optional<BallVector> small_box(const BallSystem& system, const BallVector& near, const BallVector& box) {
    const auto zero = zero_near(system, middles(near));
    if (!zero) return {};
    const Eigen::MatrixXd inverse = approximate_inverse(system(*zero));
    if (!inverse.allFinite()) return {};
    for (const double radius : {1e-6, 1e-9, 1e-12}) {
        std::vector<double> radii;
        for (const Ball& x : *zero) radii.push_back(radius * std::max(1.0, std::abs(intervals::middle(x))));
        const BallVector small = boxes(*zero, radii);
        if (!lies_inside(small, box)) continue;
        if (lies_inside(krawczyk_image(system, *zero, small, inverse), small)) return small;
    }
    return {};
}

/// K again and again.
BallVector narrowed_by_itself(const BallSystem& system, BallVector box) {
    constexpr int most = 20;  // near the end each takes off 10⁻⁷ or better
    for (int i = 0; i < most; ++i) {
        const BallVector middle = middles(box);
        const Eigen::MatrixXd inverse = approximate_inverse(system(middle));
        if (!inverse.allFinite()) break;
        const BallVector image = krawczyk_image(system, middle, box, inverse);
        double narrowest = 1;
        for (std::size_t j = 0; j < box.size(); ++j) {
            if (!overlap(box[j], image[j]) || !is_finite(image[j])) return box;  // cannot be: the zero lies in both
            const Ball both = intersection(box[j], image[j]);
            if (radius(box[j]) > 0) narrowest = std::min(narrowest, radius(both) / radius(box[j]));
            box[j] = both;
        }
        if (narrowest > 0.9) break;
    }
    return box;
}

}  // namespace

BallVector narrowed(const BallSystem& system, const BallVector& box) {
    constexpr double wide = 1e-6;
    BallVector near = narrowed_by_itself(system, box);
    const bool is_wide = std::any_of(near.begin(), near.end(), [](const Ball& x) { return !(radius(x) < wide); });
    if (!is_wide) return near;
    const auto small = small_box(system, near, box);
    return small ? narrowed_by_itself(system, *small) : near;
}

}  // namespace swirl::intervals
