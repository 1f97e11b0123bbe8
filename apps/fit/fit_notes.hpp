// What a reader of a fit must know beside its numbers.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "apps/fit/impact_table.hpp"

#include <string>
#include <vector>

namespace swirl::apps::fit {

/// One sentence or two each: signs that momentum turns, k that it contradicts, μ without an upper end, laws that can't
/// be told apart, scatter beyond the noise, parameters that depend on a speed, rows left out.
std::vector<std::string> notes_of(const analysis::ImpactFit& fit, const ImpactTable& table);

/// Why a fit ended as ImpactFitOutcome::gains_energy.
std::string risen_energy(const analysis::ImpactFit& fit);

/// Momentum alone gives another k; of stated errors the balance has to be wider with this one, too, for impacts of
/// which none changes the spin tell no k.
bool contradicts_momentum(const analysis::ImpactFit& fit, bool stated);

}  // namespace swirl::apps::fit
