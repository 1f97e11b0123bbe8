#include "apps/sweep/scenes_file.hpp"

#include "apps/command_line/text_file.hpp"
#include "apps/input/cells.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/sweep/grid_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace swirl::apps::sweep {

namespace {

constexpr std::size_t longest_file = std::size_t{1} << 28;  // 256 MiB
constexpr std::size_t most_scenes = 1'000'000;

struct TextLine {
    std::size_t number;
    std::string text;
};

/// Those with content.
std::vector<TextLine> lines_of(const std::string& content) {
    std::vector<TextLine> lines;
    std::size_t number = 0;
    for (std::string& text : pieces_of(content, '\n')) {
        ++number;
        if (!text.empty() && text.back() == '\r') text.pop_back();
        const std::size_t first = text.find_first_not_of(" \t");
        if (first != std::string::npos && text[first] != '#') lines.push_back({number, std::move(text)});
    }
    return lines;
}

char separator_of(const std::string& header) {
    for (const char separator : {'\t', ';'})
        if (header.find(separator) != std::string::npos) return separator;
    return ',';
}

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& why) {
    throw BadInput(fmt::format("scenes '{}', line {}: {}", file, line, why));
}

std::vector<std::string> names_in(const std::string& file, const TextLine& header, char separator) {
    std::vector<std::string> names = cells_of(header.text, separator);
    for (auto name = names.begin(); name != names.end(); ++name) {
        *name = flag_name(*name);
        if (!is_axis_name(*name))
            refuse(file, header.number, fmt::format("column '{}' is none of: {}", *name, axis_names()));
        if (std::find(names.begin(), name, *name) != name)
            refuse(file, header.number, fmt::format("column {} is there twice", *name));
    }
    return names;
}

}  // namespace

ScenesFile read_scenes(const std::string& file) {
    std::string content = read_text("scenes", file, longest_file);
    if (content.starts_with("\xEF\xBB\xBF")) content.erase(0, 3);  // a byte order mark
    const std::vector<TextLine> lines = lines_of(content);
    if (lines.size() < 2)
        throw BadInput(fmt::format("scenes '{}' has no scene: a header and a row at least are wanted", file));
    if (lines.size() > most_scenes + 1)
        throw BadInput(
            fmt::format("scenes '{}' has {} scenes: 1 to {} are allowed", file, lines.size() - 1, most_scenes));
    const char separator = separator_of(lines.front().text);
    const std::vector<std::string> names = names_in(file, lines.front(), separator);
    ScenesFile scenes{lines.size() - 1, {}};
    for (const std::string& name : names) scenes.columns.push_back(name + "=");
    for (std::size_t row = 1; row < lines.size(); ++row) {
        const std::vector<std::string> cells = cells_of(lines[row].text, separator);
        if (cells.size() != names.size())
            refuse(file, lines[row].number, fmt::format("{} cells for {} columns", cells.size(), names.size()));
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (cells[k].empty()) refuse(file, lines[row].number, names[k] + " is empty");
            try {
                const GridAxis axis{names[k], "", {}, true, false};
                if (row > 1) scenes.columns[k] += ',';
                scenes.columns[k] += word_at(axis, axis_value(names[k], cells[k]));
            } catch (const BadInput& error) {
                refuse(file, lines[row].number, error.what());
            }
        }
    }
    return scenes;
}

}  // namespace swirl::apps::sweep
