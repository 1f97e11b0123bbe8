// An orbit of a scene, impact by impact, in one number type, whatever the shape and impact rule: what follows orbits is
// compiled once a number type, and the maps behind it once in all (orbit_by_map.hpp).
#pragma once

#include "apps/studies/scene_map/start.hpp"
#include "map/baselines/baseline_contact.hpp"
#include "map/orbit/orbit.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies {

/// What an orbit is asked, whatever its map.
template <class T>
class OrbitOfScene {
public:
    OrbitOfScene() = default;
    OrbitOfScene(const OrbitOfScene&) = delete;
    OrbitOfScene& operator=(const OrbitOfScene&) = delete;
    virtual ~OrbitOfScene() = default;

    virtual bool advance(double horizon, const ContactSink& sink) = 0;
    virtual const ReturnStep<T>& return_step() const = 0;
    virtual const LabFrame<T>& frame() const = 0;
    virtual Outcome outcome() const = 0;
    virtual long long impacts() const = 0;
};

/// Orbit of the scene's map, which it owns.
template <class T>
class SceneOrbit {
public:
    ///   search  in place of the exact one (map/baselines), in double only
    /// @throws std::invalid_argument for a scene or start out of range
    SceneOrbit(const Scene<T>& scene, const Start<T>& start, const std::optional<BaselineSearch>& search = {});

    /// One that is followed otherwise (noise/impact_noise.hpp).
    SceneOrbit(const Scene<T>& scene, std::unique_ptr<OrbitOfScene<T>> orbit)
        : orbit_(std::move(orbit)), body_(make_body(scene)) {}

    /// As Orbit::advance, and so are those below.
    bool advance(double horizon = contact_horizon, const ContactSink& sink = {}) {
        return orbit_->advance(horizon, sink);
    }

    const Body<T>& body() const { return body_; }
    const ReturnStep<T>& return_step() const { return orbit_->return_step(); }
    const LabFrame<T>& frame() const { return orbit_->frame(); }
    Outcome outcome() const { return orbit_->outcome(); }
    long long impacts() const { return orbit_->impacts(); }

    const Collision<T>& collision() const { return return_step().collision; }
    const PostImpactState<T>& post_impact() const { return return_step().collision.after; }
    const std::vector<ContactSegment>& contacts() const { return return_step().contacts; }
    LabState<T> lab() const { return lab_state(body_, frame(), post_impact()); }

private:
    std::unique_ptr<OrbitOfScene<T>> orbit_;
    Body<T> body_;
};

}  // namespace swirl::studies
