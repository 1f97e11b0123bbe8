// The details under a command's --help, as blocks that a page can set.
#pragma once

#include <string>
#include <vector>

namespace swirl::apps::manual {

/// Lines that are kept as they stand, or a paragraph that is set anew.
struct Block {
    bool kept = false;
    std::vector<std::string> lines;  ///< of a paragraph one
};

struct Details {
    std::vector<Block> blocks;
    std::vector<std::string> examples;  ///< command lines, and comments between them
};

/// Indented lines and those of a table are kept. Of others a line that ends a sentence and had room for the next one's
/// first word was ended on purpose: what follows is a paragraph of its own. What stands under a line `Example:` or
/// `Examples:` are the examples.
Details details_of(const std::string& text);

}  // namespace swirl::apps::manual
