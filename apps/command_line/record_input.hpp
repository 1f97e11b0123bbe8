// Records that are read.
#pragma once

#include <string>

namespace swirl::apps {

/// A word of warning, once it was read, of a record that no checksum speaks for: it was edited or packed anew, or comes
/// from another program, and damage to its numbers would not be seen. Nothing of what is no record at all.
void warn_without_checksum(const std::string& record, bool quiet);

}  // namespace swirl::apps
