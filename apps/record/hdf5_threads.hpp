#pragma once

namespace swirl::apps {

/// May several threads read and write records at once? Not where the HDF5 library was built without that.
bool hdf5_is_safe_in_threads();

}  // namespace swirl::apps
