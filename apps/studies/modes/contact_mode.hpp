// The mode of an orbit that has come to stay on the wall.
#pragma once

#include "analysis/classification/classify.hpp"
#include "analysis/classification/swing.hpp"
#include "map/contact/rim_pendulum.hpp"
#include "map/orbit/bent_flight.hpp"
#include "map/orbit/return_map.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace swirl::studies {

/// S that stays within this is constant: a body at rest in the co-rotating frame, or one that nothing turns.
constexpr double rest_of_spin = 1e-7;

/// What was seen of a contact that lasts: the second half of the time that it was followed.
class ContactTail {
public:
    ///   scene  of which `contact` is what contact needs
    ContactTail(const Scene<double>& scene, const ContactScene<double>& contact, double followed);

    /// A ContactSink.
    void add(const ContactSums<double>& sums, Support support, ContactMotion motion, const ContactState<double>& state);

    /// Fills mode, kind, mean S and evidence. At rest in the co-rotating frame, or S constant: rolling, steady;
    /// swinging or turning on with a period, or settling on one: quasi-steady; slipping, unless that dies out: sliding;
    /// on an edge: two-vertex (both steady if S is constant); else undecided. A rolling disk whose slip dies out is
    /// named by the pendulum that it settles on (settled_pendulum), and its mean S is that pendulum's. Over a floor
    /// that drags a rolling disk that has turned back once does so for ever less, and comes to rest: rolling, S = −ρ/α;
    /// one without friction ceases to turn. A body that a dish's dry friction holds: riding, steady, S = 0.
    /// @return true if nothing changes any more: a longer look would show the same
    bool judge(analysis::Classification& verdict) const;
    double followed() const { return followed_; }

private:
    double friction(Support support, ContactMotion motion, const ContactState<double>& state) const;
    void note_rolling(double share, const ContactState<double>& state);
    std::optional<double> spin_over_floor() const;
    bool judge_rest(analysis::Classification& verdict) const;
    bool judge_over_floor(const analysis::Swing& swing, analysis::Classification& verdict) const;
    bool was_cut() const;  ///< contact was not followed as far as was asked for
    bool slip_dies() const;
    std::optional<RimPendulum> settles_on(const analysis::Swing& swing) const;
    void describe(const analysis::Swing& swing, const std::optional<RimPendulum>& settled,
                  analysis::Classification& verdict) const;

    ContactScene<double> scene_;
    BendContact over_dry_floor_;  ///< empty without one
    double followed_;
    std::vector<analysis::SwingSample> samples_;
    double last_time_ = 0;
    double slip_early_ = 0, slip_late_ = 0;  ///< what slip dissipates in the first and the last quarter of that half
    double last_loss_ = 0;                   ///< |f u_t| at the last look
    std::optional<ContactState<double>> rolling_;  ///< where a disk rolled last
    /// The least energy (RimPendulum) with which a disk rolled in the first and the last quarter.
    double height_early_ = std::numeric_limits<double>::infinity();
    double height_late_ = std::numeric_limits<double>::infinity();
    bool slides_ = false;
    bool on_edge_ = true;
};

}  // namespace swirl::studies
