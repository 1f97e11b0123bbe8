#include "apps/studies/basins/saddles.hpp"

namespace swirl::studies::grids {

std::string_view name_of(analysis::StraddleEnd end) {
    using analysis::StraddleEnd;
    switch (end) {
        case StraddleEnd::found:
            return "saddle";
        case StraddleEnd::border:
            return "border";
        case StraddleEnd::rounding:
            return "rounding";
        case StraddleEnd::undecided:
            return "undecided";
        case StraddleEnd::ended:
            return "ended";
        case StraddleEnd::not_found:
            return "not-found";
    }
    return "";
}

}  // namespace swirl::studies::grids
