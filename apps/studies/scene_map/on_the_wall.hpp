// The states that impacts without restitution leave.
//
// At e = 0 the vertex that strikes stays at the wall: u_n = v_n − αS sin χ − β sin ψ = 0 (disk: χ = 0) after every
// impact, so that all cycles lie on that surface. Smaller ones hold more of them:
//
//     an edge's other end is on the wall      χ = ±(π/N − arcsin(α sin(π/N)))
//     and stays there                         S = u_t: S = (v_t − β cos ψ)/(1 − α cos χ)
//     the vertex sticks                       u_t = v_t + αS cos χ − β cos ψ = 0
//
// Beside its surface F is another map: a vertex that leaves with u_n < 0, however slowly, comes back for one impact
// more. Guesses along a tangent leave the surface by O(h²), and continuation by small steps alone would crawl. So where
// the map itself leads nowhere solvers try F∘P, where P(z) has the coordinates of those surfaces that z is near to. A
// cycle of F on the surface is one of F∘P, with the same multipliers, since F leads there, where P(z) = z; where a
// cycle of F∘P is none of F, it does not close by F.
#pragma once

#include "analysis/section_map.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "map/model/body.hpp"
#include "map/model/parameter.hpp"

namespace swirl::studies {

/// A state in the section's coordinates, (ψ, χ, v_n, v_t, S) or a disk's (ψ, v_n, v_t, S), as a function of another.
template <int D>
struct WallState {
    analysis::Vector<D> z = analysis::Vector<D>::Zero();             ///< P(z)
    analysis::Matrix<D> by_state = analysis::Matrix<D>::Identity();  ///< DP
    analysis::Vector<D> by_alpha = analysis::Vector<D>::Zero();      ///< ∂P/∂α at the same z
    analysis::Vector<D> by_beta = analysis::Vector<D>::Zero();       ///< ∂P/∂β
    double beside = 0;                                               ///< the largest coordinate of P(z) − z

    /// ∂P/∂p.
    analysis::Vector<D> along(Parameter parameter) const {
        return parameter == Parameter::alpha  ? by_alpha
               : parameter == Parameter::beta ? by_beta
                                              : analysis::Vector<D>(analysis::Vector<D>::Zero());
    }
};

/// P(z) and its derivatives. Near: within 2·10⁻⁴ (of χ, in units of the edge's own). Cost: a function of Jets of D + 2.
template <int D>
WallState<D> on_the_wall(const Body<double>& body, const analysis::Vector<D>& z);

extern template WallState<disk_dimension> on_the_wall(const Body<double>&, const analysis::Vector<disk_dimension>&);
extern template WallState<polygon_dimension> on_the_wall(const Body<double>&,
                                                         const analysis::Vector<polygon_dimension>&);

}  // namespace swirl::studies
