// A map of the user's own, z -> F(z; p) by a Python function, given to analysis/: its cycles, branches and exponents.
#pragma once

namespace pybind11 {

class module_;

}  // namespace pybind11

namespace swirl::python {

/// Adds the class OwnMap to the module; swirl/analysis.py has what users see.
void add_own_map(pybind11::module_& module);

}  // namespace swirl::python
