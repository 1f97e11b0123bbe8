// The tables of `swirl tradeoff`, each described once.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/tradeoff/tradeoff.hpp"

namespace swirl::apps::tradeoff {

using namespace studies::tradeoff;

/// Time and errors of an arithmetic …
Table<ArithmeticRow> errors_table();
/// … contacts that it missed …
Table<ArithmeticRow> contacts_table();
/// … what its own orbit is …
Table<ArithmeticRow> orbits_table();
/// … and all of these.
Table<ArithmeticRow> arithmetic_table();
Table<EvidenceRow> evidence_table();
/// What of the evidence is of all starts; evidence_table() has it in records and JSON.
Table<EvidenceRow> starts_table();
Table<RiskRow> risk_table();
Table<ModelRow> model_table();

}  // namespace swirl::apps::tradeoff
