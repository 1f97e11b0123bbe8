// The fields `kind` and `period` of every result that names modes: null in JSON where a record has "none" and 0.
#pragma once

#include "analysis/classification/mode.hpp"
#include "apps/output/table.hpp"

namespace swirl::apps {

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

}  // namespace swirl::apps
