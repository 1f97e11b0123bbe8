// Along a curve: predictor, corrector, step length ds, and why it ends. What else a kind of curve looks at is said by
// a class of its own.
#pragma once

#include "analysis/curves/curve.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace swirl::analysis {

/// cos of the angle between tangents a step apart, at least: 14 degrees. The curve's point then lies tan 7° = 0.12 of
/// the step beside the predictor, a quarter of what the corrector may lead, where it takes 3 or 4 iterations.
inline constexpr double least_cosine = 0.97;
/// Of a family, 11 degrees: its steps grow faster, and its members are where pins and `belongs_to` begin.
inline constexpr double family_cosine = 0.98;

/// How long the steps are.
struct StepRule {
    double first = 1e-3, longest = 0.02;
    double shortest = 1e-12;  ///< a step that fails there is the last
    int most_points = 5000;
    double growth = 1.4;           ///< after a success …
    int successes_before = 1;      ///< … that so many successes since the last failure were before
    double cosine = least_cosine;  ///< of the bend
};

enum class CurveEnd {
    plane,          ///< it left the plane of its two parameters
    range,          ///< the parameter reached the end of its range
    closed,         ///< it came back to where it began
    one_to_one,     ///< a Neimark–Sacker curve: the pair became real at 1 (behind it lie neutral saddles)
    one_to_two,     ///< the same at −1
    halved,         ///< the cycle became one of half its period, behind which it repeats itself
    border,         ///< a border of the map behind which no cycle was found to go on
    not_converged,  ///< no cycle was found to go on, though the map does
    most_points,    ///< as many points as were asked for
    switched,       ///< it begins at a special point of another branch
    family,         ///< from there on the solutions are no curve over the parameter, but a family at one value of it
    stopped,        ///< interrupted
};
std::string_view name_of(CurveEnd end);

/// Why a curve ends; of a border its name.
struct CurveEnding {
    CurveEnd why = CurveEnd::plane;
    std::string border = {};

    bool operator==(CurveEnd end) const { return why == end; }
};
/// The border's name where it has one, else the reason's.
std::string name_of(const CurveEnding& ending);

/// One way along a curve. The step is halved where the corrector fails, where tangents turn by more than the rule
/// allows, or where the kind of curve refuses the point; it grows after successes.
class CurveWalk {
public:
    virtual ~CurveWalk() = default;

    /// To its end: every step goes on, or halves ds down to the shortest. Cost: a `correct` a step.
    CurveEnd run();

protected:
    CurveWalk(CurveProblem of, const StepRule& steps, std::function<bool()> stop)
        : problem_(std::move(of)), rule_(steps), stop_(std::move(stop)), length_(steps.first) {}

    /// The last point, and how many there are.
    virtual const CurvePoint& here() const = 0;
    virtual std::size_t count() const = 0;
    /// Before a step: may end the curve.
    virtual void look_ahead() {}
    /// Of a point that the corrector found: appends it, or ends the curve. False: a shorter step is wanted.
    virtual bool go_to(CurvePoint next) = 0;
    /// After a step that succeeded: may end the curve.
    virtual void look_back() {}
    /// No step is short enough: ends the curve, or begins anew behind.
    ///   why  how the corrector ended last; converged if the kind of curve refused the point
    virtual void meet_end(Correction why) = 0;

    void end(CurveEnd why) {
        end_ = why;
        has_ended_ = true;
    }
    double step_length() const { return length_; }
    /// The itinerary that a failed step since the last point led to; empty if none did.
    const std::vector<std::int64_t>& itinerary_behind() const { return itinerary_behind_; }
    void begin_anew() { restart(rule_.first); }

    CurveProblem problem_;

private:
    void step();
    void restart(double length) {
        length_ = length;
        successes_ = 0;
    }

    StepRule rule_;
    std::function<bool()> stop_;
    double length_;
    int successes_ = 0;
    std::vector<std::int64_t> itinerary_behind_;
    CurveEnd end_ = CurveEnd::not_converged;
    bool has_ended_ = false;
};

/// What is passed the other way, turned.
inline void turn(CurvePoint& point) {
    point.tangent *= -1;
}

/// Makes `back`, which was walked the other way from the same point, the first part of `forth`: points and special
/// points in order, each turned (`turn`), `special.after` counted anew, and why it begins. The rest of `forth` stays.
template <class Curve>
void put_before(Curve back, Curve& forth) {
    const std::size_t count = back.points.size();  // its first is the other's first
    std::reverse(back.points.begin(), back.points.end());
    for (auto& point : back.points) turn(point);
    std::reverse(back.special.begin(), back.special.end());
    for (auto& special : back.special) {
        turn(special);
        special.after = count < 2 ? 0 : count - 2 - std::min(special.after, count - 2);
    }
    for (auto& special : forth.special) special.after += count - 1;
    back.points.insert(back.points.end(), forth.points.begin() + 1, forth.points.end());
    back.special.insert(back.special.end(), forth.special.begin(), forth.special.end());
    forth.points = std::move(back.points);
    forth.special = std::move(back.special);
    forth.begin = back.end;
}

/// Both ways from a point; one that closes, or is stopped, is whole.
///   one_way  the curve from a point in the direction of its tangent
template <class OneWay>
auto both_ways(CurvePoint start, const OneWay& one_way) {
    auto curve = one_way(start);
    if (curve.end == CurveEnd::closed || curve.end == CurveEnd::stopped) {
        curve.begin = curve.end;
        return curve;
    }
    turn(start);
    put_before(one_way(start), curve);
    return curve;
}

}  // namespace swirl::analysis
