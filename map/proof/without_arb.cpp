// What a build without Arb answers.
#include "map/proof/prove_cycle.hpp"

#include <stdexcept>

namespace swirl::proof {

namespace {

[[noreturn]] void refuse() {
    throw std::invalid_argument("this build of swirl has no interval arithmetic: it was built without Arb (FLINT)");
}

}  // namespace

bool has_interval_arithmetic() {
    return false;
}

CycleProof prove_cycle(const Scene<double>&, const CycleClaim&) {
    refuse();
}

}  // namespace swirl::proof
