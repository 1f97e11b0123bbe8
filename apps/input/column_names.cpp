#include "apps/input/column_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace swirl::apps {

namespace {

enum class Letters { none, letter, digit };

Letters kind_of(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isdigit(byte) != 0) return Letters::digit;
    return std::isalpha(byte) != 0 || byte >= 0x80 ? Letters::letter : Letters::none;
}

struct Word {
    std::string lower;
    std::size_t begin = 0;  ///< in the name
};

/// Runs of letters and runs of digits, without the unit in brackets: "X_Arena0" is x, arena, 0; "imageNumber" is image,
/// number; "poseX1" is pose, x, 1.
std::vector<Word> words_of(const std::string& name) {
    const std::string unit = unit_in_name(name);
    const bool bracketed = !name.empty() && !unit.empty() && (name.back() == ')' || name.back() == ']');
    const std::size_t size = bracketed ? name.size() - unit.size() - 2 : name.size();
    std::vector<Word> words;
    Letters before = Letters::none;
    bool lower_before = false;
    for (std::size_t i = 0; i < size; ++i) {
        const Letters kind = kind_of(name[i]);
        const auto byte = static_cast<unsigned char>(name[i]);
        const bool is_capital = std::isupper(byte) != 0;
        if (kind != Letters::none) {
            if (kind != before || (is_capital && lower_before)) words.push_back({"", i});
            words.back().lower += static_cast<char>(std::tolower(byte));
        }
        before = kind;
        lower_before = std::islower(byte) != 0;
    }
    return words;
}

template <std::size_t N>
bool any_word(const std::string& name, const std::array<const char*, N>& any_of) {
    const auto words = words_of(name);
    return std::any_of(words.begin(), words.end(), [&](const Word& word) {
        return std::find(any_of.begin(), any_of.end(), word.lower) != any_of.end();
    });
}

/// The words of a name, side by side.
std::string joined_words(const std::string& name) {
    std::string joined;
    for (const Word& word : words_of(name)) joined += word.lower;
    return joined;
}

template <std::size_t N>
bool is_one_of(const std::string& text, const std::array<const char*, N>& any_of) {
    return std::find(any_of.begin(), any_of.end(), text) != any_of.end();
}

/// The likelihood of a point whose columns begin so ("tip."), or the only one that there is.
std::optional<std::size_t> likelihood_of(const DelimitedFile& file, const std::string& begin) {
    std::optional<std::size_t> last;
    std::size_t count = 0;
    for (std::size_t k = 0; k < file.header.size(); ++k) {
        if (!names_likelihood(file.header[k])) continue;
        if (!begin.empty() && file.header[k].rfind(begin, 0) == 0) return k;
        ++count;
        last = k;
    }
    return count == 1 ? last : std::nullopt;
}

}  // namespace

bool names_time(const std::string& name) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const std::string word : {"time", "t"})
        if (lower.rfind(word, 0) == 0 &&
            (lower.size() == word.size() || std::isalnum(static_cast<unsigned char>(lower[word.size()])) == 0))
            return true;
    return false;
}

bool may_name_time(const std::string& name) {
    static constexpr std::array whole = {"seconds",    "sec",      "secs",  "milliseconds", "timestamp",
                                         "timestamps", "datetime", "date",  "age",          "ages",
                                         "elapsed",    "clock",    "timems"};
    static constexpr std::array last = {"t", "time", "timestamp", "seconds", "sec"};
    if (is_one_of(joined_words(name), whole)) return true;
    const auto words = words_of(name);
    return words.size() > 1 && is_one_of(words.back().lower, last);
}

bool names_frame(const std::string& name) {
    static constexpr std::array whole = {"frame",       "frames",     "frameidx",       "frameid",           "frameno",
                                         "framenumber", "frameindex", "framen",         "imagenumber",       "fnum",
                                         "slice",       "slicen",     "slicen\xC2\xB0", "slicen\xEF\xBF\xBD"};
    return is_one_of(joined_words(name), whole);
}

bool names_spin(const std::string& name) {
    return name == "S" || name == "spin";
}

