// SPDX-License-Identifier: BSD-3-Clause
// Code that models and scenes share.
#pragma once

#include <string>

#include "common.hpp"
#include "smurf/conversion.hpp"

namespace smurf::python {

using Model = Ref<LinkedModel>;
using Scene = Ref<LinkedScene>;

/// May be called again and again.
Report check_owned(Owner& owner);

const Dialect& from_dialect(const py::object& name);
/// Raises for the refusal of a conversion: ValueError if it is about options, else smurf.Error with
/// the findings of the report that make the result wrong.
void refuse(const std::string& path, const Refusal& refusal, Report report,
            const SourceMap& sources, const LossOf& loss_of);
void refuse(const Scene& scene, const Refusal& refusal, Report report);

py::tuple reduce(const Ref<urdf::Link>& link);
py::tuple reduce(const Ref<urdf::Joint>& joint);

void bind_joint_orders(py::class_<Model>& model);
void bind_kinematics(py::class_<Model>& model);
void bind_exports(py::class_<Model>& model);
void bind_exports(py::class_<Scene>& scene);
void bind_pickle(py::class_<Model>& model);
void bind_pickle(py::class_<Scene>& scene);

}  // namespace smurf::python
