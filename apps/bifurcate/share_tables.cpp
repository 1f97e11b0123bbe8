#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <string>

namespace swirl::apps::bifurcate {

namespace {

std::string mean_in_words(const ColumnShare& row) {
    const Attractor& attractor = *row.attractor;
    return spin_in_words(row.mean_spin, row.mean_spin_error, attractor.kind == analysis::Kind::chaotic,
                         way_in_words(attractor.growth, attractor.limit_spin));
}

}  // namespace

Table<ColumnShare> share_table(const Diagram& diagram) {
    using Row = ColumnShare;
    using F = Field<Row>;
    const auto of = [](auto member) { return [member](const Row& row) { return row.attractor->*member; }; };
    const auto in_percent = [](const Value& value) {
        return fmt::format("  {:>6.2f} %", 100 * std::get<double>(value));
    };
    const auto parameter = [](const Row& row) { return row.column->parameter; };
    Table<Row> table{
        {"share_of_column"},
        {F{"parameter", parameter, "1", "parameter " + diagram.along.name}.record_only().shown(diagram.along.name,
                                                                                               "  {:>14.10g}"),
         F{"column", &Row::number, "1", "column"}.record_only(),
         F{"share", &Row::share, "1", "share of the column's starts"}.shown("share", {"  {:>8}", in_percent}),
         F{"mode", of(&Attractor::mode), "", "mode of these starts"}.shown("mode", "  {:<13}"),
         kind_field<Row>(of(&Attractor::kind)).shown("kind", " {:<20}"),
         F{"outcome", of(&Attractor::outcome), "", "how their orbits ended"},
         period_field<Row>(of(&Attractor::period), "0: none").shown("period", dash_for_zero(" {:>7}")),
         F{"mean_S", &Row::mean_spin, "1", "mean of the starts' time means"},
         F{"mean_S_error", &Row::mean_spin_error, "1", "its standard error over them; of one its own"},
         F{"mean_S_in_words", mean_in_words, no_column}.table_only().shown("mean S", " {:>19}")},
        {"parameter", "share", "column", "mode", "kind", "outcome", "period"}};
    const auto driven = driven_fields<Row>(of(&Attractor::growth), of(&Attractor::limit_spin));
    table.fields.insert(table.fields.end(), driven.begin(), driven.end());
    return table;
}

}  // namespace swirl::apps::bifurcate
