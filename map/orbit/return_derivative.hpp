// The derivative of the return map where a return step leads through sustained contact.
//
// An impact that ends in contact leaves with a normal velocity that may be as small as 10⁻⁸, so differences over larger
// h would reach states that begin a flight. DF is therefore the product B A, divided at the landing: A is the
// derivative of the state in contact, where the removal of u_n with its friction is smooth for either sign of u_n
// (`landed_like`), B that of the motion from there to the next impact. Both are central differences with error O(h²).
// If only neighbours on one side pass through the same events as the orbit (`same_way`), B's column is a one-sided
// difference, with error O(h²) from two neighbours and O(h) from one; if none does, the column is zero. A singular
// value of B within rounding belongs to a direction that contact removes, and is set to zero. A neighbour that takes
// eight times as long in contact as the orbit shows that h is no small step there: the derivative is then NaN.
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/orbit/return_map.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace swirl {

namespace detail {

constexpr double difference_step = 1e-5;
/// Contact is integrated with an error of some 10⁻¹⁴: in a difference over 2 h that is 10⁻⁹.
constexpr double difference_rounding = 1e-8;

/// How many power series a neighbour of an orbit in contact may take.
inline long most_steps_beside(const ReturnStep<double>& known) {
    constexpr long fewest = 500, more = 8;
    return std::max(fewest, more * contact_steps(known));
}

/// The coordinates in which a state in contact can differ: a disk has no χ; a moving edge turns as one piece, S = u_t;
/// an edge at rest has ψ only.
inline int contact_freedom(const ContactScene<double>& scene, const ChatterCompletion<double>& completion) {
    if (completion.support == Support::rim) return 3;
    if (completion.support == Support::vertex) return 4;
    return rests_still(scene, completion) ? 1 : 2;
}

inline Eigen::Vector4d contact_vector(const ChatterCompletion<double>& completion, const ContactState<double>& s) {
    if (completion.support == Support::vertex) return {s.psi, s.ut, s.spin, s.chi};
    return {s.psi, s.ut, s.spin, 0};
}

inline ContactState<double> moved_by(const ChatterCompletion<double>& completion, int coordinate, double h) {
    ContactState<double> s = completion.state;
    if (coordinate == 0) s.psi += h;
    if (coordinate == 1) s.ut += h;
    if (coordinate == 2) s.spin += h;
    if (coordinate == 3) s.chi += h;
    if (completion.support == Support::edge) s.spin = s.ut;
    return s;
}

inline double wrapped(double angle) {
    return std::remainder(angle, 2 * pi<double>());
}

/// A landing on a vertex whose neighbour comes to rest at once counts as one on their edge: the rocking between ends
/// within rounding.
inline ChatterCompletion<double> lasting_completion(ChatterCompletion<double> completion,
                                                    const std::vector<ContactSegment>& contacts) {
    if (contacts.size() < 2 || completion.support != Support::vertex) return completion;
    const ContactSegment& first = contacts[0];
    const ContactSegment& second = contacts[1];
    if (first.end > first.start || second.support != Support::edge) return completion;
    return {true, Support::edge, second.from, second.vertex_step, completion.error, completion.jacobi};
}

/// True if two return steps have the same sequence of supports, the same last event and the same impact. (A slip of no
/// duration does not count: every neighbour of a sticking state has one.)
inline bool same_way(const ReturnStep<double>& a, const ReturnStep<double>& b) {
    if (a.outcome != Outcome::completed || a.contacts.empty() || b.contacts.empty()) return false;
    const auto supports = [](const ReturnStep<double>& return_step) {
        std::vector<Support> list;
        for (const auto& segment : return_step.contacts)
            if (segment.end > segment.start && (list.empty() || list.back() != segment.support))
                list.push_back(segment.support);
        return list;
    };
    return a.collision.vertex_step == b.collision.vertex_step && a.collision.impulse.mode == b.collision.impulse.mode &&
           a.contacts.back().finish == b.contacts.back().finish && supports(a) == supports(b);
}

template <Shape shape>
Eigen::Matrix<double, section_dimension<shape>, 1> section_difference(const PostImpactState<double>& a,
                                                                      const PostImpactState<double>& b) {
    constexpr int dimension = section_dimension<shape>;
    const auto x = coordinates<shape>(section_point(a)), y = coordinates<shape>(section_point(b));
    Eigen::Matrix<double, dimension, 1> d;
    for (int i = 0; i < dimension; ++i) d[i] = x[static_cast<std::size_t>(i)] - y[static_cast<std::size_t>(i)];
    const int angles = shape == Shape::disk ? 1 : 2;
    for (int i = 0; i < angles; ++i) d[i] = wrapped(d[i]);
    return d;
}

/// A: ∂(state in contact)/∂(post-impact state).
template <Shape shape>
auto landing_derivative(const ContactScene<double>& scene, const SectionPoint<double>& z,
                        const ChatterCompletion<double>& completion) {
    constexpr int dimension = section_dimension<shape>;
    constexpr double h = difference_step;
    Eigen::Matrix<double, 4, dimension> a;
    const auto c = coordinates<shape>(z);
    const PostImpactState<double> base = post_impact_state(z);
    for (int j = 0; j < dimension; ++j) {
        const auto at = [&](double step) {
            auto near = c;
            near[static_cast<std::size_t>(j)] += step;
            return contact_vector(completion,
                                  landed_like(scene, base, completion, post_impact_state(section_point<shape>(near))));
        };
        a.col(j) = at(h) - at(-h);
        a(0, j) = wrapped(a(0, j));
        a(3, j) = wrapped(a(3, j));
    }
    return Eigen::Matrix<double, 4, dimension>(a / (2 * h));
}

/// One column of B: `end(s)` is the state after the next impact from s along the coordinate, empty if the events
/// differ.
template <Shape shape, class End>
Eigen::Matrix<double, section_dimension<shape>, 1> column_of(const PostImpactState<double>& after, const End& end,
                                                             double h) {
    const auto above = end(h), below = end(-h);
    if (above && below) return section_difference<shape>(*above, *below) / (2 * h);
    if (!above && !below) return Eigen::Matrix<double, section_dimension<shape>, 1>::Zero();
    const double side = above ? h : -h;
    const auto near = section_difference<shape>(above ? *above : *below, after);
    const auto beyond = end(2 * side);
    if (!beyond) return near / side;
    return (4 * near - section_difference<shape>(*beyond, after)) / (2 * side);
}

/// B with singular values that are no more than rounding made zero.
Eigen::MatrixXd without_rounding(const Eigen::MatrixXd& b);

}  // namespace detail

/// DF(z), where `known` is F(z) and leads through contact; NaN where neighbours stay in contact for much longer.
///   series  is added how many power series it took, or as much in looks at flights, if it is given
template <class Map>
auto derivative_through_contact(const ReturnMap<Map>& map, const SectionPoint<double>& z,
                                const ReturnStep<double>& known, long* series = nullptr) {
    constexpr int dimension = section_dimension<Map::shape>;
    constexpr double h = detail::difference_step;
    const PostImpactState<double> base = post_impact_state(z);
    const ChatterCompletion<double> completion = detail::lasting_completion(map.completion(base), known.contacts);
    const int freedom = detail::contact_freedom(map.contact(), completion);
    Eigen::Matrix<double, dimension, 4> b = Eigen::Matrix<double, dimension, 4>::Zero();
    constexpr long looks_per_series = 64;  // of the flight after contact
    const long most_steps = detail::most_steps_beside(known);
    bool follows = true;
    for (int i = 0; i < freedom && follows; ++i) {
        const auto end = [&](double step) -> std::optional<PostImpactState<double>> {
            ChatterCompletion<double> near = completion;
            near.state = detail::moved_by(completion, i, step);
            const ReturnStep<double> return_step = map.advance_in_contact(base, near, contact_horizon, {}, most_steps);
            if (series) *series += contact_steps(return_step) + return_step.collision.steps / looks_per_series;
            if (return_step.outcome == Outcome::contact_cut) follows = false;
            if (!detail::same_way(return_step, known)) return {};
            return return_step.collision.after;
        };
        b.col(i) = detail::column_of<Map::shape>(known.collision.after, end, h);
    }
    using Derivative = Eigen::Matrix<double, dimension, dimension>;
    if (!follows) return Derivative(Derivative::Constant(std::numeric_limits<double>::quiet_NaN()));
    return Derivative(detail::without_rounding(b) *
                      detail::landing_derivative<Map::shape>(map.contact(), z, completion));
}

}  // namespace swirl
