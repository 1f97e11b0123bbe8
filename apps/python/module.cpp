// The Python module swirl._swirl: what the package in swirl/ is made of.
#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/python/background.hpp"
#include "apps/python/command_run.hpp"
#include "apps/python/own_map.hpp"
#include "apps/python/scene_texts.hpp"
#include "apps/record/record_error.hpp"
#include "apps/studies/scene_map/scene_function.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::python {

namespace {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What a command has printed. Documents may have tens of megabytes: they become bytes where somebody reads them.
struct PrintedText {
    std::vector<std::string> pieces;

    std::size_t size() const {
        std::size_t size = 0;
        for (const std::string& piece : pieces) size += piece.size();
        return size;
    }
    py::bytes bytes() const {
        PyObject* const whole = PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(size()));
        if (whole == nullptr) throw py::error_already_set();
        char* place = PyBytes_AS_STRING(whole);
        for (const std::string& piece : pieces) place = std::copy(piece.begin(), piece.end(), place);
        return py::reinterpret_steal<py::bytes>(whole);
    }
};

py::tuple run(const std::vector<std::string>& words, const py::object& progress) {
    Look look;
    if (!progress.is_none())
        look = [&progress](const std::string& task, double total, double done) { progress(task, total, done); };
    CommandResult result = run_command(words, look);
    py::object raised = py::none();
    if (result.raised) {
        try {
            std::rethrow_exception(result.raised);
        } catch (const py::error_already_set& error) {
            raised = error.value();
        }
    }
    return py::make_tuple(result.code, PrintedText{std::move(result.text)}, result.messages, result.failure, raised);
}

py::list commands() {
    py::list all;
    for (const apps::CommandDefinition& command : definition().commands) {
        py::list options;
        for (const apps::OptionDefinition& o : command.options)
            options.append(py::dict(py::arg("flags") = o.flags, py::arg("place") = o.place,
                                    py::arg("values") = o.values, py::arg("value") = o.value,
                                    py::arg("range") = o.range, py::arg("words") = o.words, py::arg("help") = o.help,
                                    py::arg("group") = o.group, py::arg("required") = o.required,
                                    py::arg("several") = o.several));
        all.append(py::dict(py::arg("name") = command.name, py::arg("does") = command.does,
                            py::arg("details") = command.details, py::arg("options") = options));
    }
    return all;
}

/// What is asked of a scene's numbers.
class SceneOfPython {
public:
    explicit SceneOfPython(const std::vector<std::string>& words)
        : read_(read_scene(words)), function_(studies::function_of(read_.scene)) {}

    const SceneTexts& texts() const { return read_.texts; }

    py::dict values() const {
        const Scene<double>& s = read_.scene;
        const py::object sides = s.is_disk() ? py::object(py::str("disk")) : py::object(py::int_(s.sides));
        py::object units = py::none();
        if (read_.units)
            units = py::dict(py::arg("length") = read_.units->length, py::arg("time") = read_.units->time,
                             py::arg("mass") = read_.units->mass);
        py::dict all(py::arg("sides") = sides, py::arg("alpha") = s.alpha, py::arg("beta") = s.beta,
                     py::arg("mu") = s.mu, py::arg("restitution") = s.restitution,
                     py::arg("law") = std::string(name_of(s.law)), py::arg("inertia_factor") = s.inertia_factor,
                     py::arg("units") = units);
        if (s.tangential_restitution != 0) all["tangential_restitution"] = s.tangential_restitution;
        if (s.is_rounded()) all["corner"] = s.corner;
        if (!s.acts_in_flight()) return all;
        if (s.has_drag()) {
            all["drag"] = s.drag;
            all["spin_drag"] = s.turning_drag();
        } else {
            all["floor_friction"] = s.floor_friction;
            all["gravity_ratio"] = s.gravity_ratio;
        }
        all["floor"] = std::string(name_of(s.floor));
        return all;
    }

    py::object map(const Array& z, std::int64_t steps, int threads, bool with_outcomes) const {
        if (steps < 0) throw std::invalid_argument(fmt::format("steps = {} is outside its range: 0 or more", steps));
        const std::size_t rows = rows_of(z);
        Array image(shape_of(z));
        py::array_t<std::uint8_t> outcomes(static_cast<py::ssize_t>(rows));
        const std::span<const double> from(z.data(), static_cast<std::size_t>(z.size()));
        const std::span<double> to(image.mutable_data(), static_cast<std::size_t>(image.size()));
        const std::span<std::uint8_t> ends(outcomes.mutable_data(), rows);
        compute(static_cast<double>(rows) * static_cast<double>(steps),
                [=, this](const std::function<bool()>& stop) { function_->map(from, steps, threads, to, ends, stop); });
        return with_outcomes ? py::object(py::make_tuple(image, outcomes)) : py::object(image);
    }

