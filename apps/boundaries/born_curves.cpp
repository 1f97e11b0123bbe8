#include "apps/boundaries/born_curves.hpp"

#include "analysis/linear_algebra/dense.hpp"
#include "apps/boundaries/border_system.hpp"
#include "apps/boundaries/critical_word.hpp"

#include <cmath>

namespace swirl::apps::boundaries {

namespace {

/// As many equations as unknowns: the cycle of a word, how far it is from the border, and its multiplier.
struct BornSystem {
    const WordMap& map;
    const Plane& plane;
    BorderCycle like;
    bool strikes;       ///< with the impact that vanishes on the border, the first of the cycle
    double multiplier;  ///< 1 or −1
    double off;         ///< what touches, off the border

    double determinant(const Eigen::VectorXd& y) const {
        return word_determinant(map, border_cycle_at(map, like, y), multiplier);
    }

    bool equations(const Eigen::VectorXd& y, analysis::ArcEquations& at) const {
        const BorderLayout layout = layout_of(map, like);
        if (!is_in_range(plane, y.segment<2>(layout.parameters()))) return false;
        const Eigen::Index row = layout.parameters() + layout.period;
        at.residual = Eigen::VectorXd::Zero(y.size());
        at.jacobian = Eigen::MatrixXd::Zero(y.size(), y.size());
        add_cycle(map, like, layout, y, at);
        if (strikes)
            add_approach(map, like, layout, y, at);
        else
            add_touch(map, like, layout, y, at);
        at.residual[row] -= off;
        const Eigen::Index last = y.size() - 1;
        at.residual[last] = determinant(y);
        constexpr double h = 1e-6;  // steers only
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            Eigen::VectorXd above = y, below = y;
            above[i] += h;
            below[i] -= h;
            // At the end of a parameter's range (μ = 0) from one side.
            if (!is_in_range(plane, above.segment<2>(layout.parameters()))) above = y;
            if (!is_in_range(plane, below.segment<2>(layout.parameters()))) below = y;
            at.jacobian(last, i) = (determinant(above) - determinant(below)) / (above[i] - below[i]);
        }
        const double size = at.jacobian.row(last).norm();
        at.residual[last] /= size;
        at.jacobian.row(last) /= size;
        return at.residual.allFinite() && at.jacobian.allFinite();
    }

    /// By Newton's method from the cycle on the border; it stays near that.
    std::optional<BorderCycle> solve() const {
        constexpr double rounding = 1e-12, most_rounding = 1e-9, farthest = 0.1;
        const Eigen::VectorXd start = unknowns_of(map, like);
        Eigen::VectorXd y = strikes ? Eigen::VectorXd(start.head(layout_of(map, like).touch_time())) : start;
        const Eigen::VectorXd first = y;
        double before = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 20; ++i) {
            analysis::ArcEquations at;
            if (!equations(y, at)) return std::nullopt;
            const Eigen::VectorXd step = analysis::solve_by_qr(at.jacobian, -at.residual);
            const double size = step.norm();
            if (!std::isfinite(size) || !((y - first).norm() < farthest)) return std::nullopt;
            if (size <= rounding || (size >= 0.5 * before && size <= most_rounding))
                return border_cycle_at(map, like, y);
            before = size;
            y += step;
        }
        return std::nullopt;
    }
};

/// The side on which there is such a cycle: what touches is inside, a flight takes time, an impact has a rate. Across a
/// stick-slip border there is one on either.
std::vector<double> signs_of(Touch touch, bool strikes) {
    if (strikes || touch == Touch::no_flight) return {1};
    if (touch == Touch::grazing || touch == Touch::two_vertices) return {-1};
    return {1, -1};
}

std::optional<Seed> seed_of(const BornSystem& system, const analysis::PlaneMap& map) {
    const auto cycle = system.solve();
    if (!cycle) return std::nullopt;
    const auto shooting = analysis::plane_shooting(map, analysis::stacked(cycle->points), cycle->p);
    constexpr double closes = 1e-7;
    if (!shooting.alive || !(shooting.gap.lpNorm<Eigen::Infinity>() < closes)) return std::nullopt;
    return Seed{system.multiplier > 0 ? "fold" : "flip", cycle->points, cycle->p, system.multiplier};
}

}  // namespace

BornSeeds seeds_born_on(const WordMap& words, const analysis::PlaneMap& map, const Plane& plane,
                        const BorderCurve& curve) {
    BornSeeds born;
    for (const auto& special : curve.arc.special) {
        const bool folds = special.kind.rfind("fold", 0) == 0;
        if (!folds && special.kind.rfind("flip", 0) != 0) continue;
        const bool strikes = special.kind == fold_of_impact || special.kind == flip_of_impact;
        BorderCycle cycle = border_cycle_at(words, curve.like, special.at.y);
        if (strikes) cycle = with_impact(words, cycle, 0);
        for (const double sign : signs_of(cycle.touch, strikes)) {
            std::optional<Seed> seed;
            for (const double off : {1e-3, 1e-4, 1e-5})
                if (!seed) seed = seed_of({words, plane, cycle, strikes, folds ? 1.0 : -1.0, sign * off}, map);
            if (seed)
                born.seeds.push_back(std::move(*seed));
            else
                ++born.not_found;
        }
    }
    return born;
}

}  // namespace swirl::apps::boundaries
