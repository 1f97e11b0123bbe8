// The attractors of a column, each with the share of the starts that settle on it.
#pragma once

#include "apps/studies/diagrams/diagram.hpp"

#include <cstddef>
#include <vector>

namespace swirl::studies::diagrams {

struct ColumnShare {
    const DiagramColumn* column;
    std::size_t number;          ///< the column's
    double share;                ///< of the column's starts
    const Attractor* attractor;  ///< the first start's
    double mean_spin;            ///< mean over the starts that share it
    double mean_spin_error;      ///< its standard error over them; of one start its own
};

/// By falling share; the same attractor for two starts as attractors_of() tells them apart. Of the random
/// starts alone where there are any: those followed from column to column keep to one attractor.
std::vector<ColumnShare> shares_of(const DiagramColumn& column, std::size_t number);

}  // namespace swirl::studies::diagrams
