// SIGINT (Ctrl-C), SIGTERM and SIGHUP: exit code 130 within half a second, no stray file, and what is finished kept. Of
// a command that runs for another program (caller.hpp) that program says when to stop: no signal is touched.
#pragma once

#include <functional>

namespace swirl::apps {

/// A command that a caller has stopped, and that has nothing to keep.
struct Interrupted {};

/// A SIGHUP that is ignored from outside now, as by nohup, stays so, whatever a library does to it later.
void keep_ignored_hangup();

/// From now on these signals end the process with exit code 130 at once: for work of which nothing is finished before
/// its end. Files that are being written are removed. (A SIGHUP that is ignored from outside, as by nohup, stays so.)
/// @throws Interrupted where a caller has said stop, and then no more
void exit_when_interrupted();

/// From now on an end of exit_when_interrupted() is said in a line on standard error: of work that takes a while, and
/// after which there is nothing.
void tell_interruption();

/// From now on they are noted: for work that looks at is_interrupted() and keeps what is finished. Work that has not
/// come to finish_up() 0.3 seconds later is ended as by exit_when_interrupted(). (What a handler can reach is global.)
void note_interruptions();

/// Is the command that this thread runs interrupted?
bool is_interrupted();
/// The same question about the command that this thread runs now, for any thread to ask.
std::function<bool()> interruption();

/// The work is over, done or interrupted: what is finished is about to be written, however long that takes.
void finish_up();

}  // namespace swirl::apps
