#include "apps/studies/noise/impact_noise.hpp"

#include "analysis/random_draws.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "map/model/turned_impact.hpp"
#include "map/orbit/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <variant>

namespace swirl::studies {

namespace {

constexpr std::uint64_t stream_of_noise = 0x6e6f697365;  // the key's second word: that of starts is 0

constexpr double most_turned = std::numbers::pi / 4;

/// Reflected into [0, 1].
double within_unit(double x) {
    return std::abs(std::remainder(x, 2.0));
}

Scene<double> scene_of(const Scene<double>& scene, const NoisyImpact& impact) {
    Scene<double> varied = scene;
    varied.restitution = impact.restitution;
    varied.mu = impact.mu;
    return varied;
}

/// Turns the impact that a step ends with.
template <int D>
void turn_impact(const Body<double>& body, const Scene<double>& scene, const NoisyImpact& noise,
                 ReturnStep<double>& step) {
    if (noise.turn == 0 || step.outcome != Outcome::completed || !step.contacts.empty()) return;
    Collision<double>& collision = step.collision;
    constexpr Shape shape = D == disk_dimension ? Shape::disk : Shape::polygon;
    const PostImpactState<double> before = before_impact(body, collision.after, collision.impulse);
    with_rule<shape>(scene, [&](auto rule) {
        const TurnedImpact<double> turned =
            turned_impact<rule()>(body, before, noise.mu, noise.restitution, noise.turn);
        collision.after = turned.after;
        collision.impulse = turned.impulse;
        collision.jacobi_restitution = turned.jacobi_restitution;
        collision.jacobi_friction = turned.jacobi_friction;
    });
}

/// The orbit, position in the laboratory included; as Orbit.
template <int D>
class NoisyOrbit final : public OrbitOfScene<double> {
public:
    NoisyOrbit(const Scene<double>& scene, const Start<double>& start, const ImpactNoise& noise)
        : scene_(scene), noise_(noise), similar_(scene_for_noise(scene, noise)) {
        if (const auto* point = std::get_if<SectionPoint<double>>(&start)) {
            require_leaving(similar_.body(), *point);
            step_.collision.after = post_impact_state(*point);
            frame_ = LabFrame<double>::at_section(*point);
        } else {
            lab_ = std::get<LabStart<double>>(start);
            flight_from(similar_.body(), *lab_);  // refused here, before anything is followed
            frame_ = LabFrame<double>::at_start(lab_->angle);
        }
    }

    bool advance(double horizon, const ContactSink& sink) override {
        if (outcome_ != Outcome::completed) return false;
        const auto impact = static_cast<std::uint64_t>(impacts_) + 1;
        step_ = lab_ ? first_step(impact)
                     : noisy_step(similar_, scene_, noise_, step_.collision.after, impact, horizon, sink);
        lab_.reset();
        outcome_ = step_.outcome;
        if (outcome_ != Outcome::completed) return false;
        ++impacts_;
        const Body<double>& body = similar_.body();
        if (has_come_to_rest(body, step_.collision.after)) outcome_ = Outcome::resting;
        if (has_diverged(body, step_.collision.after)) outcome_ = Outcome::diverged;
        frame_.follow(Shaped{body}, step_.collision, step_.turned);
        return true;
    }

    const ReturnStep<double>& return_step() const override { return step_; }
    const LabFrame<double>& frame() const override { return frame_; }
    Outcome outcome() const override { return outcome_; }
    long long impacts() const override { return impacts_; }

private:
    /// What LabFrame asks of a map.
    struct Shaped {
        static constexpr Shape shape = D == disk_dimension ? Shape::disk : Shape::polygon;
        const Body<double>& its_body;
        const Body<double>& body() const { return its_body; }
    };

    ReturnStep<double> first_step(std::uint64_t impact) const {
        const NoisyImpact varied = noisy_impact(noise_, scene_, impact);
        const Scene<double> own = scene_of(scene_, varied);
        const SceneMap<D> map = similar_.with(own);
        ReturnStep<double> step = map.first_impact(*lab_);
        turn_impact<D>(map.body(), scene_for_noise(own, noise_), varied, step);
        return step;
    }

    Scene<double> scene_;
    ImpactNoise noise_;
    SceneMap<D> similar_;
    std::optional<LabStart<double>> lab_;  ///< until the first impact
    ReturnStep<double> step_;
    LabFrame<double> frame_;
    Outcome outcome_ = Outcome::completed;
    long long impacts_ = 0;
};

}  // namespace

NoisyImpact noisy_impact(const ImpactNoise& noise, const Scene<double>& scene, std::uint64_t impact) {
    const auto u = analysis::uniform_draws({noise.run, impact, 0, 0}, {noise.seed, stream_of_noise});
    const auto normal = [&](std::size_t pair, bool sine) {
        const double turn = 2 * std::numbers::pi * u[2 * pair + 1];
        return std::sqrt(-2 * std::log(u[2 * pair])) * (sine ? std::sin(turn) : std::cos(turn));
    };
    NoisyImpact varied{scene.restitution, scene.mu, 0};
    if (noise.restitution > 0)
        varied.restitution = within_unit(scene.restitution + noise.restitution * normal(0, false));
    if (noise.mu > 0) varied.mu = std::abs(scene.mu + noise.mu * normal(0, true));
    if (noise.wall > 0) varied.turn = std::clamp(noise.wall * normal(1, false), -most_turned, most_turned);
    return varied;
}

Scene<double> scene_for_noise(const Scene<double>& scene, const ImpactNoise& noise) {
    Scene<double> with_friction = scene;
    if (scene.mu == 0 && noise.mu > 0) with_friction.mu = noise.mu;
    return with_friction;
}

template <int D>
ReturnStep<double> noisy_step(const SceneMap<D>& similar, const Scene<double>& scene, const ImpactNoise& noise,
                              const PostImpactState<double>& z, std::uint64_t impact, double horizon,
                              const ContactSink& sink) {
    const NoisyImpact varied = noisy_impact(noise, scene, impact);
    const Scene<double> own = scene_of(scene, varied);
    const SceneMap<D> map = similar.with(own);
    ReturnStep<double> step = map.return_step(z, horizon, sink);
    turn_impact<D>(map.body(), scene_for_noise(own, noise), varied, step);
    return step;
}

std::unique_ptr<OrbitOfScene<double>> noisy_orbit(const Scene<double>& scene, const Start<double>& start,
                                                  const ImpactNoise& noise) {
    if (scene.is_disk()) return std::make_unique<NoisyOrbit<disk_dimension>>(validated(scene), start, noise);
    return std::make_unique<NoisyOrbit<polygon_dimension>>(validated(scene), start, noise);
}

template ReturnStep<double> noisy_step(const SceneMap<disk_dimension>&, const Scene<double>&, const ImpactNoise&,
                                       const PostImpactState<double>&, std::uint64_t, double, const ContactSink&);
template ReturnStep<double> noisy_step(const SceneMap<polygon_dimension>&, const Scene<double>&, const ImpactNoise&,
                                       const PostImpactState<double>&, std::uint64_t, double, const ContactSink&);

}  // namespace swirl::studies
