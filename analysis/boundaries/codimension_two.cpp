#include "analysis/boundaries/codimension_two.hpp"

#include "analysis/continuation/normal_form.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/linear_algebra/dense.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;
using Forms = std::function<HigherForms(const CyclePoints&, const Eigen::Vector2d&)>;

/// Differences of D(Fᵏ) in double: second derivatives to 10⁻¹⁰, third ones to 10⁻⁷ or so.
HigherForms forms_in_double(const AugmentedSystem& system, const CurvePoint& at) {
    const PlaneMap& map = system.map;
    const Eigen::Vector2d p = at.y.segment<2>(system.coordinates());
    const std::size_t k = system.period;
    const std::vector<std::int64_t> itinerary = at.shooting.itinerary;
    return difference_forms<double>(
        [map, p, k, itinerary](const Eigen::VectorXd& from, const double&, Eigen::MatrixXd& product) {
            Eigen::VectorXd z = from;
            product = Eigen::MatrixXd::Identity(map.dimension, map.dimension);
            for (std::size_t i = 0; i < k; ++i) {
                const ShootingStep step = map.step(z, p);
                if (!step.alive || step.letter != itinerary[i]) return false;
                product = (step.by_state * product).eval();
                z = step.state;
            }
            return true;
        },
        at.y.head(map.dimension), 0, 1e-5, 3e-4);
}

Eigen::MatrixXd shifted(const Eigen::MatrixXd& a, double by) {
    return a + by * Eigen::MatrixXd::Identity(a.rows(), a.cols());
}

/// Σ_i of the principal minors without row and column i: ∂det(A + xI)/∂x.
double sum_of_minors(const Eigen::MatrixXd& a) {
    const Eigen::Index d = a.rows();
    if (d == 1) return 1;
    double sum = 0;
    for (Eigen::Index left_out = 0; left_out < d; ++left_out) {
        Eigen::MatrixXd minor(d - 1, d - 1);
        for (Eigen::Index i = 0; i + 1 < d; ++i)
            for (Eigen::Index j = 0; j + 1 < d; ++j)
                minor(i, j) = a(i < left_out ? i : i + 1, j < left_out ? j : j + 1);
        sum += determinant_of(minor);
    }
    return sum;
}

/// Without the one nearest to `critical`, and without its conjugate if that is another.
std::vector<Complex> others(std::vector<Complex> multipliers, Complex critical, bool pair) {
    const auto leave_out = [&](Complex m) {
        if (multipliers.empty()) return;
        multipliers.erase(std::min_element(multipliers.begin(), multipliers.end(),
                                           [m](Complex a, Complex b) { return std::abs(a - m) < std::abs(b - m); }));
    };
    leave_out(critical);
    if (pair) leave_out(std::abs(critical) > 1 ? 1.0 / critical : std::conj(critical));
    return multipliers;
}

/// b of the curve's kind; NaN where it does not exist. (Of its poles: `has_coefficient`.)
Complex coefficient_at(const AugmentedSystem& system, const CurvePoint& point, const Forms& forms) {
    CriticalPoint critical;
    critical.derivative = monodromy(point.shooting);
    const Eigen::Index n = system.coordinates();
    critical.by_parameter = critical.branch_slope = Eigen::VectorXd::Zero(system.map.dimension);  // of no interest here
    critical.forms = forms ? forms(point.points(), point.y.segment<2>(n)) : forms_in_double(system, point);
    std::optional<NormalForm> form;
    if (system.kind == BoundaryKind::fold) form = fold_form(critical);
    if (system.kind == BoundaryKind::flip) form = flip_form(critical);
    const Complex multiplier = system.multiplier(point.y);
    if (system.kind == BoundaryKind::neimark_sacker && multiplier.imag() > 0)
        form = neimark_sacker_form(critical, multiplier);
    return form ? form->nonlinear : Complex(nan, nan);
}

double cusp_function(const AugmentedSystem& system, const CurvePoint& point) {
    const Eigen::Index n = system.coordinates();
    const CriticalValue value = critical_value(point.shooting, 1, system.borders);
    const auto gradient =
        gradient_of(system.map, point.y.head(n), point.y.segment<2>(n), point.shooting, value, system.steep_below);
    return gradient ? -(gradient->head(n).array() * value.right.array()).sum().real() : nan;
}

/// b, without its poles.
double generalised_flip_function(const CurvePoint& point, Complex b) {
    const Eigen::MatrixXd a = monodromy(point.shooting);
    return b.real() * sum_of_minors(shifted(a, 1)) * determinant_of(shifted(a, -1));
}

double chenciner_function(Complex b) {
    return b.real() / std::abs(b);
}

double other_pairs_function(const AugmentedSystem& system, const CurvePoint& point) {
    const bool pair = system.kind == BoundaryKind::neimark_sacker;
    return neimark_sacker_function(others(multipliers_at(point), system.multiplier(point.y), pair));
}

