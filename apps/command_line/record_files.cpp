// Records that are read, and where one goes: never into what is read, and in place of a file only if that is a record
// of the same command.
#include "apps/command_line/record_files.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/record/journal.hpp"
#include "apps/record/output_file.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>

namespace swirl::apps {

void warn_without_checksum(const std::string& record, bool quiet) {
    if (quiet || record.empty() || has_checksum(record)) return;
    report(
        fmt::format("swirl: record '{}' has no checksum of what it holds now: damage to it would not be seen", record));
}

namespace {

bool leads_to(const std::filesystem::path& written, const std::string& input) {
    return input == "-" ? is_same_file(written, STDIN_FILENO) : is_same_file(written, input);
}

/// What a file is, where it is not a record of `command`; else nothing.
std::optional<std::string> not_a_record_of(const std::string& command, const std::string& file) {
    try {
        const RecordReader record(file);
        if (!record.has_attribute("/", "command")) return "a record that does not say what wrote it";
        const auto wrote = record.attribute<std::string>("/", "command");
        if (wrote == command) return std::nullopt;
        return fmt::format("a record of {}", wrote);
    } catch (const RecordError&) {
        return "no record";
    }
}

}  // namespace

void require_no_input(const std::string& output, const std::vector<std::string>& inputs) {
    if (output.empty()) return;
    for (const std::string& input : inputs) {
        if (input.empty()) continue;
        for (const auto& written : {std::filesystem::path(output), partial_path_of(output), journal_path(output)})
            if (leads_to(written, input))
                throw BadInput(fmt::format("output '{}' would replace the input {}: name another file", output,
                                           input == "-" ? "on standard input" : fmt::format("'{}'", input)));
    }
}

void require_replaceable(const OutputOptions& output) {
    std::error_code ignored;
    if (output.record.empty() || output.force || !std::filesystem::is_regular_file(output.record, ignored)) return;
    if (const auto other = not_a_record_of(output.command, output.record))
        throw BadInput(fmt::format(
            "output '{}' exists and is {}; {} replaces a record of its own only: name another file, or give "
            "--force",
            output.record, *other, output.command));
}

std::string suffix_of(const std::string& file) {
    std::string suffix = std::filesystem::path(file).extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
    return suffix;
}

void require_record_name(const OutputOptions& output) {
    constexpr std::array<std::array<const char*, 3>, 10> others = {{{".png", "plot", "-o"},
                                                                    {".svg", "plot", "-o"},
                                                                    {".pdf", "plot", "-o"},
                                                                    {".jpg", "plot", "-o"},
                                                                    {".gif", "animate", "-o"},
                                                                    {".mp4", "animate", "-o"},
                                                                    {".webm", "animate", "-o"},
                                                                    {".ipynb", "notebook", "-o"},
                                                                    {".html", "explore", "-o"},
                                                                    {".csv", "show", "--csv"}}};
    const std::string suffix = suffix_of(output.record);
    for (const auto& [other, command, flag] : others)
        if (suffix == other)
            throw BadInput(
                fmt::format("output '{0}': -o writes a record (HDF5): give -o FILE.h5, then swirl {1} FILE.h5 "
                            "{2} {0}",
                            output.record, command, flag));
}

void require_output(const OutputOptions& output, const std::vector<std::string>& inputs) {
    require_no_input(output.record, inputs);
    require_record_name(output);
    require_replaceable(output);
}

void require_creatable(const OutputOptions& output) {
    if (output.record.empty()) return;
    require_record_name(output);
    if (const auto obstacle = obstacle_to_creating(output.record))
        throw BadInput(fmt::format("cannot create record '{}': {}", output.record, *obstacle));
}

std::optional<RecordWriter> open_record(const OutputOptions& output, const std::string& title,
                                        const std::vector<std::string>& inputs, const std::optional<Units>& units) {
    if (output.record.empty()) return std::nullopt;
    require_output(output, inputs);
    try {
        return create_record(output, title, units);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

RecordWriter create_record(const OutputOptions& output, const std::string& title, const std::optional<Units>& units) {
    RecordWriter record(output.record, {title, version(), instruction_set(), output.command});
    if (units) {
        write_attributes(record.root().group("units"), unit_settings(*units));
        record.scale_units([units = *units](const std::string& unit) { return physical_scale(units, unit); });
    }
    return record;
}

}  // namespace swirl::apps
