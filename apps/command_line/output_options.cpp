#include "apps/command_line/output_options.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"

#include <fmt/format.h>

namespace swirl::apps {

Flag add_file(Flags& command, const std::string& flag, std::string& file, const std::string& type,
              const std::string& help) {
    return command.add_option(flag, file, type, help)
        ->check(TextCheck{
            [](const std::string& name) { return std::string(name.empty() ? "a file's name is wanted" : ""); }, ""});
}

void OutputOptions::add_to(Flags& app, bool with_record) {
    command = app.command_name();
    Flags output = app.under("Output");
    output.add_flag("--json", json, "one JSON document on standard output, and nothing else");
    if (with_record) {
        add_file(output, "-o,--output", record, "FILE.h5", "write a record (HDF5)");
        output.add_flag("--force", force, "replace an existing file that is not a record of this command");
    }
    output.add_flag("--quiet", quiet, "no progress, no messages and no table");
    add_whole_number(output, "--threads", threads, "T", 0, 4096, "threads (default all); results do not depend on it");
    output.add_option("--accuracy", accuracy_name, "NAME", accuracy_help())->offer(accuracy_names());
}

void OutputOptions::require_double(const std::string& why) const {
    if (accuracy() != Accuracy::double_precision) throw BadInput(fmt::format("accuracy = {}: {}", accuracy_name, why));
}

}  // namespace swirl::apps
