#include "apps/studies/bifurcation_curves/border_system.hpp"

#include "analysis/linear_algebra/dense.hpp"
#include "analysis/within_period.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace swirl::studies::bifurcation_curves {

Eigen::MatrixXd itinerary_matrix(const ItineraryMap& map, const BorderCycle& cycle, double multiplier) {
    const Eigen::Index d = map.dimension, k = static_cast<Eigen::Index>(cycle.points.size());
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(k * (d + 1), k * (d + 1));
    for (Eigen::Index i = 0; i < k; ++i) {
        const auto flight = static_cast<std::size_t>(i);
        const ItineraryStep step = map.step(cycle.points[flight], cycle.times[flight], cycle.p, cycle.vertices[flight]);
        const Eigen::Index next = (i + 1) % k;
        m.block(i * d, i * d, d, d) += step.after_by.leftCols(d);
        m.block(i * d, k * d + i, d, 1) = step.after_by.col(d);
        m.block(i * d, next * d, d, d) -= (i + 1 == k ? multiplier : 1.0) * Eigen::MatrixXd::Identity(d, d);
        m.block(k * d + i, i * d, 1, d) = step.touch.gap_by.head(d);
        m(k * d + i, k * d + i) = step.touch.gap_by[d];
    }
    return m;
}

double itinerary_determinant(const ItineraryMap& map, const BorderCycle& cycle, double multiplier) {
    return analysis::determinant_of(itinerary_matrix(map, cycle, multiplier));
}

BorderCycle with_impact(const ItineraryMap& map, const BorderCycle& grazing, double earlier) {
    BorderCycle cycle = grazing;
    const double time = grazing.touch_time - earlier;
    const ItineraryStep step = map.step(grazing.points.front(), time, grazing.p, grazing.vertex);
    cycle.points = {grazing.points.front(), step.after};
    cycle.points.insert(cycle.points.end(), grazing.points.begin() + 1, grazing.points.end());
    cycle.times.insert(cycle.times.begin(), time);
    cycle.times[1] = grazing.times.front() - time;
    cycle.vertices.insert(cycle.vertices.begin(), grazing.vertex);
    if (map.sides > 0) cycle.vertices[1] = (grazing.vertices.front() + map.sides - grazing.vertex) % map.sides;
    return cycle;
}

double grazing_determinant(const ItineraryMap& map, const BorderCycle& grazing, double multiplier) {
    constexpr double earlier = 1e-6;  // the impact's derivative is that of u_n > 0; extrapolated, to 10⁻¹²
    const double near = itinerary_determinant(map, with_impact(map, grazing, earlier), multiplier);
    const double far = itinerary_determinant(map, with_impact(map, grazing, 2 * earlier), multiplier);
    return 2 * near - far;
}

namespace {

/// Writes ∂(something of flight i) by (z, t, p) into a row of the Jacobian; `time` is where t stands.
template <class Row>
void put(const BorderLayout& layout, Eigen::Index flight, Eigen::Index time, const Row& by, Eigen::Index row,
         Eigen::MatrixXd& jacobian) {
    const Eigen::Index d = layout.dimension;
    jacobian.row(row).segment(flight * d, d) += by.head(d);
    jacobian(row, time) += by[d];
    jacobian.row(row).segment(layout.parameters(), 2) += by.tail(2);
}

/// What is zero on a stick-slip border; null for the others.
const ModeMargin* margin_of(Touch touch, const ItineraryStep& step) {
    switch (touch) {
        case Touch::slip_ends:
            return &step.slip;
        case Touch::slip_late:
            return &step.late;
        case Touch::slip_held:
            return &step.held;
        case Touch::grazing:
        case Touch::two_vertices:
        case Touch::no_flight:
            break;
    }
    return nullptr;
}

}  // namespace

void add_touch(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
               analysis::ShootingResidual& at) {
    const Eigen::Index row = layout.parameters() + layout.period;
    if (like.touch == Touch::no_flight) {
        at.gap[row] = y[layout.time(0)];
        at.jacobian(row, layout.time(0)) = 1;
        return;
    }
    if (like.touch != Touch::grazing && like.touch != Touch::two_vertices) {
        const ItineraryStep step = map.step(y.head(layout.dimension), y[layout.time(0)],
                                            y.segment<2>(layout.parameters()), like.vertices.front());
        const ModeMargin& margin = *margin_of(like.touch, step);
        at.gap[row] = margin.value;
        put(layout, 0, layout.time(0), margin.by, row, at.jacobian);
        return;
    }
    const Eigen::Index time = like.touch == Touch::grazing ? layout.touch_time() : layout.time(0);
    const ItineraryTouchRows touch =
        map.touch(y.head(layout.dimension), y[time], y.segment<2>(layout.parameters()), like.vertex);
    at.gap[row] = touch.gap;
    put(layout, 0, time, touch.gap_by, row, at.jacobian);
    if (like.touch != Touch::grazing) return;
    at.gap[row + 1] = touch.rate;
    put(layout, 0, time, touch.rate_by, row + 1, at.jacobian);
}

