// A film of a body that moves freely between impacts: straight lines with constant spin, or what a floor's drag makes
// of them, and the kinks between them.
#pragma once

#include "analysis/special_values.hpp"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

/// Places and angle of one frame.
struct FilmFrame {
    double time = nan;
    Eigen::Vector3d place = Eigen::Vector3d::Constant(nan);  ///< (x, y, θ); NaN: missing
};

/// (1 − e^(−γt))/γ: a body that moves freely under the drag γ does so evenly in this; t where γ is 0.
inline double dragged_time(double time, double drag) {
    return drag == 0 ? time : -std::expm1(-drag * time) / drag;
}

/// A floor that does not turn, whose place is radius (cos, sin)(rate t + phase); radius 0: it stands still. With the
/// drag γ a free body obeys X″ = −γ (X′ − floor's velocity), so that X = A + B (1 − e^(−γt))/γ + K cis(rate t + phase),
/// K = γ radius/(γ + i rate): without the last, straight in dragged_time().
struct FloorMotion {
    double radius = 0, rate = 1, phase = 0;

    /// K cis(rate t + phase), and its velocity; the angle is not carried.
    Eigen::Vector3d carried(double time, double drag) const;
    Eigen::Vector3d carried_velocity(double time, double drag) const;
};

/// Gravity g on free bodies, with the drag γ of what holds them up or they move through: X″ = g − γ X′, so that X = A +
/// B (1 − e^(−γt))/γ + g (t − from)²/2, of a drag g ((t − from) − (1 − e^(−γ(t − from)))/γ)/γ in the last's place. Any
/// `from` does, near the arcs' times.
struct UniformFall {
    Eigen::Vector2d gravity = Eigen::Vector2d::Zero();
    double from = 0;

    bool any() const { return gravity != Eigen::Vector2d::Zero(); }
    /// The last, and its velocity; the angle does not fall.
    Eigen::Vector3d place(double time, double drag) const;
    Eigen::Vector3d velocity(double time, double drag) const;
};

/// γ of the places, and γ_r of the angle: θ″ = −γ_r θ′. A uniform film of fluid makes them the same.
struct Drags {
    double places = 0, angle = 0;

    bool any() const { return places != 0 || angle != 0; }
};

/// dragged_time() of x, y and θ.
inline Eigen::Vector3d dragged_times(double time, const Drags& drags) {
    const double places = dragged_time(time, drags.places);
    return {places, places, drags.angle == drags.places ? places : dragged_time(time, drags.angle)};
}

/// A straight line through consecutive frames, by least squares: place = middle + velocity (time − mean time), or with
/// a drag middle + velocity (dragged_time(time − mean time) − lag), to which FilmArcs::place_on() adds what the floor
/// carries, or the fall. Numbers for (x, y, θ), of which the angle's differ with its drag.
struct FreeArc {
    std::size_t first = 0, last = 0;  ///< of the frames that count, both included
    std::size_t count = 0;            ///< frames on it
    double mean_time = nan, start = nan, end = nan;
    Eigen::Vector3d spread = Eigen::Vector3d::Constant(nan);  ///< Σ since(t)²: a velocity's variance is σ²/spread
    Eigen::Vector3d middle = Eigen::Vector3d::Constant(nan), velocity = Eigen::Vector3d::Constant(nan);
    double squares = nan, angle_squares = nan;  ///< summed squares of the residuals of x and y, and of θ
    bool after_gap = false;                     ///< frames are missing before it: what happened there is not known
    Drags drags;
    /// Mean of the dragged times: 0 without a drag; `velocity` is that at the mean time.
    Eigen::Vector3d lag = Eigen::Vector3d::Zero();

    Eigen::Vector3d since(double time) const { return dragged_times(time - mean_time, drags) - lag; }
    Eigen::Vector3d at(double time) const { return middle + velocity.cwiseProduct(since(time)); }
    /// Of the velocity at the mean time, what is left of it at another.
    Eigen::Vector3d decay(double time) const {
        if (!drags.any()) return Eigen::Vector3d::Ones();
        const double places = std::exp(-drags.places * (time - mean_time));
        return {places, places, std::exp(-drags.angle * (time - mean_time))};
    }
    Eigen::Vector3d velocity_at(double time) const { return velocity.cwiseProduct(decay(time)); }
    /// Variance of x or y of at(time) in units of σ². (The angle's own is this where the drags are the same, and nearly
    /// so else.)
    double share(double time) const {
        const double s = since(time)[0];
        return 1 / static_cast<double>(count) + s * s / spread[0];
    }
    /// That of velocity_at(time), likewise.
    double velocity_share(double time) const { return std::pow(decay(time)[0], 2) / spread[0]; }
};

struct FilmArcs {
    std::vector<FreeArc> arcs;
    double place_noise = nan, angle_noise = nan;  ///< standard deviations of x or y, and of θ, in one frame
    /// Covariance of the noise of (along the body's angle, across it, θ): a tracker that takes the angle from two
    /// points has errors of the angle that go with those of the place.
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
    std::size_t frames = 0, outliers = 0;  ///< that count, and that lie off a line which goes on behind them
    std::vector<FilmFrame> kept;  ///< those that count, outliers left out, the angle unwound: arcs' first and last
    Drags drags;                  ///< of all arcs
    FloorMotion floor;
    UniformFall fall;
    Eigen::Vector3d least_noise = Eigen::Vector3d::Zero();  ///< as it was given
    /// Standard deviations of accelerations of free arcs that the model does not have; 0: as far as can be seen.
    Eigen::Vector3d wandering = Eigen::Vector3d::Zero();
    double impact_time = 0;  ///< impacts last so long, or are that far from where arcs meet: an error of their times

