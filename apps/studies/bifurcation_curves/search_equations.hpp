// What all pieces of a search for curves stand on.
#pragma once

#include "apps/studies/bifurcation_curves/border_curve.hpp"
#include "apps/studies/bifurcation_curves/curves.hpp"
#include "apps/studies/bifurcation_curves/smooth_curve.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

namespace swirl::studies::bifurcation_curves {

/// The scene's maps over a plane, and how curves are followed. Nothing of it changes, so that pieces share it.
struct SearchEquations {
    Scene<double> scene;
    Plane plane;
    FollowOptions follow;
    analysis::PlaneMap map;
    analysis::ShootingMap coordinates;
    ItineraryMap words;
    analysis::BoundaryOptions smooth;
    BorderOptions border;

    SearchEquations(const Scene<double>& of, const Plane& over, const FollowOptions& options)
        : scene(of),
          plane(over),
          follow(options),
          map(plane_map_of(of, over.parameter(0), over.parameter(1))),
          coordinates(analysis::on_line(map, 0, over.low())),
          words(itinerary_map_of(of, over.parameter(0), over.parameter(1))),
          smooth(smooth_options(of, over, options.longest_step, options.control.stop)),
          border{options.longest_step, options.control.stop} {
        // DF is some 50 at u_n = 0.05; differences over 10⁻⁵ are then of its change.
        if (options.to_vanishing_impacts) smooth.steep_below = 0.05;
    }
};

}  // namespace swirl::studies::bifurcation_curves
