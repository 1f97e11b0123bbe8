#include "analysis/classification/angle_spectrum.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/spectrum/fft.hpp"
#include "analysis/spectrum/segments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t slowest = 6;    // bins that the taper mixes with the line
constexpr std::size_t half_line = 6;  // bins either way that a line reaches, with a margin of two
constexpr std::size_t surroundings = 40;
constexpr std::size_t block = 64;
constexpr double above_noise = 25, above_surroundings = 30, block_above_noise = 3;
constexpr double certain_excess = 5;  // standard deviations
constexpr double arithmetic = 2e-12;  // of the largest angle: 10⁻¹² either way, as of a series (classify_series.cpp)

/// The median of exponentially distributed numbers is ln 2 of their mean.
double level_of(std::vector<double> powers) {
    auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
    std::nth_element(powers.begin(), middle, powers.end());
    return *middle / std::numbers::ln2;
}

/// Takes away mean and slope. @return the slope, per sample
double remove_line(std::vector<double>& x) {
    const double n = static_cast<double>(x.size()), middle = (n - 1) / 2;
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double t = static_cast<double>(i) - middle;
        products += t * (x[i] - mean);
        squares += t * t;
    }
    const double slope = products / squares;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= mean + slope * (static_cast<double>(i) - middle);
    return slope;
}

/// |X_k|², k = 0 … n/2, in units in which white noise has its variance in each.
std::vector<double> tapered_power(const std::vector<double>& x) {
    const std::vector<double> taper = window_values(Window::blackman_harris, x.size());
    RealFft fft(x.size());
    const auto input = fft.input();
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        input[i] = taper[i] * x[i];
        squares += taper[i] * taper[i];
    }
    std::vector<double> power;
    for (const auto& value : fft.transform()) power.push_back(std::norm(value) / squares);
    return power;
}

class Division {
public:
    Division(std::vector<double> power, std::size_t samples, double spacing, AngleSpectrum& found)
        : power_(std::move(power)), taken_(power_.size(), 0), samples_(samples), spacing_(spacing), found_(found) {
        const double q = found_.resolution, rounding = q * q / 12;
        const double level = level_of(std::vector<double>(power_.begin() + first_of_highest(), power_.end()));
        found_.level = std::sqrt(level);
        found_.noise = std::sqrt(std::max({level, rounding, found_.noise * found_.noise}));
        noise_ = found_.noise * found_.noise;
        largest_of_rounding_ = 2 * q / pi;
        const double before = std::max(0.0, level - rounding);  // variance of the noise before the rounding
        left_by_noise_ = q > 0 ? std::exp(-2 * pi * pi * before / (q * q)) : 0;
        for (std::size_t k = 0; k < slowest; ++k) {
            if (power_[k] > above_noise * noise_) found_.slow += variance(k);
            taken_[k] = 1;
        }
    }

    /// The strongest first, as S has them.
    void take_lines() {
        std::vector<std::size_t> order;
        for (std::size_t k = slowest; k < power_.size(); ++k)
            if (power_[k] > above_noise * noise_) order.push_back(k);
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return variance(a) > variance(b); });
        for (const std::size_t k : order)
            if (taken_[k] == 0 && stands_out(k)) take_line(k);
    }

    void take_continuum() {
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < power_.size(); ++k)
            if (taken_[k] == 0) left.push_back(k);
        double of_angle = 0;
        for (std::size_t begin = 0; begin + block <= left.size(); begin += block) {
            std::vector<double> powers;
            for (std::size_t i = begin; i < begin + block; ++i) powers.push_back(power_[left[i]]);
            if (!(level_of(std::move(powers)) > block_above_noise * noise_)) continue;
            ++found_.blocks;
            for (std::size_t i = begin; i < begin + block; ++i) {
                found_.in_continuum += variance(left[i]);
                of_angle += variance_of_angle(left[i]);
            }
        }
        if (found_.blocks == 0) of_angle = take_faint(left);
        leave_rounding(of_angle);
    }

