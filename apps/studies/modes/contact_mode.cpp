#include "apps/studies/modes/contact_mode.hpp"

#include "map/orbit/dry_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace swirl::studies {

namespace {

using analysis::in_words;

constexpr double rest = rest_of_spin;  // an angle that stays within this is at rest, too
constexpr double regular = 1e-5;       // periods that agree to this make a motion periodic
constexpr double nearly = 1e-2;        // so near must the limit of periods that still change be, relative
constexpr double dying = 0.9;          // slip dies out if what it loses falls by this from first to last quarter
constexpr int enough_periods = 3;

/// Where S is constant and psi turns all the same there is no swirl, or none that shows: the body rolls on evenly.
analysis::Kind kind_of(analysis::SwingKind swing, bool slides, bool on_edge, bool constant) {
    using analysis::Kind, analysis::SwingKind;
    if (swing == SwingKind::irregular) return Kind::transient;
    if (on_edge) return Kind::two_vertex;
    if (slides) return Kind::sliding;
    if (swing == SwingKind::at_rest || constant) return Kind::rolling;
    return swing == SwingKind::librating ? Kind::rolling_librating : Kind::rolling_circulating;
}

void describe_periods(const analysis::Swing& swing, bool limit_known, analysis::Classification& verdict) {
    const bool enough = swing.periods >= enough_periods;
    verdict.evidence.push_back({"periods seen", static_cast<double>(swing.periods), enough_periods,
                                enough ? "these are enough to compare" : "these are too few to call psi periodic",
                                enough ? "fewer than " + std::to_string(enough_periods) + ": undecided"
                                       : "at least " + std::to_string(enough_periods) + ": their spread decides"});
    if (!enough) return;
    const bool periodic = swing.period_spread <= regular;
    verdict.evidence.push_back(
        {"spread of the periods", swing.period_spread, regular,
         periodic ? "psi is periodic" : "psi is not periodic so far",
         periodic ? "above " + in_words(regular) + ": not periodic; whether the periods come to a limit decides"
                  : "at most " + in_words(regular) + ": periodic"});
    if (periodic || limit_known) return;
    const bool settles = swing.still_to_come <= nearly;
    verdict.evidence.push_back(
        {"change of the period still to come", swing.still_to_come, nearly,
         settles ? "the periods' changes fall like n^-" + in_words(swing.settling_exponent) + ": they come to a limit"
                 : "the periods still change, and their limit is unknown",
         settles ? "above " + in_words(nearly) + ": undecided, since psi still settles"
                 : "at most " + in_words(nearly) + ": the mode is that of the motion that psi settles on"});
}

}  // namespace

ContactTail::ContactTail(const Scene<double>& scene, const ContactScene<double>& contact, double followed)
    : scene_(contact), over_dry_floor_(dry_paths(scene).contact), followed_(followed) {}

double ContactTail::friction(Support support, ContactMotion motion, const ContactState<double>& state) const {
    return over_dry_floor_ ? over_dry_floor_(support, motion, state, 0).friction
                           : reaction_of(scene_, support, motion, state).friction;
}

void ContactTail::add(const ContactSums<double>& sums, Support support, ContactMotion motion,
                      const ContactState<double>& state) {
    const double from = std::max(last_time_, 0.5 * followed_);
    const double share = 2 * (sums.time / followed_) - 1;  // of the tail, 0 to 1
    const bool slips = motion != ContactMotion::sticking;
    const double loss = slips ? std::abs(friction(support, motion, state) * state.ut) : 0;
    if (slips && sums.time > from) {
        const double lost = 0.5 * (last_loss_ + loss) * (sums.time - from);
        if (share <= 0.25) slip_early_ += lost;
        if (share > 0.75) slip_late_ += lost;
        slides_ = true;
    }
    last_time_ = sums.time;
    last_loss_ = loss;
    if (!slips && support == Support::rim && !scene_.floor.drags && !over_dry_floor_) note_rolling(share, state);
    if (sums.time < 0.5 * followed_) return;
    samples_.push_back({sums.time, state.psi, normal_rate(scene_, support, state) - 1, state.spin, sums.turned});
    on_edge_ = on_edge_ && support == Support::edge;
}

void ContactTail::note_rolling(double share, const ContactState<double>& state) {
    rolling_ = state;
    if (share < 0) return;
    const double height = rim_pendulum(scene_, state).height;
    if (share <= 0.25) height_early_ = std::min(height_early_, height);
    if (share > 0.75) height_late_ = std::min(height_late_, height);
}

bool ContactTail::was_cut() const {
    return followed_ < contact_horizon * (1 - 1e-12);
}

/// Without friction slip loses nothing and lasts.
bool ContactTail::slip_dies() const {
    return scene_.mu > 0 && slip_late_ <= dying * slip_early_;
}

/// The pendulum that a disk settles on which still slips now and then: it loses energy and the pendulum is near. (The
/// work of slips that are few and small is no measure: a quarter may hold one more of them than another.)
std::optional<RimPendulum> ContactTail::settles_on(const analysis::Swing& swing) const {
    if (!slides_ || !rolling_ || height_late_ > height_early_ * (1 + 1e-12) || swing.periods < enough_periods)
        return {};
    const auto settled = settled_pendulum(scene_, rim_pendulum(scene_, *rolling_));
    if (!settled) return {};
    const double mean = mean_rolling_spin(scene_, *settled);
    return std::abs(swing.mean - mean) <= nearly * std::max(1.0, std::abs(mean)) ? settled : std::nullopt;
}

