// The scene: which polygon in which container, dimensionless (R_c = 1, ω_s = 1, m = 1). map/README.md, "Scene".
#pragma once

#include "map/numbers/real.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace swirl {

/// How the end of restitution is fixed (map/README.md, "Impact"). Without friction, in sliding and for the disk all
/// agree.
enum class Law { poisson, newton, stronge };

inline constexpr Law all_laws[] = {Law::poisson, Law::newton, Law::stronge};

/// Whose velocity a floor that drags has: the container's, or zero.
enum class Floor { dish, table };

/// Number of sides that stands for the disk (N = ∞).
inline constexpr int disk_sides = 0;
/// The rod, a segment of length 2R_p whose ends touch.
inline constexpr int rod_sides = 2;
inline constexpr int max_sides = 1'000'000;
/// γ and γ_r in units of ω_s: velocities fall by e in a thousandth of 1/ω_s.
inline constexpr double largest_drag = 1000;
/// M, and G = g/(R_c ω_s²): a dish of 1 cm swirled once in a minute has 9·10⁴.
inline constexpr double largest_floor_friction = 1000;
inline constexpr double largest_gravity_ratio = 1e6;
/// Means over a polygon's area are sums over its sides.
inline constexpr int most_sides_over_dry_floor = 1024;

/// A scene, in units of R_c, 1/ω_s and m.
template <class T = double>
struct Scene {
    int sides = 6;    ///< N: 2 … 10⁶, or `disk_sides`
    T alpha{};        ///< α = R_p/R_c, in (0, 1)
    T beta{};         ///< β = r_s/R_c, ≥ 0
    T mu{};           ///< friction μ, ≥ 0
    T restitution{};  ///< e, in [0, 1]
    Law law = Law::poisson;
    T inertia_factor{};          ///< κ: I = κ m R_p², > 0
    T drag{};                    ///< γ: the floor's force −γ(V − V_f), in m ω_s, ≥ 0
    T spin_drag = T(-1);         ///< γ_r: its torque −γ_r I S; negative: γ's value
    Floor floor = Floor::dish;   ///< V_f
    T tangential_restitution{};  ///< e_t, in [0, 1]; of the disk alone
    T corner{};          ///< r of a polygon's rounded corners, in R_c, 0 ≤ r < α; α is their outermost points'
    T floor_friction{};  ///< M, the floor's dry friction, ≥ 0: its force is −M m g ⟨û⟩, û the direction of sliding
    T gravity_ratio{};  ///< G = g/(R_c ω_s²), ≥ 0

    bool is_disk() const { return sides == disk_sides; }
    bool is_rod() const { return sides == rod_sides; }
    T turning_drag() const { return spin_drag < T(0) ? drag : spin_drag; }
    bool is_rounded() const { return corner != T(0); }
    /// Is it followed by a map of its own (map/dragged, map/dry, map/corners), of which less is known in closed form?
    bool has_own_map() const { return acts_in_flight() || is_rounded(); }
    bool has_dry_floor() const { return floor_friction != T(0) && gravity_ratio != T(0); }
    /// a_f = M G, in R_c ω_s²: the deceleration of a body that slides and does not spin
    T floor_deceleration() const { return floor_friction * gravity_ratio; }
    /// Does the floor act on the body in flight, by drag or by dry friction?
    bool acts_in_flight() const { return has_drag() || has_dry_floor(); }
    bool has_drag() const { return drag != T(0) || turning_drag() != T(0); }
};

/// κ of the uniform lamina: (2 + cos(2π/N))/6, ½ for the disk, and ⅓ for the rod, whose mass is on its line.
template <class T>
inline T uniform_inertia_factor(int sides) {
    using std::cos;
    if (sides == disk_sides) return T(0.5);
    if (sides == rod_sides) return T(1) / T(3);
    return (T(2) + cos(T(2 * pi<T>() / sides))) / T(6);
}

/// κ of the uniform lamina with corners of radius r, α the circumradius of their outermost points. With ρ = α − r that
/// of the corners' centres it is their polygon, a rectangle of width r on each of its sides, and a sector of a disk at
/// each of its vertices:
///     A = ½Nρ² sin(2π/N) + Nsr + πr²,   s = 2ρ sin(π/N),  a = ρ cos(π/N)
///     I/m = [½Nρ⁴ sin(2π/N)(2 + cos(2π/N))/6 + Nsr(s²/12 + r²/12 + (a + r/2)²) + πr²(ρ² + r²/2) + ⅔ N s r³]/A
/// κ = I/(m α²). The rod (N = 2) becomes a stadium.
template <class T>
inline T uniform_inertia_factor(int sides, const T& alpha, const T& corner) {
    using std::cos;
    using std::sin;
    const bool has_shape = corner > T(0) && corner <= alpha;  // else `validated` says what is wrong
    if (!has_shape || sides == disk_sides) return uniform_inertia_factor<T>(sides);
    const T n = T(sides), half = T(pi<T>() / sides);
    const T r = corner / alpha, rho = (alpha - corner) / alpha;  // in R_p
    const T side = T(2) * rho * sin(half), apothem = sides == rod_sides ? T(0) : T(rho * cos(half));
    const T inner = T(0.5) * n * side * apothem, rectangles = n * side * r, disk = T(pi<T>()) * r * r;
    const T middle = apothem + T(0.5) * r;
    return (inner * rho * rho * uniform_inertia_factor<T>(sides) +
            rectangles * ((side * side + r * r) / T(12) + middle * middle) + disk * (rho * rho + T(0.5) * r * r) +
            T(2) * n * side * r * r * r / T(3)) /
           (inner + rectangles + disk);
}

