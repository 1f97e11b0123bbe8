#include "apps/command_line/numbers.hpp"

#include <algorithm>

namespace swirl::apps {

std::vector<std::string> pieces_of(const std::string& text, char separator, std::size_t begin) {
    std::vector<std::string> pieces;
    while (begin <= text.size()) {
        const auto end = std::min(text.find(separator, begin), text.size());
        pieces.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return pieces;
}

std::vector<double> points_between(const std::string& a, const std::string& b, long count) {
    const Quad first = number_from<Quad>("A", a), last = number_from<Quad>("B", b);
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(count));
    for (long i = 0; i < count; ++i)
        points.push_back(static_cast<double>(count == 1 ? first : first + (last - first) * Quad(i) / Quad(count - 1)));
    return points;
}

}  // namespace swirl::apps
