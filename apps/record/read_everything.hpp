#pragma once

#include "apps/record/record_reader.hpp"

namespace swirl::apps {

/// Reads whatever a record holds, and throws it away: all groups, attributes and datasets that can be read, each on its
/// own, so that one that can't does not hide another. For try_reading().
void read_everything(const RecordReader& record);

}  // namespace swirl::apps
