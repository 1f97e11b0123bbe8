// Box2D 2.4 as its manual says to use it: lengths of about 10 m, the container a static loop of short edges, gravity
// set before each step to the swirl's force at the step's middle, restitution threshold 0. Its impact is its own.
#include "container_frame.hpp"

#include <box2d/box2d.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace swirl::peers {
namespace {

constexpr float length_scale = 10;  // metres in R_c
constexpr int edges = 720;          // of the container: it is inside the circle by 10⁻⁵ R_c at most

/// Edges and polygons have a skin, at which they touch: the container is larger by as much.
float skin_of(const Scene<double>& scene) {
    return (scene.is_disk() ? 1.0f : 2.0f) * b2_polygonRadius;
}

class Struck final : public b2ContactListener {
public:
    bool any = false;
    void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override {
        for (int i = 0; i < impulse->count; ++i) any = any || impulse->normalImpulses[i] > 1e-6f * length_scale;
    }
};

class Box2dPeer final : public Peer {
public:
    Box2dPeer(const Scene<double>& scene, const Settings& settings)
        : scene_(scene), step_(static_cast<float>(settings.step)), world_(b2Vec2(0, 0)) {
        std::vector<b2Vec2> loop;  // clockwise: solid outside
        for (int i = 0; i < edges; ++i) {
            const float angle = static_cast<float>(-2 * M_PI * i / edges);
            loop.push_back((length_scale + skin_of(scene)) * b2Vec2(std::cos(angle), std::sin(angle)));
        }
        b2ChainShape chain;
        chain.CreateLoop(loop.data(), edges);
        b2BodyDef at_rest;
        add_fixture(*world_.CreateBody(&at_rest), chain);
        world_.SetContactListener(&struck_);
    }

    Impact next(const State& start) override { return row(start, 1).front(); }

    /// The body goes on as the impact leaves it, in place, too: what is outside is Box2D's to put right.
    std::vector<Impact> row(State start, std::size_t count) override {
        b2Body& body = make_body(container_state(scene_, start));
        std::vector<Impact> impacts;
        for (long steps = 0; impacts.size() < count && (impacts.empty() || impacts.back().found);)
            impacts.push_back(go_on(body, steps));
        world_.DestroyBody(&body);
        return impacts;
    }

private:
    Impact go_on(const b2Body& body, long& steps) {
        const double step = static_cast<double>(step_), begin = static_cast<double>(steps) * step;
        double t = begin;
        for (struck_.any = false; !struck_.any && t - begin < longest_flight;) {
            const double middle = t + 0.5 * step;
            const float force = length_scale * static_cast<float>(scene_.beta);
            world_.SetGravity(force *
                              b2Vec2(static_cast<float>(std::cos(middle)), static_cast<float>(std::sin(middle))));
            world_.Step(step_, 8, 3);
            t = static_cast<double>(++steps) * step;
        }
        return struck_.any ? impact_of(body, t, t - begin) : Impact{};
    }

    void add_fixture(b2Body& body, const b2Shape& shape) const {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = 1;
        fixture.friction = static_cast<float>(scene_.mu);
        fixture.restitution = static_cast<float>(scene_.restitution);
        fixture.restitutionThreshold = 0;
        body.CreateFixture(&fixture);
    }

    b2Body& make_body(const ContainerState& from) {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position = scaled(from.centre);
        definition.linearVelocity = scaled(from.velocity);
        definition.angle = static_cast<float>(from.angle);
        definition.angularVelocity = static_cast<float>(from.spin);
        definition.allowSleep = false;
        b2Body& body = *world_.CreateBody(&definition);
        const float radius = length_scale * static_cast<float>(scene_.alpha);
        if (scene_.is_disk()) {
            b2CircleShape circle;
            circle.m_radius = radius;
            add_fixture(body, circle);
        } else {
            std::array<b2Vec2, b2_maxPolygonVertices> corners;
            for (int k = 0; k < scene_.sides; ++k) {
                const double angle = 2 * M_PI * k / scene_.sides;
                corners.at(static_cast<std::size_t>(k)) =
                    radius * b2Vec2(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
            }
            b2PolygonShape polygon;
            polygon.Set(corners.data(), scene_.sides);
            add_fixture(body, polygon);
        }
        b2MassData mass;
        mass.mass = 1;
        mass.center.SetZero();
        mass.I = static_cast<float>(scene_.inertia_factor) * radius * radius;
        body.SetMassData(&mass);
        return body;
    }

    /// What it has come to at the end of the step; the vertex that is farthest out has struck.
    Impact impact_of(const b2Body& body, double t, double flight_time) const {
        const Vec2<double> centre = unscaled(body.GetPosition());
        int vertex = 0;
        Vec2<double> arm{};
        double farthest = -1;
        for (int k = 0; k < (scene_.is_disk() ? 1 : scene_.sides); ++k) {
            const Vec2<double> other = arm_of(scene_, centre, static_cast<double>(body.GetAngle()), k);
            const Vec2<double> x = centre + other;
            if (dot(x, x) <= farthest) continue;
            farthest = dot(x, x);
            vertex = k;
            arm = other;
        }
        return {true, flight_time, vertex,
                section_state(scene_, t, centre, unscaled(body.GetLinearVelocity()), arm,
                              static_cast<double>(body.GetAngularVelocity()))};
    }

    static b2Vec2 scaled(const Vec2<double>& v) {
        return length_scale * b2Vec2(static_cast<float>(v.x), static_cast<float>(v.y));
    }
    static Vec2<double> unscaled(const b2Vec2& v) {
        return {static_cast<double>(v.x) / length_scale, static_cast<double>(v.y) / length_scale};
    }

    Scene<double> scene_;
    float step_;
    b2World world_;
    Struck struck_;
};

}  // namespace

std::unique_ptr<Peer> make_box2d_peer(const Scene<double>& scene, const Settings& settings) {
    if (!scene.is_disk() && scene.sides > b2_maxPolygonVertices) return nullptr;
    return std::make_unique<Box2dPeer>(scene, settings);
}

std::string box2d_numbers(const Scene<double>& scene) {
    char line[200];
    std::snprintf(
        line, sizeof line,
        "float32 (eps %.1e), R_c = %g m: slop %.1e R_c, skin %.1e R_c (the container is larger by it), %d edges",
        std::numeric_limits<float>::epsilon(), length_scale, b2_linearSlop / length_scale,
        skin_of(scene) / length_scale, edges);
    return line;
}

}  // namespace swirl::peers
