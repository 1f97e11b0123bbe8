// `swirl show`: what a record holds, as a table, as JSON or as CSV.
#pragma once

#include "apps/command_line/flags.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/show/record_tables.hpp"

#include <cstdint>
#include <string>

namespace swirl::apps::show {

struct ShowOptions {
    std::string record;
    std::string csv;    ///< where a table goes
    std::string group;  ///< the table's
    std::int64_t rows = 20;
    bool json = false, quiet = false, force = false;

    void add_to(Flags& command);
};

extern const char* const show_details;

/// The record for people: all groups, or that which is asked for.
std::string text_of(const RecordReader& record, const ShowOptions& options);
/// As a document.
void print_record(const RecordReader& record, const ShowOptions& options);
/// One table into a file that is written whole or not at all.
void write_csv(const RecordReader& record, const ShownTable& table, const std::string& file);

int show(ShowOptions& options);

}  // namespace swirl::apps::show
