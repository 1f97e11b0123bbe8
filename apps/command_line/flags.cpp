#include "apps/command_line/flags.hpp"

#include "apps/command_line/definitions.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace swirl::apps {

Flag& Flag::type_name(const std::string& name) {
    option_->type_name(name);
    return *this;
}

Flag& Flag::group(const std::string& name) {
    option_->group(name);
    return *this;
}

Flag& Flag::check(const TextCheck& check) {
    option_->check(CLI::Validator(check.check, check.description));
    return *this;
}

Flag& Flag::transform(const TextCheck& check) {
    option_->transform(CLI::Validator(check.check, check.description));
    return *this;
}

Flag& Flag::required() {
    option_->required();
    return *this;
}

Flag& Flag::expected(int values) {
    option_->expected(values);
    return *this;
}

Flag& Flag::allow_extra_args(bool allowed) {
    option_->allow_extra_args(allowed);
    return *this;
}

Flag& Flag::offer(const std::vector<std::string>& words) {
    // CLI11 keeps nothing else with an option that --help does not show.
    std::string name = offered_words_prefix;
    for (const std::string& word : words) name += word + '\n';
    CLI::Validator none([](std::string&) { return std::string(); }, "");
    option_->check(none.name(name));
    return *this;
}

std::optional<std::int64_t> Flag::number() const {
    return option_->count() > 0 ? std::optional(option_->as<std::int64_t>()) : std::nullopt;
}

std::optional<double> Flag::real() const {
    return option_->count() > 0 ? std::optional(option_->as<double>()) : std::nullopt;
}

std::string Flags::command_name() const {
    return command_.get_name();
}

CLI::App& Flags::program() const {
    return *command_.get_parent();
}

template <class Target>
Flag Flags::add_option(const std::string& name, Target& target, const std::string& help) {
    return added(command_.add_option(name, target, help));
}

template Flag Flags::add_option(const std::string&, std::string&, const std::string&);
template Flag Flags::add_option(const std::string&, int&, const std::string&);
template Flag Flags::add_option(const std::string&, std::int64_t&, const std::string&);
template Flag Flags::add_option(const std::string&, std::uint64_t&, const std::string&);
template Flag Flags::add_option(const std::string&, double&, const std::string&);
template Flag Flags::add_option(const std::string&, std::optional<std::string>&, const std::string&);
template Flag Flags::add_option(const std::string&, std::optional<int>&, const std::string&);
template Flag Flags::add_option(const std::string&, std::optional<std::int64_t>&, const std::string&);
template Flag Flags::add_option(const std::string&, std::optional<double>&, const std::string&);
template Flag Flags::add_option(const std::string&, std::vector<std::string>&, const std::string&);

Flag Flags::add_flag(const std::string& name, bool& target, const std::string& help) {
    return added(command_.add_flag(name, target, help));
}

Flag Flags::add_text(const std::string& name, std::function<void(const std::string&)> take, const std::string& help) {
    return added(command_.add_option_function<std::string>(name, std::move(take), help));
}

Flags Flags::under(const std::string& heading) const {
    Flags flags = *this;
    flags.heading_ = heading;
    return flags;
}

Flag Flags::added(CLI::Option* option) const {
    Flag flag(option);
    if (!heading_.empty()) flag.group(heading_);
    return flag;
}

Flag Flags::get_option(const std::string& name) const {
    return Flag(command_.get_option(name));
}

}  // namespace swirl::apps
