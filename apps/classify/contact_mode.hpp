// The mode of an orbit that has come to stay on the wall.
#pragma once

#include "analysis/classification/classify.hpp"
#include "analysis/classification/swing.hpp"
#include "map/sustained/return_map.hpp"

namespace swirl::apps {

/// What was seen of a contact that lasts: the second half of the time that it was followed.
class ContactTail {
public:
    ContactTail(const ContactScene& scene, double followed) : scene_(scene), followed_(followed) {}

    /// A ContactSink.
    void add(const ContactSums& sums, Support support, ContactMotion motion, const ContactState& state);

    /// Fills mode, kind, mean S and evidence. At rest in the co-rotating frame: rolling, steady; swinging or turning on
    /// with a period, or settling on one: quasi-steady (steady if S is constant all the same); slipping, unless that
    /// dies out: sliding; on an edge: two-vertex; else undecided.
    /// @return true if nothing changes any more: a longer look would show the same
    bool judge(analysis::Classification& verdict) const;
    double followed() const { return followed_; }

private:
    ContactScene scene_;
    double followed_;
    std::vector<analysis::SwingSample> samples_;
    double last_time_ = 0;
    double slip_early_ = 0, slip_late_ = 0;  ///< time spent slipping in the first and the last quarter of that half
    bool slides_ = false;
    bool on_edge_ = true;
};

}  // namespace swirl::apps
