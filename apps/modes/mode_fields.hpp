// Fields that tables share which name modes: kind and period, what drives an orbit, errors of means of S.
#pragma once

#include "analysis/classification/growth.hpp"
#include "analysis/classification/mode.hpp"
#include "apps/output/table.hpp"
#include "apps/studies/modes/means.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps {

// The fields `kind` and `period` of every result that names modes: null in JSON where a record has "none" and 0.

template <class Row, class Reader>
Field<Row> kind_field(Reader reader, std::string long_name = "kind of the mode, or none") {
    return Field<Row>{"kind", reader, "", std::move(long_name)}.json_as([reader](const Row& row) {
        const analysis::Kind kind = std::invoke(reader, row);
        return kind == analysis::Kind::none ? std::nullopt : std::optional(kind);
    });
}

template <class Row, class Reader>
Field<Row> period_field(Reader reader, std::string long_name = "period, 0: none") {
    return Field<Row>{"period", reader, "1", std::move(long_name)}.json_as([reader](const Row& row) {
        const std::int64_t period = std::invoke(reader, row);
        return period > 0 ? std::optional(period) : std::nullopt;
    });
}

// What a table says of orbits that are accelerated, or led along a chord to a limit of S.

/// As one object, or null.
inline void write_growth(JsonWriter& json, const analysis::GrowthExponent& growth) {
    if (std::isnan(growth.value)) return json.null();
    json.begin_object();
    json.member("value", growth.value);
    json.member("low", growth.low);
    json.member("high", growth.high);
    json.end_object();
}

/// `growth_exponent`, an object in JSON and three columns of a record, and `limit_S`.
///   growth  a row's GrowthExponent, NaN unless its kind is `accelerated`
///   limit   a row's S*, NaN unless its kind is `chord`
template <class Row, class Growth, class Limit>
std::vector<Field<Row>> driven_fields(Growth growth, Limit limit) {
    using F = Field<Row>;
    using Exponent = analysis::GrowthExponent;
    const auto part = [growth](double Exponent::*member) {
        return [growth, member](const Row& row) { return std::invoke(growth, row).*member; };
    };
    return {F{"growth_exponent",
              [growth](JsonWriter& json, const Row& row) { write_growth(json, std::invoke(growth, row)); }},
            F{"growth_exponent", part(&Exponent::value), "1", "of kind accelerated: power of n by which J grows"}
                .record_only(),
            F{"growth_exponent_low", part(&Exponent::low), "1", "from this power on, at 95 %"}.record_only(),
            F{"growth_exponent_high", part(&Exponent::high), "1", "up to this power"}.record_only(),
            F{"limit_S", limit, "1", "of kind chord: S to which the chord leads"}};
}

/// What stands for a mean of S where there is none: "J ~ n^0.312", "S -> -10.4508"; nothing of other orbits.
std::string way_in_words(const analysis::GrowthExponent& growth, double limit_spin);

/// A mean of S with its error (`with_error`), of chaos without one one digit (`about`); of orbits that have no mean
/// (NaN) `way`, what stands for it.
std::string spin_in_words(double mean, double error, bool chaotic, const std::string& way);

// What a table says of the errors of one orbit's means of S.

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