void add_real_tests(const AugmentedSystem& system, const Forms& forms, std::vector<CodimensionTest>& tests) {
    const bool fold = system.kind == BoundaryKind::fold;
    const double one = fold ? -1 : 1;  // A + one · I is singular
    if (fold)
        tests.push_back({CodimensionTwo::cusp, [system](const CurvePoint& at) { return cusp_function(system, at); }});
    else
        tests.push_back(
            {CodimensionTwo::generalised_flip,
             [system, forms](const CurvePoint& at) {
                 return generalised_flip_function(at, coefficient_at(system, at, forms));
             },
             [](const BoundaryPoint& point) { return generalised_flip_function(point.at, point.coefficient); }});
    if (system.map.dimension < 2) return;
    tests.push_back({fold ? CodimensionTwo::one_to_one : CodimensionTwo::one_to_two,
                     [one](const CurvePoint& at) { return sum_of_minors(shifted(monodromy(at.shooting), one)); }});
    tests.push_back({CodimensionTwo::fold_flip,
                     [one](const CurvePoint& at) { return determinant_of(shifted(monodromy(at.shooting), -one)); }});
    if (system.map.dimension < 3) return;
    tests.push_back({fold ? CodimensionTwo::fold_neimark_sacker : CodimensionTwo::flip_neimark_sacker,
                     [system](const CurvePoint& at) { return other_pairs_function(system, at); }});
}

void add_pair_tests(const AugmentedSystem& system, const Forms& forms, std::vector<CodimensionTest>& tests) {
    const Eigen::Index c = system.coordinates() + 2;
    const auto passes = [&](CodimensionTwo kind, double cosine) {
        tests.push_back({kind, [c, cosine](const CurvePoint& at) { return at.y[c] - cosine; }});
    };
    passes(CodimensionTwo::one_to_one, 1);
    passes(CodimensionTwo::one_to_two, -1);
    passes(CodimensionTwo::one_to_three, -0.5);
    passes(CodimensionTwo::one_to_four, 0);
    constexpr double noise = 1e-4;  // of Re b/|b| in double, with room to spare: conservative maps have Re b = 0
    tests.push_back(
        {CodimensionTwo::chenciner,
         [system, forms](const CurvePoint& at) { return chenciner_function(coefficient_at(system, at, forms)); },
         [](const BoundaryPoint& point) { return chenciner_function(point.coefficient); }, noise});
    if (system.map.dimension < 3) return;
    const auto beside = [&](CodimensionTwo kind, double one) {
        tests.push_back({kind, [c, one](const CurvePoint& at) {
                             const double pair = 2 + 2 * one * at.y[c];
                             return determinant_of(shifted(monodromy(at.shooting), one)) / pair;
                         }});
    };
    beside(CodimensionTwo::fold_neimark_sacker, -1);
    beside(CodimensionTwo::flip_neimark_sacker, 1);
    if (system.map.dimension < 4) return;
    tests.push_back({CodimensionTwo::double_neimark_sacker,
                     [system](const CurvePoint& at) { return other_pairs_function(system, at); }});
}

}  // namespace

std::vector<CodimensionTest> tests_of(const AugmentedSystem& system, const Forms& forms) {
    std::vector<CodimensionTest> tests;
    if (system.kind == BoundaryKind::neimark_sacker)
        add_pair_tests(system, forms, tests);
    else
        add_real_tests(system, forms, tests);
    return tests;
}

bool is_what_it_seems(const AugmentedSystem& system, CodimensionTwo kind, const CurvePoint& point) {
    const bool pair = system.kind == BoundaryKind::neimark_sacker;
    if (kind != CodimensionTwo::double_neimark_sacker &&
        (pair || (kind != CodimensionTwo::fold_neimark_sacker && kind != CodimensionTwo::flip_neimark_sacker)))
        return true;
    const auto left = others(multipliers_at(point), system.multiplier(point.y), pair);
    return std::any_of(left.begin(), left.end(),
                       [](Complex m) { return m.imag() > 1e-6 && std::abs(std::abs(m) - 1) < 1e-6; });
}

bool has_coefficient(BoundaryKind curve, CodimensionTwo kind) {
    using enum CodimensionTwo;
    if (kind == one_to_one || kind == one_to_two) return false;
    if (curve == BoundaryKind::flip) return kind != fold_flip;
    return curve == BoundaryKind::fold || (kind != one_to_three && kind != fold_neimark_sacker);
}

BoundaryPoint boundary_point_at(const AugmentedSystem& system, const CurvePoint& at, const Forms& forms) {
    return {at, multipliers_at(at), coefficient_at(system, at, forms)};
}

}  // namespace swirl::analysis
