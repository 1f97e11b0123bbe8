// One orbit while a parameter of the scene changes slowly, up and down: the hysteresis loop as a bench sees it.
//
// Formula: p(t) = A + (B − A) t/T on the way up, back again on the way down, t from the end of the transient on. An
// impact at time t takes the scene's value to p(t), at which it stays until the next impact: z_{n+1} = F(z_n; p(t_n)).
// So the value that a flight has is behind p by at most the rate times its duration, |dp/dt| τ, and so is what the
// value does at the impact that ends it (e, μ); the largest is in `lag` of a window. (A swirl whose β changes also
// moves the wall by dβ/dt along O, which is neglected: a velocity of the order of the rate beside β.) A change of β
// moves the wall at an impact with the body on it, ψ, χ and the laboratory's velocities as they are; where the wall's
// new velocity would meet the body, u_n > 0, the wall takes it along: v_n is lessened to u_n = 0, by |δβ| at most.
// Chatter that lands counts as one impact (chatter_once.hpp), in which p stands still.
#pragma once

#include "analysis/continuation/branch.hpp"
#include "analysis/means/mean_error.hpp"
#include "analysis/ramps/kept_period.hpp"
#include "apps/studies/branches/branches.hpp"
#include "apps/studies/noise/impact_noise.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/parameter_range.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/orbit/outcome.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::ramps {

struct RampSettings {
    Scene<double> scene;                 ///< at any value of the parameter
    ParameterRange along;                ///< from A to B; `falling` where A > B
    double duration = 0;                 ///< T of one way, in 1/ω_s
    std::int64_t ways = 1;               ///< there, back, there …
    std::int64_t windows = 100;          ///< of each way, of equal durations
    std::int64_t samples = 16;           ///< the last so many impacts of each are kept
    std::int64_t transient = 2500;       ///< impacts at A before
    analysis::KeptPeriodOptions period;  ///< by which modes are seen
    Accuracy accuracy = Accuracy::double_precision;
    ImpactNoise noise;  ///< with it chatter that lands is not counted once: its rebounds differ

    double begin() const { return along.falling ? along.high : along.low; }
    double end() const { return along.falling ? along.low : along.high; }
    double rate() const { return (along.high - along.low) / duration; }
};

/// Why a parameter can't change while the body moves; empty: it can. (Which can: β, μ, e, e_t, drag.)
std::string why_not_ramped(const std::string& name);

/// What was seen of a part of a way. An impact belongs to the window in which its flight ended.
struct RampWindow {
    std::int64_t way = 0;  ///< 0, 1, …
    bool rising = true;    ///< does the parameter rise on this way?
    double parameter = 0;  ///< in the middle of the window
    double begin = 0, end = 0;
    std::int64_t impacts = 0;
    double mean_spin = 0;       ///< ∫ S dt / t over its flights
    analysis::MeanError error;  ///< of it
    std::int64_t period = 0;    ///< that was kept all through it; 0: none, or it changed
    SectionPoint<double> last;  ///< after its last impact
    double lag = 0;             ///< the largest |p(t) − value| at the end of a flight
    std::int64_t taken = 0;     ///< impacts after which the wall took the body along
};

struct RampSample {
    std::int64_t way = 0;
    bool rising = true;
    double parameter = 0;  ///< p(t) at the impact
    double t = 0;
    SectionPoint<double> point;
};

/// A mode that was kept and left.
struct RampMode {
    std::int64_t way = 0;  ///< on which it was left; the last way, where it was not
    bool rising = true;
    std::int64_t period = 0;
    double kept_from = 0;  ///< p where it was seen to be kept
    double kept_at = 0;    ///< t there
    bool left = false;     ///< false: it was kept to the end
    double left_at = 0;    ///< p there
    double time = 0;       ///< t there
    std::int64_t impact = 0;
    double round = 0;      ///< duration of its last round
    double mean_spin = 0;  ///< over its last round
    double seen_at = 0;    ///< p at `points`
    std::vector<Eigen::VectorXd>
        points;  ///< one round, at the end of the first window that it filled, or as it was kept
};

struct Ramp {
    std::vector<RampWindow> windows;  ///< those that had impacts
    std::vector<RampSample> samples;
    std::vector<RampMode> modes;  ///< in the order in which they were kept
    Outcome outcome = Outcome::completed;
    bool interrupted = false;
    std::int64_t impacts = 0;  ///< after the transient
    double time = 0;           ///< since then
    double parameter = 0;      ///< reached
};

/// Follows one orbit. A pure function of its arguments, if it is not stopped. Cost: a step of the map and a body made
/// anew, 0.45 µs an impact of a hexagon; where rebounds may come one step more is among them.
/// @throws std::invalid_argument for a scene or start out of range, at either end of the range
Ramp run_ramp(const RampSettings& settings, const Start<double>& start, const RunControl& control = {});

/// Where the branch of a mode that was left ends, in the direction in which the parameter went.
struct BranchEnd {
    std::string kind;      ///< of the special point, or why the branch ends (`range`); empty: no branch was found
    double parameter = 0;  ///< NaN without
    double delay = 0;      ///< how far beyond it the mode was left; < 0: before it; NaN: not left, or `range`
    double predicted = 0;  ///< by fold_delay with the tolerance, of a fold with a normal form; else NaN
};

struct RampBranches {
    SceneBranches scene;
    std::vector<analysis::Branch> branches;  ///< each once
    std::vector<BranchEnd> ends;             ///< of each of the modes
};

/// Continues the cycles of the modes over the range of the ramp; of more than fifty those that were kept longest.
RampBranches continue_modes(const RampSettings& settings, const RunControl& control, const Ramp& ramp);

}  // namespace swirl::studies::ramps
