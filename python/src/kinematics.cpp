// SPDX-License-Identifier: BSD-3-Clause
// The poses of the links of a model: for one configuration, or for many at once.
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model.hpp"

namespace smurf::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The positions of one joint: one number for all configurations, or one for each.
struct Column {
  std::string joint;
  double number = 0;
  std::vector<double> numbers{};  ///< empty: `number`
};

/// The configurations for which poses are computed.
struct Configurations {
  std::vector<Column> columns;
  std::optional<std::size_t> count;  ///< none: one, and the results have no such axis
};

void check_joint(const LinkedModel& model, const std::string& joint) {
  if (model.joint_names.contains(joint)) return;
  throw py::value_error("the model has no joint '" + joint + "'");
}

double finite(double position, const std::string& joint) {
  if (std::isfinite(position)) return position;
  throw py::value_error("the position of the joint '" + joint + "' is not finite");
}

/// Movable joints that follow no other joint, in the order of the URDF.
std::vector<const urdf::Joint*> free_joints(const LinkedModel& model) {
  std::vector<const urdf::Joint*> joints;
  if (!model.robot) return joints;
  for (const urdf::Joint& joint : model.robot->joints) {
    if (joint.name && joint.has_one_axis() && !joint.mimic) joints.push_back(&joint);
  }
  return joints;
}

Numbers to_numbers(const py::handle& value) {
  py::module_::import("numpy");  // as in new_array()
  Numbers numbers = Numbers::ensure(value);
  if (!numbers || value.is_none()) {
    PyErr_Clear();
    throw py::type_error("positions must be numbers");
  }
  return numbers;
}

void set_count(Configurations& all, std::size_t count) {
  if (all.count && *all.count != count) {
    throw py::value_error("positions has " + std::to_string(*all.count) + " and " +
                          std::to_string(count) + " configurations");
  }
  all.count = count;
}

Configurations from_dict(const LinkedModel& model, const py::dict& positions) {
  Configurations all;
  for (const auto& [key, value] : positions) {
    const std::string joint = from_text(key, "the name of a joint");
    check_joint(model, joint);
    Column column{joint};
    if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr())) {
      column.number = PyFloat_AsDouble(value.ptr());
      if (column.number == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
      finite(column.number, joint);
    } else {
      const Numbers numbers = to_numbers(value);
      if (numbers.ndim() > 1) {
        throw py::value_error("the positions of the joint '" + joint + "' have " +
                              std::to_string(numbers.ndim()) + " axes, not one");
      }
      const double* first = numbers.data();
      for (py::ssize_t i = 0; i < numbers.size(); ++i) finite(first[i], joint);
      if (numbers.ndim() == 0) {
        column.number = first[0];
      } else {
        column.numbers.assign(first, first + numbers.size());
        set_count(all, column.numbers.size());
      }
    }
    all.columns.push_back(std::move(column));
  }
  return all;
}

/// An array of shape (joints,) or (n, joints).
Configurations from_array(const LinkedModel& model, const py::object& positions,
                          const py::object& joints) {
  std::vector<std::string> names;
  if (joints.is_none()) {
    for (const urdf::Joint* joint : free_joints(model)) names.push_back(*joint->name);
  } else {
    names = from_texts(joints, "joints");
    for (const std::string& name : names) check_joint(model, name);
  }
  const Numbers numbers = to_numbers(positions);
  const py::ssize_t axes = numbers.ndim();
  if (axes < 1 || axes > 2 || numbers.shape(axes - 1) != static_cast<py::ssize_t>(names.size())) {
    throw py::value_error("positions must have the shape (" + std::to_string(names.size()) +
                          ",) or (n, " + std::to_string(names.size()) +
                          "): one column for each joint");
  }
  Configurations all;
  const std::size_t count = axes == 2 ? static_cast<std::size_t>(numbers.shape(0)) : 1;
  if (axes == 2) all.count = count;
  const double* first = numbers.data();
  for (std::size_t i = 0; i < names.size(); ++i) {
    Column column{names[i]};
    for (std::size_t row = 0; row < count; ++row) {
      column.numbers.push_back(finite(first[row * names.size() + i], names[i]));
    }
    if (axes == 1) {
      column.number = column.numbers.front();
      column.numbers.clear();
    }
    all.columns.push_back(std::move(column));
  }
  return all;
}

JointPositions named_set(const LinkedModel& model, const py::object& positions) {
  const std::string name = from_text(positions, "positions");
  auto known = joint_positions(model, name);
  if (!known) throw py::value_error("the model has no joint pose set '" + name + "'");
  return *std::move(known);
}

