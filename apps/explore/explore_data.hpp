// What the page of `swirl explore` holds of its records, as JSON.
#pragma once

#include <string>
#include <vector>

namespace swirl::apps::explore {

/// A page's data: the first record's kind, and the text.
struct PageData {
    std::string kind;  ///< map, diagram or curves
    std::string json;
};

/// Reads the records: one of a sweep, of a diagram or of curves, and curves that lie over a sweep. Cost: all that is
/// drawn of them in memory. @throws BadInput for any other; RecordError for one that can't be read
PageData page_data(const std::vector<std::string>& records);

}  // namespace swirl::apps::explore
