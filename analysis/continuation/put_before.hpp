// One curve of the two pieces that were walked from a point of it, one each way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace swirl::analysis {

/// Makes `back`, which was walked the other way from the same point, the first part of `forth`: points and special
/// points in order, `special.after` counted anew, and why it begins. The rest of `forth` stays.
///   turn_point, turn_special  what changes where a point, a special point is passed the other way
template <class Curve, class TurnPoint, class TurnSpecial>
void put_before(Curve back, Curve& forth, const TurnPoint& turn_point, const TurnSpecial& turn_special) {
    const std::size_t count = back.points.size();  // its first is the other's first
    std::reverse(back.points.begin(), back.points.end());
    for (auto& point : back.points) turn_point(point);
    std::reverse(back.special.begin(), back.special.end());
    for (auto& special : back.special) {
        turn_special(special);
        special.after = count < 2 ? 0 : count - 2 - std::min(special.after, count - 2);
    }
    for (auto& special : forth.special) special.after += count - 1;
    back.points.insert(back.points.end(), forth.points.begin() + 1, forth.points.end());
    back.special.insert(back.special.end(), forth.special.begin(), forth.special.end());
    forth.points = std::move(back.points);
    forth.special = std::move(back.special);
    forth.begin = back.end;
}

}  // namespace swirl::analysis
