// The cycles that a record holds, to go on from.
#pragma once

#include "map/model/scene.hpp"
#include "map/model/section.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::orbits {

/// Where a cycle is said to be, in its own scene.
struct CyclePlace {
    Scene<double> scene;
    std::vector<SectionPoint<double>> points;
    std::size_t number = 1;  ///< of the record's row, from 1
};

/// The cycles of a record of `orbits`, those along the branches of `continue` and `bifurcate`, the steady modes of
/// `describe`, or those that `classify` found, in the order of the record's rows.
struct RecordCycles {
    Scene<double> scene;
    std::string along;  ///< the parameter in which the cycles' scenes differ; empty: all in the same scene
    std::vector<CyclePlace> places;
    std::vector<std::string> others = {};  ///< kinds of the rows that are no cycles (chaos), "" of those that are
};
/// @throws BadInput if it holds none
RecordCycles cycles_of_record(const std::string& file);

/// Number `number` of them, from 1; without a number the only one.
/// @throws BadInput if there is none of that number, or several and none was chosen
CyclePlace cycle_of_record(const std::string& file, const std::optional<std::int64_t>& number);

/// "psi,chi,vn,vt,S", as --from and --near take it; a disk drops chi.
std::string point_as_flag(const SectionPoint<double>& z, bool disk);

}  // namespace swirl::apps::orbits
