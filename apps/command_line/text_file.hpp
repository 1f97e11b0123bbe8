// A named text file, read whole.
#pragma once

#include <cstddef>
#include <string>

namespace swirl::apps {

/// The content of a text file; "-" is standard input. What never ends (a device, a pipe that goes on) is read no
/// further than `most` bytes, or its first zero byte.
///   what  begins each message: "scene file", "series"
/// @throws BadInput naming the file: it can't be opened or read, is a directory, is longer, is not a text file, is
/// UTF-16
std::string read_text(const std::string& what, const std::string& name, std::size_t most);

}  // namespace swirl::apps
