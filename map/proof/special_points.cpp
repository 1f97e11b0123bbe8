#include "map/proof/special_points.hpp"

#include "map/intervals/bifurcation_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace swirl::proof {

namespace {

using intervals::BifurcationKind;
using intervals::CurvePiece;
using intervals::lower;
using intervals::upper;

/// First derivatives that have derivatives themselves.
using FirstDual = intervals::Dual<7>;
using SecondDual = intervals::Dual<7, FirstDual>;

SecondDual second_variable(const Ball& x, std::size_t index) {
    return SecondDual::variable(FirstDual::variable(x, index), index);
}

SceneIn<SecondDual> scene_twice(const BranchSystem& system, const Ball& parameter) {
    auto scene = scene_as<SecondDual>(system.cycle.scene, [](const Ball& x) { return SecondDual(FirstDual(x)); });
    set_parameter(scene, system.parameter, second_variable(parameter, parameter_index));
    set_inertia(scene);
    return scene;
}

/// One step's equations as rows; `columns` are the places of the seven local variables.
class SecondRows {
public:
    SecondRows(const BranchSystem& system, const BallVector& unknowns) : system_(system), unknowns_(unknowns) {
        const SceneIn<SecondDual> scene = scene_twice(system, unknowns.back());
        for (std::size_t i = 0; i < system.cycle.period(); ++i) add_step(scene, i);
    }
    intervals::SecondOrder take() { return std::move(result_); }

private:
    using Locals = std::vector<std::pair<std::size_t, std::size_t>>;  ///< number among the seven, column

    void add_step(const SceneIn<SecondDual>& scene, std::size_t i) {
        const CycleSystem& cycle = system_.cycle;
        const std::size_t width = cycle.unknowns_of_step(), next = (i + 1) % cycle.period();
        const BallPoint<Ball> at = point_of(cycle, unknowns_, i);
        const BallPoint<SecondDual> z{second_variable(at.psi, 0), second_variable(at.chi, 1), second_variable(at.vn, 2),
                                      second_variable(at.vt, 3), second_variable(at.spin, 4)};
        const auto step = step_in_balls<SecondDual>(scene, cycle.itinerary[i], cycle.advances[i], z,
                                                    second_variable(time_of(cycle, unknowns_, i), time_index), nullptr);
        Locals locals;
        for (std::size_t a = 0; a < cycle.active.size(); ++a) locals.emplace_back(cycle.active[a], i * width + a);
        locals.emplace_back(time_index, (i + 1) * width - 1);
        locals.emplace_back(parameter_index, system_.parameter_column());
        const std::array<const SecondDual*, 5> image{&step.after.psi, &step.after.chi, &step.after.vn, &step.after.vt,
                                                     &step.after.spin};
        for (std::size_t a = 0; a < cycle.active.size(); ++a) {
            const std::size_t index = cycle.active[a], column = next * width + a;
            Ball value = image[index]->value.value - unknowns_[column];
            if (index < 2) value -= Ball(2 * cycle.turns[i][index]) * intervals::pi_ball();
            add_row(locals, *image[index], std::move(value));
            result_.rows.back().push_back({column, next == 0, Ball(-1), {}});
        }
        add_row(locals, step.gap, step.gap.value.value);
    }

    void add_row(const Locals& locals, const SecondDual& f, Ball value) {
        std::vector<intervals::DependentEntry> row;
        for (const auto& [index, column] : locals) {
            intervals::DependentEntry entry{column, false, f.by[index].value, {}};
            for (const auto& [other, other_column] : locals) entry.by.emplace_back(other_column, f.by[index].by[other]);
            row.push_back(std::move(entry));
        }
        result_.values.push_back(std::move(value));
        result_.rows.push_back(std::move(row));
    }

