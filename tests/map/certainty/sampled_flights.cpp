#include "tests/map/certainty/sampled_flights.hpp"

#include "map/orbit/laboratory.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

namespace swirl::tests {

namespace {

Scene<double> any_scene(Random& random) {
    const int sides = random.one_of(
        {disk_sides, disk_sides, 3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 8, 9, 10, 11, 12, 50, random.chance(0.5) ? 1000 : 30});
    const double mu = random.chance(0.4) ? 0 : random.log_between(0.01, 2);
    return random_scene(random, sides, mu, random.between(0.7, 1), Law::poisson);
}

Flight<double> flight_of(const Scene<double>& scene, const SectionPoint<double>& z) {
    return flight_from(make_body(scene), post_impact_state(z));
}

std::optional<SampledFlight> flight_of_an_orbit(Random& random) {
    const Scene<double> scene = any_scene(random);
    const SectionPoint<double> z = random_point(random, scene, random.log_between(0.05, 2));
    const int impacts = static_cast<int>(random.between(0, 100));
    return with_collision_map(scene, [&](const auto& map) -> std::optional<SampledFlight> {
        auto state = post_impact_state(z);
        for (int i = 0; i < impacts; ++i) {
            const auto step = map.advance(state);
            if (step.outcome != FirstContactOutcome::contact) return std::nullopt;
            state = step.after;
        }
        return SampledFlight{FlightKind::orbit, scene, flight_from(map.body(), state), 0};
    });
}

SampledFlight departing_flight(Random& random) {
    const Scene<double> scene = any_scene(random);
    const SectionPoint<double> z = random_point(random, scene, random.log_between(1e-9, 1e-3));
    return {FlightKind::departure, scene, flight_of(scene, z), 0};
}

SampledFlight flight_from_an_edge(Random& random) {
    Scene<double> scene = any_scene(random);
    if (scene.is_disk()) scene.sides = 6;
    SectionPoint<double> z = random_point(random, scene, random.log_between(0.01, 1));
    const double chi = random.sign() * largest_chi(scene) * (1 - random.log_between(1e-15, 1e-2));
    z.vn += scene.alpha * z.spin * (std::sin(chi) - std::sin(z.chi));
    z.chi = chi;
    return {FlightKind::edge, scene, flight_of(scene, z), 0};
}

SampledFlight extreme_flight(Random& random) {
    Scene<double> scene = any_scene(random);
    double spin = random.between(-3, 3);
    switch (random.one_of({0, 1, 2})) {
        case 0:
            spin = random.sign() * random.log_between(10, 300);
            break;
        case 1:
            scene.beta = random.between(3, 50);
            break;
        default:
            scene.alpha = 1 - random.log_between(1e-6, 0.05);
    }
    SectionPoint<double> z = random_point(random, scene, random.log_between(0.05, 2));
    z.vn += scene.alpha * (spin - z.spin) * std::sin(z.chi);
    z.spin = spin;
    return {FlightKind::extreme, scene, flight_of(scene, z), 0};
}

SampledFlight flight_in_the_air(Random& random) {
    const Scene<double> scene = any_scene(random);
    // The centre within 0.9 (1 − α) of the container's: every vertex is inside.
    const double reach = 0.9 * (1 - scene.alpha) * std::sqrt(random.unit()), towards = random.angle();
    const LabStart<double> start{scene.beta + reach * std::cos(towards),
                                 reach * std::sin(towards),
                                 random.between(-2, 2),
                                 random.between(-2, 2),
                                 random.angle(),
                                 random.between(-3, 3)};
    return {FlightKind::airborne, scene, flight_from(make_body(scene), start), 0};
}

/// Flights between two starts on the same wall, λ from 0 to 1; the border is between two λ.
class Line {
public:
    explicit Line(Random& random) : scene_(any_scene(random)) {
        from_ = random_point(random, scene_, random.log_between(0.05, 2));
        towards_ = random_point(random, scene_, random.log_between(0.05, 2));
        const double length = random.between(0.1, 1);
        towards_ = at(length);
    }

