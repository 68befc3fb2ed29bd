// SPDX-License-Identifier: BSD-3-Clause
// smurf._smurf: the library as Python has it. What users see is named in python/smurf/__init__.py.
#include "common.hpp"

PYBIND11_MODULE(_smurf, module) {
  using namespace smurf::python;
  module.attr("__version__") = SMURF_VERSION;
  bind_places(module);
  bind_findings(module);
  bind_robot(module);
  bind_annotations(module);
  bind_model(module);
  bind_scene(module);
  bind_session(module);
}
