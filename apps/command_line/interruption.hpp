// Ctrl-C and SIGTERM: recorded, and checked between pieces of work, so that finished results are saved.
#pragma once

namespace swirl::apps {

/// From now on SIGINT and SIGTERM are noted instead of ending the process. (The one global: signals have no other.)
void note_interruptions();

bool is_interrupted();

/// From now on SIGINT and SIGTERM end the process with exit code 130 at once: for work that can't check for them, as
/// long as no result is finished. A record that is being written stays as its partial file, which the next writer
/// replaces.
void exit_when_interrupted();

}  // namespace swirl::apps
