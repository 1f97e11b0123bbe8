#include "apps/scripts/python_script.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/program.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/record/output_file.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace swirl::apps::scripts {

namespace {

constexpr const char* packages =
    "python3 python3-numpy python3-h5py python3-h5netcdf python3-xarray python3-matplotlib";

/// Debian's Python packages belong to this interpreter; another python3 first on PATH may not see them.
constexpr const char* system_python = "/usr/bin/python3";

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool is_file(const std::filesystem::path& path) {
    std::error_code unreadable;
    return std::filesystem::is_regular_file(path, unreadable);
}

}  // namespace

std::filesystem::path find_script(const std::string& name) {
    const std::string chosen = environment("SWIRL_FIGURES");
    if (!chosen.empty()) {
        const auto script = std::filesystem::path(chosen) / name;
        if (!is_file(script)) throw BadInput(fmt::format("SWIRL_FIGURES = {} holds no {}", chosen, name));
        return script;
    }
    const auto installed = folder_of_this_program() / SWIRL_FIGURES_FROM_PROGRAM / name;
    if (is_file(installed)) return installed.lexically_normal();
    const auto source = std::filesystem::path(SWIRL_FIGURES_SOURCE) / name;
    if (is_file(source)) return source;
    throw BadInput(
        fmt::format("{} is not where swirl was installed; set SWIRL_FIGURES to the folder that holds it", name));
}

void become_python(const std::filesystem::path& script, const std::vector<std::string>& arguments) {
    const std::string chosen = environment("SWIRL_PYTHON");
    // -B: it leaves no compiled files beside the script
    std::vector<std::string> words = {chosen.empty() ? system_python : chosen, "-B", script.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    // Held back until the script has its own way with them (notebooks-export/script.py): Python's start has another.
    sigset_t interruptions, before;
    ::sigemptyset(&interruptions);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&interruptions, number);
    ::sigprocmask(SIG_BLOCK, &interruptions, &before);
    ::execv(argv[0], argv.data());
    const std::string reason = system_reason();
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    throw BadInput(fmt::format("cannot run {} ({}); figures need the Debian packages {}", words[0], reason, packages));
}

int run_python(const std::filesystem::path& script, const std::vector<std::string>& arguments, unsigned seconds) {
    const pid_t child = ::fork();
    if (child < 0) throw BadInput(fmt::format("cannot run Python: {}", system_reason()));
    if (child == 0) {
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_DFL);
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // an interruption ends this process: the child, too
        const rlimit most{seconds, seconds + 1};
        ::setrlimit(RLIMIT_CPU, &most);
        const rlimit none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
        try {
            become_python(script, arguments);
        } catch (const BadInput& error) {
            report(fmt::format("swirl: {}", error.what()));
        }
        ::_exit(exit_bad_input);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw BadInput(fmt::format("cannot run Python: {}", system_reason()));
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    throw BadInput(fmt::format("record '{}' cannot be read: {} ended by signal {}", arguments.front(),
                               script.filename().string(), WTERMSIG(status)));
}

}  // namespace swirl::apps::scripts
