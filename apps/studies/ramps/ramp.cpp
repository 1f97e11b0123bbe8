#include "apps/studies/ramps/ramp.hpp"

#include "apps/studies/scene_map/chatter_once.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "map/orbit/speed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>

namespace swirl::studies::ramps {

namespace {

/// p over time.
class Course {
public:
    explicit Course(const RampSettings& settings) : settings_(settings) {}

    std::int64_t way(double t) const { return part(t, settings_.duration, settings_.ways); }
    double at(double t) const {
        const std::int64_t now = way(t);
        const double done = std::min(t / settings_.duration - static_cast<double>(now), 1.0);
        const double there = now % 2 == 0 ? done : 1 - done;
        if (there == 1) return settings_.end();
        return settings_.begin() + there * (settings_.end() - settings_.begin());
    }
    bool rising(std::int64_t now) const { return (now % 2 == 0) != settings_.along.falling; }
    double length() const { return settings_.duration * static_cast<double>(settings_.ways); }

    /// Windows are numbered through all ways.
    std::int64_t window(double t) const { return part(t, width(), settings_.windows * settings_.ways); }
    double width() const { return settings_.duration / static_cast<double>(settings_.windows); }

private:
    /// Which of `count` parts of equal duration holds t; a flight may end any number of parts beyond the last.
    static std::int64_t part(double t, double duration, std::int64_t count) {
        const double number = t / duration;
        return number < static_cast<double>(count) ? static_cast<std::int64_t>(number) : count - 1;
    }

    const RampSettings& settings_;
};

Scene<double> scene_at(const RampSettings& settings, double value) {
    return with_parameter(settings.scene, *settings.along.parameter, value);
}

/// The state with the wall's velocity of another β: see ramp.hpp. Was the body taken along?
bool take_along(const Body<double>& body, PostImpactState<double>& z) {
    const double un = kinematics_of(body, z).un;
    if (!(un > 0)) return false;
    z.vn -= un;
    return true;
}

template <int D>
class Follower {
public:
    using Map = SceneMap<D>;
    using Point = analysis::Vector<D>;

    // The impact rule is that of a value within the range: at an end μ, drag or e_t may be 0.
    explicit Follower(const RampSettings& settings)
        : settings_(settings),
          course_(settings),
          moves_wall_(settings.along.parameter == Parameter::beta),
          similar_(scene_for_noise(scene_at(settings, (settings.begin() + settings.end()) / 2), settings.noise),
                   contact_horizon, settings.accuracy),
          map_(similar_.with(scene_at(settings, settings.begin()))),
          kept_(settings.period) {}

    Ramp follow(const Start<double>& start, const RunControl& control) {
        const OrbitBegin begin = begin_orbit(map_, start);
        ramp_.outcome = begin.outcome;
        z_ = begin.state;
        ramp_.parameter = settings_.begin();
        if (begin.outcome != Outcome::completed || !settle(control, settings_.transient + 1 - begin.impacts))
            return std::move(ramp_);
        const ReportDone done = control.begin("ramp", course_.length());
        while (ramp_.time < course_.length()) {
            if (ramp_.impacts % 1024 == 0) {
                if (control.is_stopped()) {
                    ramp_.interrupted = true;
                    break;
                }
                done(ramp_.time);
            }
            if (!advance()) break;
        }
        if (ramp_.time >= course_.length()) close_window();
        if (!ramp_.modes.empty() && !ramp_.modes.back().left) describe_last_round(ramp_.modes.back());
        return std::move(ramp_);
    }

private:
    /// The transient, at A.
    bool settle(const RunControl& control, std::int64_t impacts) {
        for (std::int64_t i = 0; i < impacts; ++i) {
            if (i % 1024 == 0 && control.is_stopped()) {
                ramp_.interrupted = true;
                return false;
            }
            const auto step = next_step(i + 1);
            if (!step.alive) return false;
            z_ = step.state;
            kept_.add(map_, map_.coordinates(z_));
        }
        if (kept_.period() > 0) begin_mode();
        fills_ = kept_.period() > 0;
        return true;
    }

    bool advance() {
        const double value = course_.at(ramp_.time);
        if (value != value_) {
            value_ = value;
            map_ = similar_.with(scene_at(settings_, value));
            if (moves_wall_ && take_along(map_.body(), z_)) ++now_.taken;
        }
        const auto step = next_step(settings_.transient + ramp_.impacts + 1);
        if (!step.alive) return false;
        z_ = step.state;
        const double t = ramp_.time + step.duration;
        if (course_.window(t) != window_) {
            close_window();
            window_ = course_.window(t);
            fills_ = kept_.period() > 0;
        }
        ramp_.time = t;
        ramp_.parameter = course_.at(t);
        ++ramp_.impacts;
        durations_.push_back(step.duration);
        integrals_.push_back(step.integral);
        now_.lag = std::max(now_.lag, std::abs(ramp_.parameter - value));
        const std::int64_t way = course_.way(t);
        recent_.push_back({way, course_.rising(way), ramp_.parameter, t, section_point(z_)});
        if (static_cast<std::int64_t>(recent_.size()) > settings_.samples) recent_.pop_front();
        watch();
        return true;
    }

