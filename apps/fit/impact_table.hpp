// Measured impacts from a text file.
#pragma once

#include "analysis/fits/measured_impact.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps::fit {

struct ImpactTable {
    std::vector<analysis::MeasuredImpact> impacts;
    std::size_t rows = 0;     ///< of the file
    std::size_t flagged = 0;  ///< left out: flags > 0
    std::size_t missing = 0;  ///< left out: a value is missing
    bool by_rows = false;     ///< the offset was given as n3, d3
    bool has_errors = false;  ///< the table states each impact's standard errors
};

/// Columns, by their names in the header: vx_before vy_before spin_before vx_after vy_after spin_after, and rx ry, the
/// offset from the centre to the contact, or n3 d3, the third entries of the rows (0, 1, n3) and (1, 0, d3) that give
/// the contact's velocity (r = (n3, −d3)); flags, if there is one; and the standard errors velocity_error_before
/// spin_error_before velocity_error_after spin_error_after, all four or none. Others are not read. For n3 and d3 beside
/// rx and ry the latter count.
/// @throws BadInput naming file, line or column, and what is allowed; for fewer than `analysis::fewest_impacts` rows
ImpactTable read_impacts(const std::string& file);

}  // namespace swirl::apps::fit
