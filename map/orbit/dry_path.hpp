// Where a body is at any moment of a flight over a floor with dry friction.
#pragma once

#include "map/dry/dry_map.hpp"
#include "map/orbit/bent_flight.hpp"

#include <memory>
#include <vector>

namespace swirl {

/// A flight over a floor with dry friction, with the stations of its integration.
class DryPath final : public BentFlight {
public:
    ///   lasts  in 1/ω_s: later places are not asked for
    DryPath(const Scene<double>& scene, const FlightBegin& begin, double lasts);

    /// Cost: a step of the integration.
    Place at(double later) const override;

private:
    Body<double> body_;
    std::shared_ptr<const UniformPressure> pressure_;
    DryFlight<double> flight_;
    std::vector<Station<double>> stations_;
    bool has_stopped_ = false;
};

/// The flights of a scene; nothing without dry friction, where they are straight or in closed form.
BendFlight dry_paths(const Scene<double>& scene);

}  // namespace swirl
