// An orbit that has settled on a cycle to the last bit repeats itself from then on: what follows is known.
#pragma once

#include "map/model/section.hpp"

#include <cstdint>
#include <cstring>

namespace swirl::studies {

/// Looks for an exact return of a deterministic map's state (R. P. Brent, BIT 20 (1980) 176). The state is that which
/// the map sees, so that equal bits now mean equal bits for ever. Cost: one comparison a step.
class ExactReturn {
public:
    /// After each step; the number of steps after which the state has come again, 0 if it has not.
    std::int64_t after(const PostImpactState<double>& state) {
        ++steps_;
        if (std::memcmp(&state, &marked_, sizeof state) == 0) return steps_;
        if (steps_ == next_) {
            marked_ = state;
            next_ *= 2;
            steps_ = 0;
        }
        return 0;
    }

private:
    static_assert(sizeof(PostImpactState<double>) == 7 * sizeof(double),
                  "no padding, so that bytes are all there is to compare");
    PostImpactState<double> marked_{};
    std::int64_t steps_ = 0;
    std::int64_t next_ = 64;
};

}  // namespace swirl::studies