Configurations configurations_of(const LinkedModel& model, const py::object& positions,
                                 const py::object& joints) {
  if (!joints.is_none() && (positions.is_none() || py::isinstance<py::str>(positions) ||
                            py::isinstance<py::dict>(positions))) {
    throw py::type_error("joints names the columns of an array of positions");
  }
  if (positions.is_none()) return {};
  if (py::isinstance<py::str>(positions)) {
    Configurations all;
    for (auto& [joint, position] : named_set(model, positions)) {
      all.columns.push_back({joint, position});
    }
    return all;
  }
  if (py::isinstance<py::dict>(positions)) {
    return from_dict(model, py::reinterpret_borrow<py::dict>(positions));
  }
  if (!py::isinstance<py::array>(positions) && !PySequence_Check(positions.ptr())) {
    throw py::type_error("positions must be a dict, an array, or the name of a joint pose set");
  }
  return from_array(model, positions, joints);
}

/// Writes the poses of the named links, of all configurations.
class LinkPoses {
 public:
  LinkPoses(const LinkedModel& model, Configurations configurations)
      : model_(model), configurations_(std::move(configurations)) {}

  py::dict run() {
    const std::size_t count = configurations_.count.value_or(1);
    if (!model_.robot) return {};
    // One configuration gives the links that have a pose; it does not depend on positions.
    const auto poses = poses_at(0);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Field<std::string>& name = model_.robot->links[i].name;
      // The first of equal names is the link that has the name.
      if (!poses[i] || !name || model_.link_names.find(*name) != i) continue;
      std::vector<py::ssize_t> shape{4, 4};
      if (configurations_.count) shape.insert(shape.begin(), static_cast<py::ssize_t>(count));
      results_.push_back({i, *name, new_array(shape)});
      targets_.push_back(results_.back().array.mutable_data());
    }
    fill(count);
    py::dict X_RL;
    for (const Result& result : results_) X_RL[to_text(result.name)] = result.array;
    return X_RL;
  }

 private:
  struct Result {
    std::size_t link = 0;
    std::string name;
    py::array_t<double> array;
  };

  std::vector<std::optional<Pose>> poses_at(std::size_t row) {
    for (const Column& column : configurations_.columns) {
      if (column.numbers.empty()) {
        if (row == 0) positions_[column.joint] = column.number;
      } else if (row < column.numbers.size()) {
        positions_[column.joint] = column.numbers[row];
      }
    }
    return forward_kinematics(model_, positions_);
  }

  void fill(std::size_t count) {
    for (std::size_t row = 0; row < count; ++row) {
      const auto poses = poses_at(row);
      for (std::size_t i = 0; i < results_.size(); ++i) {
        write_matrix4(*poses[results_[i].link], targets_[i] + 16 * row);
      }
    }
  }

  const LinkedModel& model_;
  Configurations configurations_;
  JointPositions positions_;
  std::vector<Result> results_;
  std::vector<double*> targets_;
};

py::dict link_poses(const Model& self, const py::object& positions, const py::object& joints) {
  return LinkPoses(*self, configurations_of(*self, positions, joints)).run();
}

py::object named_positions(const Model& self, const py::object& pose) {
  py::dict positions;
  for (const auto& [joint, position] : named_set(*self, pose)) {
    positions[to_text(joint)] = position;
  }
  return positions;
}

}  // namespace

void bind_kinematics(py::class_<Model>& model) {
  model
      .def_property_readonly(
          "free_joints",
          [](const Model& self) {
            py::list joints;
            for (const urdf::Joint* joint : free_joints(*self)) {
              joints.append(Ref<urdf::Joint>{self.owner, joint});
            }
            return joints;
          },
          "A new list of smurf.Joint: those with one axis that mimic no other joint, in the order of "
          "the URDF. They are the columns of arrays of positions.")
      .def(
          "forward_kinematics", &link_poses, py::arg("positions") = py::none(),
          py::arg("joints") = py::none(),
          "The poses of the links: a dict from names of links to X_RL, the pose of the link L in the "
          "first root link R, an array of shape (4, 4), m.\n\n"
          "`positions` is a dict from names of joints to rad or m, the name of a joint pose set, or an "
          "array of shape (joints,) with a number for each of `free_joints`, or for each of the names "
          "in `joints`. Joints that it leaves out are at zero, and those that mimic others follow "
          "them. Arrays of shape (n, joints), or arrays of shape (n,) in the dict, are n "
          "configurations: the results have the shape (n, 4, 4). Links that the root does not reach "
          "are left out.")
      .def("joint_positions", &named_positions, py::arg("pose"),
           "The positions of a joint pose set by joints: a dict, rad or m.");
}

}  // namespace smurf::python
