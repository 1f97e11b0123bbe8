// The collision map, with sustained contact, as the page of `swirl explore` calls it: compiled to WebAssembly by
// build_map.py, and nowhere else. Numbers pass through one array of doubles, `exchange`.
//
// Nothing is thrown here: what the map would refuse is refused before, by a return value.

#include "map/contact/contact_state.hpp"
#include "map/orbit/orbit.hpp"
#include "map/orbit/trajectory_segment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace {

using namespace swirl;

static_assert(std::numeric_limits<long double>::digits == 113);  // rounded_to_64.hpp

constexpr int numbers_of_impact = 16;
constexpr int most_impacts = 4096;  ///< of one call
constexpr int numbers_of_moment = 6;
constexpr double longest_contact_step = 0.04;  ///< in 1/ω_s: the page joins moments in contact by straight lines

double exchange[numbers_of_impact * most_impacts];

/// One orbit of one scene.
class Follower {
public:
    virtual ~Follower() = default;
    /// In the laboratory, at t = 0.
    virtual void start(const LabStart<double>& start) = 0;
    /// To just after the next impact, whose numbers go to `row`. False if there is none.
    virtual bool advance(double* row) = 0;
    virtual Outcome outcome() const = 0;
    /// The way since the impact before: moments t, x, y, angle, S, in contact (1) or in flight (0).
    virtual const std::vector<double>& way() const = 0;
};

template <class Map>
class FollowerOf final : public Follower {
public:
    FollowerOf(const Scene<double>& scene, const Body<double>& similar) : map_(scene, &similar) {}

    void start(const LabStart<double>& start) override {
        orbit_.emplace(map_, start);
        segmenter_.emplace(map_.scene(), start);
        sink_ = segmenter_->sink();
        way_.clear();
    }

    bool advance(double* row) override {
        const bool struck = orbit_->advance(contact_horizon, sink_);
        way_.clear();
        for (const TrajectorySegment& segment : segmenter_->passed(*orbit_, struck)) add(segment);
        if (struck) write(row);
        return struck;
    }

    Outcome outcome() const override { return orbit_->outcome(); }
    const std::vector<double>& way() const override { return way_; }

private:
    void add(const TrajectorySegment& segment) {
        const double lasts = segment.end - segment.start;
        const int steps =
            segment.in_contact ? std::max(1, static_cast<int>(std::ceil(lasts / longest_contact_step))) : 1;
        for (int i = 0; i <= steps; ++i) {
            const double t = i == steps ? segment.end : segment.start + lasts * i / steps;
            const Moment moment = moment_at(segmenter_->scene(), segment, t);
            way_.insert(way_.end(), {t, moment.centre.x, moment.centre.y, moment.angle, moment.spin,
                                     segment.in_contact ? 1.0 : 0.0});
        }
    }

    void write(double* row) const {
        const LabState<double> lab = orbit_->lab();
        const SectionPoint<double> z = section_point(orbit_->post_impact());
        const Collision<double>& collision = orbit_->collision();
        const double numbers[numbers_of_impact] = {lab.t,
                                                   lab.x,
                                                   lab.y,
                                                   lab.vx,
                                                   lab.vy,
                                                   lab.angle,
                                                   lab.spin,
                                                   static_cast<double>(orbit_->frame().vertex),
                                                   z.psi,
                                                   z.chi,
                                                   z.vn,
                                                   z.vt,
                                                   collision.flight_time,
                                                   collision.impulse.normal,
                                                   collision.impulse.tangential,
                                                   static_cast<double>(collision.impulse.mode)};
        std::copy(std::begin(numbers), std::end(numbers), row);
    }

    Map map_;
    std::optional<Orbit<Map>> orbit_;
    std::optional<TrajectorySegmenter> segmenter_;
    ContactSink sink_;
    std::vector<double> way_;
};

std::unique_ptr<Follower> follower;

template <Shape shape, ImpactRule rule>
std::unique_ptr<Follower> follower_by(const Scene<double>& scene, const Body<double>& similar) {
    return std::make_unique<FollowerOf<CollisionMap<double, shape, rule>>>(scene, similar);
}

