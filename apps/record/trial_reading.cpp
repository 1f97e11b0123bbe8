#include "apps/record/trial_reading.hpp"

#include "apps/record/output_file.hpp"
#include "apps/record/record_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <system_error>

namespace swirl::apps {

namespace {

constexpr auto read_action = "cannot read record";

[[noreturn]] void read_in_child(const std::function<void()>& read, rlim_t seconds) {
    // The parent's own handlers would clear up after the parent.
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) std::signal(number, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO), ::dup2(nowhere, STDERR_FILENO);
    const rlimit time{seconds, seconds + 1};
    ::setrlimit(RLIMIT_CPU, &time);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    try {
        read();
    } catch (const std::exception&) {  // said by the process itself, where it reads the same
    }
    ::_exit(0);
}

}  // namespace

void try_reading(const std::filesystem::path& file, const std::function<void()>& read) {
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(file, unknown);
    const rlim_t seconds = 5 + (unknown ? 0 : bytes / 20'000'000);
    const pid_t child = ::fork();
    if (child < 0) throw RecordError(read_action, file.string(), system_reason());
    if (child == 0) read_in_child(read, seconds);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw RecordError(read_action, file.string(), system_reason());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        throw RecordError(read_action, file.string(),
                          fmt::format("it is damaged: the HDF5 library had not read it after {} s", seconds));
    throw RecordError(read_action, file.string(), "it is damaged: the HDF5 library crashes on it");
}

}  // namespace swirl::apps
