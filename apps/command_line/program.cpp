#include "apps/command_line/program.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/words.hpp"
#include "apps/output/wrapped.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace swirl::apps {

std::filesystem::path folder_of_this_program() {
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    return unknown ? std::filesystem::path() : program.parent_path();
}

namespace {

constexpr const char* options_heading = "Options";

/// Every release of CLI11 lays help out in its own way: ours is the same on all.
class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter() { label("POSITIONALS", "Positionals"); }  // in capitals from 2.5 on

    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        return app->get_description() + "\nUsage: " + name + arguments_of(*app) + "\n" + make_positionals(app) +
               make_groups(app, mode) + make_subcommands(app, mode) + "\n" + app->get_footer() + "\n";
    }

    std::string make_subcommand(const CLI::App* command) const override {
        return row(command->get_name(), command->get_description());
    }

    std::string make_option(const CLI::Option* option, bool is_positional) const override {
        return row(make_option_name(option, is_positional) + make_option_opts(option), option->get_description());
    }

private:
    /// "  name   what it does", which begins a line of its own below a name that is longer than its columns.
    static std::string row(const std::string& name, const std::string& does) {
        const std::string head = "  " + name, indent(description_column, ' ');
        const std::string gap = head.size() < description_column ? indent.substr(head.size()) : "\n" + indent;
        return head + (does.empty() ? "" : gap + does) + "\n";
    }

    std::string arguments_of(const CLI::App& app) const {
        std::string text = " [OPTIONS]";
        for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); }))
            text += " " + make_option_usage(option);
        return app.get_subcommands(nullptr).empty() ? text : text + " [SUBCOMMAND]";
    }
};

}  // namespace

Program::Program(const std::string& description, const std::string& version, const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, "swirl")) {
    app_->formatter(std::make_shared<HelpFormatter>());
    app_->get_help_ptr()->group(options_heading);
    app_->option_defaults()->group(options_heading);
    app_->set_version_flag("--version", version);
    app_->require_subcommand(0, 1);
    app_->footer(footer);
}

Program::~Program() = default;

void Program::new_command(const std::string& name, const std::string& does, const std::string& details, Entry entry) {
    entry.command = app_->add_subcommand(name, does);
    entry.command->group("Subcommands");
    entry.command->get_help_ptr()->group(options_heading);
    entry.command->footer(details);
    entries_.push_back(std::move(entry));
}

void Program::add_flags_for(const std::vector<std::string>& words) {
    const auto named = [&words](const Entry& entry) {
        return std::find(words.begin(), words.end(), entry.command->get_name()) != words.end();
    };
    const bool all = std::any_of(entries_.begin(), entries_.end(),
                                 [&](const Entry& entry) { return entry.looks_at_all && named(entry); });
    for (Entry& entry : entries_)
        if (all || named(entry)) add_flags(entry);
}

void Program::add_flags(Entry& entry) {
    if (!entry.add_flags) return;
    Flags flags(*entry.command);
    std::exchange(entry.add_flags, nullptr)(flags);
}

ProgramDefinition Program::definition() {
    for (Entry& entry : entries_) add_flags(entry);
    return definition_of(*app_);
}

namespace {

/// "record: At Most 1 required but received 2" (CLI11 2.6: "At most"), as sentences here are written.
std::string in_lower_case(std::string text) {
    for (const std::string_view limit : {"at most", "at least"})
        for (const char letter : {limit[3], static_cast<char>(limit[3] - 'a' + 'A')}) {
            const std::string capital = std::string("At ") + letter + std::string(limit.substr(4));
            if (const auto at = text.find(capital); at != std::string::npos) text.replace(at, limit.size(), limit);
        }
    return text;
}

/// `help NAME` is `NAME --help`, and `help` alone `--help`. @throws BadInput for more words
std::vector<std::string> without_help(const std::vector<std::string>& words) {
    if (words.empty() || words.front() != "help") return words;
    if (words.size() > 2)
        throw BadInput(fmt::format("help takes the name of one command; {} are given", words.size() - 1));
    return words.size() == 1 ? std::vector<std::string>{"--help"} : std::vector<std::string>{words[1], "--help"};
}

}  // namespace

Program::Action Program::called(int argc, char** argv) {
    const std::vector<std::string> words =
        without_help(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
    add_flags_for(words);
    check_words(*app_, words);
    try {
        std::vector<const char*> arguments = {argc > 0 ? argv[0] : "swirl"};
        for (const std::string& word : words) arguments.push_back(word.c_str());
        app_->parse(static_cast<int>(arguments.size()), arguments.data());
    } catch (const CLI::CallForHelp&) {
        return [this] {
            std::cout << help_in_columns(app_->help());
            std::cout.flush();
            return static_cast<int>(exit_done);
        };
    } catch (const CLI::Success& success) {  // --version; app_->exit(…) prints it
        return [this, success] {
            app_->exit(success);
            std::cout.flush();
            return static_cast<int>(exit_done);
        };
    } catch (const CLI::ConversionError& error) {
        constexpr std::string_view lead = "Could not convert: ";
        const std::string_view what = error.what();
        if (what.substr(0, lead.size()) != lead) throw BadInput(error.what());
        throw BadInput(std::string(what.substr(lead.size())) + ": not a number that this option takes");
    } catch (const CLI::ArgumentMismatch& error) {
        throw BadInput(in_lower_case(error.what()));
    } catch (const CLI::ParseError& error) {
        throw BadInput(error.what());
    }
    for (const Entry& entry : entries_)
        if (entry.command->parsed()) return entry.action;
    throw BadInput("no command given; swirl --help lists them");
}

}  // namespace swirl::apps
