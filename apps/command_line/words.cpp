#include "apps/command_line/words.hpp"

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>

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

/// The fewest letters that are put in, left out, changed or swapped with their neighbour to make one of the other
/// (optimal string alignment).
std::size_t letters_apart(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

/// They begin alike, but for the last letters: boundary and boundaries, tolerances and tolerance.
bool have_one_stem(const std::string& a, const std::string& b) {
    const auto stem = static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
    return stem >= 5 && stem + 3 >= std::max(a.size(), b.size());
}

/// Of a misspelt word at most a third of the letters are wrong, and never all; or only its ending is another one.
std::string nearest(const std::string& word, const std::vector<std::string>& names) {
    std::string best;
    std::size_t least = std::min(word.size(), 1 + word.size() / 3);
    for (const std::string& name : names) {
        const bool begins = word.size() >= 3 && name.starts_with(word);
        std::size_t apart = begins ? 0 : letters_apart(word, name);
        if (have_one_stem(word, name)) apart = std::min<std::size_t>(apart, 1);
        if (apart >= least && !(begins && best.empty())) continue;
        least = apart;
        best = name;
    }
    return best;
}

std::string did_you_mean(const std::string& name) {
    return name.empty() ? std::string() : fmt::format("; did you mean {}?", name);
}

/// A number, perhaps negative, is a value.
bool is_number(const std::string& word) {
    char* end = nullptr;
    std::strtod(word.c_str(), &end);
    return end != word.c_str();
}

/// @throws BadInput for what looks like a command and is none
void check_command(const CLI::App& app, const std::vector<std::string>& words) {
    if (words.empty() || words.front().empty() || words.front()[0] == '-') return;
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), words.front()) != names.end()) return;
    throw BadInput(fmt::format("there is no command {}{} (swirl --help lists them)", words.front(),
                               did_you_mean(nearest(words.front(), names))));
}

/// @throws BadInput for what looks like a flag of the command and is none
void check_flag(const CLI::App& command, const std::string& word) {
    if (word.size() < 2 || word[0] != '-' || is_number(word)) return;
    const std::string name = word.substr(0, word.find('='));
    if (name.size() > 2 && name[1] != '-' && command.get_option_no_throw(name.substr(0, 2)) != nullptr)
        return;  // -oFILE
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& long_name : option->get_lnames()) names.push_back("--" + long_name);
    const std::string of = command.get_parent() == nullptr ? "swirl" : "swirl " + command.get_name();
    throw BadInput(
        fmt::format("{} has no flag {}{} ({} --help lists them)", of, name, did_you_mean(nearest(name, names)), of));
}

}  // namespace

void check_words(const CLI::App& app, const std::vector<std::string>& words) {
    check_command(app, words);
    const CLI::App& command = command_of(app, words);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--") return;  // all that follows is no option
        const bool follows = i > 0 && option_of(command, words[i - 1]) != nullptr;
        if (word.empty())
            throw BadInput(follows ? fmt::format("{} = '' is empty; a value is wanted", words[i - 1])
                                   : std::string("an argument is empty: '' names nothing"));
        const CLI::Option* option = option_of(command, word);
        if (option == nullptr) {
            check_flag(command, word);
            continue;
        }
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
