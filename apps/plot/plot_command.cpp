#include "apps/plot/plot_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/record_input.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/plot/figure_script.hpp"
#include "apps/record/posix_file.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

namespace swirl::apps::plot {

const char* const plot_details =
    R"(The figure follows from what the record holds:
  simulate            orbit (the default: the next two in one), spin (S(t) with its running time mean), path (of the
                      centre, in the laboratory, in the container, and co-rotating with the swirl; on the wall too, with
                      simulate --sample)
  sweep               modes: bands, a map or panels, by the number of parameters
  bifurcate, continue bifurcation: samples, branches and the points where they change
  orbits              multipliers: in the complex plane, with the mean spin of each orbit
It is drawn by the Python package swirl_figures, which notebooks can use as well. The environment's SWIRL_FIGURES names
another folder that holds plot_record.py, SWIRL_PYTHON another interpreter than /usr/bin/python3.

Example:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 200 -o orbit.h5
  swirl plot orbit.h5 -o orbit.png)";

void PlotOptions::add_to(Flags& command) {
    command.add_option("record", record, "a record of another command")->type_name("RECORD.h5")->required();
    command.add_option("-o,--output", figure, "the figure to write: .png, .svg or .pdf")
        ->type_name("FIGURE")
        ->required();
    command.add_option("--kind", kind, "which figure, where there are several")->type_name("NAME");
    command.add_flag("--force", force, "replace an existing file that swirl plot did not draw");
    command.add_flag("--json", json, "one JSON document on standard output: figure, kind, record");
    command.add_flag("--quiet", quiet, "no messages");
}

namespace {

constexpr std::array<const char*, 3> suffixes = {".png", ".svg", ".pdf"};

void check_record(const std::string& path) {
    try {
        const RecordReader record(path);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

/// A figure says of itself what drew it (notebooks-export/swirl_figures/output.py), wherever its format keeps that.
bool is_drawn_by_plot(const std::filesystem::path& figure) {
    constexpr std::string_view mark = "drawn by swirl plot";
    std::ifstream file(figure, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(file), {}};
    return content.find(mark) != std::string::npos;
}

void check_figure(const PlotOptions& options) {
    const std::filesystem::path figure(options.figure);
    if (std::find(suffixes.begin(), suffixes.end(), figure.extension().string()) == suffixes.end())
        throw BadInput(fmt::format("figure '{}': its suffix is none of .png, .svg, .pdf", options.figure));
    if (const auto obstacle = obstacle_to_creating(figure))
        throw BadInput(fmt::format("cannot create figure '{}': {}", options.figure, *obstacle));
    std::error_code missing;
    if (std::filesystem::equivalent(figure, options.record, missing))
        throw BadInput(fmt::format("figure '{}' is the record itself", options.figure));
    require_no_input(options.figure, {options.record});
    if (!options.force && std::filesystem::is_regular_file(figure, missing) && !is_drawn_by_plot(figure))
        throw BadInput(
            fmt::format("figure '{}' exists and was not drawn by swirl plot: name another file, or replace it with "
                        "--force",
                        options.figure));
}

/// A path that no parser takes for a flag.
std::string as_word(const std::string& path) {
    return path.starts_with('-') ? "./" + path : path;
}

}  // namespace

int plot(PlotOptions& options) {
    check_record(options.record);
    check_figure(options);
    warn_without_checksum(options.record, options.quiet);
    std::vector<std::string> arguments = {as_word(options.record), "--output=" + options.figure};
    if (!options.kind.empty()) arguments.push_back("--kind=" + options.kind);
    if (options.json) arguments.emplace_back("--json");
    if (options.quiet) arguments.emplace_back("--quiet");
    if (!has_checksum(options.record)) return run_python(figure_script(), arguments);
    become_python(figure_script(), arguments);
}

}  // namespace swirl::apps::plot
