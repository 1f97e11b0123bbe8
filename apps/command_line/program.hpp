// The program: its commands, the one that a command line calls, and its folder. CLI11 stands behind it (see flags.hpp).
#pragma once

#include "apps/command_line/definitions.hpp"
#include "apps/command_line/flags.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace swirl::apps {

/// Where the file of the program that runs lies: what was installed with it is found from there, wherever the prefix
/// was moved to. Empty where the system does not tell.
std::filesystem::path folder_of_this_program();

/// Options that keep the program look at the flags of every command.
template <class Options>
concept KeepsProgram = requires(Options options) {
    options.program;
};

class Program {
public:
    /// What a command does once its flags are read; gives the exit code.
    using Action = std::function<int()>;

    /// `version` is the answer to --version, `footer` the end of --help.
    Program(const std::string& description, const std::string& version, const std::string& footer);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Adds command `name` whose options live in an `Options` with `void add_to(Flags&)`; `run(options)` gives the exit
    /// code. `details` ends with a command line that runs, shown under --help. The options are added once a command
    /// line names the command: those of all commands would be a tenth of what a short run takes.
    template <class Options, class Run>
    void add_command(const std::string& name, const std::string& does, const std::string& details, Run run) {
        const auto options = std::make_shared<Options>();
        new_command(name, does, details,
                    {nullptr, [options](Flags& flags) { options->add_to(flags); },
                     [options, run] { return run(*options); }, KeepsProgram<Options>});
    }

    template <class Options>
    void add_command(const std::string& name, const std::string& does, const std::string& details,
                     int (*run)(Options&)) {
        add_command<Options, int (*)(Options&)>(name, does, details, run);
    }

    /// What the command line asks for, its flags read: a command, or to print --help or --version.
    /// @throws BadInput for words that are no command line of this program, with one line that names the word
    Action called(int argc, char** argv);

    /// All commands, with their flags.
    ProgramDefinition definition();

private:
    struct Entry {
        CLI::App* command;
        std::function<void(Flags&)> add_flags;  ///< empty once they are there
        Action action;
        bool looks_at_all;  ///< at the flags of every command
    };

    void new_command(const std::string& name, const std::string& does, const std::string& details, Entry entry);
    void add_flags_for(const std::vector<std::string>& words);
    void add_flags(Entry& entry);

    std::unique_ptr<CLI::App> app_;
    std::vector<Entry> entries_;
};

}  // namespace swirl::apps
