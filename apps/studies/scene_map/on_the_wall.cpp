#include "apps/studies/scene_map/on_the_wall.hpp"

#include "map/numbers/jets.hpp"

#include <cmath>

namespace swirl::studies {

namespace {

constexpr double near_surface = 2e-4;

/// A coordinate as a function of z (in the section's order), α and β.
template <int D>
using Jet = ceres::Jet<double, D + 2>;

template <int D>
struct Coordinates {
    Jet<D> psi, chi, vn, vt, spin;
};

template <class J>
bool is_near(const J& a, const J& b, double size) {
    return std::abs(a.a - b.a) <= near_surface * size;
}

/// Sets χ where both ends of an edge are on the wall, and S where both stay there: true for these.
template <int D>
bool lay_edge(int sides, const Jet<D>& alpha, const Jet<D>& beta, Coordinates<D>& z) {
    const double half = pi<double>() / sides;
    const Jet<D> widest = half - asin(alpha * std::sin(half));
    const Jet<D> chi = z.chi.a < 0 ? -widest : widest;
    if (!is_near(z.chi, chi, widest.a)) return false;
    z.chi = chi;
    const Jet<D> spin = (z.vt - beta * cos(z.psi)) / (1.0 - alpha * cos(chi));
    if (!is_near(z.spin, spin, 1 + std::abs(spin.a))) return false;
    z.spin = spin;
    return true;
}

/// Sets v_t where the vertex sticks; an edge then rests.
template <int D>
void stick(const Jet<D>& alpha, const Jet<D>& beta, bool edge_stays, Coordinates<D>& z) {
    const Jet<D> wall = beta * cos(z.psi), held = wall - alpha * z.spin * cos(z.chi);
    if (!is_near(z.vt, held, 1 + std::abs(held.a))) return;
    if (edge_stays) z.spin = Jet<D>(0.0);  // S = u_t
    z.vt = edge_stays ? wall : held;
}

template <int D>
Coordinates<D> seeded(const analysis::Vector<D>& z) {
    Coordinates<D> c;
    c.psi = Jet<D>(z[0], 0);
    if constexpr (D == polygon_dimension) c.chi = Jet<D>(z[1], 1);
    c.vn = Jet<D>(z[D - 3], D - 3);
    c.vt = Jet<D>(z[D - 2], D - 2);
    c.spin = Jet<D>(z[D - 1], D - 1);
    return c;
}

}  // namespace

template <int D>
WallState<D> on_the_wall(const Body<double>& body, const analysis::Vector<D>& z) {
    const Jet<D> alpha(body.alpha, D), beta(body.beta, D + 1);
    Coordinates<D> c = seeded<D>(z);
    bool edge_stays = false;
    if constexpr (D == polygon_dimension) edge_stays = lay_edge<D>(body.sides, alpha, beta, c);
    stick<D>(alpha, beta, edge_stays, c);
    c.vn = alpha * c.spin * sin(c.chi) + beta * sin(c.psi);
    WallState<D> at;
    const auto take = [&](int row, const Jet<D>& value) {
        at.z[row] = value.a;
        at.by_state.row(row) = value.v.template head<D>().transpose();
        at.by_alpha[row] = value.v[D];
        at.by_beta[row] = value.v[D + 1];
    };
    take(0, c.psi);
    if constexpr (D == polygon_dimension) take(1, c.chi);
    take(D - 3, c.vn);
    take(D - 2, c.vt);
    take(D - 1, c.spin);
    at.beside = (at.z - z).template lpNorm<Eigen::Infinity>();
    return at;
}

template WallState<disk_dimension> on_the_wall(const Body<double>&, const analysis::Vector<disk_dimension>&);
template WallState<polygon_dimension> on_the_wall(const Body<double>&, const analysis::Vector<polygon_dimension>&);

}  // namespace swirl::studies
