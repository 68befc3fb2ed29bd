// SPDX-License-Identifier: BSD-3-Clause
// smurf._smurf: the Python binding of the library. python/smurf/__init__.py lists the public names.
#include "common.hpp"

namespace {

/// For classes that only this module makes. Without it, Python could make objects without a value,
/// which nothing checks for: cls.__new__(cls).
PyObject* refuse(PyTypeObject* type, PyObject*, PyObject*) {
  PyErr_Format(PyExc_TypeError, "cannot create or pickle objects of %s", type->tp_name);
  return nullptr;
}

void forbid_construction(const pybind11::module_& module) {
  // The base of all classes has no object of its own; pybind11 ends the interpreter when one is
  // made, as the old protocols of pickle do.
  auto* base = reinterpret_cast<PyTypeObject*>(pybind11::detail::get_internals().instance_base);
  base->tp_new = refuse;
  PyType_Modified(base);
  for (const auto& [name, item] : pybind11::dict(module.attr("__dict__"))) {
    if (!PyType_Check(item.ptr()) || item.is(module.attr("Session"))) continue;
    auto* type = reinterpret_cast<PyTypeObject*>(item.ptr());
    type->tp_new = nullptr;
  }
}

}  // namespace

PYBIND11_MODULE(_smurf, module) {
  using namespace smurf::python;
  module.attr("__version__") = SMURF_VERSION;
  bind_places(module);
  bind_findings(module);
  bind_robot(module);
  bind_annotations(module);
  bind_export(module);
  bind_model(module);
  bind_scene(module);
  bind_session(module);
  bind_comparison(module);
  forbid_construction(module);
}
