#include "map/baselines/baseline_map.hpp"

namespace swirl {

FirstContact<double> baseline_contact(BaselineSearch search, const Body<double>& body, const Flight<double>& flight) {
    switch (search) {
        case BaselineSearch::paper:
            return paper_contact(body, flight);
        case BaselineSearch::brent:
            return brent_contact(body, flight);
        case BaselineSearch::fixed_step:
            break;
    }
    return fixed_step_contact(body, flight);
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_BASELINE, double)

}  // namespace swirl
