#include "apps/explore/explore_command.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/explore/explore_data.hpp"
#include "apps/explore/page_text.hpp"
#include "apps/record/output_file.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace swirl::apps::explore {

namespace {

const scripts::ScriptOutput page{"", "page", "swirl explore", {".html"}, "made by swirl explore"};

/// A page that mail and web servers still pass on.
constexpr std::size_t most_bytes = 3'000'000;

/// Within a page a script's end would end the data.
std::string without_tags(const std::string& json) {
    std::string text;
    text.reserve(json.size());
    for (const char letter : json)
        if (letter == '<')
            text += "\\u003c";
        else
            text += letter;
    return text;
}

}  // namespace

const char* const explore_details =
    R"(Writes a page of a record: one HTML file, which opens in a browser without a network. It draws the mode map of a sweep, or
the diagram of a bifurcate or continue record; a record of boundaries draws its curves over the sweep before it, or alone. A
click or a drag chooses the scene's parameters there, and the map itself runs in the page: this program's own, compiled to
WebAssembly. It shows the body in the swirled dish, S(t) with its running mean, the section and the recurrence rate.

What the record says is this program's verdict on the scenes that it followed. What the page says of the scene that you
choose is less: the period with which the last impacts recur on the section, to 1e-9, or "not settled". The page never calls a
scene chaotic. It gives the command of swirl simulate that follows the same orbit.

In the page Tab, arrows, space and the keys that it lists do what the mouse does; its address holds its state.

A page takes 3 MB at most. Of a diagram with more than 60,000 samples it has every second, third ..., and says so.

Example:
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:9 --grid beta=0.1:0.9:9 -o sweep.h5
  swirl explore sweep.h5 -o sweep.html)";

void ExploreOptions::add_to(Flags& command) {
    files.add_to(command, page, true);
}

int explore(ExploreOptions& options) {
    const scripts::ScriptFiles& files = options.files;
    scripts::check_output(page, files);
    exit_when_interrupted();
    PageData data;
    try {
        data = page_data(files.records);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
    for (const auto& record : files.records) warn_without_checksum(record, files.quiet);
    const std::string json = without_tags(data.json);
    const std::size_t bytes = page_before_data().size() + json.size() + page_after_data().size();
    if (bytes > most_bytes)
        throw BadInput(fmt::format("page '{}' would have {:.1f} MB, at most 3: give a record of fewer cells or starts",
                                   files.output, static_cast<double>(bytes) * 1e-6));
    OutputFile file(files.output, "page");
    file.append(page_before_data());
    file.append(json);
    file.append(page_after_data());
    file.commit();
    if (files.json)
        print_document([&](JsonWriter& document) {
            document.member("page", files.output);
            document.member("kind", data.kind);
            document.member("record", files.records.front());
            if (files.records.size() > 1) document.list("records", files.records);
        });
    else if (!files.quiet)
        fmt::print("{}: {}\n", files.output, data.kind);
    return exit_done;
}

}  // namespace swirl::apps::explore
