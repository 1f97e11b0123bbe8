#include "apps/inspect/inspect_command.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/inspect/inspection.hpp"
#include "apps/output/wrapped.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace swirl::apps::inspect {

const char* const inspect_details =
    R"(Reads a text file as `classify`, `recurrence` and `spectrum` read it with --series, and says what it is taken for: its
columns and the time among them, its gaps, the bodies in it, the points whose x and y it has, what would be analysed,
and the command that does it. Flags given here are heeded, and go into the command.

Read as they come are tables of spreadsheets and of Tracker (OSP), TrackMate, DeepLabCut, SLEAP, TRex, OCTRON,
idtracker.ai, AnimalTA, ToxTrac, trackpy, Bonsai (times of the clock), ImageJ, and .trc; with preambles, rows of units,
`sep=;`, decimal commas, R's row names. Nothing is guessed silently: each decision is a note. Not read is what is no
text (HDF5, npz, xls).

Example:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --camera 5 --time 200 -o dish.csv
  swirl inspect dish.csv)";

void InspectOptions::add_to(Flags& command) {
    series.add_to(command, false, "FILE,--series");
    command.get_option("--series")->required();
    command.add_option("--angle", angle, "NAME", "a column of angles, whose rate over --swirl-rate is S")
        ->group("Input");
    command
        .add_option("--swirl-rate", swirl_rate, "W",
                    "omega_s: radians per unit of time, or as 33rpm, 0.5Hz; < 0: clockwise")
        ->group("Input");
    command.add_flag("--json", json, "one JSON document on standard output, and nothing else")->group("Output");
    command.add_flag("--quiet", quiet, "no messages and no table")->group("Output");
}

namespace {

std::string separator_in_words(char separator) {
    switch (separator) {
        case '\t':
            return "tab";
        case ';':
            return "semicolon";
        case ',':
            return "comma";
        default:
            return "blank";
    }
}

void write_document(const Inspection& found, const InspectOptions& options) {
    print_document([&](JsonWriter& json) {
        const TableLayout& layout = found.file->layout;
        const auto text_or_null = [&](const char* key, const std::string& text) {
            json.key(key);
            if (text.empty())
                json.null();
            else
                json.value(std::string_view(text));
        };
        const auto number = [&](const char* key, const auto& member) {
            json.key(key);
            if (found.series)
                json.value(member(*found.series));
            else
                json.null();
        };
        text_or_null("time", found.time);
        json.list("columns", found.columns);
        json.list("units", layout.units);
        json.member("separator", std::string_view(separator_in_words(layout.separator)));
        json.member("decimal_comma", layout.decimal == ',');
        json.member("rows", found.file->rows.size());
        number("samples", [](const MeasuredSeries& s) { return s.values.size(); });
        number("missing", [](const MeasuredSeries& s) { return s.missing; });
        number("gaps", [](const MeasuredSeries& s) { return s.gaps; });
        number("even", [](const MeasuredSeries& s) { return s.even; });
        number("spacing", [](const MeasuredSeries& s) { return s.spacing; });
        text_or_null("body_column", found.bodies.column ? column_name(*found.file, *found.bodies.column) : "");
        json.list("bodies", found.bodies.ids);
        json.key("points");
        json.begin_array(JsonLayout::rows);
        for (const PointColumns& point : found.points) {
            json.begin_object();
            json.member("name", std::string_view(point.name));
            json.member("x", std::string_view(found.columns[point.x]));
            json.member("y", std::string_view(found.columns[point.y]));
            json.end_object();
        }
        json.end_array();
        text_or_null("column", found.series ? found.series->column : "");
        text_or_null("quantity", found.series ? found.series->quantity : "");
        text_or_null("command", found.command);
        text_or_null("problem", found.problem);
        json.list("notes", found.notes, JsonLayout::rows);
        write_json(json, "settings", Settings{{"flags", options.series.flags()}});
    });
}

void print_inspection(const Inspection& found) {
    const TableLayout& layout = found.file->layout;
    const auto line = [](const std::string& text) { fmt::print("{}\n", wrapped(printable(text), 12)); };
    line(fmt::format("file        {}: {} rows of {} column{}, separated by {}s{}", found.file->name,
                     found.file->rows.size(), found.file->columns, found.file->columns == 1 ? "" : "s",
                     separator_in_words(layout.separator), layout.decimal == ',' ? ", with decimal commas" : ""));
    line(fmt::format("columns     {}", fmt::join(found.columns, ", ")));
    line(fmt::format("time        {}", found.time.empty() ? "none: rows are counted"
                                                          : found.time + (found.in_frames ? ", in frames" : "")));
    if (found.bodies.column)
        line(fmt::format("bodies      {}, by column {}: {}", found.bodies.ids.size(),
                         column_name(*found.file, *found.bodies.column), listed(found.bodies.ids)));
    for (const PointColumns& point : found.points)
        line(fmt::format("point       {} {}", found.columns[point.x], found.columns[point.y]));
    if (found.series)
        line(fmt::format("analysed    {}", series_in_words(*found.series)));
    else
        line(fmt::format("problem     {}", found.problem));
    for (const std::string& note : found.notes) line(fmt::format("note        {}", note));
    fmt::print("command     {}\n", printable(found.command));
}

}  // namespace

int inspect(InspectOptions& options) {
    options.series.angle = options.angle;
    const Inspection found = inspection_of(options.series, options.swirl_rate);
    if (options.json)
        write_document(found, options);
    else if (!options.quiet)
        print_inspection(found);
    return exit_done;
}

}  // namespace swirl::apps::inspect
