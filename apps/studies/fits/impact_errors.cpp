#include "apps/studies/fits/impact_errors.hpp"

#include "apps/studies/fits/film_impacts.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace swirl::studies {

namespace {

using analysis::FilmArcs;
using analysis::FreeArc;
using analysis::ImpactCovariance;
using analysis::Kink;
using analysis::MeasuredImpact;
using Eigen::Vector3d;
using ImpactNumbers = Eigen::Matrix<double, 8, 1>;

ImpactNumbers numbers_of(const MeasuredImpact& impact) {
    ImpactNumbers numbers;
    numbers << impact.before, impact.after, impact.offset;
    return numbers;
}

ImpactNumbers numbers_at(const Kink& kink, const FilmedScene& scene, const Plate& plate) {
    return numbers_of(in_contact_axes(kink, contact_on(scene, plate, kink.place)));
}

/// What one standard error does, of numbers as a function of such errors: slopes where noise is small.
template <class Numbers>
ImpactNumbers moved_by_one(const Numbers& numbers) {
    constexpr double share = 0.01;
    return (numbers(share) - numbers(-share)) / (2 * share);
}

}  // namespace

ImpactCovariance impact_covariance(const FilmArcs& film, const Kink& kink, const FilmedScene& scene,
                                   const Plate& plate) {
    const Vector3d noise(film.place_noise, film.place_noise, film.angle_noise);
    const FreeArc arcs[2] = {film.arcs[kink.before], film.arcs[kink.before + 1]};
    ImpactCovariance covariance = ImpactCovariance::Zero();
    const auto add = [&](const auto& numbers) {
        const ImpactNumbers moved = moved_by_one(numbers);
        covariance += moved * moved.transpose();
    };
    for (const std::size_t which : {0, 1})
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const auto with = [&](Vector3d FreeArc::*number, double error) {
                FreeArc other[2] = {arcs[0], arcs[1]};
                (other[which].*number)[axis] += error;
                return numbers_at(analysis::kink_between(film, other[0], other[1]), scene, plate);
            };
            const FreeArc& arc = arcs[which];
            // A line through places that an acceleration bends, carried on to the kink.
            const auto bent = [&](double acceleration) {
                FreeArc other[2] = {arcs[0], arcs[1]};
                const double after = kink.time - arc.mean_time,
                             square = arc.spread[axis] / static_cast<double>(arc.count);
                other[which].velocity[axis] += acceleration * after;
                other[which].middle[axis] -= acceleration * (after * after + square) / 2;
                return numbers_at(analysis::kink_between(film, other[0], other[1]), scene, plate);
            };
            const double of_middle = noise[axis] / std::sqrt(static_cast<double>(arc.count)),
                         of_velocity = noise[axis] / std::sqrt(arc.spread[axis]);
            add([&](double share) { return with(&FreeArc::middle, share * of_middle); });
            add([&](double share) { return with(&FreeArc::velocity, share * of_velocity); });
            if (film.wandering[axis] > 0) add([&](double share) { return bent(share * film.wandering[axis]); });
        }
    if (film.impact_time > 0)
        add([&](double share) {
            const double later = share * film.impact_time;
            Kink other = kink;
            other.velocity_before = film.velocity_on(arcs[0], kink.time + later);
            other.velocity_after = film.velocity_on(arcs[1], kink.time + later);
            other.place += later * kink.drift;
            return numbers_at(other, scene, plate);
        });
    const Eigen::LLT<Eigen::Matrix2d> root(plate.errors + 1e-30 * Eigen::Matrix2d::Identity());
    for (Eigen::Index k = 0; k < 2; ++k)
        add([&](double share) {
            Plate other = plate;
            const Eigen::Vector2d moved = share * Eigen::Matrix2d(root.matrixL()).col(k);
            other.tilt += moved[0], other.mark += moved[1];
            return numbers_at(kink, scene, other);
        });
    covariance.bottomRightCorner<2, 2>().diagonal().array() += plate.doubt * plate.doubt;
    return covariance;
}

void add_common_errors(MeasuredImpact& impact, std::size_t number, std::span<const std::vector<MeasuredImpact>> moved) {
    ImpactCovariance covariance = impact.covariance.value();
    for (const std::vector<MeasuredImpact>& other : moved) {
        const ImpactNumbers by_one = numbers_of(other[number]) - numbers_of(impact);
        covariance += by_one * by_one.transpose();
    }
    const ImpactNumbers errors = covariance.diagonal().cwiseSqrt();
    impact.error_before = errors.head<3>(), impact.error_after = errors.segment<3>(3);
    impact.covariance = covariance;
}

}  // namespace swirl::studies
