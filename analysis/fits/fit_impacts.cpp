#include "analysis/fits/fit_impacts.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/fits/natural_units.hpp"
#include "analysis/fits/robust.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace swirl::analysis {

namespace {

/// What has a unit goes back to the table's.
void restore_units(ImpactFit& fit, const NaturalUnits& units) {
    const double square = units.length * units.length;
    for (std::size_t j = 0; j < 2; ++j) fit.signs.coefficients[j] /= square, fit.signs.errors[j] /= square;
    for (FittedNumber* k : {&fit.inertia, &fit.balance}) k->value *= square, k->low *= square, k->high *= square;
    fit.velocity_noise *= units.speed;
    fit.spin_noise *= units.speed / units.length;
    for (MeasuredImpact& impact : fit.impacts) {
        impact = from_units(impact, units);
        impact.whitening.reset();
    }
    for (ImpactResidual& residual : fit.residuals)
        residual.approach_speed *= units.speed, residual.slip_speed *= units.speed;
    for (ConstancyTest& test : fit.constancy) test.slope /= units.speed, test.error /= units.speed;
}

/// Resamples in natural units, without impacts that have a gross error.
auto resampled_in(const NaturalUnits& units, const ImpactFitSettings& settings) {
    return [units, &settings](std::uint64_t index) {
        const WeighedImpacts drawn = settings.resampled(index);
        WeighedImpacts natural;
        for (std::size_t i = 0; i < drawn.impacts.size(); ++i) {
            const MeasuredImpact impact = in_units(drawn.impacts[i], units);
            if (has_gross_error(impact)) continue;
            natural.impacts.push_back(impact);
            natural.weights.push_back(drawn.weights[i]);
        }
        return natural;
    };
}

}  // namespace

ImpactFit fit_impacts(std::span<const MeasuredImpact> impacts, std::span<const NamedImpactLaw> laws,
                      const ImpactFitSettings& settings) {
    if (laws.empty()) refuse("laws", 0, "1 or more");
    const NaturalUnits units = natural_units(impacts);
    std::vector<MeasuredImpact> scaled;
    for (const MeasuredImpact& impact : impacts)
        if (const MeasuredImpact natural = in_units(impact, units); !has_gross_error(natural))
            scaled.push_back(natural);
    if (scaled.size() < fewest_impacts)
        refuse("usable impacts", static_cast<double>(scaled.size()), std::to_string(fewest_impacts) + " or more");
    std::vector<double> squares;
    squares.reserve(scaled.size());
    for (const MeasuredImpact& impact : scaled) squares.push_back(impact.offset.squaredNorm());
    ImpactFit fit;
    if (quantile(std::move(squares), 0.5) > 0) {
        ImpactFitSettings natural = settings;
        if (natural.inertia) *natural.inertia /= units.length * units.length;
        if (settings.resampled) natural.resampled = resampled_in(units, settings);
        fit = fit_in_natural_units(scaled, laws, natural);
    } else {
        fit.outcome = ImpactFitOutcome::no_offsets;
    }
    fit.left_out = impacts.size() - scaled.size();
    fit.length = units.length;
    restore_units(fit, units);
    return fit;
}

}  // namespace swirl::analysis
