// Ctrl-C and SIGTERM: noted, and looked at between pieces of work, so that what is finished can be kept.
#pragma once

namespace swirl::apps {

/// From now on SIGINT and SIGTERM are noted instead of ending the process. (The one global: signals have no other.)
void note_interruptions();

bool is_interrupted();

}  // namespace swirl::apps