/// "poisson", "newton", "stronge".
inline std::string_view name_of(Law law) {
    static constexpr std::string_view names[] = {"poisson", "newton", "stronge"};
    return names[static_cast<std::size_t>(law)];
}

/// "dish", "table".
inline std::string_view name_of(Floor floor) {
    return floor == Floor::dish ? "dish" : "table";
}

namespace detail {

template <class T>
[[noreturn]] void out_of_range(const char* name, const T& value, const char* range) {
    throw std::invalid_argument(std::string(name) + " = " + NumberTraits<Plain<T>>::text(plain(value)) +
                                " is outside its range: " + range);
}

/// The numbers of a scene and of a start are 0 or within these bounds, so that their fourth powers can be held.
inline constexpr double smallest_magnitude = 1e-75;
inline constexpr double largest_magnitude = 1e75;

template <class T>
inline bool is_holdable(const T& value) {
    return value == T(0) || ((value >= T(smallest_magnitude) || -value >= T(smallest_magnitude)) &&
                             value <= T(largest_magnitude) && -value <= T(largest_magnitude));
}

/// @throws std::invalid_argument for a coordinate of a start that is not finite, or too large
template <class T>
inline void require_finite(const char* name, const T& value) {
    if (!(value <= T(largest_magnitude) && -value <= T(largest_magnitude)))
        out_of_range(name, value, "any finite number up to 1e75");
}

/// @throws std::invalid_argument for a start whose speed is neither 0 nor within 10⁻⁷⁵ … 10⁷⁵; a single component may
/// be arbitrarily small
template <class T>
inline void require_speed(const T& speed) {
    if (!is_holdable(speed)) out_of_range("speed", speed, "0 (at rest), or 1e-75 to 1e75");
}

}  // namespace detail

/// True if the scene is dissipative without drive: every impact lowers a quantity that is constant in flight and
/// bounded from below. For e < 1 and μ = 0 that is J (ΔJ = −½(1 − e) p u_n); for e < 1 and β = 0 it is the energy,
/// except for a polygon with friction under Newton's law. Impacts then die out, and no cycle or attractor has any
/// (map/README.md, "Energy in the swirling frame").
template <class T>
inline bool is_dissipative_without_drive(const Scene<T>& scene) {
    if (scene.acts_in_flight()) return false;  // the floor of a dish drives, and takes energy in flight
    if (!(scene.restitution < T(1))) return false;
    return scene.mu == T(0) || (scene.beta == T(0) && (scene.law != Law::newton || scene.is_disk()));
}

/// True of a disk with e = e_t = 1 and friction: J + IS/α changes by the work of sliding alone, and so is conserved for
/// ever once impacts only stick (map/README.md, "Tangential restitution").
template <class T>
inline bool keeps_energy_without_sliding(const Scene<T>& scene) {
    return scene.is_disk() && !scene.acts_in_flight() && scene.mu > T(0) && scene.restitution == T(1) &&
           scene.tangential_restitution == T(1);
}

namespace detail {

/// @throws std::invalid_argument for what is not followed over a floor with dry friction
template <class T>
inline void require_known_over_dry_floor(const Scene<T>& scene) {
    if (scene.has_drag())
        out_of_range("floor-friction", scene.floor_friction, "0 over a floor that drags: one of the two is followed");
    if (scene.is_rounded())
        out_of_range("corner", scene.corner,
                     "0 over a floor with dry friction, to which rounded corners are not extended");
    if (scene.sides > most_sides_over_dry_floor)
        out_of_range("sides", scene.sides, "2 to 1024, or disk, over a floor with dry friction");
}

}  // namespace detail

