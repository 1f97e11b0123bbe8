#include "apps/classify/contact_mode.hpp"

namespace swirl::apps {

namespace {

constexpr double rest = 1e-7;        // an angle and S that stay within this are at rest
constexpr double regular = 1e-5;     // periods that agree to this make a motion periodic

analysis::Kind kind_of(analysis::SwingKind swing, bool slides, bool on_edge) {
    using analysis::Kind, analysis::SwingKind;
    if (swing == SwingKind::irregular) return Kind::transient;
    if (on_edge) return Kind::two_vertex;
    if (slides) return Kind::sliding;
    if (swing == SwingKind::at_rest) return Kind::rolling;
    return swing == SwingKind::librating ? Kind::rolling_librating : Kind::rolling_circulating;
}

}  // namespace

void ContactTail::add(const ContactSums& sums, Support support, ContactMotion motion, const ContactState& state) {
    if (sums.time < 0.5 * followed_) return;
    samples_.push_back({sums.time, state.psi, normal_rate(scene_, support, state) - 1, state.spin, sums.turned});
    slides_ = slides_ || motion != ContactMotion::sticking;
    on_edge_ = on_edge_ && support == Support::edge;
}

void ContactTail::judge(analysis::Classification& verdict) const {
    using analysis::Mode;
    const analysis::Swing swing = analysis::judge_swing(samples_, rest, regular);
    verdict.kind = kind_of(swing.kind, slides_, on_edge_);
    const bool constant = swing.range <= rest;
    verdict.mode = verdict.kind == analysis::Kind::transient ? Mode::undecided
                 : constant                                  ? Mode::steady
                                                             : Mode::quasi_steady;
    verdict.mean = swing.mean;
    verdict.evidence.push_back({"time in contact", followed_, contact_horizon, "no impact: the body stays on the wall"});
    verdict.evidence.push_back({"range of S", swing.range, rest, constant ? "S is constant" : "S varies"});
    if (swing.kind == analysis::SwingKind::at_rest) return;
    verdict.evidence.push_back({"periods seen", static_cast<double>(swing.periods), 3,
                                swing.periods >= 3 ? "enough to compare" : "too few to call it periodic"});
    verdict.evidence.push_back({"spread of the periods", swing.period_spread, regular,
                                swing.period_spread <= regular ? "psi is periodic" : "psi is not periodic (yet)"});
}

}  // namespace swirl::apps
