#include "map/proof/branch_walk.hpp"

#include "map/proof/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace swirl::proof {

namespace {

using intervals::CurvePiece;
using intervals::lower;
using intervals::upper;

constexpr double longest_step = 0.25, first_step = 0.02, least_step = 1e-9, step_growth = 1.6;
constexpr double least_undecided = 1e-7;   ///< boxes of which only the stability is not certain
constexpr double undecided_growth = 1.15;  ///< of one to the next: less than their distance from where it changes
constexpr double overlap_share = 1e-3;     ///< of a step, at both ends
constexpr std::size_t most_boxes = 20'000;

/// The parameter is a scene's for all of the box, or beyond a bound that scenes may have by rounding: a range that ends
/// there is walked a little beyond.
bool is_a_scenes(Parameter parameter, const Running& p) {
    constexpr double rounding = 1e-9;
    switch (parameter) {
        case Parameter::alpha:
            return lower(p) > 0 && upper(p) < 1;
        case Parameter::restitution:
            return lower(p) >= -rounding && upper(p) <= 1 + rounding;
        case Parameter::inertia_factor:
            return lower(p) > 0;
        default:
            return lower(p) >= -rounding;
    }
}

/// A box that was tried, with the point at which the next begins.
struct Step {
    CurvePiece piece, next;
    BoxStanding standing;
    bool at_end = false;  ///< the range ends in it
};

class Walk {
public:
    Walk(const BranchStart& start, bool forward)
        : start_(start), system_(start.system), joint_(start.point), direction_(start.direction) {
        for (double& d : direction_) d = forward ? d : -d;
    }

    Walked run(const std::function<bool()>& stop) {
        double step = first_step;
        int undecided = 0;
        while (true) {
            if (stop() || walked_.boxes.size() >= most_boxes) return ended({BranchEndKind::stopped, "", false, 0, 0});
            const double least = least_undecided * std::pow(undecided_growth, undecided);
            const std::optional<Step> tried = next_step(step, step > least);
            if (!tried) {
                step *= 0.5;
                if (step < least_step) return ended(why());
                continue;
            }
            undecided = tried->standing.decided ? 0 : undecided + 1;
            take(*tried, step);
            if (tried->at_end) return ended({BranchEndKind::range, "", true, 0, 0});
            if (walked_.boxes.size() > 3 && lies_on(tried->piece, start_.point))
                return ended({BranchEndKind::closed, "", true, 0, 0});
            step = std::min(longest_step, (undecided > 0 ? undecided_growth : step_growth) * step);
        }
    }

private:
    std::size_t column() const { return system_.parameter_column(); }
    intervals::CurveSystem equations() const {
        return [this](const std::vector<Running>& unknowns) { return evaluate(system_, unknowns); };
    }

    /// A box along so much of the curve; nothing where it is not proven. `last_` then says why.
    ///   decided  its stability is wanted, too
    std::optional<Step> next_step(double length, bool decided) {
        Step step;
        if (!curve_along(length, step)) {
            last_ = {Verdict::undecided,
                     BranchEndKind::equations,
                     "no box is mapped into itself by Krawczyk's operator",
                     false,
                     0,
                     0};
            return std::nullopt;
        }
        step.standing = standing_of(system_, step.piece);
        last_ = step.standing;
        if (step.standing.verdict != Verdict::proven || (decided && !step.standing.decided)) return std::nullopt;
        return step;
    }

    /// The solutions alone.
    bool curve_along(double length, Step& step) const {
        const std::size_t c = running_unknown(direction_);
        const double change = length * direction_[c] * start_.scales[c], from = joint_.middle[c];
        double near = from - overlap_share * change, to = from + change, far = to + overlap_share * change;
        // A little beyond the range, more than a bound of the end errs by.
        const double beyond = 1e-11 * start_.scales[column()];
        const double limit = change > 0 ? start_.high + beyond : start_.low - beyond;
        if (c == column() && (far - limit) * change >= 0) {
            step.at_end = true;
            near = from - overlap_share * (limit - from);
            far = limit;
            to = from + 0.5 * (limit - from);
        }
        std::vector<double> guess = joint_.middle;
        for (std::size_t i = 0; i < guess.size(); ++i)
            guess[i] += 0.5 * (far - from) / (direction_[c] * start_.scales[c]) * direction_[i] * start_.scales[i];
        const auto piece = curve_piece(equations(), guess, c, std::min(near, far), std::max(near, far));
        if (!piece || !lies_on(*piece, joint_)) return false;
        if (!is_a_scenes(system_.parameter, tube(*piece, piece->near)[column()])) return false;
        const std::vector<Running> ahead = centre_of(*piece);
        const double e = (to - ahead[c].mid) / ahead[c].by[0];
        for (std::size_t i = 0; i < guess.size(); ++i)
            guess[i] = piece->middle[i] + e * (piece->slope[i] + e * piece->curvature[i]);
        const auto next = curve_piece(equations(), guess, c, to, to);
        if (!next || !lies_on(*piece, *next)) return false;
        const double p = next->middle[column()];
        if (c != column() && (p >= start_.high || p <= start_.low) && is_beyond(*next)) step.at_end = true;
        step.piece = *piece;
        step.next = *next;
        return true;
    }
    bool is_beyond(const CurvePiece& point) const {
        const Running p = tube(point, point.near)[column()];
        return lower(p) > start_.high || upper(p) < start_.low;
    }

