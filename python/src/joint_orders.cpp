// SPDX-License-Identifier: BSD-3-Clause
// The orders of joints that readers build, and the permutations between them.
#include "smurf/joint_order.hpp"

#include "model.hpp"

namespace smurf::python {
namespace {

/// Raises ValueError if the order is not known.
JointOrder order_of(const Model& self, const py::object& reader) {
  JointOrder order = joint_order(*self, *from_target(from_text(reader, "reader")));
  if (order.is_known) return order;
  throw py::value_error("the order of joints of " + std::string(order.reader->name) + ": " +
                        std::string(order.basis));
}

py::array_t<std::int64_t> to_indices(const std::vector<std::size_t>& values) {
  py::module_::import("numpy");  // as in new_array()
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

py::list to_names(const std::vector<std::string>& names) {
  py::list list;
  for (const std::string& name : names) list.append(to_text(name));
  return list;
}

py::dict order_to_dict(const Model& self, const py::object& reader) {
  const JointOrder order = order_of(self, reader);
  py::dict dict;
  dict["reader"] = to_text(order.reader->name);
  dict["walk"] = to_text(order.walk);
  dict["basis"] = to_text(order.basis);
  dict["joints"] = to_names(order.joints);
  dict["indices"] = to_indices(order.indices);
  dict["bodies"] = to_names(order.bodies);
  return dict;
}

py::array_t<std::int64_t> permutation_between(const Model& self, const py::object& from,
                                              const py::object& to) {
  const JointOrder source = order_of(self, from), target = order_of(self, to);
  const auto places = permutation(source.joints, target.joints);
  std::vector<std::size_t> values;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) {
      throw py::value_error(std::string(source.reader->name) + " has no joint '" +
                            target.joints[i] + "', which " + std::string(target.reader->name) +
                            " has");
    }
    values.push_back(*places[i]);
  }
  return to_indices(values);
}

}  // namespace

void bind_joint_orders(py::class_<Model>& model) {
  model
      .def(
          "joint_order", &order_to_dict, py::arg("reader"),
          "The order in which a reader such as \"mujoco\" or \"pinocchio\" builds the robot, a dict: "
          "`joints`, the names of the joints with positions in the order of the positions; "
          "`indices`, an array of their indices in functions of the reader; `bodies`, their names; "
          "`walk` and `basis`, the order in words, and the versions that were executed. Raises "
          "ValueError if the order is not known.")
      .def("joint_permutation", &permutation_between, py::arg("source"), py::arg("target"),
           "An array of integers p: positions q in the order of the reader `source` are q[p] in "
           "that of `target`. Raises ValueError if an order is not known, or if `source` lacks a "
           "joint that `target` has.");
}

}  // namespace smurf::python
