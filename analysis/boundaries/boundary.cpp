#include "analysis/boundaries/boundary.hpp"

#include <array>
#include <cstddef>

namespace swirl::analysis {

std::string_view name_of(BoundaryKind kind) {
    static constexpr std::array<std::string_view, 3> names{"fold", "flip", "neimark-sacker"};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(CodimensionTwo kind) {
    static constexpr std::array<std::string_view, 11> names{"cusp",
                                                            "generalised-flip",
                                                            "chenciner",
                                                            "1:1",
                                                            "1:2",
                                                            "1:3",
                                                            "1:4",
                                                            "fold-flip",
                                                            "fold-neimark-sacker",
                                                            "flip-neimark-sacker",
                                                            "double-neimark-sacker"};
    return names[static_cast<std::size_t>(kind)];
}

void turn(BoundaryPoint& point) {
    turn(point.at);
}

void turn(BoundarySpecial& special) {
    turn(special.cycle);
}

Eigen::Vector2d parameters_of(const Boundary& boundary, const Eigen::VectorXd& y) {
    return y.segment<2>(y.size() - (boundary.kind == BoundaryKind::neimark_sacker ? 3 : 2));
}

}  // namespace swirl::analysis
