// Standard input, output and error, as they are found: closed, full, or with nobody at the other end.
#pragma once

#include <string>
#include <string_view>

namespace swirl::apps {

/// At the start of the program. Of the descriptors 0, 1 and 2 those that are closed are taken, so that no file that is
/// opened later gets their number and, with it, what is printed. Reading from such an input and writing to such an
/// output fail as on a closed one; what is said on such an error is lost. Writing to a pipe that nobody reads, or
/// beyond the limit of a file's size, fails like any other writing instead of ending the process.
void prepare_standard_streams();

/// True if standard output is a pipe or a socket whose reader has closed it, as `| head` does.
bool reader_of_output_has_gone();

/// Text on standard output; that of a command that runs for another program (caller.hpp) goes to that. @throws
/// std::system_error if it can't be written
void print_text(std::string_view text);

/// A line on standard error, or to the program for which the command runs, in which control characters are written out
/// (text_file.hpp). Nothing depends on whether it can be written.
void report(const std::string& line);

}  // namespace swirl::apps
