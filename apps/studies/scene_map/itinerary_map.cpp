#include "apps/studies/scene_map/itinerary_map.hpp"

#include "apps/studies/scene_map/section_coordinates.hpp"
#include "map/derivative/itinerary_collision.hpp"

#include <type_traits>
#include <utility>

namespace swirl::studies {

namespace {

template <Shape shape>
ItineraryTouchRows rows_of(const ItineraryTouch<double, shape>& touch) {
    return {touch.gap, touch.rate, touch.gap_by, touch.rate_by};
}

/// The functions of one shape and rule.
template <Shape shape, ImpactRule rule>
struct ItineraryFunctions {
    static constexpr int dimension = section_dimension<shape>;

    Scene<double> scene;
    Body<double> body;  ///< of the scene
    Parameter first, second;

    Scene<double> at(const Eigen::Vector2d& p) const {
        return with_parameter(with_parameter(scene, first, p[0]), second, p[1]);
    }

    ItineraryStep step(const Eigen::VectorXd& z, double time, const Eigen::Vector2d& p, int vertex) const {
        const auto collision =
            collide_by_itinerary<double, shape, rule>(at(p), first, second, section_point_of(z), time, vertex);
        ItineraryStep result;
        result.touch = rows_of<shape>(collision.touch);
        result.after = Eigen::Map<const Eigen::Matrix<double, dimension, 1>>(collision.after.data());
        result.after_by = collision.after_by;
        result.mode = collision.mode;
        const auto& margins = collision.margins;
        result.stops = margins.stops;
        result.slip = {margins.slip, margins.slip_by};
        result.late = {margins.late, margins.late_by};
        result.held = {margins.held, margins.held_by};
        return result;
    }

    ItineraryTouchRows touch(const Eigen::VectorXd& z, double time, const Eigen::Vector2d& p, int vertex) const {
        return rows_of<shape>(
            touch_by_itinerary<double, shape, rule>(at(p), first, second, section_point_of(z), time, vertex));
    }

    std::vector<std::pair<int, double>> nearest(const Eigen::VectorXd& z, double time, const Eigen::Vector2d& p) const {
        const Body<double> here = make_body(at(p), &body);
        const Flight<double> flight = flight_from(here, post_impact_state(section_point_of(z)));
        const Instant<double> moment = instant_at<shape>(flight, time);
        if constexpr (shape == Shape::disk) {
            return {{0, centre_gap(here, flight, moment).value}};
        } else {
            detail::NearestTwo<double> pair;
            detail::look_around(here, flight, moment, pair);
            if (pair.second.gap.value > pair.first.gap.value) std::swap(pair.first, pair.second);
            return {{pair.first.vertex, pair.first.gap.value}, {pair.second.vertex, pair.second.gap.value}};
        }
    }
};

}  // namespace

ItineraryMap itinerary_map_of(const Scene<double>& scene, Parameter first, Parameter second) {
    Scene<double> typical = scene;
    for (const Parameter parameter : {first, second})
        if (parameter == Parameter::mu) typical = with_parameter(typical, parameter, 1.0);
    return with_collision_map(typical, [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        const ItineraryFunctions<Map::shape, Map::rule> functions{typical, map.body(), first, second};
        ItineraryMap result;
        result.dimension = functions.dimension;
        result.sides = typical.sides;
        for (int i = 0; i < functions.dimension; ++i)
            result.angle_periods.push_back(i < functions.dimension - 3 ? 2 * pi<double>() : 0);
        result.step = [functions](const auto& z, double time, const auto& p, int vertex) {
            return functions.step(z, time, p, vertex);
        };
        result.touch = [functions](const auto& z, double time, const auto& p, int vertex) {
            return functions.touch(z, time, p, vertex);
        };
        result.nearest = [functions](const auto& z, double time, const auto& p) {
            return functions.nearest(z, time, p);
        };
        return result;
    });
}

}  // namespace swirl::studies
