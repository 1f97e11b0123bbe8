#include "analysis/classification/classify_angle.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/spectrum/fft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr std::size_t slowest = 6;    // bins that the taper mixes with the line
constexpr std::size_t half_line = 6;  // bins either way that a line reaches, with a margin of two
constexpr std::size_t surroundings = 40;
constexpr std::size_t block = 64;
constexpr double above_noise = 25, above_surroundings = 30, block_above_noise = 3;
constexpr double few_continuum = 0.02, much_continuum = 0.3;
constexpr int fewest_blocks = 3;

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
    constexpr double weights[] = {0.35875, -0.48829, 0.14128, -0.01168};  // Blackman-Harris
    RealFft fft(x.size());
    const auto input = fft.input();
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(x.size());
        double taper = 0;
        for (int k = 0; k < 4; ++k) taper += weights[k] * std::cos(k * turn);
        input[i] = taper * x[i];
        squares += taper * taper;
    }
    std::vector<double> power;
    for (const auto& value : fft.transform()) power.push_back(std::norm(value) / squares);
    return power;
}

class Division {
public:
    Division(std::vector<double> power, std::size_t samples, double spacing, AngleSpectrum& found)
        : power_(std::move(power)), taken_(power_.size(), 0), samples_(samples), spacing_(spacing), found_(found) {
        if (!(found_.noise > 0)) {
            const auto third = static_cast<std::ptrdiff_t>(2 * power_.size() / 3);
            found_.noise = std::sqrt(level_of(std::vector<double>(power_.begin() + third, power_.end())));
        }
        noise_ = found_.noise * found_.noise;
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
        for (const std::size_t k : order) {
            if (taken_[k] != 0 || !stands_out(k)) continue;
            ++found_.lines;
            for (std::size_t j = k - std::min(k, half_line); j <= std::min(k + half_line, power_.size() - 1); ++j) {
                if (taken_[j] == 0) found_.in_lines += variance(j);
                taken_[j] = 1;
            }
        }
    }

    void take_continuum() {
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < power_.size(); ++k)
            if (taken_[k] == 0) left.push_back(k);
        for (std::size_t begin = 0; begin + block <= left.size(); begin += block) {
            std::vector<double> powers;
            double sum = 0;
            for (std::size_t i = begin; i < begin + block; ++i) {
                powers.push_back(power_[left[i]]);
                sum += variance(left[i]);
            }
            if (!(level_of(powers) > block_above_noise * noise_)) continue;
            ++found_.blocks;
            found_.in_continuum += sum;
        }
    }

private:
    /// Of S, from bin k: without the noise.
    double variance(std::size_t k) const {
        const double rate =
            2 * std::sin(std::numbers::pi * static_cast<double>(k) / static_cast<double>(samples_)) / spacing_;
        return 2 * (power_[k] - noise_) * rate * rate / static_cast<double>(samples_);
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

    std::vector<double> power_;
    std::vector<char> taken_;
    std::size_t samples_;
    double spacing_, noise_ = 0;
    AngleSpectrum& found_;
};

void describe(const AngleSpectrum& found, const ClassifySeriesOptions& options, Classification& result) {
    result.evidence.push_back({"noise of the angle in radians", found.noise, options.noise,
                               options.noise > 0 ? "as given" : "the level of the highest third of the frequencies",
                               "nothing by itself: lines and continuum are what stands above it"});
    const double all = found.slow + found.in_lines + found.in_continuum;
    const double slow = all > 0 ? found.slow / all : 0;
    result.evidence.push_back(
        {"share of S that drifts", slow, 0.5, slow > 0.5 ? "still settling" : "it lasts",
         slow > 0.5 ? "at most 0.5: lines and continuum would decide" : "above 0.5: undecided, still settling"});
    result.evidence.push_back({"lines in the spectrum of the angle", static_cast<double>(found.lines), 1,
                               found.lines > 0 ? "S repeats, in one period or several" : "S has no period",
                               found.lines > 0 ? "none: steady, if there is no continuum"
                                               : "one or more: quasi-steady, if there is no continuum"});
    result.evidence.push_back(
        {"share of the continuum in S", found.continuum_share(), few_continuum,
         found.blocks == 0 ? "nothing above the noise but lines"
                           : "irregular beyond the camera's noise (a container that is shaken would look the same)",
         "at most " + in_words(few_continuum) + ": steady or quasi-steady; at least " + in_words(much_continuum) +
             ": chaotic; between: undecided"});
}

}  // namespace

AngleSpectrum spectrum_of_angle(std::span<const double> angle, double spacing, double noise) {
    if (angle.size() < fewest_angles)
        throw std::invalid_argument("angle of " + std::to_string(angle.size()) + " samples: must be " +
                                    std::to_string(fewest_angles) + " or more without a gap");
    for (const double value : angle)
        if (!std::isfinite(value)) refuse("angle", value, "finite");
    if (!(noise >= 0 && std::isfinite(noise))) refuse("noise", noise, ">= 0, finite");
    AngleSpectrum found;
    found.noise = noise;
    std::vector<double> rest(angle.begin(), angle.end());
    found.rate = remove_line(rest) / spacing;
    Division division(tapered_power(rest), rest.size(), spacing, found);
    division.take_lines();
    division.take_continuum();
    return found;
}

Classification classify_angle(std::span<const double> angle, double spacing, const ClassifySeriesOptions& options) {
    const AngleSpectrum found = spectrum_of_angle(angle, spacing, options.noise);
    Classification result;
    result.steps = static_cast<std::int64_t>(angle.size());
    result.mean = found.rate;
    std::vector<double> rates;
    for (std::size_t i = 1; i < angle.size(); ++i) rates.push_back((angle[i] - angle[i - 1]) / spacing);
    const auto rate = recurrence::recurrence_rate(recurrence::embed_series(rates), options.recurrence_threshold);
    result.recurrence_rate = rate.with_diagonal();
    result.recurrence_rate_without_diagonal = rate.without_diagonal();
    describe(found, options, result);
    const double share = found.continuum_share();
    if (found.slow > found.in_lines + found.in_continuum) {
        result.kind = Kind::transient;
    } else if (found.lines == 0 && found.blocks == 0) {
        result.mode = Mode::steady;
        result.kind = Kind::fixed_point;
    } else if (share <= few_continuum) {
        result.mode = Mode::quasi_steady;
    } else if (share >= much_continuum && found.blocks >= fewest_blocks) {
        result.mode = Mode::chaotic;
        result.kind = Kind::chaotic;
    }
    return result;
}

}  // namespace swirl::analysis
