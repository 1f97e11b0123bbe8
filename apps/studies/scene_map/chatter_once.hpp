// Chatter that ends in contact counts as one impact.
//
// With e < 1 a landing comes after rebounds without end. How many of them a number type can tell apart is a matter of e
// and of rounding (5, 7, 9 … as e grows), not of the motion. So wherever impacts are counted (periods, itineraries,
// means per impact) the first of them stands for all, and the step from it leads through the rebounds and the contact
// to the impact after: a cycle whose one impact lands has period 1 for every e.
//
// Rebounds are a run of impacts, each after a shorter flight than the one before, on one vertex (or the rim), or on two
// neighbours in turn (an edge that rocks), at whose end the return map leads through contact.
#pragma once

#include "apps/studies/scene_map/scene_map.hpp"

#include <vector>

namespace swirl::studies {

/// The steps of the return map that count as one from z on: more than one where z is the first of rebounds that end in
/// contact. Cost: one step, and one or two that are looked ahead where nothing lands.
template <int D>
std::vector<ReturnStep<double>> steps_as_one(const SceneMap<D>& map, const PostImpactState<double>& z);

/// The one step that they make: its duration and integral are sums; its letter has the vertices on and the contact mode
/// of the impact that it ends with.
template <int D>
analysis::Advance<D, PostImpactState<double>> sum_of(const SceneMap<D>& map,
                                                     const std::vector<ReturnStep<double>>& steps);

/// One such step from z on.
template <int D>
analysis::Advance<D, PostImpactState<double>> advance_as_one(const SceneMap<D>& map, const PostImpactState<double>& z) {
    return sum_of(map, steps_as_one(map, z));
}

/// The sum of two letters of an itinerary: vertices on from both, the later one's contact mode, through contact if
/// either is.
Letter joined(const Letter& first, const Letter& second, int sides);

extern template std::vector<ReturnStep<double>> steps_as_one(const SceneMap<disk_dimension>&,
                                                             const PostImpactState<double>&);
extern template std::vector<ReturnStep<double>> steps_as_one(const SceneMap<polygon_dimension>&,
                                                             const PostImpactState<double>&);
extern template analysis::Advance<disk_dimension, PostImpactState<double>> sum_of(
    const SceneMap<disk_dimension>&, const std::vector<ReturnStep<double>>&);
extern template analysis::Advance<polygon_dimension, PostImpactState<double>> sum_of(
    const SceneMap<polygon_dimension>&, const std::vector<ReturnStep<double>>&);

}  // namespace swirl::studies