    const BranchSystem& system_;
    const BallVector& unknowns_;
    intervals::SecondOrder result_;
};

/// Boxes first … last − 1, of which the stability is not decided, between two of which it is.
class Between {
public:
    Between(const BranchSystem& system, const std::vector<BranchBox>& boxes, std::size_t first, std::size_t last)
        : system_(system), boxes_(boxes) {
        const BranchBox &before = boxes[first - 1], &after = boxes[last];
        special_.outside_before = before.outside;
        special_.outside_after = after.outside;
        special_.first = first;
        special_.last = last;
        special_.parameter_low = special_.parameter_high = before.parameter_end;
        for (std::size_t i = first; i < last; ++i) {
            special_.parameter_low = std::min(special_.parameter_low, boxes[i].parameter_low);
            special_.parameter_high = std::max(special_.parameter_high, boxes[i].parameter_high);
        }
        turns_ = (before.parameter_end - before.parameter_begin) * (after.parameter_end - after.parameter_begin) < 0;
        follow_advances(system_, boxes[first].middle);
    }

    SpecialPoint found() {
        const int crossed = std::abs(special_.outside_after - special_.outside_before);
        if (crossed > 2) return special_;
        special_.kind = crossed == 2 ? SpecialKind::neimark_sacker : turns_ ? SpecialKind::fold : SpecialKind::flip;
        const auto& word = system_.cycle.itinerary;
        const bool smooth = std::all_of(word.begin(), word.end(), [](const Branch& letter) {
            return letter.slip != 0 || letter.mode == ContactMode::frictionless;
        });
        if (!smooth) return special_;
        const BifurcationKind kind = crossed == 2 ? BifurcationKind::neimark_sacker
                                     : turns_     ? BifurcationKind::fold
                                                  : BifurcationKind::flip;
        for (const std::size_t start : {(special_.first + special_.last) / 2, special_.first, special_.last - 1})
            if (enclose(kind, boxes_[start].middle)) break;
        return special_;
    }

private:
    /// @return whether there is such a point near, and on the branch
    bool enclose(BifurcationKind kind, const std::vector<double>& near) {
        const auto twice = [this](const BallVector& unknowns) { return SecondRows(system_, unknowns).take(); };
        const auto point = intervals::bifurcation_point(twice, kind, near);
        if (!point || !is_on_the_branch(point->unknowns)) return false;
        constexpr double room = 1e-11;  // for another program's enclosure
        special_.proven = true;
        for (const Ball& x : point->unknowns) {
            special_.middle.push_back(intervals::middle(x));
            special_.within = std::max(special_.within, room + upper(abs(x - Ball(special_.middle.back()))));
        }
        special_.parameter_low = lower(point->unknowns.back()) - room;
        special_.parameter_high = upper(point->unknowns.back()) + room;
        if (kind != BifurcationKind::neimark_sacker) return true;
        special_.angle_low = lower(point->angle) - room;
        special_.angle_high = upper(point->angle) + room;
        return true;
    }

    bool is_on_the_branch(const BallVector& point) const {
        const auto equations = [this](const std::vector<Running>& unknowns) { return evaluate(system_, unknowns); };
        for (std::size_t i = special_.first; i < special_.last; ++i) {
            const BranchBox& box = boxes_[i];
            if (!(lower(point[box.running]) > box.low && upper(point[box.running]) < box.high)) continue;
            const auto piece = intervals::curve_piece(equations, box.middle, box.running, box.low, box.high);
            if (piece && lies_on(*piece, intervals::as_point(point, box.running))) return true;
        }
        return false;
    }

    BranchSystem system_;
    const std::vector<BranchBox>& boxes_;
    SpecialPoint special_;
    bool turns_ = false;
};

}  // namespace

std::vector<SpecialPoint> special_points(const BranchSystem& system, const std::vector<BranchBox>& boxes) {
    std::vector<SpecialPoint> special;
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        if (boxes[i].decided || !boxes[i - 1].decided) continue;
        std::size_t last = i;
        while (last < boxes.size() && !boxes[last].decided) ++last;
        if (last == boxes.size()) break;
        if (boxes[i - 1].outside != boxes[last].outside) special.push_back(Between(system, boxes, i, last).found());
        i = last;
    }
    return special;
}

}  // namespace swirl::proof