    /// Of the body on the arc, in the laboratory.
    Eigen::Vector3d place_on(const FreeArc& arc, double time) const {
        return arc.at(time) + floor.carried(time, drags.places) + fall.place(time, drags.places);
    }
    Eigen::Vector3d velocity_on(const FreeArc& arc, double time) const {
        return arc.velocity_at(time) + floor.carried_velocity(time, drags.places) + fall.velocity(time, drags.places);
    }
};

struct ArcOptions {
    Drags drags;
    FloorMotion floor;
    Eigen::Vector3d least_noise = Eigen::Vector3d::Zero();  ///< σ of x, y and θ is taken for no less
    UniformFall fall = {};
    /// Frames are divided as if σ were no less than this: where arcs bend by more than noise for reasons of their own,
    /// a larger one leaves them whole. The film's noise is that of its arcs, as ever.
    Eigen::Vector3d division_noise = Eigen::Vector3d::Zero();
};

/// The sequence of lines with the least Σ (residuals/σ)² + `cost_of_arc` · (lines): dynamic programming over the
/// frames, candidates pruned that can't win any more (PELT: Killick, Fearnhead & Eckley, J. Am. Stat. Assoc. 107 (2012)
/// 1590). σ starts from a lower quantile of how far frames lie off the line of their neighbours, where kinks do not
/// reach, and is then that of the residuals on lines of many frames. Up to two frames between parts of one line are
/// outliers. `period` is that of the angle; turns from frame to frame are less than half of it, after lost frames near
/// to what the last turn leads to. Times rise. With a drag lines are those of FloorMotion, with gravity parabolas.
/// O(frames × frames on an arc).
FilmArcs fit_arcs(std::span<const FilmFrame> frames, double period, const ArcOptions& options = {});

/// The same arcs, each fitted to its frames with other drags. O(frames).
FilmArcs with_drags(const FilmArcs& film, const Drags& drags);
/// With another gravity, too.
FilmArcs with_fall(const FilmArcs& film, const Eigen::Vector2d& gravity, const Drags& drags);

/// The same arcs without the frame next to either end, of those of `fewest_trimmed` or more: a tracker sees an impact
/// that lasts, or while its shutter is open, beside both arcs. Of an arc of more frames than `longest` there are then
/// two, its first frames and its last ones, with no kink between them: where arcs bend otherwise than the model has it,
/// velocities at their ends are those near the ends. O(frames).
FilmArcs end_pieces(const FilmArcs& film, std::size_t longest);
inline constexpr std::size_t fewest_trimmed = 7;

/// The same arcs, the noise being that of some of them. As it was where these tell none.
///   counts  of each arc
FilmArcs with_noise_of(const FilmArcs& film, const std::vector<bool>& counts);

/// Per line: beyond χ² of some 10 that noise reaches for one more line and a place of its kink.
inline constexpr double cost_of_arc = 25;
/// What fit_arcs makes least, of any division and noise (σ of x or y, and of θ); an outlier costs a line.
double cost_of_division(const FilmArcs& film, double place_noise, double angle_noise);
/// So many lost frames are bridged.
inline constexpr double longest_gap = 3.5;

/// Where two neighbouring lines meet: the time at which their distance, in units of its errors, is least. Place and
/// velocities are the body's, in the laboratory.
struct Kink {
    std::size_t before = 0;  ///< the arc; the next one is that after
    double time = nan, error = nan;
    double earliest = nan, latest = nan;  ///< the frames about it
    Eigen::Vector3d place = Eigen::Vector3d::Constant(nan);
    double share = nan;                                                ///< variance of the place in units of σ²
    Eigen::Vector3d velocity_before = Eigen::Vector3d::Constant(nan);  ///< at its time
    Eigen::Vector3d velocity_after = Eigen::Vector3d::Constant(nan);
    Eigen::Vector3d change = Eigen::Vector3d::Constant(nan);  ///< of the velocity, after − before
    double change_share = nan;                                ///< its variance in units of σ²
    Eigen::Vector3d drift = Eigen::Vector3d::Constant(nan);   ///< of the place by time: what an error of this moves it
    double distance = nan;  ///< squared, of the lines there, in units of its errors: χ²(2) if one impact lies between
    /// For how long the change of the velocity makes that distance, beyond what noise does of it; squared, below 0 by
    /// noise.
    double apart_for = nan;
};

/// Kinks of lines with `fewest_frames` or more on both, none across gaps.
std::vector<Kink> kinks_of(const FilmArcs& film);
/// That of two lines of the film, or of others as long.
Kink kink_between(const FilmArcs& film, const FreeArc& before, const FreeArc& after);
inline constexpr std::size_t fewest_frames = 3;

}  // namespace swirl::analysis
