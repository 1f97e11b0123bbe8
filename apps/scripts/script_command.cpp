#include "apps/scripts/script_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/record/output_file.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/scripts/python_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace swirl::apps::scripts {

void ScriptFiles::add_to(Flags& command, const ScriptOutput& kind, bool several) {
    command
        .add_option("record", records, "RECORD.h5",
                    several ? "records of other commands" : "a record of another command")
        ->expected(several ? -1 : 1)
        ->required();
    command
        .add_option("-o,--output", output,
                    fmt::format("the {} to write: {}", kind.noun, fmt::join(kind.suffixes, ", ")))
        ->type_name("FILE")
        ->required();
    command.add_flag("--force", force, fmt::format("replace an existing file that {} did not make", kind.command));
    command.add_flag("--json", json, fmt::format("one JSON document on standard output: {}, kind, record", kind.noun));
    command.add_flag("--quiet", quiet, "no messages");
}

namespace {

void check_record(const std::string& path) {
    try {
        const RecordReader record(path);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

/// A file says of itself what made it, wherever its format keeps that.
bool has_mark(const std::filesystem::path& output, const std::string& mark) {
    std::ifstream file(output, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(file), {}};
    return content.find(mark) != std::string::npos;
}

/// A path that no parser takes for a flag.
std::string as_word(const std::string& path) {
    return path.starts_with('-') ? "./" + path : path;
}

}  // namespace

void check_output(const ScriptOutput& kind, const ScriptFiles& files) {
    const std::filesystem::path output(files.output);
    if (std::find(kind.suffixes.begin(), kind.suffixes.end(), output.extension().string()) == kind.suffixes.end())
        throw BadInput(
            fmt::format("{} '{}': its suffix is none of {}", kind.noun, files.output, fmt::join(kind.suffixes, ", ")));
    if (const auto obstacle = obstacle_to_creating(output))
        throw BadInput(fmt::format("cannot create {} '{}': {}", kind.noun, files.output, *obstacle));
    std::error_code missing;
    for (const auto& record : files.records)
        if (std::filesystem::equivalent(output, record, missing))
            throw BadInput(fmt::format("{} '{}' is the record itself", kind.noun, files.output));
    require_no_input(files.output, files.records);
    if (!files.force && std::filesystem::is_regular_file(output, missing) && !has_mark(output, kind.mark))
        throw BadInput(
            fmt::format("{0} '{1}' exists and was not made by {2}: name another file, or replace it with "
                        "--force",
                        kind.noun, files.output, kind.command));
}

void add_argument(std::vector<std::string>& arguments, const char* name, const std::string& value) {
    if (!value.empty()) arguments.push_back(fmt::format("--{}={}", name, value));
}

int run_script(const ScriptOutput& kind, const ScriptFiles& files, const std::vector<std::string>& own) {
    for (const auto& record : files.records) check_record(record);
    check_output(kind, files);
    std::vector<std::string> arguments;
    bool all_whole = true;
    for (const auto& record : files.records) {
        warn_without_checksum(record, files.quiet);
        all_whole = all_whole && has_checksum(record);
        arguments.push_back(as_word(record));
    }
    arguments.push_back("--output=" + files.output);
    if (files.json) arguments.emplace_back("--json");
    if (files.quiet) arguments.emplace_back("--quiet");
    arguments.insert(arguments.end(), own.begin(), own.end());
    const auto script = find_script(kind.script);
    if (!all_whole) return run_python(script, arguments, kind.seconds);
    become_python(script, arguments);
}

}  // namespace swirl::apps::scripts
