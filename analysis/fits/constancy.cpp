#include "analysis/fits/constancy.hpp"

#include "analysis/fits/robust.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

/// Slopes shorter than this against the residual's unit say nothing of a parameter.
constexpr double least_information = 1e-12;

struct SpeedPoint {
    double speed, value, weight;
};

ConstancyTest slope_test(const std::string& parameter, const std::string& speed,
                         const std::vector<SpeedPoint>& points) {
    double sum = 0, mean_speed = 0, mean_value = 0;
    for (const SpeedPoint& p : points) {
        sum += p.weight;
        mean_speed += p.weight * p.speed;
        mean_value += p.weight * p.value;
    }
    mean_speed /= sum, mean_value /= sum;
    double spread = 0, product = 0;
    for (const SpeedPoint& p : points) {
        spread += p.weight * (p.speed - mean_speed) * (p.speed - mean_speed);
        product += p.weight * (p.speed - mean_speed) * (p.value - mean_value);
    }
    const double slope = product / spread;
    double variance = 0, squares = 0;
    for (const SpeedPoint& p : points) {
        const double away = p.speed - mean_speed;
        const double leverage = p.weight * (1 / sum + away * away / spread);
        const double pull = p.weight * away * (p.value - mean_value - slope * away) / (1 - leverage);
        variance += pull * pull;
        squares += std::pow(p.weight * away * away, 2);
    }
    const double error = std::sqrt(variance) / spread;
    // As many impacts of one weight as these tell the slope by, less the two numbers of the line.
    const double freedom = spread * spread / squares - 2;
    if (!(freedom >= 1) || !std::isfinite(error)) return {parameter, speed, nan, nan, true};
    return {parameter, speed, slope, error, std::abs(slope) <= sure_slope(freedom) * error};
}

}  // namespace

double sure_slope(double freedom) {
    constexpr double each_side = 0.05 / 4 / 2;
    return boost::math::quantile(boost::math::complement(boost::math::students_t(freedom), each_side));
}

std::vector<ImpactResidual> residuals_of(const LawProblem& problem, const LawParameters& parameters) {
    std::vector<ImpactResidual> residuals;
    for (const MeasuredImpact& impact : problem.impacts) {
        const LawMisfit misfit = misfit_of(impact, problem.inertia, *problem.law, parameters);
        const Eigen::Vector2d contact = contact_velocity(impact.offset, misfit.before);
        const double square = misfit.squared() / (problem.scale * problem.scale);
        const Eigen::Vector2d information = misfit.slopes.colwise().squaredNorm().transpose();
        const auto alone = [&](Eigen::Index j) {
            if (!(information[j] > least_information)) return nan;
            return -misfit.slopes.col(j).dot(misfit.residual) / information[j];
        };
        residuals.push_back({-contact[1], std::abs(contact[0]), std::sqrt(square), biweight(square, biweight_of_three),
                             alone(0), alone(1), information[0], information[1]});
    }
    return residuals;
}

std::vector<ConstancyTest> constancy_tests(std::span<const ImpactResidual> residuals) {
    using Number = double ImpactResidual::*;
    struct Of {
        const char* name;
        Number value, information;
    };
    constexpr std::array<Of, 2> parameters{
        {{"restitution", &ImpactResidual::restitution, &ImpactResidual::restitution_information},
         {"friction", &ImpactResidual::friction, &ImpactResidual::friction_information}}};
    constexpr std::array<std::pair<const char*, Number>, 2> speeds{
        {{"approach", &ImpactResidual::approach_speed}, {"slip", &ImpactResidual::slip_speed}}};
    std::vector<ConstancyTest> tests;
    for (const Of& parameter : parameters)
        for (const auto& [name, speed] : speeds) {
            std::vector<SpeedPoint> points;
            for (const ImpactResidual& row : residuals)
                if (std::isfinite(row.*parameter.value))
                    points.push_back({row.*speed, row.*parameter.value, row.weight * (row.*parameter.information)});
            tests.push_back(slope_test(parameter.name, name, points));
        }
    return tests;
}

}  // namespace swirl::analysis
