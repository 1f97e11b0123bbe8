#include "apps/command_line/numbers.hpp"

namespace swirl::apps {

std::vector<double> points_between(const std::string& a, const std::string& b, long count) {
    const Quad first = number_from<Quad>("A", a), last = number_from<Quad>("B", b);
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(count));
    for (long i = 0; i < count; ++i)
        points.push_back(static_cast<double>(count == 1 ? first : first + (last - first) * Quad(i) / Quad(count - 1)));
    return points;
}

}  // namespace swirl::apps
