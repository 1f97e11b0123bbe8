#include "apps/command_line/words.hpp"

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace swirl::apps {

namespace {

/// The option that a word names, "--name" or "--name=value" or "-n"; null where it names none.
const CLI::Option* option_of(const CLI::App& command, const std::string& word) {
    if (word.size() < 2 || word[0] != '-') return nullptr;
    return command.get_option_no_throw(word.substr(0, word.find('=')));
}

/// The command that is called; the program itself where none is.
const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& words) {
    if (!words.empty())
        for (const CLI::App* command : app.get_subcommands({}))
            if (command->get_name() == words.front()) return *command;
    return app;
}

}  // namespace

void check_words(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App& command = command_of(app, words);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--") return;  // all that follows is no option
        const bool follows = i > 0 && option_of(command, words[i - 1]) != nullptr;
        if (word.empty())
            throw BadInput(follows ? fmt::format("{} = '' is empty; a value is wanted", words[i - 1])
                                   : std::string("an argument is empty: '' names nothing"));
        const CLI::Option* option = option_of(command, word);
        if (option == nullptr) continue;
        const auto equals = word.find('=');
        if (equals != std::string::npos && equals + 1 == word.size())
            throw BadInput(fmt::format("{} is without a value; {}VALUE is wanted", word, word));
        const bool wants_next = equals == std::string::npos && option->get_items_expected_min() > 0;
        if (!wants_next || i + 1 == words.size()) continue;
        if (option_of(command, words[i + 1]) != nullptr)
            throw BadInput(fmt::format("{} is without a value: {} after it is an option", word, words[i + 1]));
        if (!words[i + 1].empty()) ++i;
    }
}

}  // namespace swirl::apps
