#include "apps/spectrum/spectrum_signal.hpp"

#include "analysis/spectrum/bin_average.hpp"
#include "analysis/spectrum/uniform_motion.hpp"
#include "apps/input/angle_stretch.hpp"
#include "apps/input/resampled_series.hpp"

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace swirl::apps::spectrum {

namespace {

using Complex = std::complex<double>;

/// A power of two, four bins or more for a flight: above its Nyquist frequency S(t) has little that could fold back.
std::size_t automatic_bins(std::size_t flights) {
    constexpr std::size_t most = std::size_t{1} << 22;
    std::size_t bins = 64;
    while (bins < 4 * flights && bins < most) bins *= 2;
    return bins;
}

std::vector<std::string> columns_for(const SpectrumOptions& options) {
    if (is_spin(options)) return {"t", "S"};
    if (options.observable == "x" || options.observable == "y" || options.observable == "position")
        return {"t", "x", "y", "vx", "vy"};
    throw BadInput(fmt::format("observable = '{}' is none of: S, x, y, position", options.observable));
}

/// Averages over `bins` bins of that width, from the orbit's first time on.
///   flight(i, until, averager)              adds the flight from impact i on
///   contact(segment, until, averager)       adds a segment of the way through contact
template <class Value, class Flight, class FirstContact>
std::vector<Value> averages(const OrbitColumns& orbit, std::size_t bins, double width, const Flight& flight,
                            const FirstContact& contact) {
    const auto& t = orbit.values[0];
    analysis::BinAverager<Value> averager(t.front(), width);
    const double last_edge = t.front() + static_cast<double>(bins) * width;  // can lie an ulp beyond t.back()
    auto return_step = orbit.contacts.begin();
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        const double until = i + 2 < t.size() ? t[i + 1] : std::max(t[i + 1], last_edge);
        if (return_step == orbit.contacts.end() || return_step->after != i) {
            flight(i, until, averager);
            continue;
        }
        for (const TrajectorySegment& segment : return_step->trajectory)
            contact(
                segment,
                &segment == &return_step->trajectory.back() ? until : std::clamp(segment.end, averager.end(), until),
                averager);
        ++return_step;
    }
    std::vector<Value> found = averager.averages();
    found.resize(bins);  // of whole periods: what the orbit has beyond them
    return found;
}

std::vector<double> spin_averages(const OrbitColumns& orbit, std::size_t bins, double width) {
    const auto flight = [&](std::size_t i, double until, analysis::BinAverager<double>& averager) {
        averager.add_constant(until, orbit.values[1][i]);
    };
    const auto contact = [&](const TrajectorySegment& segment, double until, analysis::BinAverager<double>& averager) {
        averager.add(until, [&](double a, double b) {
            return moment_at(*orbit.contact_scene, segment, b).turned -
                   moment_at(*orbit.contact_scene, segment, a).turned;
        });
    };
    return averages<double>(orbit, bins, width, flight, contact);
}

/// ∫ f dt from a to b, of what turns by less than half a radian in that time: ten points give it to rounding.
template <class F>
Complex integral_of(const F& f, double a, double b) {
    using Rule = boost::math::quadrature::gauss<double, 10>;
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    Complex sum = 0;
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
        sum += Rule::weights()[k] * (f(middle + half * Rule::abscissa()[k]) + f(middle - half * Rule::abscissa()[k]));
    return half * sum;
}

/// Exact averages of the position over `bins` bins of that width.
std::vector<Complex> position_averages(const OrbitColumns& orbit, std::size_t bins, double width,
                                       analysis::Frame frame) {
    using analysis::UniformMotion;
    const auto point = [](const Vec2<double>& v) { return Complex(v.x, v.y); };
    const auto fly = [&](const UniformMotion& motion, double until, analysis::BinAverager<Complex>& averager) {
        averager.add(until,
                     [&](double a, double b) { return analysis::position_integral(motion, a, b, frame, orbit.beta); });
    };
    const auto flight = [&](std::size_t i, double until, analysis::BinAverager<Complex>& averager) {
        const auto& v = orbit.values;
        fly({{v[1][i], v[2][i]}, {v[3][i], v[4][i]}, v[0][i]}, until, averager);
    };
    const auto contact = [&](const TrajectorySegment& segment, double until, analysis::BinAverager<Complex>& averager) {
        if (!segment.in_contact && !segment.is_bent() && segment.end > segment.start) {
            const Complex velocity = point(segment.to - segment.from) / (segment.end - segment.start);
            fly({point(segment.from), velocity, segment.start}, until, averager);
            return;
        }
        const auto place = [&](double t) {
            const UniformMotion here{point(moment_at(*orbit.contact_scene, segment, t).centre), 0, t};
            return analysis::position_at(here, t, frame, orbit.beta);
        };
        averager.add(until, [&](double a, double b) { return integral_of(place, a, b); });
    };
    return averages<Complex>(orbit, bins, width, flight, contact);
}

/// A record lists the pieces of its contacts, not the motion on them: its orbit is followed again.
OrbitColumns orbit_of(SpectrumOptions& options, const std::vector<std::string>& names, SpectrumSignal& signal) {
    OrbitColumns orbit = options.input.orbit(options.output, names);
    if (orbit.every > 1)
        throw BadInput(fmt::format("the record lists every {}th impact; a spectrum needs all: simulate with --every 1",
                                   orbit.every));
    // Of a scene that was followed here the flights are known already.
    const bool is_read = orbit.contacts.empty() && orbit.values.front().size() > 1;
    const bool over_floor = is_read && std::any_of(orbit.scene.begin(), orbit.scene.end(), [](const auto& setting) {
                                return setting.first == "drag" || setting.first == "spin_drag";
                            });
    if (orbit.contacts_listed == 0 && !over_floor) return orbit;
    if (orbit.accuracy != "double")
        throw BadInput(
            fmt::format("the record's orbit leads through contact, or over a floor that drags, in {} accuracy, and its "
                        "scene is kept in "
                        "double: give the scene and --accuracy instead of the record",
                        orbit.accuracy));
    signal.notes.emplace_back(
        over_floor ? "the floor drags: the orbit is followed again from the record's scene and start"
                   : "the orbit leads through contact: it is followed again from the record's scene and start");
    return followed_again(orbit, options.output, names);
}

/// The period of the cycle that S(t) is from the first impact kept to the last: in impacts, and in time.
struct Cycle {
    std::size_t impacts = 0;  ///< 0: none
    double time = 0;
};

/// Of flights and spins that repeat to a billionth, and more than once. S that is constant has no period of its own.
Cycle cycle_of(const std::vector<double>& t, const std::vector<double>& spin) {
    constexpr double closeness = 1e-9;  // the orbit is on the cycle; rounding is far less
    constexpr std::size_t longest = 4096, fewest_periods = 4;
    const std::size_t flights = t.size() - 1;
    double most_time = 0, most_spin = 0;
    for (std::size_t i = 0; i < flights; ++i) {
        most_time = std::max(most_time, t[i + 1] - t[i]);
        most_spin = std::max(most_spin, std::abs(spin[i]));
    }
    // A flight is a difference of times, which are rounded.
    const double near_time = closeness * most_time + 4 * std::numeric_limits<double>::epsilon() * std::abs(t.back());
    const auto repeats = [&](std::size_t i, std::size_t p) {
        return std::abs(spin[i + p] - spin[i]) <= closeness * most_spin &&
               std::abs((t[i + p + 1] - t[i + p]) - (t[i + 1] - t[i])) <= near_time;
    };
    for (std::size_t p = 1; p <= std::min(longest, flights / fewest_periods); ++p) {
        std::size_t i = 0;
        while (i + p < flights && repeats(i, p)) ++i;
        if (i + p < flights) continue;
        if (p == 1) return {};
        const std::size_t periods = flights / p;
        return {p, (t[periods * p] - t[0]) / static_cast<double>(periods)};
    }
    return {};
}

/// Bins of a cycle: a power of two of them a period, eight or more an impact; of an orbit too long for it as they were.
void divide_period(const Cycle& cycle, SpectrumSignal& signal, std::size_t& bins) {
    constexpr std::size_t most = std::size_t{1} << 22;
    std::size_t of_period = 8;
    while (of_period < 8 * cycle.impacts) of_period *= 2;
    const auto periods = static_cast<std::size_t>(signal.duration / cycle.time * (1 + 1e-12));
    if (of_period * periods > most) return;
    bins = of_period * periods;
    signal.samples_of_period = of_period;
    signal.spacing = cycle.time / static_cast<double>(of_period);
    signal.duration = signal.spacing * static_cast<double>(bins);
}

SpectrumSignal signal_of_orbit(SpectrumOptions& options) {
    if (!options.resample.empty()) throw BadInput("--resample is a measured series'; an orbit has --bins");
    SpectrumSignal signal;
    const analysis::Frame frame = analysis::frame_from_name(options.frame);
    signal.orbit = orbit_of(options, columns_for(options), signal);
    const auto& orbit = *signal.orbit;
    signal.cycle_time = 2 * std::numbers::pi;
    const auto& t = orbit.values[0];
    signal.enough = t.size() >= 2 && t.back() > t.front();
    if (!signal.enough) {
        if (orbit.outcome == "completed")
            throw BadInput(fmt::format("orbit of {} impacts: a spectrum needs 2 or more", t.size()));
        return signal;
    }
    std::size_t bins = options.bins > 0 ? static_cast<std::size_t>(options.bins) : automatic_bins(t.size() - 1);
    signal.duration = t.back() - t.front();
    signal.spacing = signal.duration / static_cast<double>(bins);
    if (is_spin(options)) {
        const Cycle cycle = orbit.contacts.empty() ? cycle_of(t, orbit.values[1]) : Cycle{};
        signal.period = cycle.time;
        if (cycle.impacts > 0 && options.bins == 0) divide_period(cycle, signal, bins);
        signal.values = spin_averages(orbit, bins, signal.spacing);
        return signal;
    }
    signal.positions = position_averages(orbit, bins, signal.spacing, frame);
    if (options.observable == "position") return signal;
    for (const auto& z : signal.positions) signal.values.push_back(options.observable == "x" ? z.real() : z.imag());
    signal.positions.clear();
    return signal;
}

SpectrumSignal signal_of_series(const SpectrumOptions& options) {
    if (options.observable != "S")
        throw BadInput(fmt::format("observable = '{}' is an orbit's; a series has --column", options.observable));
    if (options.bins > 0 || options.compensate)
        throw BadInput("--bins and --compensate belong to an orbit's bins; a series has samples");
    SpectrumSignal signal;
    signal.series = options.input.measured();
    const auto& series = *signal.series;
    signal.spacing = series.spacing;
    signal.values = series.values;
    signal.duration = series.times.back() - series.times.front();
    if (series.quantity == spin_of_angle && series.gaps > 0) {
        BridgedSpin spin = bridged_spin(series);
        signal.values = std::move(spin.values);
        signal.bridged = spin.bridged;
        if (signal.bridged > 0)
            signal.notes.push_back(
                fmt::format("{} row{} of the angle that were lost are bridged: S beside them is its "
                            "mean across",
                            signal.bridged, signal.bridged == 1 ? "" : "s"));
    }
    signal.uneven = options.resample.empty() && !series.even;
    if (options.resample.empty()) return signal;
    const analysis::Resampled even = resampled(options.resample, series.times, signal.values, signal.resampled);
    signal.spacing = even.series.spacing;
    signal.values = even.series.values;
    signal.highest = even.own_nyquist;
    signal.notes.push_back(resampling_in_words(even));
    return signal;
}

}  // namespace

bool is_spin(const SpectrumOptions& options) {
    return options.observable == "S" || options.observable == "spin";
}

SpectrumSignal signal_of(SpectrumOptions& options) {
    return options.input.kind() == InputKind::series ? signal_of_series(options) : signal_of_orbit(options);
}

}  // namespace swirl::apps::spectrum
