// Flight times whose impact is as strong as asked: (1 − cos τ)/τ between two values.
#pragma once

#include <vector>

namespace swirl::steady {

struct Interval {
    double from = 0, to = 0;
};

/// The pieces of (0, longest] on which (1 − cos τ)/τ rises, or falls, between two values. It rises and falls once
/// between two multiples of 2π, highest where tan(τ/2) = τ; its largest value is 0.7246.
std::vector<Interval> flight_times_between(double lowest, double highest, double longest);

}  // namespace swirl::steady
