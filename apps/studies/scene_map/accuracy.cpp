#include "apps/studies/scene_map/accuracy.hpp"

#include "analysis/enum_name.hpp"

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

}  // namespace swirl::studies
