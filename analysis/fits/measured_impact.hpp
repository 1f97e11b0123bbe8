// An impact as it was measured, and a law of impact as a function that is given.
//
// The plane of the impact: the wall lies along x, y is its normal and points from the wall to the body. Velocities are
// (v_x, v_y, S), those of the body's centre and its spin; r is the offset from the centre to the contact; k = I/m. An
// impulse (q, p) per mass at the contact changes them by (q, p, (r_x p − r_y q)/k).
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>

namespace swirl::analysis {

/// Covariance of (before, after, offset).
using ImpactCovariance = Eigen::Matrix<double, 8, 8>;

struct MeasuredImpact {
    Eigen::Vector3d before, after;  ///< (v_x, v_y, S)
    Eigen::Vector2d offset;         ///< r, from the centre to the contact
    /// Standard errors of `before` and `after`, in any common unit: fits find the scale.
    Eigen::Vector3d error_before = Eigen::Vector3d::Ones(), error_after = Eigen::Vector3d::Ones();
    /// Where errors go together, as of velocities that are those at one time, with an offset that the body's angle
    /// turns: `error_before` and `error_after` are its diagonal's roots. None: they are independent, r is exact.
    std::optional<ImpactCovariance> covariance;
    /// C^(−1/2) of the prediction's error, fixed: the misfit is this times v⁺ − law(v⁻), see with_fixed_weights().
    std::optional<Eigen::Matrix3d> whitening;
};

/// The velocity of the body's point at the contact: (v_x − r_y S, v_y + r_x S); y < 0 approaches.
inline Eigen::Vector2d contact_velocity(const Eigen::Vector2d& offset, const Eigen::Vector3d& velocity) {
    return {velocity[0] - offset[1] * velocity[2], velocity[1] + offset[0] * velocity[2]};
}

/// What an impulse (q, p) at the contact does to (v_x, v_y, S): the 3 × 2 matrix.
inline Eigen::Matrix<double, 3, 2> effect_of_impulse(const Eigen::Vector2d& offset, double inertia) {
    Eigen::Matrix<double, 3, 2> effect;
    effect << 1, 0, 0, 1, -offset[1] / inertia, offset[0] / inertia;
    return effect;
}

/// The two numbers of a law.
struct LawParameters {
    double restitution = 0.5;  ///< e, 0 to 1
    double friction = 0.1;     ///< μ ≥ 0
};

/// An impulse per mass, and how it changes.
struct PredictedImpulse {
    Eigen::Vector2d impulse;             ///< (q, p)
    Eigen::Matrix<double, 2, 4> slopes;  ///< by the contact's velocity (x, y), e and μ
};

/// Impulse of a contact with offset r, k and velocity u before the impact (u_y < 0).
using ImpactLaw = std::function<PredictedImpulse(const Eigen::Vector2d& offset, double inertia,
                                                 const Eigen::Vector2d& velocity, const LawParameters& parameters)>;

struct NamedImpactLaw {
    std::string name;
    ImpactLaw law;
};

}  // namespace swirl::analysis