/// S to which the drag brings a disk that it still slows. With E = ½(1 + κ)ρψ′² plus the swirl's and the drag's
/// potentials, E′ = −(γ + κγ_r)ρψ′²: a disk that rolls and turns back is in a well, and swings less and less about its
/// bottom, where ψ′ = 0. Nothing of others.
std::optional<double> ContactTail::spin_over_floor() const {
    if (!scene_.floor.drags || !scene_.is_disk() || was_cut()) return {};
    if (scene_.mu == 0) return scene_.floor.spin_drag > 0 ? std::optional(0.0) : std::nullopt;
    const auto goes = [&](int sign) {
        return std::any_of(samples_.begin(), samples_.end(),
                           [&](const analysis::SwingSample& sample) { return sign * sample.rate > 0; });
    };
    return !slides_ && goes(1) && goes(-1) ? std::optional(-scene_.body.inner / scene_.body.alpha) : std::nullopt;
}

bool ContactTail::judge_over_floor(const analysis::Swing& swing, analysis::Classification& verdict) const {
    const std::optional<double> spin = spin_over_floor();
    if (!spin) return false;
    verdict.kind = scene_.mu > 0 ? analysis::Kind::rolling : analysis::Kind::sliding;
    verdict.mode = analysis::Mode::steady;
    verdict.mean = *spin;
    verdict.evidence.push_back({"time in contact", followed_, contact_horizon,
                                "there was no impact: the body stays on the wall",
                                "an impact before that: the orbit of its impacts gives the mode"});
    verdict.evidence.push_back({"range of S", swing.range, rest,
                                scene_.mu > 0 ? "the drag takes what is left of the swing about the place of rest"
                                              : "without friction the drag alone changes S, until it is 0",
                                "no drag: quasi-steady, if periodic"});
    return true;
}

bool ContactTail::judge_rest(analysis::Classification& verdict) const {
    const bool rests = over_dry_floor_ && !samples_.empty() &&
                       std::all_of(samples_.begin(), samples_.end(), [](const analysis::SwingSample& sample) {
                           return sample.rotation == 0 && sample.rate == -1;
                       });
    if (!rests) return false;
    verdict.kind = analysis::Kind::riding;
    verdict.mode = analysis::Mode::steady;
    verdict.mean = 0;
    verdict.evidence.push_back({"room at the wall", 0, 0, "friction holds the body against the dish, at its wall",
                                "more pull than friction holds: it is torn loose"});
    return true;
}

bool ContactTail::judge(analysis::Classification& verdict) const {
    using analysis::Kind, analysis::Mode;
    if (judge_rest(verdict)) return true;
    const analysis::Swing swing = analysis::judge_swing(samples_, rest, regular, nearly);
    if (judge_over_floor(swing, verdict)) return true;
    const auto settled = settles_on(swing);
    const bool constant = swing.range <= rest;
    verdict.kind = settled && !constant ? (settled->turns() ? Kind::rolling_circulating : Kind::rolling_librating)
                                        : kind_of(swing.kind, !settled && slides_ && !slip_dies(), on_edge_, constant);
    // Slip that goes on when no more was followed has not shown what it leads to.
    if (!settled && was_cut() && scene_.mu > 0 && slides_ && !slip_dies()) verdict.kind = Kind::transient;
    verdict.mode = verdict.kind == Kind::transient ? Mode::undecided : constant ? Mode::steady : Mode::quasi_steady;
    verdict.mean = settled ? mean_rolling_spin(scene_, *settled) : swing.mean;
    describe(swing, settled, verdict);
    if (swing.kind == analysis::SwingKind::at_rest) return true;
    return verdict.mode != Mode::undecided && swing.period_spread <= regular;
}

void ContactTail::describe(const analysis::Swing& swing, const std::optional<RimPendulum>& settled,
                           analysis::Classification& verdict) const {
    const bool constant = swing.range <= rest;
    const bool cut = was_cut();
    verdict.evidence.push_back(
        {"time in contact", followed_, contact_horizon,
         cut ? "there was no impact, but the motion on the wall is too fast to be followed further"
             : "there was no impact: the body stays on the wall",
         "an impact before that: the orbit of its impacts gives the mode"});
    verdict.evidence.push_back({"range of S", swing.range, rest, constant ? "S is constant" : "S varies",
                                constant ? "above " + in_words(rest) + ": quasi-steady, if periodic"
                                         : "at most " + in_words(rest) + ": steady"});
    if (settled) {
        verdict.evidence.push_back({"energy of rolling, last quarter", height_late_, height_early_,
                                    "slip takes energy (threshold: the first quarter's)",
                                    "above " + in_words(height_early_) + ": the work of slip decides"});
    } else if (slides_) {
        const double limit = dying * slip_early_;
        verdict.evidence.push_back(
            {"work of slip, last quarter", slip_late_, limit, slip_dies() ? "slip dies out" : "slip goes on",
             slip_dies() ? "above " + in_words(limit) + ": sliding"
                         : "at most " + in_words(limit) + ": rolling in the end, since slip dies out"});
    }
    if (swing.kind == analysis::SwingKind::at_rest) return;
    describe_periods(swing, settled.has_value(), verdict);
    if (!settled) return;
    const double mean = mean_rolling_spin(scene_, *settled), allowed = nearly * std::max(1.0, std::abs(mean));
    verdict.evidence.push_back({"change of mean S still to come", std::abs(swing.mean - mean), allowed,
                                "psi settles on the pendulum on which friction just holds; mean S is that pendulum's",
                                "above " + in_words(allowed) + ": undecided, since psi still settles"});
}

}  // namespace swirl::studies