    py::object derivative(const Array& z, int threads, bool with_outcomes) const {
        const std::size_t rows = rows_of(z);
        std::vector<py::ssize_t> shape = shape_of(z);
        Array image(shape);
        shape.push_back(function_->dimension());
        Array derivative(shape);
        py::array_t<std::uint8_t> outcomes(static_cast<py::ssize_t>(rows));
        const std::span<const double> from(z.data(), static_cast<std::size_t>(z.size()));
        const std::span<double> to(image.mutable_data(), static_cast<std::size_t>(image.size()));
        const std::span<double> by(derivative.mutable_data(), static_cast<std::size_t>(derivative.size()));
        const std::span<std::uint8_t> ends(outcomes.mutable_data(), rows);
        compute(10 * static_cast<double>(rows), [=, this](const std::function<bool()>& stop) {
            function_->derivative(from, threads, to, by, ends, stop);
        });
        return with_outcomes ? py::object(py::make_tuple(derivative, outcomes)) : py::object(derivative);
    }

private:
    static std::vector<py::ssize_t> shape_of(const Array& z) { return {z.shape(), z.shape() + z.ndim()}; }

    /// @throws std::invalid_argument unless it is one state or rows of them
    std::size_t rows_of(const Array& z) const {
        const py::ssize_t d = function_->dimension();
        if ((z.ndim() != 1 && z.ndim() != 2) || z.shape(z.ndim() - 1) != d)
            throw std::invalid_argument(fmt::format("z has the shape ({}); ({}) or (n, {}) is wanted: {} of each state",
                                                    fmt::join(shape_of(z), ", "), d, d,
                                                    d == 4 ? "psi, vn, vt, S" : "psi, chi, vn, vt, S"));
        return z.ndim() == 1 ? 1 : static_cast<std::size_t>(z.shape(0));
    }

    /// Some steps at once; more beside Python, so that others go on and signals are heard.
    template <class Work>
    static void compute(double steps, const Work& work) {
        static const std::function<bool()> never = [] { return false; };
        constexpr double few = 100, some = 100'000;  // 10 µs, 10 ms
        if (steps <= few) return work(never);
        if (steps <= some) {
            const py::gil_scoped_release others_go_on;
            return work(never);
        }
        std::atomic<bool> stopped = false;
        std::exception_ptr failure;
        Watch watch;
        watch.stop = [&stopped] { stopped = true; };
        watch.is_finishing = [] { return true; };  // it looks, and uses what is Python's
        const Background background = run_beside(
            [&] {
                try {
                    work([&stopped] { return stopped.load(); });
                } catch (...) {
                    failure = std::current_exception();
                }
            },
            watch);
        if (background.raised) std::rethrow_exception(background.raised);
        if (failure) std::rethrow_exception(failure);
    }

    ReadScene read_;
    std::unique_ptr<studies::SceneFunction> function_;
};

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const apps::BadInput& error) {
        PyErr_SetString(PyExc_ValueError, error.what());
    } catch (const apps::RecordError& error) {
        PyErr_SetString(PyExc_OSError, error.what());
    }
}

}  // namespace

}  // namespace swirl::python

PYBIND11_MODULE(_swirl, m) {
    namespace py = pybind11;
    using namespace swirl::python;
    py::register_exception_translator(translate);
    m.attr("version") = swirl::apps::version();
    m.attr("instruction_set") = swirl::apps::instruction_set();
    m.attr("outcomes") = py::tuple(py::cast(swirl::studies::outcome_names()));
    py::class_<PrintedText>(m, "PrintedText").def("__len__", &PrintedText::size).def("__bytes__", &PrintedText::bytes);
    m.def("run", run, py::arg("words"), py::arg("progress") = py::none(),
          "(exit code, PrintedText of standard output, messages, failure, what a signal raised) of a command line.");
    m.def("commands", commands, "The commands with their flags.");
    m.def("scene_names", scene_names, "The names of a scene's flags.");
    m.def("scene_of_record", scene_of_record, py::arg("record"), "Texts of a record's scene, by flag.");
    add_own_map(m);
    py::class_<SceneOfPython>(m, "Scene")
        .def(py::init<const std::vector<std::string>&>(), py::arg("words"))
        .def("texts", &SceneOfPython::texts)
        .def("values", &SceneOfPython::values)
        .def("map", &SceneOfPython::map, py::arg("z"), py::arg("steps") = 1, py::arg("threads") = 0,
             py::arg("outcomes") = false)
        .def("derivative", &SceneOfPython::derivative, py::arg("z"), py::arg("threads") = 0,
             py::arg("outcomes") = false);
}