/// Returns the scene if every parameter is within its range.
/// @throws std::invalid_argument naming the parameter, its value and its range; a NaN is outside every range.
template <class T>
inline Scene<T> validated(const Scene<T>& scene) {
    using detail::is_holdable;
    if (scene.sides != disk_sides && (scene.sides < rod_sides || scene.sides > max_sides))
        detail::out_of_range("sides", scene.sides, "2 to 1000000, or disk");
    if (!(scene.alpha > T(0) && scene.alpha < T(1) && is_holdable(scene.alpha)))
        detail::out_of_range("alpha", scene.alpha, "0 < alpha < 1, at least 1e-75");
    if (!(scene.beta >= T(0) && is_holdable(scene.beta)))
        detail::out_of_range("beta", scene.beta, "beta >= 0, finite (0, or 1e-75 to 1e75)");
    if (!(scene.mu >= T(0) && is_holdable(scene.mu)))
        detail::out_of_range("mu", scene.mu, "mu >= 0, finite (0, or 1e-75 to 1e75)");
    if (!(scene.restitution >= T(0) && scene.restitution <= T(1)))
        detail::out_of_range("restitution", scene.restitution, "0 <= restitution <= 1");
    if (!(scene.inertia_factor > T(0) && is_holdable(scene.inertia_factor)))
        detail::out_of_range("inertia-factor", scene.inertia_factor, "inertia-factor > 0, finite (1e-75 to 1e75)");
    if (!(scene.tangential_restitution >= T(0) && scene.tangential_restitution <= T(1)))
        detail::out_of_range("tangential-restitution", scene.tangential_restitution, "0 to 1 (of the disk)");
    if (scene.tangential_restitution != T(0) && !scene.is_disk())
        detail::out_of_range(
            "tangential-restitution", scene.tangential_restitution,
            "0 for a polygon, whose normal and tangential impulse are coupled (B_3 != 0): it could gain "
            "energy; 0 to 1 for the disk");
    if (!(scene.corner >= T(0) && scene.corner < scene.alpha && is_holdable(scene.corner)))
        detail::out_of_range("corner", scene.corner,
                             "0 <= corner < alpha (0, or at least 1e-75; at alpha it is the disk)");
    if (scene.is_rounded() && scene.is_disk())
        detail::out_of_range("corner", scene.corner, "0 for the disk, which has no corners");
    if (scene.is_rounded() && scene.has_drag())
        detail::out_of_range("corner", scene.corner,
                             "0 over a floor that drags, to which rounded corners are not extended");
    const T& turning = scene.turning_drag();
    if (!(scene.drag >= T(0) && scene.drag <= T(largest_drag) && is_holdable(scene.drag)))
        detail::out_of_range("drag", scene.drag, "0, or 1e-75 to 1000");
    if (!(turning >= T(0) && turning <= T(largest_drag) && is_holdable(turning)))
        detail::out_of_range("spin-drag", turning, "0, or 1e-75 to 1000");
    if (!(scene.floor_friction >= T(0) && scene.floor_friction <= T(largest_floor_friction) &&
          is_holdable(scene.floor_friction)))
        detail::out_of_range("floor-friction", scene.floor_friction, "0, or 1e-75 to 1000");
    if (!(scene.gravity_ratio >= T(0) && scene.gravity_ratio <= T(largest_gravity_ratio) &&
          is_holdable(scene.gravity_ratio)))
        detail::out_of_range("gravity-ratio", scene.gravity_ratio, "0, or 1e-75 to 1e6");
    if (scene.has_dry_floor()) detail::require_known_over_dry_floor(scene);
    return scene;
}

/// The scene, if its floor has no dry friction.
///   what  that is not extended to it, as the beginning of a sentence
/// @throws std::invalid_argument naming what, and the friction
template <class T>
inline Scene<T> without_dry_floor(const Scene<T>& scene, const char* what) {
    if (scene.has_dry_floor())
        throw std::invalid_argument(std::string(what) +
                                    " is not extended to a floor with dry friction (floor-friction = " +
                                    NumberTraits<Plain<T>>::text(plain(scene.floor_friction)) + "); 0 is wanted");
    return scene;
}

/// The scene, if its floor does not act in flight.
///   what  that is not extended to a floor that drags or has dry friction, as the beginning of a sentence
/// @throws std::invalid_argument naming what, and the drag or the friction
template <class T>
inline Scene<T> without_floor(const Scene<T>& scene, const char* what) {
    without_dry_floor(scene, what);
    if (scene.has_drag())
        throw std::invalid_argument(std::string(what) + " is not extended to a floor that drags (drag = " +
                                    NumberTraits<Plain<T>>::text(plain(scene.drag)) + ", spin-drag = " +
                                    NumberTraits<Plain<T>>::text(plain(scene.turning_drag())) + "); drag 0 is wanted");
    return scene;
}

/// The scene, if its sticking impacts return nothing of the slip.
///   what  as in `without_floor`
template <class T>
inline Scene<T> without_tangential_restitution(const Scene<T>& scene, const char* what) {
    if (scene.tangential_restitution != T(0))
        throw std::invalid_argument(
            std::string(what) + " is not extended to tangential restitution (tangential-restitution = " +
            NumberTraits<Plain<T>>::text(plain(scene.tangential_restitution)) + "); 0 is wanted");
    return scene;
}

/// The scene, if its body is not the rod.
///   what  as in `without_floor`
template <class T>
inline Scene<T> without_rod(const Scene<T>& scene, const char* what) {
    if (scene.is_rod())
        throw std::invalid_argument(std::string(what) +
                                    " is not extended to the rod (sides = 2); 3 to 1000000, or disk, is wanted");
    return scene;
}

/// The scene, if its body has sharp corners or none.
///   what  as in `without_floor`
template <class T>
inline Scene<T> without_rounding(const Scene<T>& scene, const char* what) {
    if (scene.is_rounded())
        throw std::invalid_argument(std::string(what) + " is not extended to rounded corners (corner = " +
                                    NumberTraits<Plain<T>>::text(plain(scene.corner)) + "); 0 is wanted");
    return scene;
}

}  // namespace swirl
