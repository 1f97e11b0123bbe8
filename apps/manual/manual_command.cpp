#include "apps/manual/manual_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/manual/pages.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

namespace swirl::apps::manual {

const char* const manual_details =
    R"(Prints the page of a command, or of swirl itself, as man reads it: `swirl manual classify | man -l -`. With -o it
writes all pages into a folder, which is made if there is none: swirl.1, swirl-classify.1, ... or .md. A file that is there
is replaced only if it is such a page. The pages are made of what --help says, and are installed as man pages.

Examples:
  swirl manual classify
  swirl manual --format markdown -o pages)";

void ManualOptions::add_to(Flags& command) {
    program = &command.program();
    command.add_option("COMMAND", page, "COMMAND", "whose page is printed (default: that of swirl)");
    command.add_option("--format", form, "NAME", "man (default) or markdown")->offer({"man", "markdown"});
    command.add_option("-o,--output", folder, "FOLDER", "write all pages into this folder");
}

namespace {

using Page = std::pair<std::filesystem::path, std::string>;

PageForm form_from(const std::string& name) {
    if (name == "man") return PageForm::man;
    if (name == "markdown") return PageForm::markdown;
    throw BadInput(fmt::format("format = '{}' is none of: man, markdown", name));
}

bool begins_with(const std::filesystem::path& path, const std::string& mark) {
    std::ifstream file(path, std::ios::binary);
    std::string begin(mark.size(), '\0');
    return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == mark;
}

/// All that can be known before the first page is written. @throws BadInput
void check_folder(const std::string& folder, const std::vector<Page>& pages, PageForm form) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw BadInput(fmt::format("output = '{}': the folder can't be made: {}", folder,
                                   error ? error.message() : std::string("a file of that name exists")));
    for (const auto& [path, text] : pages)
        if (std::filesystem::exists(path) && !begins_with(path, mark_of(form)))
            throw BadInput(
                fmt::format("'{}' exists and was not made by swirl manual: name another folder", path.string()));
}

void write_pages(const std::string& folder, const ProgramDefinition& program, PageForm form) {
    const auto page = [&](const CommandDefinition* command) {
        return Page(std::filesystem::path(folder) / file_name(command, form), page_of(program, command, form));
    };
    std::vector<Page> pages = {page(nullptr)};
    for (const CommandDefinition& command : program.commands) pages.push_back(page(&command));
    check_folder(folder, pages, form);
    for (const auto& [path, text] : pages) {
        std::ofstream file(path, std::ios::binary);
        file << text;
        file.close();
        if (!file) throw RecordError("cannot write page", path.string(), "the disk is full, or may not be written to");
    }
}

}  // namespace

int manual(ManualOptions& options) {
    const PageForm form = form_from(options.form);
    const ProgramDefinition program = definition_of(*options.program);
    if (!options.folder.empty() && !options.page.empty())
        throw BadInput("a command and --output are both given: -o writes the pages of all");
    if (!options.folder.empty()) {
        write_pages(options.folder, program, form);
        return exit_done;
    }
    const CommandDefinition* command = options.page.empty() ? nullptr : program.command(options.page);
    if (command == nullptr && !options.page.empty())
        throw BadInput(fmt::format("there is no command {} (swirl --help lists them)", options.page));
    const std::string text = page_of(program, command, form);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return exit_done;
}

}  // namespace swirl::apps::manual