private:
    /// Of the highest third.
    std::ptrdiff_t first_of_highest() const { return static_cast<std::ptrdiff_t>(2 * power_.size() / 3); }

    /// Of the angle and of S, from bin k: without the noise.
    double variance_of_angle(std::size_t k) const { return 2 * (power_[k] - noise_) / static_cast<double>(samples_); }
    double variance(std::size_t k) const { return variance_of_angle(k) * square_of_rate(k); }
    double square_of_rate(std::size_t k) const {
        const double rate = 2 * std::sin(pi * static_cast<double>(k) / static_cast<double>(samples_)) / spacing_;
        return rate * rate;
    }

    bool stands_out(std::size_t k) const {
        if (power_[k] < power_[k - 1] || (k + 1 < power_.size() && power_[k] < power_[k + 1])) return false;
        std::vector<double> about;
        for (std::size_t away = half_line + 1; away <= surroundings; ++away) {
            if (k >= away && taken_[k - away] == 0) about.push_back(power_[k - away]);
            if (k + away < power_.size() && taken_[k + away] == 0) about.push_back(power_[k + away]);
        }
        return about.size() >= half_line && power_[k] > above_surroundings * level_of(std::move(about));
    }

    void take_line(std::size_t k) {
        double of_angle = 0, of_spin = 0;
        for (std::size_t j = k - std::min(k, half_line); j <= std::min(k + half_line, power_.size() - 1); ++j) {
            if (taken_[j] == 0) of_angle += variance_of_angle(j), of_spin += variance(j);
            taken_[j] = 1;
        }
        const double amplitude = std::sqrt(2 * std::max(of_angle, 0.0));
        if (amplitude > largest_of_rounding_) {
            ++found_.lines;
            found_.in_lines += of_spin;
        } else if (amplitude > largest_of_rounding_ * left_by_noise_) {
            ++found_.uncertain;
        }
    }

    /// What the bins in the lower two thirds hold together above the noise, if that is certain. Neighbours share half
    /// of their power under the taper, so that numbers of them vary twice as much; the level is a median of powers,
    /// with a relative error of √(2/n)/ln 2. @return the same of the angle
    double take_faint(const std::vector<std::size_t>& left) {
        double excess = 0, of_angle = 0, square = 0, noise = 0;
        for (const std::size_t k : left) {
            if (static_cast<std::ptrdiff_t>(k) >= first_of_highest()) break;
            excess += variance(k);
            of_angle += variance_of_angle(k);
            const double of_noise = 2 * noise_ / static_cast<double>(samples_) * square_of_rate(k);
            square += 2 * of_noise * of_noise;
            noise += of_noise;
        }
        const double highest = static_cast<double>(power_.size()) - static_cast<double>(first_of_highest());
        const double error = std::sqrt(2 / highest) / std::numbers::ln2 * noise;
        if (excess > certain_excess * std::sqrt(square + error * error)) found_.in_continuum = excess;
        return of_angle;
    }

    /// A continuum of less than rounding's largest variance is not believed.
    void leave_rounding(double of_angle) {
        const double largest = found_.resolution * found_.resolution / 4;
        if (!(found_.in_continuum > 0) || of_angle > largest) return;
        if (of_angle > largest * left_by_noise_ * left_by_noise_) ++found_.uncertain;
        found_.in_rounding = found_.in_continuum;
        found_.in_continuum = 0;
        found_.blocks = 0;
    }

    std::vector<double> power_;
    std::vector<char> taken_;
    std::size_t samples_;
    double spacing_, noise_ = 0;
    double largest_of_rounding_ = 0;  // amplitude of a line
    double left_by_noise_ = 0;        // of that amplitude
    AngleSpectrum& found_;
};

}  // namespace

AngleSpectrum spectrum_of_angle(std::span<const double> angle, double spacing, double noise, double resolution) {
    if (angle.size() < fewest_angles)
        throw std::invalid_argument("angle of " + std::to_string(angle.size()) + " samples: must be " +
                                    std::to_string(fewest_angles) + " or more without a gap");
    double largest = 0;
    for (const double value : angle) {
        if (!std::isfinite(value)) refuse("angle", value, "finite");
        largest = std::max(largest, std::abs(value));
    }
    if (!(noise >= 0 && std::isfinite(noise))) refuse("noise", noise, ">= 0, finite");
    if (!(resolution >= 0 && std::isfinite(resolution))) refuse("resolution", resolution, ">= 0, finite");
    AngleSpectrum found;
    found.noise = noise;
    found.resolution = std::max(resolution, arithmetic * largest);
    std::vector<double> rest(angle.begin(), angle.end());
    found.rate = remove_line(rest) / spacing;
    const auto [lowest, highest] = std::minmax_element(rest.begin(), rest.end());
    found.range = *highest - *lowest;
    Division division(tapered_power(rest), rest.size(), spacing, found);
    division.take_lines();
    division.take_continuum();
    return found;
}

}  // namespace swirl::analysis
