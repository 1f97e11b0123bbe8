// Chatter that ends in contact counts as one impact.
//
// With e < 1 a landing comes after rebounds without end. How many of them a number type can tell apart is a matter of e
// and of rounding (5, 7, 9 … as e grows), not of the motion. So wherever impacts are counted (periods, words, means per
// impact) the first of them stands for all, and the step from it leads through the rebounds and the contact to the
// impact after: a cycle whose one impact lands has period 1 for every e.
//
// Rebounds are a run of impacts, each after a shorter flight than the one before, on one vertex (or the rim), or on two
// neighbours in turn (an edge that rocks), at whose end the return map leads through contact.
#pragma once

#include "apps/system/scene_map.hpp"

namespace swirl::apps {

/// How many steps of the return map count as one from z on: more than 1 where z is the first of rebounds that end in
/// contact. Cost: the steps that it looks ahead, two or three where nothing lands.
template <int D>
std::int64_t steps_as_one(const SceneMap<D>& map, const PostImpactState<double>& z);

/// One such step. Its duration and integral are sums; its letter has the vertices on and the contact mode of the impact
/// that it ends with.
template <int D>
analysis::Advance<D, PostImpactState<double>> advance_as_one(const SceneMap<D>& map, const PostImpactState<double>& z);

/// The sum of two letters of a word: vertices on from both, the later one's contact mode, through contact if either is.
Letter joined(const Letter& first, const Letter& second, int sides);

extern template std::int64_t steps_as_one(const SceneMap<disk_dimension>&, const PostImpactState<double>&);
extern template std::int64_t steps_as_one(const SceneMap<polygon_dimension>&, const PostImpactState<double>&);
extern template analysis::Advance<disk_dimension, PostImpactState<double>> advance_as_one(
    const SceneMap<disk_dimension>&, const PostImpactState<double>&);
extern template analysis::Advance<polygon_dimension, PostImpactState<double>> advance_as_one(
    const SceneMap<polygon_dimension>&, const PostImpactState<double>&);

}  // namespace swirl::apps
