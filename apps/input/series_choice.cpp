#include "apps/input/series_choice.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace swirl::apps {

namespace {

void require_holdable(const char* name, double value) {
    if (!(value > 0 && detail::is_holdable(value)))
        throw BadInput(fmt::format("{} = {} is outside its range: {:g} to {:g}", name, value,
                                   detail::smallest_magnitude, detail::largest_magnitude));
}

}  // namespace

std::string in_one_word(const std::string& text) {
    const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c < 0 ||
               std::string_view("._-=/+:").find(c) != std::string_view::npos;
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

void SeriesChoice::add_to(Flags& command, bool with_spacing, const std::string& file_flag) {
    Flags input = command.under("Input");
    const auto columns = [&](const char* name, std::vector<std::string>& target, const char* type, int count,
                             const char* help) { input.add_option(name, target, type, help).expected(count); };
    input.add_option(file_flag, file, "FILE.csv", "a measured series, text; - reads standard input");
    input.add_option("--column", column, "NAME", "the series' values: name or number of the column");
    input.add_option("--time", time, "NAME", "the series' times: name or number of the column, or none");
    if (with_spacing)
        input.add_option("--spacing", spacing, "DT",
                         "time between samples where there is no column of times (default 1)");
    input.add_option("--fps", fps, "F", "frames a second: times are the column of frames, or the row's number, over F");
    input.add_flag("--degrees", degrees, "of --angle COLUMN, whose rate over --swirl-rate is S: it is in degrees");
    add_whole_number(input, "--symmetry", symmetry, "N", 1, 1'000'000,
                     "of an angle: it is known modulo 1/N of a turn (default 1)");
    columns("--marks", marks, "X1 Y1 X2 Y2", 4, "in place of --angle: four columns, two points of the body");
    columns("--mark", mark, "X Y", 2, "in place of --angle: two columns, a point that turns about the origin");
    columns("--position", position, "X Y", 2,
            "in place of --column: two columns, of which the distance from the origin is analysed: the swirl's "
            "centre in the laboratory, or the container's in its own frame");
    columns("--origin", origin, "X Y", 2, "of --position and --mark, in the units of the columns (default 0 0)");
    input.add_flag("--fit-origin", fits_origin, "it is the centre of the circle fitted to the points");
    input.add_option("--scale", scale, "F", "what lengths, or the values of --column, are multiplied by (default 1)");
    input.add_flag("--y-down", y_down, "y points down, as in images: turns are seen the other way round, -S");
    input.add_option("--likelihood", likelihood, "P", "a point of less than this (its tracker's column) is a gap");
    input
        .add_option("--where", where, "COLUMN=VALUE",
                    "only the rows in which a column has a value: one body of several")
        ->allow_extra_args(false);
    input.add_option("--each", each, "COLUMN", "each value of this column is a body: one answer for each");
    add_whole_number(input, "--header-line", header_line, "N", 1, 1'000'000'000,
                     "the line of the file that has the columns' names");
    input.add_flag("--decimal-comma", decimal_comma, "1,5 is one and a half");
    input
        .add_option("--rows", rows, "NAME",
                    "of a series: impacts, or samples in time (default: samples if times are even)")
        ->offer({"impacts", "samples"});
}

bool SeriesChoice::given() const {
    return !flags().empty();
}

std::string SeriesChoice::flags() const {
    std::string all;
    const auto add = [&](const char* flag, const std::string& value) {
        if (!value.empty()) all += fmt::format(" {} {}", flag, in_one_word(value));
    };
    const auto add_list = [&](const char* flag, const std::vector<std::string>& values) {
        if (values.empty()) return;
        all += fmt::format(" {}", flag);
        for (const auto& value : values) all += fmt::format(" {}", in_one_word(value));
    };
    const auto add_number = [&](const char* flag, const std::optional<double>& value) {
        if (value) all += fmt::format(" {} {}", flag, *value);
    };
    const auto add_switch = [&](const char* flag, bool on) {
        if (on) all += fmt::format(" {}", flag);
    };
    add("--column", column);
    add("--time", time);
    add_number("--fps", fps);
    add_switch("--degrees", degrees);
    if (symmetry != 1) all += fmt::format(" --symmetry {}", symmetry);
    add_list("--marks", marks);
    add_list("--mark", mark);
    add_list("--position", position);
    add_list("--origin", origin);
    add_switch("--fit-origin", fits_origin);
    if (scale != 1) add_number("--scale", scale);
    add_switch("--y-down", y_down);
    add_number("--likelihood", likelihood);
    for (const auto& condition : where) add("--where", condition);
    add("--each", each);
    if (header_line) all += fmt::format(" --header-line {}", *header_line);
    add_switch("--decimal-comma", decimal_comma);
    return all.empty() ? all : all.substr(1);
}

void SeriesChoice::set_swirl_rate(const std::string& text) {
    static constexpr std::pair<std::string_view, RateUnit> units[] = {
        {"rpm", RateUnit::turns_a_minute}, {"Hz", RateUnit::turns_a_second}, {"rad/s", RateUnit::radians_a_second}};
    std::string number = text;
    rate_unit = RateUnit::radians;
    for (const auto& [name, unit] : units)
        if (number.size() > name.size() && std::string_view(number).substr(number.size() - name.size()) == name) {
            rate_unit = unit;
            number.resize(number.size() - name.size());
            break;
        }
    while (!number.empty() && number.back() == ' ') number.pop_back();
    swirl_rate = number_from<double>("swirl-rate", number);
}

void SeriesChoice::check() const {
    if (!angle.empty() + !marks.empty() + !mark.empty() + !position.empty() + !column.empty() > 1)
        throw BadInput("--column, --angle, --marks, --mark and --position each say what is analysed; give one");
    if (!is_angle() && symmetry != 1) throw BadInput("--symmetry of a series is an angle's; --angle COLUMN is missing");
    if (angle.empty() && degrees) throw BadInput("--degrees of a series is an angle's; --angle COLUMN is missing");
    require_holdable("swirl-rate", std::abs(swirl_rate));
    require_holdable("spacing", spacing);
    require_holdable("scale", scale);
    if (fps) require_holdable("fps", *fps);
    if (fps && spacing != 1) throw BadInput("--fps and --spacing both say how far samples are apart; give one");
    if ((!origin.empty() || fits_origin) && position.empty() && mark.empty())
        throw BadInput("--origin and --fit-origin are of --position or --mark, which is missing");
    if (!origin.empty() && fits_origin) throw BadInput("--origin and --fit-origin are both given; give one");
    if (scale != 1 && is_angle()) throw BadInput("--scale is of lengths and values; an angle has none");
    if (likelihood && !std::isfinite(*likelihood))
        throw BadInput(fmt::format("likelihood = {}: a finite number is needed", *likelihood));
    if (!rows.empty() && rows != "impacts" && rows != "samples")
        throw BadInput(fmt::format("rows = '{}' is none of: impacts, samples", rows));
}

std::shared_ptr<const DelimitedFile> SeriesChoice::read() const {
    if (table) return table;
    LayoutChoice layout;
    layout.decimal_comma = decimal_comma;
    if (header_line) layout.header_line = static_cast<std::size_t>(*header_line);
    return std::make_shared<const DelimitedFile>(read_delimited(file, layout));
}

}  // namespace swirl::apps
