#include "apps/studies/scene_map/accuracy.hpp"

#include "analysis/enum_name.hpp"

#include <stdexcept>
#include <string>

namespace swirl::studies {

std::string_view name_of(Accuracy accuracy) {
    using enum Accuracy;
    return analysis::name_in<Accuracy>({{double_precision, "double"},
                                        {extended, "extended"},
                                        {quad, "quad"},
                                        {paper, "paper"},
                                        {brent, "brent"},
                                        {fixed_step, "fixed-step"}},
                                       accuracy);
}

void refuse_baseline(Accuracy accuracy, std::string_view what) {
    throw std::invalid_argument(
        "accuracy = " + std::string(name_of(accuracy)) + " is not extended to " + std::string(what) +
        (baseline_of(accuracy) ? "; double, extended or quad is wanted" : "; double is wanted"));
}

}  // namespace swirl::studies
