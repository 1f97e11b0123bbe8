// Where the reference files of this folder lie.
#pragma once

#include <string>

namespace swirl::tests {

/// The path of a file of tests/references in the source tree that these tests were built from.
std::string reference_path(const std::string& name);

}  // namespace swirl::tests
