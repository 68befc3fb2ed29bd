// SPDX-License-Identifier: BSD-3-Clause
// Two versions of a model or scene, compared as smurf-diff compares them.
#include <string>
#include <utility>

#include "common.hpp"
#include "smurf-diff/versions.hpp"
#include "smurf/diff.hpp"

namespace smurf::python {
namespace {

struct Comparison {
  std::vector<Difference> differences;
  SourceMap sources;
  DiffInputs inputs;

  std::string json() const {
    return render_diff_json(differences, sources, inputs, {"smurf (Python)", SMURF_VERSION});
  }
};

py::object to_differences(const Comparison& self) {
  return py::module_::import("json").attr("loads")(to_text(self.json()))["differences"];
}

py::object compare(const py::object& before, const py::object& after, double tolerance,
                   const py::kwargs& keywords) {
  const CheckSettings settings = settings_of(keywords);
  if (!(tolerance >= 0)) throw py::value_error("tolerance must be 0 or more");
  tools::Options options;
  options.tolerance = tolerance;
  options.packages = settings.packages;
  options.environment = settings.xacro.environment;
  const auto version = [&](const std::string& path) {
    return tools::InputVersion{.path = path, .shown = path, .xacro = settings.xacro};
  };
  Session session;
  const tools::InputVersion old_one = version(from_path(before));
  const tools::InputVersion new_one = version(from_path(after));
  const auto compared = tools::compare_versions(session, old_one, new_one, options);
  if (!compared.is_known()) {
    raise_error(compared.problem.empty()
                    ? "'" + old_one.path + "' and '" + new_one.path + "' cannot be compared"
                    : compared.problem,
                to_findings(compared.trouble, session.loaded_sources()));
  }
  return py::cast(Comparison{
      compared.differences, session.loaded_sources(), {old_one.path, new_one.path, tolerance}});
}

}  // namespace

void bind_comparison(py::module_& module) {
  py::class_<Comparison>(module, "Comparison", "What differs between two versions of a robot.")
      .def_property_readonly(
          "differences", &to_differences,
          "A new list of dicts, as in the JSON report (schemas/diff-report.schema.json).")
      .def(
          "text",
          [](const Comparison& self) {
            return to_text(render_diff(self.differences, self.sources));
          },
          "As smurf-diff shows it.")
      .def(
          "to_json", [](const Comparison& self) { return to_text(self.json()); },
          "The report as JSON text (schemas/diff-report.schema.json).")
      .def("__len__", [](const Comparison& self) { return self.differences.size(); })
      .def("__iter__", [](const Comparison& self) { return py::iter(to_differences(self)); })
      .def("__str__",
           [](const Comparison& self) {
             return to_text(render_diff(self.differences, self.sources));
           })
      .def("__repr__", [](const Comparison& self) {
        return py::str("<smurf.Comparison: {} differences>").format(self.differences.size());
      });
  module.def(
      "diff", &compare, py::arg("before"), py::arg("after"), py::arg("tolerance") = 1e-9,
      "Compares two versions of a model, URDF, xacro file or scene by what they mean for the robot, "
      "as smurf-diff does, and returns a smurf.Comparison. Keyword arguments: `packages`, `args`, "
      "`xacro_env`. Raises smurf.Error when one cannot be read.");
}

}  // namespace smurf::python