void add_approach(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout,
                  const Eigen::VectorXd& y, analysis::ShootingResidual& at) {
    const Eigen::Index row = layout.parameters() + layout.period;
    const ItineraryTouchRows touch = map.touch(y.head(layout.dimension), y[layout.time(0)],
                                               y.segment<2>(layout.parameters()), like.vertices.front());
    at.gap[row] = touch.rate;
    put(layout, 0, layout.time(0), touch.rate_by, row, at.jacobian);
}

void add_cycle(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
               analysis::ShootingResidual& at) {
    const Eigen::Index d = layout.dimension, k = layout.period;
    const Eigen::Vector2d p = y.segment<2>(layout.parameters());
    at.itinerary.clear();
    for (Eigen::Index i = 0; i < k; ++i) {
        const Eigen::Index next = (i + 1) % k;
        const ItineraryStep step =
            map.step(y.segment(i * d, d), y[layout.time(i)], p, like.vertices[static_cast<std::size_t>(i)]);
        for (Eigen::Index c = 0; c < d; ++c) {
            at.gap[i * d + c] = analysis::within_period(step.after[c] - y[next * d + c],
                                                        map.angle_periods[static_cast<std::size_t>(c)]);
            put(layout, i, layout.time(i), step.after_by.row(c), i * d + c, at.jacobian);
            at.jacobian(i * d + c, next * d + c) -= 1;
        }
        at.gap[layout.parameters() + i] = step.touch.gap;
        put(layout, i, layout.time(i), step.touch.gap_by, layout.parameters() + i, at.jacobian);
        at.itinerary.push_back(static_cast<std::int64_t>(step.mode));
    }
}

bool is_in_range(const Plane& plane, const Eigen::Vector2d& p) {
    return is_allowed(plane.parameter(0), p[0]) && is_allowed(plane.parameter(1), p[1]);
}

namespace {

/// On a stick-slip border slip stops; where it is held or not, or late or not, it stops before the impact ends.
std::string slip_refusal(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout,
                         const Eigen::VectorXd& y) {
    if (like.touch == Touch::two_vertices || like.touch == Touch::no_flight) return "";
    const ItineraryStep step =
        map.step(y.head(layout.dimension), y[layout.time(0)], y.segment<2>(layout.parameters()), like.vertices.front());
    const bool stops = step.stops && (like.touch == Touch::slip_ends || step.slip.value < 0);
    return stops ? "" : "stick-slip";
}

/// Does anything lie outside within flight i, as far as samples tell?
bool is_clear(const ItineraryMap& map, const BorderLayout& layout, const Eigen::VectorXd& y, Eigen::Index i) {
    constexpr int samples = 200;
    constexpr double rounding = 1e-9;  // of gaps at vertices that are on the wall
    const Eigen::VectorXd z = y.segment(i * layout.dimension, layout.dimension);
    const double time = y[layout.time(i)];
    for (int s = 1; s < samples; ++s)
        if (map.nearest(z, time * s / samples, y.segment<2>(layout.parameters()))[0].second > rounding) return false;
    return true;
}

}  // namespace

BorderLayout layout_of(const ItineraryMap& map, const BorderCycle& cycle) {
    return {map.dimension, static_cast<Eigen::Index>(cycle.points.size())};
}

analysis::CurveProblem border_problem(const ItineraryMap& map, const Plane& plane, const BorderCycle& like) {
    const BorderLayout layout = layout_of(map, like);
    const Eigen::Index count = layout.touch_time() + (like.touch == Touch::grazing ? 1 : 0);
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(layout.period));
    weights.segment<2>(layout.parameters()) = (plane.high() - plane.low()).cwiseAbs2().cwiseInverse();
    auto problem = analysis::augmented_problem(weights, [map, like, layout, plane](const Eigen::VectorXd& y) {
        analysis::ShootingResidual at;
        if (!is_in_range(plane, y.segment<2>(layout.parameters()))) return at;  // where Newton's method went astray
        at.gap.resize(y.size() - 1);
        at.jacobian = Eigen::MatrixXd::Zero(y.size() - 1, y.size());
        add_cycle(map, like, layout, y, at);
        add_touch(map, like, layout, y, at);
        at.alive = at.gap.allFinite() && at.jacobian.allFinite();
        return at;
    });
    problem.keeps_itinerary = false;  // a contact mode that changes ends no curve: `refusal_of` says what does
    return problem;
}

