// For tests that ask for the same bits from every instruction set.
#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace swirl::tests {

/// Each that this machine can run.
inline std::vector<std::int64_t> all_targets() {
    std::vector<std::int64_t> targets;
    for (std::int64_t t = hwy::SupportedTargets(); t != 0; t &= t - 1) targets.push_back(t & -t);
    return targets;
}

/// The instruction sets in use are the best one of `targets`, until the guard ends.
struct OnlyTargets {
    explicit OnlyTargets(std::int64_t targets) {
        hwy::SetSupportedTargetsForTest(targets);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    ~OnlyTargets() {
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

}  // namespace swirl::tests
