// How long the steps of a walk along a curve are.
#pragma once

#include <algorithm>

namespace swirl::analysis {

/// Halved where a step fails; 1.4 times as long after each success but the first since, up to the longest.
class StepLength {
public:
    StepLength(double first, double longest, double shortest)
        : first_(first), longest_(longest), shortest_(shortest), length_(first) {}

    double value() const { return length_; }

    /// False if it is shorter than the shortest then: there is no going on.
    bool shorten() {
        length_ *= 0.5;
        successes_ = 0;
        return length_ >= shortest_;
    }

    void succeed() {
        if (++successes_ > 1) length_ = std::min(1.4 * length_, longest_);
    }

    void begin_anew() {
        length_ = first_;
        successes_ = 0;
    }

private:
    double first_, longest_, shortest_, length_;
    int successes_ = 0;
};

}  // namespace swirl::analysis
