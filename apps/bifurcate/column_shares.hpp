// The attractors of a column, each with the share of the starts that settle on it.
#pragma once

#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/output/table.hpp"

namespace swirl::apps::bifurcate {

struct ColumnShare {
    const DiagramColumn* column;
    std::size_t number;          ///< the column's
    double share;                ///< of the column's starts
    const Attractor* attractor;  ///< the first start's
    double mean_spin;            ///< mean over the starts that share it
    double mean_spin_error;      ///< its standard error over them; of one start its own
};

/// By falling share; the same attractor for two starts as `swirl classify --runs` tells them apart. Of the random
/// starts alone where there are any: those followed from column to column keep to one attractor.
std::vector<ColumnShare> shares_of(const DiagramColumn& column, std::size_t number);

/// What the starts of the columns settle on: one line for each attractor of a column.
Table<ColumnShare> share_table(const Diagram& diagram);

}  // namespace swirl::apps::bifurcate
