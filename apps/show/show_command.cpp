#include "apps/show/show_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace swirl::apps::show {

const char* const show_details =
    R"(Prints what a record holds: what made it, its scene, its settings, and the first --rows rows of each table, numbered from 1.
`swirl continue RECORD --orbit I` and `swirl certify RECORD --orbit I` take these numbers. A list in a row has a column for
each of its values: points_psi, points_2_S (of the second impact of a cycle). Numbers are as the record has them, where
R_c = omega_s = m = 1.

--json prints all rows. A group is a list of objects, one a row, under its name; a group that also has values of its own is
an object of these, with the rows under the name of what they run over (evidence of mode).

--csv FILE writes all rows of one table (--group NAME, where a record has several). Lines that begin with # say what made it
and name each column's units and meaning. Then come the names of the columns and a line a row, numbers as the shortest
decimals that read back to the same double, nan where there is no value.

Examples:
  swirl orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --period 1 -o fixed.h5
  swirl show fixed.h5
  swirl show fixed.h5 --group orbits --csv fixed.csv)";

void ShowOptions::add_to(Flags& command) {
    add_file(command, "record", record, "RECORD.h5", "a record of another command")->required();
    add_file(command, "--csv", csv, "FILE", "write a table to this file")->group("Output");
    command.add_option("--group", group, "NAME", "the table, or the group, that is shown");
    add_whole_number(command, "--rows", rows, "K", 1, 1'000'000'000,
                     "rows of each table that are printed (default 20)");
    command.add_flag("--json", json, "one JSON document on standard output, and nothing else")->group("Output");
    command.add_flag("--force", force, "replace an existing file")->group("Output");
    command.add_flag("--quiet", quiet, "no messages and no table")->group("Output");
}

namespace {

std::string names_of(const std::vector<ShownTable>& tables) {
    std::vector<std::string> names;
    for (const ShownTable& table : tables) names.push_back(table.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

ShownTable table_asked_for(const RecordReader& record, const ShowOptions& options) {
    const std::vector<ShownTable> tables = tables_of(record);
    if (tables.empty()) throw BadInput(fmt::format("record '{}' holds no table: no group has rows", options.record));
    if (options.group.empty() && tables.size() > 1)
        throw BadInput(fmt::format("record '{}' holds {} tables: choose one by --group, {}", options.record,
                                   tables.size(), names_of(tables)));
    if (options.group.empty()) return tables.front();
    for (const ShownTable& table : tables)
        if (table.name == options.group) return table;
    throw BadInput(fmt::format("group = {}: record '{}' holds no such table; it holds {}", options.group,
                               options.record, names_of(tables)));
}

/// Before the record is read through, so that a bad name costs nothing.
void require_writable(const ShowOptions& options) {
    require_no_input(options.csv, {options.record});
    std::error_code ignored;
    if (!options.force && std::filesystem::exists(options.csv, ignored))
        throw BadInput(fmt::format("csv '{}' exists: name another file, or replace it with --force", options.csv));
}

void show_record(const RecordReader& record, const ShowOptions& options) {
    if (!options.csv.empty()) {
        const ShownTable table = table_asked_for(record, options);
        write_csv(record, table, options.csv);
        if (!options.quiet)
            report(fmt::format("swirl: {} row{} of {} in '{}'", table.rows(), table.rows() == 1 ? "" : "s", table.name,
                               options.csv));
    } else if (options.json) {
        print_record(record, options);
    } else if (!options.quiet) {
        fmt::print("{}", text_of(record, options));
    }
}

}  // namespace

int show(ShowOptions& options) {
    if (!options.csv.empty() && options.json) throw BadInput("--csv and --json are both given; give one");
    if (options.force && options.csv.empty()) throw BadInput("--force goes with --csv");
    if (!options.csv.empty()) require_writable(options);
    exit_when_interrupted();
    try {
        const RecordReader record(options.record);
        warn_without_checksum(options.record, options.quiet);
        show_record(record, options);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
    return exit_done;
}

}  // namespace swirl::apps::show