    void take(const Step& step, double length) {
        const std::vector<Running> all = tube(step.piece, step.piece.near);
        BranchBox box;
        box.running = step.piece.running;
        box.low = step.piece.low;
        box.high = step.piece.high;
        box.middle = step.piece.middle;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (i != box.running) box.within = std::max(box.within, largest(all[i] - Running(box.middle[i])));
        box.within = 1.01 * box.within + 1e-9;  // room for another program's enclosure
        box.decided = step.standing.decided;
        box.outside = step.standing.outside;
        box.inside = step.standing.inside;
        box.parameter_low = lower(all[column()]);
        box.parameter_high = upper(all[column()]);
        box.parameter_begin = joint_.middle[column()];
        const std::vector<double> next = unit_direction(system_, step.next.middle, box.running, start_.scales);
        double along = 0;
        for (std::size_t i = 0; i < next.size(); ++i) along += next[i] * direction_[i];
        const auto change = [&](std::size_t i) { return (step.next.middle[i] - joint_.middle[i]) / start_.scales[i]; };
        const std::size_t c = box.running;
        box.length = step.at_end && c == column() ? length : std::abs(change(c) / direction_[c]);
        direction_ = next;
        if (along < 0)
            for (double& d : direction_) d = -d;
        joint_ = step.next;
        box.parameter_end =
            step.at_end ? (direction_[column()] > 0 ? box.parameter_high : box.parameter_low) : joint_.middle[column()];
        follow_advances(system_, joint_.middle);
        walked_.boxes.push_back(std::move(box));
    }

    /// The end, after the last box that could be tried. It is proven where the solutions go on to a point at which the
    /// same is violated.
    BranchEnd why() const {
        BranchEnd end{last_.kind, last_.reason, false, joint_.middle[column()], joint_.middle[column()]};
        for (double length = least_step; length < 1e-2; length *= 2) {
            Step step;
            if (!curve_along(length, step)) break;
            const BoxStanding there = standing_of(system_, step.next);
            const Running p = tube(step.piece, step.piece.near)[column()];
            end.parameter_low = std::min(end.parameter_low, lower(p));
            end.parameter_high = std::max(end.parameter_high, upper(p));
            if (there.verdict != Verdict::refuted) continue;
            end.kind = there.kind;
            end.reason = there.reason;
            end.proven = true;
            break;
        }
        return end;
    }

    Walked ended(BranchEnd end) {
        const double at = end.kind == BranchEndKind::range ? (direction_[column()] > 0 ? start_.high : start_.low)
                                                           : joint_.middle[column()];
        if (end.reason.empty()) end.parameter_low = end.parameter_high = at;
        walked_.end = std::move(end);
        return std::move(walked_);
    }

    const BranchStart& start_;
    BranchSystem system_;
    CurvePiece joint_;
    std::vector<double> direction_;
    BoxStanding last_;
    Walked walked_;
};

}  // namespace

std::size_t running_unknown(const std::vector<double>& direction) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < direction.size(); ++i)
        if (std::abs(direction[i]) > std::abs(direction[most])) most = i;
    const std::size_t parameter = direction.size() - 1;
    return std::abs(direction[parameter]) >= 0.1 * std::abs(direction[most]) ? parameter : most;
}

std::vector<double> unit_direction(const BranchSystem& system, const std::vector<double>& point, std::size_t running,
                                   const std::vector<double>& scales) {
    const auto equations = [&](const std::vector<Running>& unknowns) { return evaluate(system, unknowns); };
    std::vector<double> direction = intervals::direction_at(equations, point, running);
    double sum = 0;
    for (std::size_t i = 0; i < direction.size(); ++i) {
        direction[i] /= scales[i];
        sum += direction[i] * direction[i];
    }
    for (double& d : direction) d /= std::sqrt(sum);
    return direction;
}

Walked walk(const BranchStart& start, bool forward, const std::function<bool()>& stop) {
    return Walk(start, forward).run(stop);
}

}  // namespace swirl::proof