    /// The next impact; chatter that lands as one, without noise.
    analysis::Advance<D, PostImpactState<double>> next_step(std::int64_t impact) {
        analysis::Advance<D, PostImpactState<double>> next;
        if (settings_.noise.is_any()) {
            const ReturnStep<double> step = noisy_step(similar_, scene_at(settings_, value_), settings_.noise, z_,
                                                       static_cast<std::uint64_t>(impact));
            next = map_.advance_by(step);
            if (next.alive) return next;
            ramp_.outcome = step.outcome;
            if (step.outcome == Outcome::completed)
                ramp_.outcome = has_diverged(map_.body(), step.collision.after) ? Outcome::diverged : Outcome::resting;
            return next;
        }
        next = advance_as_one(map_, z_);
        long long impacts = 0;
        if (!next.alive) ramp_.outcome = ending_at(map_, z_, impacts);
        return next;
    }

    void watch() {
        rounds_.push_back({durations_.back(), integrals_.back()});
        if (rounds_.size() > static_cast<std::size_t>(settings_.period.longest)) rounds_.pop_front();
        const int before = kept_.period();
        switch (kept_.add(map_, map_.coordinates(z_))) {
            case analysis::PeriodEvent::none:
                return;
            case analysis::PeriodEvent::kept: {
                fills_ = false;
                begin_mode();
                return;
            }
            case analysis::PeriodEvent::left: {
                fills_ = false;
                RampMode& mode = ramp_.modes.back();
                mode.left = true;
                describe_last_round(mode, before);
                return;
            }
        }
    }

    void begin_mode() {
        RampMode mode;
        mode.period = kept_.period();
        mode.kept_from = ramp_.parameter;
        mode.kept_at = ramp_.time;
        ramp_.modes.push_back(mode);
        see(ramp_.modes.back());
        was_seen_ = false;
    }

    /// Its points, as they are now.
    void see(RampMode& mode) {
        mode.points.clear();
        for (const Point& point : kept_.last_period()) mode.points.emplace_back(point);
        mode.seen_at = value_;
    }

    void describe_last_round(RampMode& mode, int period = 0) {
        mode.way = course_.way(ramp_.time);
        mode.rising = course_.rising(mode.way);
        mode.left_at = ramp_.parameter;
        mode.time = ramp_.time;
        mode.impact = ramp_.impacts;
        // The round that left is none of the mode's; rounds_ may be shorter where the ramp has just begun.
        const auto count = static_cast<std::size_t>(period > 0 ? period : kept_.period());
        double turned = 0;
        mode.round = 0;
        for (std::size_t i = 0; i < std::min(count, rounds_.size()); ++i) {
            const auto& [duration, integral] = rounds_[rounds_.size() - 1 - i];
            mode.round += duration;
            turned += integral;
        }
        mode.mean_spin = turned / mode.round;
    }

    void close_window() {
        if (!durations_.empty()) {
            now_.way = window_ / settings_.windows;
            now_.rising = course_.rising(now_.way);
            now_.begin = static_cast<double>(window_) * course_.width();
            now_.end = now_.begin + course_.width();
            now_.parameter = course_.at((now_.begin + now_.end) / 2);
            now_.impacts = static_cast<std::int64_t>(durations_.size());
            double time = 0, turned = 0;
            for (const double duration : durations_) time += duration;
            for (const double integral : integrals_) turned += integral;
            now_.mean_spin = turned / time;
            now_.error = analysis::error_of_ratio(integrals_, durations_);
            now_.period = fills_ ? kept_.period() : 0;
            now_.last = recent_.back().point;
            if (fills_ && !was_seen_) {
                see(ramp_.modes.back());
                was_seen_ = true;
            }
            ramp_.windows.push_back(now_);
            ramp_.samples.insert(ramp_.samples.end(), recent_.begin(), recent_.end());
        }
        now_ = {};
        durations_.clear();
        integrals_.clear();
        recent_.clear();
    }

    const RampSettings& settings_;
    Course course_;
    bool moves_wall_;
    Map similar_, map_;
    double value_ = settings_.begin();
    PostImpactState<double> z_{};
    analysis::KeptPeriod<Map> kept_;
    Ramp ramp_;
    std::int64_t window_ = 0;
    RampWindow now_;  ///< of this window
    std::vector<double> durations_, integrals_;
    std::deque<RampSample> recent_;
    std::deque<std::pair<double, double>> rounds_;  ///< durations and ∫ S dt of the last impacts
    bool fills_ = false;                            ///< is the period that is kept kept since the window began?
    bool was_seen_ = false;  ///< were the mode's points taken at the end of a window that it filled?
};

}  // namespace

std::string why_not_ramped(const std::string& name) {
    if (name == "alpha") return "it changes the body: its other vertices would be moved in flight";
    if (name == "corner") return "it changes the body, whose other corners would be moved in flight";
    if (name == "sides" || name == "law") return "it is no number that changes continuously";
    if (name == "inertia-factor") return "it changes the body, whose spin would change with it";
    if (name == "swirl-rate")
        return "omega_s is the unit of time: without a floor that drags nothing depends on it, with one drag does";
    return {};
}

Ramp run_ramp(const RampSettings& settings, const Start<double>& start, const RunControl& control) {
    for (const double end : {settings.begin(), settings.end()}) validated(scene_at(settings, end));
    if (settings.scene.is_disk()) return Follower<disk_dimension>(settings).follow(start, control);
    return Follower<polygon_dimension>(settings).follow(start, control);
}

}  // namespace swirl::studies::ramps
