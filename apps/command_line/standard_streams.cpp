#include "apps/command_line/standard_streams.hpp"

#include "apps/command_line/caller.hpp"
#include "apps/command_line/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace swirl::apps {

namespace {

/// Opens the null device under the number of a closed descriptor: open() gives the lowest one that is free, and all
/// below are open by now.
void take(int descriptor, int mode) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) return;
    if (::open("/dev/null", mode) != descriptor) std::_Exit(4);  // a system without a null device: nothing is safe
}

}  // namespace

void prepare_standard_streams() {
    // Opened the wrong way round, reading and writing fail, as they do on a closed descriptor.
    take(STDIN_FILENO, O_WRONLY);
    take(STDOUT_FILENO, O_RDONLY);
    take(STDERR_FILENO, O_RDONLY);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool reader_of_output_has_gone() {
    pollfd output{STDOUT_FILENO, 0, 0};  // errors are reported unasked: POLLERR of a pipe, POLLHUP of a socket
    return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

void print_text(std::string_view text) {
    if (const auto caller = caller_of_this_thread()) return caller->take_text(text);
    fmt::print("{}", text);
}

void report(const std::string& line) {
    if (const auto caller = caller_of_this_thread()) return caller->take_message(printable(line));
    std::fflush(stdout);  // where both go to one file, a line must not stand within another
    const std::string whole = printable(line) + "\n";  // at once, so that lines of several processes don't mix
    std::fwrite(whole.data(), 1, whole.size(), stderr);
}

}  // namespace swirl::apps
