#include "analysis/continuation/normal_form.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/linear_algebra/dense.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>

namespace swirl::analysis {

std::vector<std::complex<double>> multipliers_at(const CurvePoint& point) {
    return sorted_multipliers(monodromy(point.shooting));
}

double flip_function(const std::vector<std::complex<double>>& multipliers) {
    std::complex<double> product = 1;
    for (const auto& m : multipliers) product *= 1.0 + m;
    return product.real();
}

double neimark_sacker_function(const std::vector<std::complex<double>>& multipliers) {
    std::complex<double> product = 1;
    for (std::size_t i = 0; i < multipliers.size(); ++i)
        for (std::size_t j = i + 1; j < multipliers.size(); ++j) product *= multipliers[i] * multipliers[j] - 1.0;
    return product.real();
}

double crossing_function(const CurveProblem& problem, const CurvePoint& point) {
    return determinant_of(bordered(problem, point.shooting, point.tangent));
}

namespace {

using Complex = std::complex<double>;
using ComplexState = Eigen::VectorXcd;

/// B and C extended to complex vectors; `ok` falls if a difference could not be taken.
class Forms {
public:
    explicit Forms(const HigherForms& forms) : forms_(forms) {}
    bool ok = true;

    ComplexState b(const ComplexState& u, const ComplexState& v) { return matrix_along(u) * v; }
    ComplexState c(const ComplexState& u, const ComplexState& v, const ComplexState& w) {
        const Eigen::MatrixXcd real = second(u.real(), v.real()) - second(u.imag(), v.imag());
        const Eigen::MatrixXcd imaginary = second(u.real(), v.imag()) + second(u.imag(), v.real());
        return (real + Complex(0, 1) * imaginary) * w;
    }

private:
    Eigen::MatrixXcd matrix_along(const ComplexState& u) { return first(u.real()) + Complex(0, 1) * first(u.imag()); }
    Eigen::MatrixXcd first(const Eigen::VectorXd& u) {
        if (u.isZero(0)) return Eigen::MatrixXcd::Zero(u.size(), u.size());
        const auto value = forms_.first(u, 0);
        ok = ok && value.has_value();
        return value ? Eigen::MatrixXcd(value->cast<Complex>()) : Eigen::MatrixXcd::Zero(u.size(), u.size());
    }
    Eigen::MatrixXcd second(const Eigen::VectorXd& u, const Eigen::VectorXd& v) {
        if (u.isZero(0) || v.isZero(0)) return Eigen::MatrixXcd::Zero(u.size(), u.size());
        const auto value = forms_.second(u, v);
        ok = ok && value.has_value();
        return value ? Eigen::MatrixXcd(value->cast<Complex>()) : Eigen::MatrixXcd::Zero(u.size(), u.size());
    }

    const HigherForms& forms_;
};

/// dm/dp along the branch.
std::optional<Complex> multiplier_slope(const CriticalPoint& point, const EigenPair& pair) {
    const auto change = point.forms.first(point.branch_slope, 1);
    if (!change) return std::nullopt;
    return pair.left.dot(change->cast<Complex>() * pair.right);  // dot conjugates its first argument
}

ComplexState solved(const Eigen::MatrixXcd& matrix, const ComplexState& right) {
    return matrix.fullPivLu().solve(right);
}

}  // namespace

EigenPair eigen_pair(const Eigen::MatrixXd& a, Complex m) {
    const Eigen::MatrixXcd shifted = a.cast<Complex>() - m * Eigen::MatrixXcd::Identity(a.rows(), a.cols());
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(shifted, Eigen::ComputeFullU | Eigen::ComputeFullV);
    EigenPair pair{svd.matrixV().rightCols(1), svd.matrixU().rightCols(1)};
    if (m.imag() == 0) {  // a real vector times a phase
        Eigen::Index largest;
        pair.right.cwiseAbs().maxCoeff(&largest);
        pair.right *= std::conj(pair.right[largest]) / std::abs(pair.right[largest]);
        pair.right = pair.right.real().cast<Complex>().eval();
        pair.right.normalize();
    }
    // ⟨p, q⟩ = conj(p)·q = 1.
    pair.left /= std::conj(pair.left.dot(pair.right));
    return pair;
}

std::optional<NormalForm> fold_form(const CriticalPoint& point) {
    const EigenPair pair = eigen_pair(point.derivative, 1);
    Forms forms(point.forms);
    NormalForm form;
    form.parameter = pair.left.dot(point.by_parameter.cast<Complex>());
    form.nonlinear = 0.5 * pair.left.dot(forms.b(pair.right, pair.right));
    return forms.ok ? std::optional(form) : std::nullopt;
}

std::optional<NormalForm> flip_form(const CriticalPoint& point) {
    const EigenPair pair = eigen_pair(point.derivative, -1);
    const auto n = point.derivative.rows();
    const ComplexState& q = pair.right;
    Forms forms(point.forms);
    const Eigen::MatrixXcd complement = Eigen::MatrixXcd::Identity(n, n) - point.derivative.cast<Complex>();
    const ComplexState bent = solved(complement, forms.b(q, q));
    NormalForm form;
    form.nonlinear = pair.left.dot(ComplexState(forms.c(q, q, q) + 3.0 * forms.b(q, bent))) / 6.0;
    form.supercritical = form.nonlinear.real() > 0;
    const auto slope = multiplier_slope(point, pair);
    if (!forms.ok || !slope) return std::nullopt;
    form.parameter = *slope;
    return form;
}

std::optional<NormalForm> neimark_sacker_form(const CriticalPoint& point, Complex multiplier) {
    EigenPair pair = eigen_pair(point.derivative, multiplier);
    pair.right *= std::sqrt(0.5);
    pair.left /= std::sqrt(0.5);
    const auto n = point.derivative.rows();
    const ComplexState& q = pair.right;
    const ComplexState conjugate = q.conjugate();
    const Complex turn = multiplier / std::abs(multiplier);
    Forms forms(point.forms);
    const Eigen::MatrixXcd a = point.derivative.cast<Complex>();
    const Eigen::MatrixXcd identity = Eigen::MatrixXcd::Identity(n, n);
    const ComplexState mean = solved(identity - a, forms.b(q, conjugate));
    const ComplexState second = solved(turn * turn * identity - a, forms.b(q, q));
    NormalForm form;
    form.angle = std::arg(multiplier);
    const ComplexState all = forms.c(q, q, conjugate) + 2.0 * forms.b(q, mean) + forms.b(conjugate, second);
    form.nonlinear = 0.5 * std::conj(turn) * pair.left.dot(all);
    form.supercritical = form.nonlinear.real() < 0;
    const auto slope = multiplier_slope(point, pair);
    if (!forms.ok || !slope) return std::nullopt;
    form.parameter = *slope / turn;
    return form;
}

}  // namespace swirl::analysis
