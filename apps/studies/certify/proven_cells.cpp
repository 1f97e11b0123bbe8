#include "apps/studies/certify/proven_cells.hpp"

#include "apps/studies/parallel/pieces.hpp"
#include "map/proof/steady_cells.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace swirl::studies::certify {

namespace {

constexpr int piece_halvings = 4;  ///< of each side at most: 256 pieces, by which threads share the work

/// Number `index` of the plane's pieces, along its first parameter first: by halves, as the pieces themselves are cut.
swirl::cells::ParameterCell piece_of(const Plane& plane, int halvings, std::size_t index) {
    swirl::cells::ParameterCell piece;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t place = i == 0 ? index % (std::size_t{1} << static_cast<unsigned>(halvings))
                                         : index >> static_cast<unsigned>(halvings);
        piece.low[i] = plane.axes[i].low;
        piece.high[i] = plane.axes[i].high;
        for (int bit = halvings; bit-- > 0;) {
            const double middle = piece.middle(i);
            ((place >> static_cast<unsigned>(bit)) & 1U ? piece.low[i] : piece.high[i]) = middle;
        }
    }
    return piece;
}

/// By depth, summed up.
std::vector<DepthShare> depths_of(const std::vector<swirl::cells::PlanePiece>& pieces) {
    std::vector<DepthShare> depths;
    const auto at = [&depths](std::size_t depth) -> DepthShare& {
        if (depths.size() <= depth) depths.resize(depth + 1);
        return depths[depth];
    };
    for (const swirl::cells::PlanePiece& piece : pieces) {
        for (std::size_t depth = 0; depth < piece.costs.size(); ++depth) {
            at(depth).cells += piece.costs[depth].cells;
            at(depth).seconds += piece.costs[depth].seconds;
        }
        for (const swirl::cells::PlaneCell& cell : piece.cells)
            if (cell.proven) at(static_cast<std::size_t>(cell.depth)).proven_area += std::ldexp(1.0, -cell.depth);
    }
    for (std::size_t depth = 0; depth < depths.size(); ++depth) {
        depths[depth].depth = static_cast<int>(depth);
        if (depth == 0) continue;
        depths[depth].proven_area += depths[depth - 1].proven_area;
        depths[depth].seconds += depths[depth - 1].seconds;
    }
    depths.erase(std::remove_if(depths.begin(), depths.end(), [](const DepthShare& d) { return d.cells == 0; }),
                 depths.end());
    return depths;
}

}  // namespace

void require_isolated(const Scene<double>& scene, const Plane& plane) {
    const auto range = [&](Parameter parameter, double value) {
        for (const ParameterRange& axis : plane.axes)
            if (*axis.parameter == parameter) return std::pair(axis.low, axis.high);
        return std::pair(value, value);
    };
    if (scene.is_disk())
        throw std::invalid_argument("sides = disk: cells are proven of polygons, whose fixed points are isolated");
    if (!(range(Parameter::mu, scene.mu).first > 0) || !(range(Parameter::beta, scene.beta).first > 0))
        throw std::invalid_argument(
            "mu or beta = 0: fixed points come in families there; mu > 0 and beta > 0 are wanted");
    if (!(range(Parameter::restitution, scene.restitution).second < 1))
        throw std::invalid_argument("restitution = 1: cells are proven for restitution < 1");
}

double ProvenPlane::proven_area() const {
    double area = 0;
    for (const swirl::cells::PlaneCell& cell : cells)
        if (cell.proven) area += std::ldexp(1.0, -cell.depth);  // exact: each halving is one of the plane's area
    return area;
}

std::size_t ProvenPlane::proven() const {
    return static_cast<std::size_t>(
        std::count_if(cells.begin(), cells.end(), [](const swirl::cells::PlaneCell& cell) { return cell.proven; }));
}

ProvenPlane proven_plane(const Scene<double>& scene, const Plane& plane, const ProvenPlaneOptions& options) {
    require_isolated(scene, plane);
    const int apart = std::clamp(options.halvings - 3, 0, piece_halvings);
    const std::size_t count = std::size_t{1} << static_cast<unsigned>(2 * apart);
    const proof::PlaneScene plane_scene{scene, {plane.parameter(0), plane.parameter(1)}, options.max_time};
    swirl::cells::PlaneLimits limits;
    limits.depth = 2 * apart;
    for (std::size_t i = 0; i < 2; ++i)
        limits.least[i] = std::ldexp(plane.axes[i].high - plane.axes[i].low, -options.halvings);
    const auto pieces = std::make_shared<std::vector<swirl::cells::PlanePiece>>(count);
    const std::function<bool()> stop = options.control.stop ? options.control.stop : [] { return false; };
    const bool whole = run_pieces(count, "certify", options.control,
                                  [pieces, plane_scene, plane, apart, limits, stop](std::size_t i) -> KeepResult {
                                      swirl::cells::PlanePiece piece =
                                          proof::proven_piece(plane_scene, piece_of(plane, apart, i), limits, stop);
                                      return [pieces, i, piece = std::move(piece)] { (*pieces)[i] = piece; };
                                  });
    ProvenPlane result{plane, options.max_time, options.halvings, {}, depths_of(*pieces), whole};
    for (std::size_t i = 0; i < count; ++i) {
        if ((*pieces)[i].cells.empty()) {  // a stop came before
            const swirl::cells::ParameterCell piece = piece_of(plane, apart, i);
            (*pieces)[i].cells = {swirl::cells::PlaneCell::not_looked_at(piece, limits.depth)};
        }
        for (const swirl::cells::PlaneCell& cell : (*pieces)[i].cells) {
            result.whole = result.whole && cell.doubt != swirl::cells::Doubt::not_looked_at;
            result.cells.push_back(cell);
        }
    }
    return result;
}

}  // namespace swirl::studies::certify
