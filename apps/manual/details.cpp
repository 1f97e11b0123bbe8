#include "apps/manual/details.hpp"

#include <sstream>

namespace swirl::apps::manual {

namespace {

// Details are written in lines of up to 120 characters, and broken a word or two before that where it reads better.
constexpr std::size_t line_with_room = 100;

/// A table's line has columns, what is indented is a table or code.
bool is_set_by_hand(const std::string& line) {
    return line.starts_with("  ") || line.find("   ") != std::string::npos;
}

bool has_room_for(const std::string& line, const std::string& next) {
    return (line.ends_with('.') || line.ends_with(':')) &&
           line.size() + 1 + next.substr(0, next.find(' ')).size() <= line_with_room;
}

}  // namespace

Details details_of(const std::string& text) {
    Details details;
    std::istringstream lines(text);
    std::string before;
    bool examples = false;
    for (std::string line; std::getline(lines, line); before = line) {
        examples = examples || line == "Example:" || line == "Examples:";
        if (examples) {
            if (line.starts_with("  ")) details.examples.push_back(line.substr(2));
            continue;
        }
        if (line.empty()) continue;
        const bool kept = is_set_by_hand(line);
        const bool goes_on = !before.empty() && !details.blocks.empty() && details.blocks.back().kept == kept &&
                             (kept || !has_room_for(before, line));
        if (!goes_on)
            details.blocks.push_back({kept, {line}});
        else if (kept)
            details.blocks.back().lines.push_back(line);
        else
            details.blocks.back().lines.front() += " " + line;
    }
    return details;
}

}  // namespace swirl::apps::manual
