// The cycles that a record holds, to go on from.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/studies/cycles/near_orbit.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::orbits {

using namespace studies::cycles;

/// The cycles of a record of `orbits`, those along the branches of `continue` and `bifurcate`, the steady modes of
/// `describe`, or those that `classify` found, in the order of the record's rows.
struct RecordCycles {
    Scene<double> scene;
    std::string along;  ///< the parameter in which the cycles' scenes differ; empty: all in the same scene
    std::vector<CyclePlace> places;
    std::string range = {};                   ///< of a record of branches, the range that was asked for, as its flag
    std::vector<std::int64_t> branches = {};  ///< of each cycle of a record of branches, the number of its branch
    std::vector<std::string> others = {};     ///< kinds of the rows that are no cycles (chaos), "" of those that are
};
/// @throws BadInput if it holds none
RecordCycles cycles_of_record(const std::string& file);

/// Number `number` of them, from 1; without a number the only one.
/// @throws BadInput if there is none of that number, or several and none was chosen
CyclePlace cycle_of_record(const std::string& file, const std::optional<std::int64_t>& number);

/// "psi,chi,vn,vt,S", as --from and --near take it; a disk drops chi.
std::string point_as_flag(const SectionPoint<double>& z, bool disk);

}  // namespace swirl::apps::orbits
