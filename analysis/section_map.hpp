// The only thing that analysis/ knows of a dynamical system: a map of a section to itself.
#pragma once

#include <Eigen/Core>

#include <concepts>
#include <cstdint>

namespace swirl::analysis {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;
template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

/// One application of the map, z ↦ z′.
template <int D>
struct Advance {
    Vector<D> state;          ///< z′; meaningless unless `alive`
    double duration = 1;      ///< time that the step took (1 for a map without a flow)
    std::int64_t letter = 0;  ///< which smooth branch of the map was taken; their sequence is the itinerary (word)
    bool alive = true;        ///< false: the map ends here (no next impact, sustained contact, escape)
    double integral = 0;      ///< ∫ of the observable over the step's duration, for maps that have one
};

/// The same with the derivative DF(z).
template <int D>
struct Linearised {
    Vector<D> state;
    double duration = 1;
    std::int64_t letter = 0;
    bool alive = true;
    Matrix<D> derivative;
    double integral = 0;
};

/// A map of R^D (some coordinates possibly angles) with its exact derivative.
///   M::dimension           D, known at compile time
///   map.advance(z)         F(z)
///   map.linearise(z)       F(z) and DF(z); the same F bit for bit
///   map.angle_period(i)    the period of coordinate i if it is an angle (2π), 0 if it is a plain number
///   M::integrated          optional: the coordinate whose integral over a step is `integral`; all others (all, without
///                          it) count as constant over a step
template <class M>
concept SectionMap = requires(const M& map, const Vector<M::dimension>& z, int i) {
    { M::dimension } -> std::convertible_to<int>;
    { map.advance(z) } -> std::same_as<Advance<M::dimension>>;
    { map.linearise(z) } -> std::same_as<Linearised<M::dimension>>;
    { map.angle_period(i) } -> std::convertible_to<double>;
};

/// The coordinate whose integral a map gives, −1 if none.
template <SectionMap M>
constexpr int integrated_coordinate() {
    if constexpr (requires { M::integrated; })
        return M::integrated;
    else
        return -1;
}

}  // namespace swirl::analysis