BorderCycle border_cycle_at(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y) {
    const BorderLayout layout = layout_of(map, like);
    BorderCycle cycle = like;
    cycle.points = analysis::unstacked(y.head(layout.parameters()), map.dimension);
    cycle.p = y.segment<2>(layout.parameters());
    for (Eigen::Index i = 0; i < layout.period; ++i) cycle.times[static_cast<std::size_t>(i)] = y[layout.time(i)];
    if (like.touch == Touch::grazing && y.size() > layout.touch_time()) cycle.touch_time = y[layout.touch_time()];
    return cycle;
}

Eigen::VectorXd unknowns_of(const ItineraryMap& map, const BorderCycle& cycle) {
    const BorderLayout layout = layout_of(map, cycle);
    Eigen::VectorXd y(layout.touch_time() + (cycle.touch == Touch::grazing ? 1 : 0));
    y.head(layout.parameters()) = analysis::stacked(cycle.points);
    y.segment<2>(layout.parameters()) = cycle.p;
    for (Eigen::Index i = 0; i < layout.period; ++i) y[layout.time(i)] = cycle.times[static_cast<std::size_t>(i)];
    if (cycle.touch == Touch::grazing) y[layout.touch_time()] = cycle.touch_time;
    return y;
}

namespace {

/// On a stick-slip border the derivative is that of one side or the other, as rounding has it. A little beside it,
/// where what is zero on it is positive, it is that of the side on which there is more slip.
Eigen::VectorXd beside_border(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y) {
    constexpr double beside = 1e-9;
    const BorderLayout layout = layout_of(map, like);
    const ItineraryStep step =
        map.step(y.head(layout.dimension), y[layout.time(0)], y.segment<2>(layout.parameters()), like.vertices.front());
    const ModeMargin* margin = margin_of(like.touch, step);
    if (margin == nullptr) return y;
    const Eigen::VectorXd by_point = margin->by.head(layout.dimension).transpose();
    Eigen::VectorXd moved = y;
    moved.head(layout.dimension) += (beside - margin->value) / by_point.squaredNorm() * by_point;
    return moved;
}

}  // namespace

Eigen::MatrixXd monodromy_of(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& unknowns) {
    const Eigen::VectorXd y = beside_border(map, like, unknowns);
    const BorderLayout layout = layout_of(map, like);
    const Eigen::Index d = layout.dimension;
    Eigen::MatrixXd product = Eigen::MatrixXd::Identity(d, d);
    for (Eigen::Index i = 0; i < layout.period; ++i) {
        const ItineraryStep step = map.step(y.segment(i * d, d), y[layout.time(i)], y.segment<2>(layout.parameters()),
                                            like.vertices[static_cast<std::size_t>(i)]);
        const Eigen::MatrixXd by_state =
            step.after_by.leftCols(d) - step.after_by.col(d) * (step.touch.gap_by.head(d) / step.touch.gap_by[d]);
        product = (by_state * product).eval();
    }
    return product;
}

std::string refusal_of(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y) {
    constexpr double least_rate = 2e-6;  // 2 u_n of the least impact that is one
    const BorderLayout layout = layout_of(map, like);
    const Eigen::Vector2d p = y.segment<2>(layout.parameters());
    for (Eigen::Index i = 0; i < layout.period; ++i) {
        const double time = y[layout.time(i)];
        const bool none = i == 0 && like.touch == Touch::no_flight;
        if (!none && !(time > 0)) return "two-vertices";
        const ItineraryTouchRows strike = map.touch(y.segment(i * layout.dimension, layout.dimension), time, p,
                                                    like.vertices[static_cast<std::size_t>(i)]);
        if (!(strike.rate > least_rate)) return "grazing";
        if (!none && !is_clear(map, layout, y, i)) return "border";
    }
    if (like.touch != Touch::grazing) return slip_refusal(map, like, layout, y);
    const double at = y[layout.touch_time()];
    if (!(at > 0) || !(at < y[layout.time(0)])) return "two-vertices";
    // g″ < 0: it comes from inside and goes back.
    const ItineraryTouchRows touch = map.touch(y.head(layout.dimension), at, p, like.vertex);
    return touch.rate_by[layout.dimension] < 0 ? "" : "border";
}

}  // namespace swirl::studies::bifurcation_curves
