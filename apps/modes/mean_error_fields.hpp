// What a table says of the errors of one orbit's means of S.
#pragma once

#include "apps/output/table.hpp"
#include "apps/studies/modes/means.hpp"

#include <functional>
#include <string>
#include <utility>

namespace swirl::apps {

/// Columns `mean_S_error`, `mean_S_per_impact_error`, `mean_S_bound` and `mean_S_kind`.
template <class Row>
struct MeanErrorFields {
    Field<Row> per_time, per_impact, bound, kind;
};

///   errors  of a row: its MeanErrors
///   time_error, impact_error  what a record says of the first two
template <class Row, class Errors>
MeanErrorFields<Row> mean_error_fields(Errors errors, std::string time_error = "standard error of mean_S",
                                       std::string impact_error = "that of mean_S_per_impact") {
    const auto part = [errors](auto member) {
        return [errors, member](const Row& row) { return std::invoke(errors, row).*member; };
    };
    return {{"mean_S_error", part(&studies::MeanErrors::per_time), "1", std::move(time_error)},
            {"mean_S_per_impact_error", part(&studies::MeanErrors::per_impact), "1", std::move(impact_error)},
            {"mean_S_bound", part(&studies::MeanErrors::bound), "1", "of a torus: mean_S is off by this at most"},
            {"mean_S_kind", part(&studies::MeanErrors::kind), "", "exact, sampled, bounded, too-short or none"}};
}

}  // namespace swirl::apps
