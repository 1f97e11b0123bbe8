// The tables of `swirl tradeoff`, each described once.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/tradeoff/tradeoff.hpp"

namespace swirl::apps::tradeoff {

using namespace studies::tradeoff;

/// Time and errors of an arithmetic …
Table<ArithmeticRung> errors_table();
/// … contacts that it missed …
Table<ArithmeticRung> contacts_table();
/// … what its own orbit is …
Table<ArithmeticRung> orbits_table();
/// … and all of these.
Table<ArithmeticRung> rungs_table();
Table<EvidenceRung> evidence_table();
/// What of the evidence is of all starts; evidence_table() has it in records and JSON.
Table<EvidenceRung> starts_table();
Table<ModelRung> model_table();

}  // namespace swirl::apps::tradeoff
