// What a table says of orbits that are accelerated, or led along a chord to a limit of S.
#pragma once

#include "analysis/classification/growth.hpp"
#include "apps/output/table.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace swirl::apps {

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

}  // namespace swirl::apps
