// Records that are read, and where one goes: never into what is read, and in place of a file only if that is a record
// of the same command.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/output/units.hpp"
#include "apps/record/record_writer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

// Records that are read.

/// A word of warning, once it was read, of a record that no checksum speaks for: it was edited or packed anew, or comes
/// from another program, and damage to its numbers would not be seen. Nothing of what is no record at all.
void warn_without_checksum(const std::string& record, bool quiet);

// Where a record goes: never into what is read, and in place of a file only if that is a record of the same command.

/// Refuses an output that leads to one of the files that are read: the same name, a link or a hard link to it; so, too,
/// the files beside it that are written meanwhile. Of the inputs empty ones are none, and "-" is standard input.
/// @throws BadInput naming both
void require_no_input(const std::string& output, const std::vector<std::string>& inputs);

/// Refuses an existing file that is not a record of the command, unless --force is given. @throws BadInput
void require_replaceable(const OutputOptions& output);

/// The ending of a file's name with its dot, in small letters: ".csv" of A.CSV.
std::string suffix_of(const std::string& file);

/// Refuses the name of a figure, film or notebook, which other commands make of the record. @throws BadInput
void require_record_name(const OutputOptions& output);

/// All of these, before any work.
void require_output(const OutputOptions& output, const std::vector<std::string>& inputs);

/// Refuses an output that can't be created, for work that writes it at its end. @throws BadInput
void require_creatable(const OutputOptions& output);

/// The record of -o, opened before any work; none without -o.
///   inputs  all files that the command reads
///   units   of a scene in physical units: the record gets a group `units`, and its columns the attribute
///   physical_scale
/// @throws BadInput if it can't be created, is an input, or would replace what it must not
std::optional<RecordWriter> open_record(const OutputOptions& output, const std::string& title,
                                        const std::vector<std::string>& inputs, const std::optional<Units>& units = {});

/// The record of -o, created after the work where it takes only what is finished. @throws RecordError if it can't be
/// created
RecordWriter create_record(const OutputOptions& output, const std::string& title,
                           const std::optional<Units>& units = {});

}  // namespace swirl::apps
