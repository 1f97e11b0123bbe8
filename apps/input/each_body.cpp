#include "apps/input/each_body.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/bodies.hpp"
#include "apps/input/input_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps {

namespace {

/// What is printed of a body that can't be analysed.
std::string refusal_of(const std::string& body, const std::string& why, bool json) {
    if (!json) return fmt::format("body {}: {}\n", printable(body), printable(why));
    std::string text;
    JsonWriter writer(text);
    writer.begin_object();
    writer.key("series");
    writer.begin_object();
    writer.member("body", std::string_view(body));
    writer.end_object();
    writer.member("refused", std::string_view(why));
    writer.end_object();
    writer.finish();
    return text;
}

std::vector<std::string> ids_of(const SeriesChoice& series) {
    DelimitedFile file = *series.table;
    for (const std::string& text : series.where) keep_rows(file, condition_from(file, text));
    const auto ids = values_of(file, column_of(file, "--each", series.each));
    if (ids.empty()) throw BadInput(fmt::format("each = '{}': the column has no values", series.each));
    return ids;
}

}  // namespace

int for_each_body(SeriesChoice& series, const SceneOptions& scene, const StartOptions& start,
                  const OutputOptions& output, const std::function<int()>& run) {
    if (!output.record.empty())
        throw BadInput("--each gives an answer for each body, of which a record holds one: --where takes one");
    whole_choice(series, scene, start).check();
    series.table = series.read();
    const std::vector<std::string> ids = ids_of(series);
    const std::string column = std::exchange(series.each, "");
    const std::vector<std::string> where = series.where;
    const bool prints = output.json || !output.quiet;
    int worst = exit_done;
    std::size_t refused = 0;
    std::string why;
    for (const std::string& id : ids) {
        if (prints && output.json) print_text(&id == &ids.front() ? "{\"bodies\": [\n" : ",\n");
        if (prints && !output.json && &id != &ids.front()) fmt::print("\n");
        series.where = where;
        series.where.push_back(column + "=" + id);
        try {
            worst = std::max(worst, run());
            continue;
        } catch (const BadInput& error) {
            why = error.what();
        } catch (const std::invalid_argument& error) {
            why = error.what();
        }
        ++refused;
        if (prints) print_text(refusal_of(id, why, output.json));
    }
    if (prints && output.json) print_text(fmt::format("], \"swirl_version\": \"{}\"}}\n", version()));
    if (refused == ids.size())
        throw BadInput(fmt::format("each = '{}': no body can be analysed; the last: {}", column, why));
    return worst;
}

}  // namespace swirl::apps
