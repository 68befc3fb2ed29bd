// SPDX-License-Identifier: BSD-3-Clause
// Code that models and scenes share.
#pragma once

#include <functional>
#include <string>

#include "common.hpp"
#include "smurf/dialect.hpp"

namespace smurf::python {

using Model = Ref<LinkedModel>;
using Scene = Ref<LinkedScene>;

/// May be called again and again.
Report check_owned(Owner& owner);
/// Raises when there is a finding that makes a result wrong.
void refuse_errors(Owner& owner, const std::string& path,
                   const std::function<bool(const Diagnostic&)>& is_loss);
/// ValueError when it is gone.
std::string current_folder();

const Dialect& from_dialect(const py::object& name);
/// Raises for findings that leave a pose unknown and, unless `force`, for others that make a result
/// wrong.
void refuse_unknown_poses(const Scene& scene, bool force);

py::tuple reduce(const Ref<urdf::Link>& link);
py::tuple reduce(const Ref<urdf::Joint>& joint);

void bind_kinematics(py::class_<Model>& model);
void bind_exports(py::class_<Model>& model);
void bind_exports(py::class_<Scene>& scene);
void bind_pickle(py::class_<Model>& model);
void bind_pickle(py::class_<Scene>& scene);

}  // namespace smurf::python
