#include "apps/studies/certify/chart_map.hpp"

#include "analysis/within_period.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/proof/covering_claim.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace swirl::studies::certify {

namespace {

std::array<double, 5> numbers_of(const SectionPoint<double>& z) {
    return {z.psi, z.chi, z.vn, z.vt, z.spin};
}

}  // namespace

ChartMap::ChartMap(const Scene<double>& scene, const SectionPoint<double>& z)
    : scene_(scene), map_(shooting_map_of(scene)), chart_(proof::section_chart(scene)) {
    if (chart_.size() != 2) return;
    const double x = 1 - scene.alpha + scene.beta * std::cos(z.psi), y = scene.beta * std::sin(z.psi);
    const double vn = z.vn - y, vt = z.vt - x;
    jacobi_ = 0.5 * (vn * vn + vt * vt - x * x - y * y);
}

double ChartMap::normal_velocity(double psi, double vt) const {
    const double x = 1 - scene_.alpha + scene_.beta * std::cos(psi), y = scene_.beta * std::sin(psi);
    return y - std::sqrt(x * x + y * y - (vt - x) * (vt - x) + 2 * *jacobi_);
}

Eigen::VectorXd ChartMap::chart_of(const SectionPoint<double>& z) const {
    const std::array<double, 5> all = numbers_of(z);
    Eigen::VectorXd x(dimension());
    for (int i = 0; i < dimension(); ++i) x[i] = all[chart_[static_cast<std::size_t>(i)]];
    return x;
}

SectionPoint<double> ChartMap::point_of(const Eigen::VectorXd& x) const {
    std::array<double, 5> all{};
    for (int i = 0; i < dimension(); ++i) all[chart_[static_cast<std::size_t>(i)]] = x[i];
    if (jacobi_) all[2] = normal_velocity(x[0], x[1]);
    return {all[0], all[1], all[2], all[3], all[4]};
}

ChartStep ChartMap::step(const Eigen::VectorXd& x) const {
    ChartStep result;
    const SectionPoint<double> z = point_of(x);
    for (const double number : numbers_of(z))
        if (!std::isfinite(number)) return result;
    const analysis::ShootingStep step = map_.step(coordinates_of(z, scene_.is_disk()), 0);
    if (!step.alive || step.letter < 0) return result;
    result.alive = true;
    result.letter = step.letter;
    result.duration = step.duration;
    if (!jacobi_) {
        result.state = step.state;
        result.by_state = step.by_state;
        return result;
    }
    // The rows ψ and v_t of a disk's four; v_n follows the other two.
    const double cx = 1 - scene_.alpha + scene_.beta * std::cos(x[0]), cy = scene_.beta * std::sin(x[0]);
    const double root = cy - z.vn, by_psi = -cy, along = x[1] - cx;
    const double slope_psi = (cx * by_psi + cy * (cx - 1 + scene_.alpha) + along * by_psi) / root;
    const double vn_by_psi = scene_.beta * std::cos(x[0]) - slope_psi, vn_by_vt = along / root;
    result.state = Eigen::Vector2d(step.state[0], step.state[2]);
    result.by_state.resize(2, 2);
    for (int i = 0; i < 2; ++i) {
        const int row = i == 0 ? 0 : 2;
        result.by_state(i, 0) = step.by_state(row, 0) + step.by_state(row, 1) * vn_by_psi;
        result.by_state(i, 1) = step.by_state(row, 2) + step.by_state(row, 1) * vn_by_vt;
    }
    return result;
}

Eigen::VectorXd ChartMap::difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    Eigen::VectorXd d = a - b;
    for (int i = 0; i < dimension(); ++i)
        if (chart_[static_cast<std::size_t>(i)] < 2) d[i] = analysis::within_period(d[i], 2 * pi<double>());
    return d;
}

double largest_exponent(const ChartMap& map, Eigen::VectorXd x, int impacts) {
    Eigen::VectorXd direction = Eigen::VectorXd::Ones(x.size()).normalized();
    const int before = impacts / 1000;
    double sum = 0;
    for (int i = -before; i < impacts; ++i) {
        const ChartStep step = map.step(x);
        if (!step.alive) return std::numeric_limits<double>::quiet_NaN();
        direction = step.by_state * direction;
        const double length = direction.norm();
        if (!(length > 0)) return std::numeric_limits<double>::quiet_NaN();
        direction /= length;
        if (i >= 0) sum += std::log(length);
        x = step.state;
    }
    return sum / impacts;
}

}  // namespace swirl::studies::certify
