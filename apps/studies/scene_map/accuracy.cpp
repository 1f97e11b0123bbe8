#include "apps/studies/scene_map/accuracy.hpp"

namespace swirl::studies {

std::string_view name_of(Accuracy accuracy) {
    switch (accuracy) {
        case Accuracy::double_precision:
            return "double";
        case Accuracy::extended:
            return "extended";
        case Accuracy::quad:
            return "quad";
        case Accuracy::paper:
            return "paper";
        case Accuracy::brent:
            return "brent";
        case Accuracy::fixed_step:
            return "fixed-step";
    }
    return "";
}

}  // namespace swirl::studies
