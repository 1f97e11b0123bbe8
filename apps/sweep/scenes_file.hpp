// A table of scenes: CSV, a scene a row, columns named as the flags of the scene and of its start.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

struct ScenesFile {
    std::size_t rows = 0;
    std::vector<std::string> columns;  ///< NAME=V,V,…, a value a row, each as word_at() writes it
};

/// Reads a file: a header, then a scene a line; cells are separated by tabs, semicolons or commas; lines that are empty
/// or begin with # are skipped. `inertia_factor` is `inertia-factor`. @throws BadInput naming the file and the line: a
/// column that is no flag or stands twice, a cell that is empty or no value of its column, no row, more than 10⁶ rows
ScenesFile read_scenes(const std::string& file);

}  // namespace swirl::apps::sweep