    const Scene<double>& scene() const { return scene_; }
    SectionPoint<double> at(double x) const {
        const auto between = [x](double a, double b) { return a + x * (b - a); };
        return {between(from_.psi, towards_.psi), between(from_.chi, towards_.chi), between(from_.vn, towards_.vn),
                between(from_.vt, towards_.vt), between(from_.spin, towards_.spin)};
    }

    struct End {
        double x = 0, time = 0;
        int vertex = -1;
    };
    std::optional<End> end_at(double x) const {
        const auto contact = claim_of(scene_, flight_of(scene_, at(x))).contact;
        if (contact.outcome != FirstContactOutcome::contact) return std::nullopt;
        return End{x, contact.at.time, contact.vertex};
    }

private:
    Scene<double> scene_;
    SectionPoint<double> from_, towards_;
};

bool is_other(const Line::End& a, const Line::End& b) {
    return a.vertex != b.vertex || std::fabs(a.time - b.time) > 0.3 * std::max(a.time, b.time);
}

struct Border {
    Line::End below, above;
};

/// Two neighbours among nine starts that end otherwise.
std::optional<Border> any_border(const Line& line) {
    std::optional<Line::End> before;
    for (int i = 0; i <= 8; ++i) {
        const auto here = line.end_at(i / 8.0);
        if (!here) return std::nullopt;
        if (before && is_other(*before, *here)) return Border{*before, *here};
        before = here;
    }
    return std::nullopt;
}

/// Halves until the border is known to `width`; false if the search ends otherwise than at its ends.
bool narrow(const Line& line, Border& border, double width) {
    while (border.above.x - border.below.x > width) {  // ends: halves
        const double x = 0.5 * (border.below.x + border.above.x);
        if (!(border.below.x < x && x < border.above.x)) return true;
        const auto here = line.end_at(x);
        if (!here) return false;
        const bool same_vertex = border.below.vertex == border.above.vertex;
        const bool is_below =
            same_vertex ? std::fabs(here->time - border.below.time) < std::fabs(here->time - border.above.time)
                        : here->vertex == border.below.vertex;
        (is_below ? border.below : border.above) = *here;
    }
    return true;
}

std::vector<SampledFlight> flights_beside_a_border(Random& random) {
    const Line line(random);
    const double width = random.log_between(1e-16, 1e-1);
    auto border = any_border(line);
    if (!border || !narrow(line, *border, width)) return {};
    const Border found = *border;
    if (!narrow(line, *border, 1e-15)) return {};
    const double jump = std::fabs(border->below.time - border->above.time);
    const bool tie = jump < 1e-6;
    if (tie && border->below.vertex == border->above.vertex) return {};  // steep, but no border
    if (tie && random.chance(0.7)) return {};                            // they are the more frequent of the two
    std::vector<SampledFlight> flights;
    for (const auto& end : {found.below, found.above})
        flights.push_back({tie ? FlightKind::tie : FlightKind::graze, line.scene(),
                           flight_of(line.scene(), line.at(end.x)), found.above.x - found.below.x});
    return flights;
}

}  // namespace

std::vector<SampledFlight> next_flights(Random& random) {
    while (true) {  // ends: most tries succeed
        const double which = random.unit();
        if (which < 0.4) {
            auto flights = flights_beside_a_border(random);
            if (!flights.empty()) return flights;
        } else if (which < 0.7) {
            if (const auto flight = flight_of_an_orbit(random)) return {*flight};
        } else if (which < 0.78) {
            return {departing_flight(random)};
        } else if (which < 0.86) {
            return {flight_from_an_edge(random)};
        } else if (which < 0.94) {
            return {extreme_flight(random)};
        } else {
            return {flight_in_the_air(random)};
        }
    }
}

std::vector<SampledFlight> next_border(Random& random) {
    while (true) {  // ends: most tries succeed
        auto flights = flights_beside_a_border(random);
        if (!flights.empty()) return flights;
    }
}

Claim claim_of(const Scene<double>& scene, const Flight<double>& flight) {
    return with_collision_map(scene, [&](const auto& map) {
        constexpr Shape shape = std::decay_t<decltype(map)>::shape;
        Claim claim;
        claim.direct = detail::direct_contact<shape>(map.body(), flight, claim.contact);
        if (!claim.direct) claim.contact = detail::undecided_contact<shape>(map.body(), flight);
        return claim;
    });
}

}  // namespace swirl::tests
