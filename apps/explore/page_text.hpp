// The page of `swirl explore` but for its data: style, script and the map, compiled to WebAssembly. Made of
// apps/explore/page/ by cmake/WritePage.cmake.
#pragma once

#include <string_view>

namespace swirl::apps::explore {

/// HTML before and after the JSON of the data.
std::string_view page_before_data();
std::string_view page_after_data();

}  // namespace swirl::apps::explore
