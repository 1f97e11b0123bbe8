// The tables of `swirl tradeoff`, each described once.
#pragma once

#include "apps/output/write_table.hpp"
#include "apps/tradeoff/tradeoff.hpp"

namespace swirl::apps::tradeoff {

/// Time, errors and missed contacts of a rung …
Table<ArithmeticRung> errors_table();
/// … what its own orbit is …
Table<ArithmeticRung> orbits_table();
/// … and all of these.
Table<ArithmeticRung> rungs_table();
Table<EvidenceRung> evidence_table();
Table<ModelRung> model_table();

}  // namespace swirl::apps::tradeoff
