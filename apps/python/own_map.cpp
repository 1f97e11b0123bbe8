#include "apps/python/own_map.hpp"

#include "analysis/continuation/continue_branch.hpp"
#include "analysis/continuation/switch_branch.hpp"
#include "analysis/cycles/find_cycles.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "analysis/section_map.hpp"

#include <fmt/format.h>
#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl::python {

namespace {

namespace py = pybind11;
namespace an = swirl::analysis;

constexpr int most_dimensions = 6;  // of exponents, which are compiled for each

/// F, dF/dz and dF/dp as the user's function gives them. What it throws ends the analysis: it is kept until then, for
/// solvers between here and there know nothing of Python's exceptions.
class OwnStep {
public:
    explicit OwnStep(py::object function) : function_(std::move(function)) {}

    an::ShootingStep at(const Eigen::VectorXd& z, double p) {
        an::ShootingStep step;
        if (failure_) return step;
        const py::gil_scoped_acquire alone;
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            std::tie(step.state, step.by_state, step.by_parameter) =
                function_(z, p).cast<std::tuple<Eigen::VectorXd, Eigen::MatrixXd, Eigen::MatrixXd>>();
            const auto d = z.size();
            if (step.state.size() != d || step.by_state.rows() != d || step.by_state.cols() != d)
                throw std::invalid_argument(
                    fmt::format("the map gives {} coordinates and a derivative of {} x {}; {} are wanted",
                                step.state.size(), step.by_state.rows(), step.by_state.cols(), d));
            step.alive = step.state.allFinite() && step.by_state.allFinite() && step.by_parameter.allFinite();
        } catch (...) {
            failure_ = std::current_exception();
        }
        return step;
    }

    bool has_failed() const { return failure_ != nullptr; }
    void rethrow() {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

private:
    py::object function_;
    std::exception_ptr failure_;
};

template <int D>
struct SectionOfOwn {
    static constexpr int dimension = D;
    OwnStep& step;
    double p;
    const std::vector<double>& angles;

    double angle_period(int i) const { return angles[static_cast<std::size_t>(i)]; }
    an::Advance<D> advance(const an::Vector<D>& z) const {
        const an::ShootingStep taken = step.at(z, p);
        an::Advance<D> result;
        result.alive = taken.alive;
        if (taken.alive) result.state = taken.state;
        return result;
    }
    an::Linearised<D> linearise(const an::Vector<D>& z) const {
        const an::ShootingStep taken = step.at(z, p);
        an::Linearised<D> result;
        result.alive = taken.alive;
        if (!taken.alive) return result;
        result.state = taken.state;
        result.derivative = taken.by_state;
        return result;
    }
};

using Points = std::vector<Eigen::VectorXd>;

py::dict shown(const an::Cycle& cycle) {
    return py::dict(py::arg("points") = cycle.points, py::arg("residual") = cycle.residual,
                    py::arg("multipliers") = cycle.multipliers,
                    py::arg("stability") = std::string(an::name_of(cycle.stability)), py::arg("index") = cycle.index);
}

py::dict shown(const an::BranchPoint& point) {
    return py::dict(py::arg("parameter") = point.at.p(), py::arg("points") = point.at.points(),
                    py::arg("multipliers") = point.multipliers,
                    py::arg("stability") = std::string(an::name_of(point.stability)));
}

py::dict shown(const an::Branch& branch) {
    py::list points, special;
    for (const an::BranchPoint& point : branch.points) points.append(shown(point));
    for (const an::SpecialPoint& one : branch.special) {
        py::dict dict = shown(one.cycle);
        dict["kind"] = one.kind == an::SpecialKind::border ? one.border : std::string(an::name_of(one.kind));
        special.append(dict);
    }
    return py::dict(py::arg("period") = branch.period(), py::arg("points") = points, py::arg("special") = special,
                    py::arg("parent") = branch.parent);
}

class OwnMap {
public:
    OwnMap(py::object function, int dimension, std::vector<double> angles)
        : step_(std::move(function)), angles_(std::move(angles)) {
        map_.dimension = dimension;
        map_.angle_periods = angles_;
        map_.has_parameter = true;
        map_.step = [this](const Eigen::VectorXd& z, double p) { return step_.at(z, p); };
    }
    OwnMap(const OwnMap&) = delete;
    OwnMap& operator=(const OwnMap&) = delete;

