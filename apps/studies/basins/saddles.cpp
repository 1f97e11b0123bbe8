#include "apps/studies/basins/saddles.hpp"

#include "analysis/enum_name.hpp"

namespace swirl::studies::grids {

std::string_view name_of(analysis::StraddleEnd end) {
    using enum analysis::StraddleEnd;
    return analysis::name_in<analysis::StraddleEnd>({{found, "saddle"},
                                                     {border, "border"},
                                                     {rounding, "rounding"},
                                                     {undecided, "undecided"},
                                                     {ended, "ended"},
                                                     {not_found, "not-found"}},
                                                    end);
}

}  // namespace swirl::studies::grids