std::unique_ptr<Follower> follower_of(const Scene<double>& scene, const Body<double>& similar) {
    const bool frictionless = scene.mu == 0;
    if (scene.is_disk())
        return frictionless ? follower_by<Shape::disk, ImpactRule::frictionless>(scene, similar)
                            : follower_by<Shape::disk, ImpactRule::poisson>(scene, similar);
    if (frictionless) return follower_by<Shape::polygon, ImpactRule::frictionless>(scene, similar);
    if (scene.law == Law::newton) return follower_by<Shape::polygon, ImpactRule::newton>(scene, similar);
    if (scene.law == Law::stronge) return follower_by<Shape::polygon, ImpactRule::stronge>(scene, similar);
    return follower_by<Shape::polygon, ImpactRule::poisson>(scene, similar);
}

bool is_in_range(const Scene<double>& scene) {
    return (scene.is_disk() || (scene.sides >= 3 && scene.sides <= Body<double>::table_limit)) && scene.alpha > 0 &&
           scene.alpha < 1 && detail::is_holdable(scene.alpha) && scene.beta >= 0 && detail::is_holdable(scene.beta) &&
           scene.mu >= 0 && detail::is_holdable(scene.mu) && scene.restitution >= 0 && scene.restitution <= 1 &&
           scene.inertia_factor > 0 && detail::is_holdable(scene.inertia_factor);
}

/// The vertices' directions as the native program has them (`VertexTable`), from `exchange`: four numbers for each.
std::shared_ptr<const VertexTable<double>> table_given(int sides) {
    auto table = std::make_shared<VertexTable<double>>();
    for (int k = 0; k < sides; ++k) {
        const double* entry = exchange + std::ptrdiff_t{4} * k;
        table->directions.push_back({entry[0], entry[1]});
        table->rests.push_back({entry[2], entry[3]});
    }
    return table;
}

}  // namespace

extern "C" {

double* swirl_exchange() {
    return exchange;
}

/// 1 if the scene is within its ranges, else 0. `exchange` holds the vertices' directions.
///   law  0 Poisson, 1 Newton, 2 Stronge
int swirl_scene(int sides, int law, double alpha, double beta, double mu, double restitution, double inertia_factor) {
    const Scene<double> scene{sides, alpha, beta, mu, restitution, static_cast<Law>(law), inertia_factor};
    follower.reset();
    if (!is_in_range(scene) || law < 0 || law > 2) return 0;
    Body<double> similar;
    similar.sides = sides;
    if (!scene.is_disk()) similar.table = table_given(sides);
    follower = follower_of(scene, similar);
    return 1;
}

/// 1 if there is a scene and the circumscribed circle lies within the container, else 0.
int swirl_start(double beta, double alpha, double x, double y, double vx, double vy, double angle, double spin) {
    const double values[] = {x, y, vx, vy, angle, spin};
    const bool finite = std::all_of(std::begin(values), std::end(values),
                                    [](double value) { return std::fabs(value) <= detail::largest_magnitude; });
    if (!follower || !finite ||
        !detail::is_holdable(std::max({std::fabs(vx), std::fabs(vy), alpha * std::fabs(spin)})) ||
        !(std::sqrt((x - beta) * (x - beta) + y * y) + alpha <= 1))
        return 0;
    follower->start({x, y, vx, vy, angle, spin});
    return 1;
}

/// Follows so many impacts, whose rows fill `exchange`: t, x, y, vx, vy, angle, S, vertex, psi, chi, vn, vt, flight
/// time, p, q, contact mode. Gives how many there were: fewer than asked for where the orbit ends (`swirl_outcome`).
int swirl_run(int impacts) {
    int made = 0;
    while (made < std::min(impacts, most_impacts) &&
           follower->advance(exchange + std::ptrdiff_t{numbers_of_impact} * made))
        ++made;
    return made;
}

int swirl_outcome() {
    return static_cast<int>(follower->outcome());
}

/// The way to the last impact: its moments, six numbers each, and how many there are.
const double* swirl_way() {
    return follower->way().data();
}
int swirl_moments() {
    return static_cast<int>(follower->way().size()) / numbers_of_moment;
}
}
