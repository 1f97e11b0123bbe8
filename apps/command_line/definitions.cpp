#include "apps/command_line/definitions.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstring>

namespace swirl::apps {

namespace {

/// "whole number, 1 to 256" of whole_number(...), "0 or more" of finite_number_from(...) (numbers.hpp).
std::string in_words(const std::string& range) {
    const auto replaced = [&](const std::string& before, const std::string& between, const std::string& after) {
        std::string text = range.substr(before.size());
        if (!after.empty()) text.resize(text.size() - after.size());
        const auto at = text.find(between);
        if (!between.empty() && at != std::string::npos) text.replace(at, between.size(), " to ");
        return text;
    };
    if (range.starts_with("INT in [")) return fmt::format("whole number, {}", replaced("INT in [", " - ", "]"));
    if (range.starts_with("FLOAT >= ")) return fmt::format("{} or more", replaced("FLOAT >= ", "", ""));
    return range;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    for (auto end = text.find('\n'); end != std::string::npos; begin = end + 1, end = text.find('\n', begin))
        lines.push_back(text.substr(begin, end - begin));
    return lines;
}

/// The value's name stands before its checks' descriptions, each after a colon.
void read_checks(CLI::Option& option, OptionDefinition& definition) {
    definition.value = option.get_type_name();
    std::string described;
    const auto checks = [&option](int index) -> CLI::Validator* {
        try {
            return option.get_validator(index);
        } catch (const CLI::OptionNotFound&) {
            return nullptr;
        }
    };
    for (int i = 0; const CLI::Validator* check = checks(i); ++i) {
        const std::string name = check->get_name();
        if (name.starts_with(offered_words_prefix))
            definition.words = lines_of(name.substr(std::strlen(offered_words_prefix)));
        if (check->get_description().empty()) continue;
        described += ":" + check->get_description();
        definition.range = in_words(check->get_description());
    }
    definition.value.resize(definition.value.size() - described.size());
}

OptionDefinition definition_of(CLI::Option& option) {
    OptionDefinition definition;
    for (const auto& name : option.get_snames()) definition.flags.push_back("-" + name);
    for (const auto& name : option.get_lnames()) definition.flags.push_back("--" + name);
    if (option.get_positional()) definition.place = option.get_name(true);
    definition.several = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    definition.values = definition.several ? 1 : option.get_items_expected_min();
    if (definition.values > 0) read_checks(option, definition);
    definition.help = option.get_description();
    definition.group = option.get_group();
    definition.required = option.get_required();
    return definition;
}

/// CLI11 shows the checks of an option only where it may be changed.
std::vector<OptionDefinition> options_of(CLI::App& command) {
    std::vector<OptionDefinition> options;
    for (CLI::Option* option : command.get_options())
        if (!option->get_group().empty()) options.push_back(definition_of(*option));
    return options;
}

}  // namespace

const CommandDefinition* ProgramDefinition::command(const std::string& named) const {
    const auto found = std::find_if(commands.begin(), commands.end(), [&](const auto& c) { return c.name == named; });
    return found == commands.end() ? nullptr : &*found;
}

ProgramDefinition definition_of(CLI::App& program) {
    ProgramDefinition definition{"swirl", program.get_description(), program.get_footer(), options_of(program), {}};
    for (CLI::App* command : program.get_subcommands({}))
        definition.commands.push_back(
            {command->get_name(), command->get_description(), command->get_footer(), options_of(*command)});
    return definition;
}

std::optional<std::string> suffix_of(const OptionDefinition& option) {
    const auto dot = option.value.find('.');
    if (dot == std::string::npos && option.value != "FILE") return std::nullopt;
    return option.value.substr(std::min(dot, option.value.size()));
}

}  // namespace swirl::apps