bool names_body(const std::string& name) {
    static constexpr std::array whole = {
        "particle",    "particleid", "track", "trackid",    "trackn",      "trackn\xC2\xB0", "trackn\xEF\xBF\xBD",
        "tracknumber", "tid",        "id",    "individual", "individuals", "individualid",   "identity",
        "animal",      "animalid",   "fish",  "fishid",     "body",        "bodyid",         "object",
        "objectid",    "instance",   "mouse", "arena",      "roi",         "target",         "blobid"};
    return is_one_of(joined_words(name), whole);
}

bool names_angle(const std::string& name) {
    static constexpr std::array words = {"theta", "\xCE\xB8", "angle",    "orientation", "heading",
                                         "th",    "phi",      "\xCF\x86", "yaw",         "rotation"};
    static constexpr std::array no_angle = {"speed", "velocity", "acceleration", "v",    "a",
                                            "omega", "rate",     "std",          "error"};
    return any_word(name, words) && !any_word(name, no_angle);
}

bool names_degrees(const std::string& unit) {
    return unit.find("deg") != std::string::npos || unit.find("\xC2\xB0") != std::string::npos;
}

bool names_likelihood(const std::string& name) {
    static constexpr std::array words = {"likelihood", "confidence", "score", "probability", "visibility"};
    return any_word(name, words);
}

bool names_no_value(const std::string& name) {
    static constexpr std::array words = {"quality", "error", "err", "std", "sd", "sem", "sigma", "uncertainty"};
    static constexpr std::array whole = {"row",       "index",    "label", "missing",
                                         "timestamp", "unnamed0", "nr",    "framecounter"};
    return names_frame(name) || names_body(name) || names_likelihood(name) || any_word(name, words) ||
           is_one_of(joined_words(name), whole);
}

std::vector<PointColumns> points_in(const DelimitedFile& file) {
    static constexpr std::array other = {"bbox", "min",    "max",     "err",      "error", "std", "var",
                                         "v",    "a",      "vel",     "velocity", "speed", "acc", "ens",
                                         "size", "offset", "midline", "region",   "width"};
    std::vector<PointColumns> points;
    for (std::size_t k = 0; k < file.header.size(); ++k) {
        const std::string& name = file.header[k];
        const auto words = words_of(name);
        const auto is_x = [](const Word& word) { return word.lower == "x"; };
        const auto x = std::find_if(words.begin(), words.end(), is_x);
        if (x == words.end() || std::count_if(words.begin(), words.end(), is_x) > 1 || any_word(name, other)) continue;
        std::string partner = name, shared;
        partner[x->begin] = name[x->begin] == 'x' ? 'y' : 'Y';
        const auto y = std::find(file.header.begin(), file.header.end(), partner);
        if (y == file.header.end()) continue;
        for (const Word& word : words)
            if (word.lower != "x") shared += (shared.empty() ? "" : ".") + word.lower;
        points.push_back({shared, k, static_cast<std::size_t>(y - file.header.begin()),
                          likelihood_of(file, name.substr(0, x->begin))});
    }
    return points;
}

std::optional<double> seconds_in(const std::string& unit) {
    static constexpr std::array<std::pair<const char*, double>, 15> units = {{{"s", 1},
                                                                              {"sec", 1},
                                                                              {"secs", 1},
                                                                              {"second", 1},
                                                                              {"seconds", 1},
                                                                              {"ms", 1e-3},
                                                                              {"msec", 1e-3},
                                                                              {"milliseconds", 1e-3},
                                                                              {"us", 1e-6},
                                                                              {"µs", 1e-6},
                                                                              {"min", 60},
                                                                              {"minutes", 60},
                                                                              {"h", 3600},
                                                                              {"hr", 3600},
                                                                              {"hours", 3600}}};
    std::string bare = unit;
    for (const char bracket : {'(', ')', '[', ']'})
        bare.erase(std::remove(bare.begin(), bare.end(), bracket), bare.end());
    const auto found = std::find_if(units.begin(), units.end(), [&](const auto& entry) { return bare == entry.first; });
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace swirl::apps
