#include "analysis/fits/natural_units.hpp"

#include "analysis/fits/robust.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

double power_of_two_by(double median) {
    return median > 0 && std::isfinite(median) ? std::exp2(std::round(std::log2(median))) : 1;
}

}  // namespace

NaturalUnits natural_units(std::span<const MeasuredImpact> impacts) {
    std::vector<double> speeds, lengths;
    for (const MeasuredImpact& impact : impacts) {
        speeds.push_back((impact.after - impact.before).head<2>().cwiseAbs().maxCoeff());
        lengths.push_back(std::hypot(impact.offset[0], impact.offset[1]));
    }
    return {power_of_two_by(quantile(std::move(speeds), 0.5)), power_of_two_by(quantile(std::move(lengths), 0.5))};
}

MeasuredImpact in_units(const MeasuredImpact& impact, const NaturalUnits& units) {
    const Eigen::Vector3d of_velocity(1 / units.speed, 1 / units.speed, units.length / units.speed);
    MeasuredImpact scaled = impact;
    for (Eigen::Vector3d* velocity : {&scaled.before, &scaled.after, &scaled.error_before, &scaled.error_after})
        *velocity = velocity->cwiseProduct(of_velocity);
    scaled.offset /= units.length;
    return scaled;
}

bool has_gross_error(const MeasuredImpact& impact) {
    const double largest = std::max(
        {impact.before.cwiseAbs().maxCoeff(), impact.after.cwiseAbs().maxCoeff(), impact.offset.cwiseAbs().maxCoeff()});
    return !(largest <= gross_error);
}

}  // namespace swirl::analysis
