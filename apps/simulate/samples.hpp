// The orbit at equal steps of time, in flight and in contact.
#pragma once

#include "apps/command_line/interruption.hpp"
#include "map/orbit/trajectory_segment.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::apps::simulate {

struct SampleRow {
    double t = 0, x = 0, y = 0, angle = 0, spin = 0;
    bool in_contact = false;
    double normal_force = 0, friction = 0, slip = 0;  ///< of the wall, as of a Moment; NaN in flight
};

/// The shortest time between samples: the samples of 10⁹ time units can be counted.
inline constexpr double least_sample_step = 1e-9;

/// Samples at the multiples of a time step; at an impact, just before it.
class Sampler {
public:
    explicit Sampler(double step) : step_(step) {}

    /// Passes on the samples of these segments up to `until`; successive calls take successive segments.
    template <class Use>
    void take(const ContactScene<double>& scene, std::span<const TrajectorySegment> trajectory, double until,
              const Use& use) {
        for (const TrajectorySegment& segment : trajectory)
            for (; time() <= segment.end && time() <= until; ++next_) {
                if (next_ % 1024 == 0 && is_interrupted()) return;
                if (time() < segment.start) continue;
                const Moment now = moment_at(scene, segment, time());
                use(SampleRow{time(), now.centre.x, now.centre.y, now.angle, now.spin, segment.in_contact,
                              now.normal_force, now.friction, now.slip});
            }
    }
    /// Leaves out all before a time.
    void pass_over(double until) { next_ = static_cast<std::int64_t>(std::ceil(until / step_)); }

private:
    double time() const { return static_cast<double>(next_) * step_; }

    double step_;
    std::int64_t next_ = 0;
};

}  // namespace swirl::apps::simulate
