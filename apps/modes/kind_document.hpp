// Kind and period in JSON documents. Records hold name_of(kind), `none` among them, and the period 0 for none.
#pragma once

#include "analysis/classification/mode.hpp"
#include "apps/json/json_writer.hpp"

namespace swirl::apps {

/// Member `kind`; null for Kind::none.
inline void write_kind(JsonWriter& json, analysis::Kind kind) {
    json.key("kind");
    if (kind == analysis::Kind::none)
        json.null();
    else
        json.value(name_of(kind));
}

/// Member `period`; null for 0.
inline void write_period(JsonWriter& json, std::int64_t period) {
    json.key("period");
    if (period > 0)
        json.value(period);
    else
        json.null();
}

}  // namespace swirl::apps
