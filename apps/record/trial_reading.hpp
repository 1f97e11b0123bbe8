// A first reading in a child process, of a file that no checksum speaks for.
#pragma once

#include <filesystem>
#include <functional>

namespace swirl::apps {

/// Runs `read` in a child process first: the HDF5 library may crash or hang on a file that is damaged, and then only
/// the child does. Its time is limited to 5 s and 1 s for each 20 MB of the file; what it prints is lost. An exception
/// of `read` is none of these: the same will be thrown where it matters, in the process itself.
/// @throws RecordError if the child came to such an end, or there can be none
void try_reading(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace swirl::apps
