// SPDX-License-Identifier: BSD-3-Clause
// Pickles say what was loaded, and by which function; reading one loads it again.
#include <cstddef>
#include <vector>

#include "model.hpp"

namespace smurf::python {
namespace {

py::object helper(const char* name) { return py::module_::import("smurf._pickle").attr(name); }

py::tuple recipe_of(const Owner& owner) {
  if (owner.recipe) return py::make_tuple(helper("load"), owner.recipe);
  throw py::type_error(
      "what a Session has loaded cannot be pickled: its texts may be on no disk; load it with "
      "smurf.load_model(), smurf.load_scene() or smurf.parse_urdf()");
}

template <class T>
std::size_t index_of(const T* value, const std::vector<T>& values) {
  return static_cast<std::size_t>(value - values.data());
}

py::tuple reduce_scene(const Scene& self) { return recipe_of(*self.owner); }

py::tuple reduce_model(const Model& self) {
  if (self.owner->model) return recipe_of(*self.owner);
  const LinkedScene& scene = self.owner->scene->scene;
  return py::make_tuple(helper("part"), py::make_tuple(Scene{self.owner, &scene}, "models",
                                                       index_of(self.value, scene.models)));
}

/// The model with this link or joint.
template <class T>
py::tuple reduce_part(const Ref<T>& self, const char* list, std::vector<T> urdf::Robot::*member) {
  const auto has_it = [&](const LinkedModel& model) {
    if (!model.robot) return false;
    const std::vector<T>& all = *model.robot.*member;
    return !all.empty() && self.value >= all.data() && self.value < all.data() + all.size();
  };
  const auto reduced = [&](const LinkedModel& model) {
    return py::make_tuple(helper("part"),
                          py::make_tuple(Model{self.owner, &model}, list,
                                         index_of(self.value, *model.robot.*member)));
  };
  if (self.owner->model) return reduced(self.owner->model->model);
  for (const LinkedModel& model : self.owner->scene->scene.models) {
    if (has_it(model)) return reduced(model);
  }
  throw py::type_error("this part of a scene cannot be pickled");
}

}  // namespace

void bind_pickle(py::class_<Model>& model) { model.def("__reduce__", &reduce_model); }
void bind_pickle(py::class_<Scene>& scene) { scene.def("__reduce__", &reduce_scene); }

py::tuple reduce(const Ref<urdf::Link>& link) {
  return reduce_part(link, "links", &urdf::Robot::links);
}
py::tuple reduce(const Ref<urdf::Joint>& joint) {
  return reduce_part(joint, "joints", &urdf::Robot::joints);
}

}  // namespace smurf::python
