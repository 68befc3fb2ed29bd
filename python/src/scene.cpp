// SPDX-License-Identifier: BSD-3-Clause
// A scene: its instances in the world.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model.hpp"
#include "smurf/conversion.hpp"
#include "smurf/flatten.hpp"
#include "smurf/write.hpp"

namespace smurf::python {
namespace {

using SceneInstance = Ref<Instance>;

const LinkedScene& scene_of(const SceneInstance& instance) { return instance.owner->scene->scene; }

/// "none", "world", or what it is fixed to.
py::object attachment(Attachment::Kind kind, const char* none, const std::string& instance,
                      const std::string& link) {
  if (kind == Attachment::Kind::none) return py::str(none);
  if (kind == Attachment::Kind::world) return py::str("world");
  return py::make_tuple(to_text(instance), to_text(link));
}
py::object attachment(const SceneInstance& self, const Attachment& to, const char* none) {
  const bool has_link = to.kind == Attachment::Kind::link;
  return attachment(to.kind, none,
                    has_link ? scene_of(self).instance(to.instance).path : std::string(), to.link);
}
py::object attachment(const FlatAttachment& to, const char* none) {
  return attachment(to.kind, none, to.instance, to.link);
}

template <class Positions>
py::dict to_dict(const Positions& positions) {
  py::dict dict;
  for (const auto& [joint, position] : positions) dict[to_text(joint)] = position;
  return dict;
}

py::object to_matrix(const std::optional<Pose>& pose) {
  if (!pose) return py::none();
  return to_matrix4(*pose);
}

py::object to_python(const Value& value) {
  return std::visit(
      [](const auto& data) -> py::object {
        using Data = std::decay_t<decltype(data)>;
        if constexpr (std::is_same_v<Data, std::monostate>) {
          return py::none();
        } else if constexpr (std::is_same_v<Data, std::string>) {
          return to_text(data);
        } else if constexpr (std::is_same_v<Data, Value::List>) {
          py::list list;
          for (const Value& item : data) list.append(to_python(item));
          return list;
        } else if constexpr (std::is_same_v<Data, Value::Object>) {
          py::dict dict;
          for (const ValueMember& member : data)
            dict[to_text(member.key)] = to_python(member.value);
          return dict;
        } else {
          return py::cast(data);
        }
      },
      value.data);
}

/// A flat scene on its own: it points into nothing.
struct Flat {
  std::shared_ptr<const FlatScene> scene;
  bool has_links = false;
};
struct FlatEntity {
  std::shared_ptr<const FlatScene> scene;
  std::size_t index = 0;