    py::list cycles(const std::vector<Points>& candidates, double p, int period, double accept) {
        an::SearchOptions options;
        options.period = period;
        options.accept = accept;
        options.threads = 1;  // Python's lock is one
        options.stop = [this] { return step_.has_failed(); };
        const auto found = without_lock([&] { return an::find_cycles(map_, p, candidates, options); });
        py::list result;
        for (const an::Cycle& cycle : found.cycles) result.append(shown(cycle));
        return result;
    }

    py::list branches(const Points& cycle, double p, double low, double high, double longest_step, int depth) {
        an::ContinuationOptions options;
        options.low = low;
        options.high = high;
        options.longest_step = longest_step;
        options.first_step = std::min(options.first_step, longest_step);
        options.stop = [this] { return step_.has_failed(); };
        const auto found = without_lock([&] {
            std::vector<an::Branch> all(1);
            if (!an::continue_branch(map_, cycle, p, options, all.front())) all.clear();
            for (std::size_t begin = 0; depth > 0 && begin < all.size(); --depth) {
                const std::size_t end = all.size();
                for (std::size_t parent = begin; parent < end; ++parent) switch_at(all, parent, options);
                begin = end;
            }
            return all;
        });
        py::list result;
        for (const an::Branch& branch : found) result.append(shown(branch));
        return result;
    }

    py::dict exponents(const Eigen::VectorXd& z, double p, std::int64_t steps, std::int64_t transient) {
        an::LyapunovOptions options;
        options.steps = steps;
        options.transient = transient;
        const auto s = without_lock([&] { return exponents_of<1>(z, p, options); });
        return py::dict(py::arg("outcome") = std::string(an::name_of(s.outcome)), py::arg("steps") = s.steps,
                        py::arg("exponents") = s.exponents, py::arg("standard_errors") = s.standard_errors,
                        py::arg("weighted_exponents") = s.weighted_exponents);
    }

private:
    template <class Work>
    std::invoke_result_t<Work> without_lock(const Work& work) {
        auto result = [&] {
            const py::gil_scoped_release others_go_on;
            return work();
        }();
        step_.rethrow();
        return result;
    }

    /// The branches that cross this one, or double its period, as far as none of those before passes there.
    void switch_at(std::vector<an::Branch>& all, std::size_t parent, const an::ContinuationOptions& options) {
        for (std::size_t i = 0; i < all[parent].special.size(); ++i) {
            const an::SpecialPoint special = all[parent].special[i];
            if (special.kind != an::SpecialKind::flip && special.kind != an::SpecialKind::branch_point) continue;
            const auto is_known = [&](const an::CurvePoint& first) {
                for (const an::Branch& branch : all)
                    if (branch.period() == first.shooting.period &&
                        an::find_on_branch(map_, branch, first.p(), first.points()))
                        return true;
                return false;
            };
            an::Branch branch;
            if (!an::switch_branch(map_, special, options, branch, is_known)) continue;
            branch.parent = static_cast<int>(parent);
            branch.parent_special = static_cast<int>(i);
            all.push_back(std::move(branch));
        }
    }

    template <int D>
    an::LyapunovSpectrum exponents_of(const Eigen::VectorXd& z, double p, const an::LyapunovOptions& options) {
        if (map_.dimension == D)
            return an::lyapunov_spectrum(SectionOfOwn<D>{step_, p, angles_}, an::Vector<D>(z), options);
        if constexpr (D < most_dimensions) return exponents_of<D + 1>(z, p, options);
        throw std::invalid_argument(fmt::format("dimension = {}: exponents are those of maps of 1 to {} coordinates",
                                                map_.dimension, most_dimensions));
    }

    OwnStep step_;
    std::vector<double> angles_;
    an::ShootingMap map_;
};

}  // namespace

void add_own_map(py::module_& module) {
    py::class_<OwnMap>(module, "OwnMap")
        .def(py::init<py::object, int, std::vector<double>>(), py::arg("function"), py::arg("dimension"),
             py::arg("angles"))
        .def("cycles", &OwnMap::cycles, py::arg("candidates"), py::arg("p"), py::arg("period"), py::arg("accept"))
        .def("branches", &OwnMap::branches, py::arg("cycle"), py::arg("p"), py::arg("low"), py::arg("high"),
             py::arg("longest_step"), py::arg("depth"))
        .def("exponents", &OwnMap::exponents, py::arg("z"), py::arg("p"), py::arg("steps"), py::arg("transient"));
}

}  // namespace swirl::python
