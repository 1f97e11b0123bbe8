// The flags of a command. CLI11 reads them; it stands behind one file, since what its headers generate takes nine
// seconds of each file's compile time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {

class App;
class Option;

}  // namespace CLI

namespace swirl::apps {

/// What a flag's text must be. `check` gives what is wrong with a text, or nothing; it may rewrite the text.
struct TextCheck {
    std::function<std::string(std::string&)> check;
    std::string description;
};

/// One flag. Each setting returns the flag, so that they follow one another with ->.
class Flag {
public:
    explicit Flag(CLI::Option* option) : option_(option) {}

    Flag* operator->() { return this; }
    const Flag* operator->() const { return this; }

    /// What stands for its value under --help.
    Flag& type_name(const std::string& name);
    /// The heading under which --help lists it.
    Flag& group(const std::string& name);
    Flag& check(const TextCheck& check);
    /// A check that rewrites the text.
    Flag& transform(const TextCheck& check);
    /// The command is refused without it.
    Flag& required();
    /// It takes so many values.
    Flag& expected(int values);
    /// False: each value has the flag's name before it.
    Flag& allow_extra_args(bool allowed);
    /// Words that a value may be or begin with ("alpha="), for the completion of a shell; they refuse nothing.
    Flag& offer(const std::vector<std::string>& words);

    /// The whole number or real number that was given, if any.
    std::optional<std::int64_t> number() const;
    std::optional<double> real() const;

private:
    CLI::Option* option_;
};

/// The flags of one command, to which its options add theirs.
class Flags {
public:
    explicit Flags(CLI::App& command) : command_(command) {}

    std::string command_name() const;
    /// What the command is a subcommand of.
    CLI::App& program() const;
    /// `name` as CLI11 has it: "-o,--output", "RECORD,--record" for a positional. `target` keeps its value unless the
    /// flag is given; it may be a string, an int, a 64-bit integer, a double, an optional of these, or a list of
    /// strings.
    template <class Target>
    Flag add_option(const std::string& name, Target& target, const std::string& help);
    /// `type` stands for its value under --help.
    template <class Target>
    Flag add_option(const std::string& name, Target& target, const std::string& type, const std::string& help) {
        return add_option(name, target, help).type_name(type);
    }
    Flag add_flag(const std::string& name, bool& target, const std::string& help);
    /// Calls `take` with the text.
    Flag add_text(const std::string& name, std::function<void(const std::string&)> take, const std::string& help);
    /// These flags, where --help lists each that is added from here on under a heading.
    Flags under(const std::string& heading) const;
    /// One that was added before.
    Flag get_option(const std::string& name) const;

private:
    Flag added(CLI::Option* option) const;

    CLI::App& command_;
    std::string heading_;  // empty: that of CLI11
};

}  // namespace swirl::apps
