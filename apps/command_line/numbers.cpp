#include "apps/command_line/numbers.hpp"

#include "map/numbers/quad.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::apps {

bool underflows(const std::string& text) {
    const bool hexadecimal = text.find_first_of("xX") != std::string::npos;
    const std::string digits = text.substr(0, text.find_first_of(hexadecimal ? "pP" : "eE"));
    const bool all_zero =
        digits.find_first_of(hexadecimal ? "123456789abcdefABCDEF" : "123456789") == std::string::npos;
    return !all_zero && std::strtod(text.c_str(), nullptr) == 0;
}

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

std::vector<double> points_between_logarithms(const std::string& a, const std::string& b, long count) {
    using std::exp, std::log;  // and Quad's own
    const Quad first = log(number_from<Quad>("A", a)), last = log(number_from<Quad>("B", b));
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(count));
    for (long i = 0; i < count; ++i)
        points.push_back(static_cast<double>(exp(first + (last - first) * Quad(i) / Quad(std::max(count - 1, 1L)))));
    points.front() = number_from<double>("A", a);
    points.back() = number_from<double>("B", b);
    return points;
}

}  // namespace swirl::apps
