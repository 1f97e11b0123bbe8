// The attracting steady modes of a scene with their shares, in documents and records.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/output/table.hpp"
#include "apps/studies/modes/attractors.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps {

/// The modes in a document; in a record along `axes` and the dimension `steady_mode`.
Table<SteadyShare> steady_share_table(const std::string& dimension = "steady_mode");

/// What a cell or a column of a record holds of its modes: lists as long as the longest of all, the rest NaN.
std::vector<double> filled(std::span<const SteadyShare> modes, double SteadyShare::*member, std::size_t length);

}  // namespace swirl::apps