  const FlatInstance* operator->() const { return &scene->instances[index]; }
};

}  // namespace

const Dialect& from_dialect(const py::object& name) {
  const std::string text = from_text(name, "dialect");
  if (const Dialect* dialect = find_dialect(text)) return *dialect;
  std::string known;
  for (const Dialect* dialect : dialects()) known += " " + std::string(dialect->name);
  throw py::value_error("'" + text + "' is not one of the dialects:" + known);
}

namespace {

Flat flatten_scene(const Scene& self, const py::object& dialect, bool links,
                   const py::object& output_folder, bool force) {
  LoadedScene& loaded = *self.owner->scene;
  const FlattenOptions options{
      .links = links, .output_folder = from_path(output_folder), .old_scenes = &loaded.old_scenes};
  FlatResult result =
      convert_to_flat(*self.owner->session, loaded, from_dialect(dialect), options, force);
  refuse(self, result.refusal, std::move(result.report));
  return {std::make_shared<FlatScene>(std::move(result.flat)), links};
}

/// One row for each instance; NaN where a dialect does not load it.
template <class Write>
py::array_t<double> stack(const Flat& self, const std::vector<py::ssize_t>& shape,
                          const Write& write) {
  std::vector<py::ssize_t> whole{static_cast<py::ssize_t>(self.scene->instances.size())};
  py::ssize_t size = 1;
  for (const py::ssize_t length : shape) {
    whole.push_back(length);
    size *= length;
  }
  py::array_t<double> array = new_array(whole);
  double* to = array.mutable_data();
  for (const FlatInstance& instance : self.scene->instances) {
    if (instance.X_WE) {
      write(*instance.X_WE, to);
    } else {
      std::fill_n(to, size, std::numeric_limits<double>::quiet_NaN());
    }
    to += size;
  }
  return array;
}

void write_position(const Pose& pose, double* to) {
  std::copy(pose.position.begin(), pose.position.end(), to);
}

void write_orientation(const Pose& pose, double* to) {
  const Quaternion& q = pose.orientation;
  to[0] = q.w;
  to[1] = q.x;
  to[2] = q.y;
  to[3] = q.z;
}

py::object to_array_of(const std::optional<Pose>& pose, py::ssize_t size,
                       void (*write)(const Pose&, double*)) {
  if (!pose) return py::none();
  py::array_t<double> array = new_array({size});
  write(*pose, array.mutable_data());
  return array;
}

void bind_instance(py::module_& module) {
  py::class_<SceneInstance>(module, "Instance", "An entity of a scene, nested scenes expanded.")
      .def_property_readonly(
          "name", [](const SceneInstance& self) { return to_text(self->name); },
          "As it is written; may repeat, and may be empty.")
      .def_property_readonly(
          "path", [](const SceneInstance& self) { return to_text(self->path); },
          "Unique: \"outer/inner\".")
      .def_property_readonly(
          "type", [](const SceneInstance& self) { return to_text(self->type); },
          "As written, else the extension of the file.")
      .def_property_readonly(
          "file",
          [](const SceneInstance& self) -> py::object {
            if (self->file.empty()) return py::none();
            return to_path(self->file);
          },
          "The path of its file; None when there is none.")
      .def_property_readonly(
          "model",
          [](const SceneInstance& self) {
            return to_optional(self.owner, scene_of(self).model(*self));
          },
          "smurf.Model, or None.")
      .def_property_readonly(
          "X_WE", [](const SceneInstance& self) { return to_matrix(self->X_WE); },
          "Pose of its root link in the world: array of shape (4, 4), m. None when that is not "
          "known because of an error.")
      .def_property_readonly(
          "parent",
          [](const SceneInstance& self) {
            return attachment(self, self->placement.parent, "world");
          },
          "\"world\", or a tuple of the path of an instance and the name of its link.")
      .def_property_readonly(
          "anchor",
          [](const SceneInstance& self) {
            return attachment(self, self->placement.anchor, "none");
          },
          "What it is fixed to: \"none\", \"world\", or as for `parent`.")
      .def_property_readonly(
          "joint_positions",
          [](const SceneInstance& self) { return to_dict(scene_of(self).joint_positions(*self)); },
          "Those of its joint pose set: a dict from joints to rad or m.")
      .def_property_readonly(
          "place",
          [](const SceneInstance& self) {
            return place_of(place_of(scene_of(self).entity(*self)), self.owner->sources());
          },
          "Where it is written.")
      .def("__eq__",
           [](const SceneInstance& a, const py::object& b) {
             return py::isinstance<SceneInstance>(b) && a == b.cast<const SceneInstance&>();
           })
      .def("__hash__",
           [](const SceneInstance& self) { return std::hash<const void*>()(self.value); })
      .def("__repr__", [](const SceneInstance& self) {
        return py::str("<smurf.Instance {!r}>").format(to_text(self->path));
      });
}

void bind_flat_instance(py::module_& module) {
  py::class_<FlatEntity>(module, "FlatInstance", "An instance with its pose in the world.")
      .def_property_readonly(
          "name", [](const FlatEntity& self) { return to_text(self->name); }, "As it is written.")
      .def_property_readonly(
          "path", [](const FlatEntity& self) { return to_text(self->path); },
          "Unique: \"outer/inner\".")
      .def_property_readonly(
          "type", [](const FlatEntity& self) { return to_text(self->type); }, "Type.")
      .def_property_readonly(
          "model",
          [](const FlatEntity& self) -> py::object {
            if (!self->model) return py::none();
            return to_text(self.scene->models[*self->model].id);
          },
          "Id of its model in FlatScene.models; None when it has none.")
      .def_property_readonly(
          "source",
          [](const FlatEntity& self) {
            return py::make_tuple(to_path(self->source_file), self->source_line);
          },
          "File and line of the entity.")
      .def_property_readonly(
          "X_WE", [](const FlatEntity& self) { return to_matrix(self->X_WE); },
          "Pose of the root link in the world: array of shape (4, 4), m. None when the dialect does "
          "not load the entity.")
      .def_property_readonly(
          "position",
          [](const FlatEntity& self) { return to_array_of(self->X_WE, 3, write_position); },
          "In the world: array of shape (3,), m.")
      .def_property_readonly(
          "orientation",
          [](const FlatEntity& self) { return to_array_of(self->X_WE, 4, write_orientation); },
          "In the world: unit quaternion (w, x, y, z), array of shape (4,), w >= 0.")
      .def_property_readonly(
          "parent", [](const FlatEntity& self) { return attachment(self->parent, "world"); },
          "\"world\", or a tuple of the path of an instance and the name of its link.")
      .def_property_readonly(
          "anchor", [](const FlatEntity& self) { return attachment(self->anchor, "none"); },
          "What it is fixed to: \"none\", \"world\", or as for `parent`.")
      .def_property_readonly(
          "joint_positions", [](const FlatEntity& self) { return to_dict(self->joint_positions); },
          "A dict from joints to rad or m.")
      .def_property_readonly(
          "properties", [](const FlatEntity& self) { return to_python(Value{self->properties}); },
          "Every key of the entity that has no attribute, as a dict.")
      .def_property_readonly(
          "links",
          [](const FlatEntity& self) {
            py::dict links;
            for (const auto& [name, X_WL] : self->links) links[to_text(name)] = to_matrix4(X_WL);
            return links;
          },
          "With flatten(links=True): a dict from links to X_WL, the pose in the world, arrays of "
          "shape (4, 4), m.")
      .def("__repr__", [](const FlatEntity& self) {
        return py::str("<smurf.FlatInstance {!r}>").format(to_text(self->path));
      });
}

void bind_flat_scene(py::module_& module) {
  py::class_<FlatModel>(module, "FlatModel", "A model of a flat scene.")
      .def_property_readonly(
          "id", [](const FlatModel& self) { return to_text(self.id); }, "Unique in the scene.")
      .def_property_readonly(
          "type", [](const FlatModel& self) { return to_text(self.type); },
          "\"smurf\" or \"urdf\".")
      .def_property_readonly(
          "file", [](const FlatModel& self) { return to_path(self.file); },
          "Path from the output folder.")
      .def_property_readonly(
          "urdf", [](const FlatModel& self) { return to_path(self.urdf); },
          "Path of its URDF from the output folder; may be empty.");
  py::class_<Flat>(module, "FlatScene",
                   "A scene as a table of instances in the world; what smurfs-flatten writes.")
      .def_property_readonly(
          "models",
          [](const Flat& self) {
            py::list models;
            for (const FlatModel& model : self.scene->models) models.append(model);
            return models;
          },
          "A new list of smurf.FlatModel, each once.")
      .def_property_readonly(
          "instances",
          [](const Flat& self) {
            py::list instances;
            for (std::size_t i = 0; i < self.scene->instances.size(); ++i) {
              instances.append(FlatEntity{self.scene, i});
            }
            return instances;
          },
          "A new list of smurf.FlatInstance, in the order of the scene.")
      .def_property_readonly(
          "X_WE",
          [](const Flat& self) {
            return stack(self, {4, 4}, write_matrix4);
          },
          "Poses of all n instances in the world: array of shape (n, 4, 4), m. NaN where a dialect "
          "does not load one.")
      .def_property_readonly(
          "positions", [](const Flat& self) { return stack(self, {3}, write_position); },
          "Array of shape (n, 3), m, in the world.")
      .def_property_readonly(
          "orientations", [](const Flat& self) { return stack(self, {4}, write_orientation); },
          "Unit quaternions (w, x, y, z): array of shape (n, 4).")
      .def_property_readonly(
          "gravity",
          [](const Flat& self) -> py::object {
            if (!self.scene->physics.gravity) return py::none();
            return to_array(*self.scene->physics.gravity);
          },
          "Array of shape (3,), m/s^2; None when the scene does not say it.")
      .def(
          "to_json",
          [](const Flat& self) { return to_text(write_flat_json(*self.scene, self.has_links)); },
          "As smurfs-flatten writes it (schemas/flat-scene.schema.json).")
      .def("__len__", [](const Flat& self) { return self.scene->instances.size(); })
      .def("__repr__", [](const Flat& self) {
        return py::str("<smurf.FlatScene of {} instances>").format(self.scene->instances.size());
      });
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_instance(module);
  bind_flat_instance(module);
  bind_flat_scene(module);
  py::class_<Scene> scene(module, "Scene", "A scene with all scenes and models in it.");
  scene
      .def_property_readonly(
          "path", [](const Scene& self) { return to_path(self->path); },
          "The path it was loaded by.")
      .def_property_readonly(
          "files",
          [](const Scene& self) {
            py::list files;
            for (const SceneFile& file : self->scenes) files.append(to_path(file.path));
            return files;
          },
          "The scene files, the loaded one first.")
      .def_property_readonly(
          "is_complete", [](const Scene& self) { return self->is_complete; },
          "False when a file is missing or broken.")
      .def_property_readonly(
          "instances", [](const Scene& self) { return to_list(self.owner, self->instances); },
          "A new list of smurf.Instance, depth-first, in the order of the files.")
      .def_property_readonly(
          "models", [](const Scene& self) { return to_list(self.owner, self->models); },
          "A new list of smurf.Model, each file once.")
      .def(
          "instance",
          [](const Scene& self, const py::object& name) {
            const std::string text = from_text(name, "name");
            const auto index = find_instance(*self, text);
            if (!index) throw py::key_error("the scene has no instance '" + text + "'");
            return SceneInstance{self.owner, &self->instance(*index)};
          },
          py::arg("name"), "An instance by its path, else the first by its name; or KeyError.")
      .def(
          "check",
          [](const Scene& self) {
            return to_report(check_owned(*self.owner), self.owner->sources());
          },
          "Checks the scene as it was loaded, and returns a smurf.Report.")
      .def(
          "flatten", &flatten_scene, py::kw_only(), py::arg("dialect") = "spec",
          py::arg("links") = false, py::arg("output_folder") = ".", py::arg("force") = false,
          "The scene as a smurf.FlatScene, as smurfs-flatten has it. `links` adds the poses of all "
          "links, `dialect` places entities as MARS or Phobos does. Raises smurf.Error for a scene "
          "with errors; `force` ignores those that leave every pose known.")
      .def(
          "to_json",
          [](const Scene& self) {
            auto text = write_scene_json(*self, self.owner->sources());
            if (!text) throw py::value_error("the scene is too large for a JSON text");
            return to_text(*text);
          },
          "Everything that was read, as JSON text (schemas/model-dump.schema.json).")
      .def("__eq__",
           [](const Scene& a, const py::object& b) {
             return py::isinstance<Scene>(b) && a == b.cast<const Scene&>();
           })
      .def("__hash__", [](const Scene& self) { return std::hash<const void*>()(self.value); })
      .def("__repr__", [](const Scene& self) {
        return py::str("<smurf.Scene {!r}>").format(to_path(self->path));
      });
  bind_exports(scene);
  bind_pickle(scene);
}

}  // namespace smurf::python
