#include "analysis/boundaries/boundary.hpp"

namespace swirl::analysis {

std::string_view name_of(BoundaryKind kind) {
    switch (kind) {
        case BoundaryKind::fold:
            return "fold";
        case BoundaryKind::flip:
            return "flip";
        case BoundaryKind::neimark_sacker:
            return "neimark-sacker";
    }
    return "?";
}

std::string_view name_of(CodimensionTwo kind) {
    switch (kind) {
        case CodimensionTwo::cusp:
            return "cusp";
        case CodimensionTwo::generalised_flip:
            return "generalised-flip";
        case CodimensionTwo::chenciner:
            return "chenciner";
        case CodimensionTwo::one_to_one:
            return "1:1";
        case CodimensionTwo::one_to_two:
            return "1:2";
        case CodimensionTwo::one_to_three:
            return "1:3";
        case CodimensionTwo::one_to_four:
            return "1:4";
        case CodimensionTwo::fold_flip:
            return "fold-flip";
        case CodimensionTwo::fold_neimark_sacker:
            return "fold-neimark-sacker";
        case CodimensionTwo::flip_neimark_sacker:
            return "flip-neimark-sacker";
        case CodimensionTwo::double_neimark_sacker:
            return "double-neimark-sacker";
    }
    return "?";
}

std::string_view name_of(BoundaryEnd end) {
    switch (end) {
        case BoundaryEnd::plane:
            return "plane";
        case BoundaryEnd::closed:
            return "closed";
        case BoundaryEnd::one_to_one:
            return "1:1";
        case BoundaryEnd::one_to_two:
            return "1:2";
        case BoundaryEnd::halved:
            return "halved";
        case BoundaryEnd::border:
            return "border";
        case BoundaryEnd::not_converged:
            return "not-converged";
        case BoundaryEnd::most_points:
            return "most-points";
        case BoundaryEnd::stopped:
            return "stopped";
    }
    return "?";
}

namespace {

Eigen::Index coordinates_of(const Boundary& boundary, const Eigen::VectorXd& y) {
    return y.size() - (boundary.kind == BoundaryKind::neimark_sacker ? 3 : 2);
}

}  // namespace

CyclePoints points_of(const Boundary& boundary, const Eigen::VectorXd& y) {
    const Eigen::Index size = coordinates_of(boundary, y);
    return unstacked(y.head(size), static_cast<int>(size / static_cast<Eigen::Index>(boundary.period)));
}

Eigen::Vector2d parameters_of(const Boundary& boundary, const Eigen::VectorXd& y) {
    return y.segment<2>(coordinates_of(boundary, y));
}

}  // namespace swirl::analysis
