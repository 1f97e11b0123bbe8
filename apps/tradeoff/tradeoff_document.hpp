// What `swirl tradeoff` says: a document, a record, tables for people.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/studies/tradeoff/tradeoff.hpp"
#include "apps/tradeoff/tradeoff_command.hpp"

namespace swirl::apps::tradeoff {

void write_document(const TradeoffOptions& options, const Scene<double>& scene, const Amounts& amounts,
                    const Tradeoff& found);
void write_record(const RecordGroup& root, const TradeoffOptions& options, const Scene<double>& scene,
                  const Amounts& amounts, const Tradeoff& found);
void print_tables(const TradeoffOptions& options, const Scene<double>& scene, const Tradeoff& found);

}  // namespace swirl::apps::tradeoff
