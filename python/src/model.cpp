// SPDX-License-Identifier: BSD-3-Clause
// A model: its contents, the poses of its links, and its URDF.
#include "model.hpp"

#include <array>
#include <optional>

#include "smurf/convert.hpp"
#include "smurf/result_losses.hpp"
#include "smurf/write.hpp"

namespace smurf::python {

Report check_owned(Owner& owner) {
  return owner.model ? owner.session->check(*owner.model) : owner.session->check(*owner.scene);
}

void refuse(const std::string& path, const Refusal& refusal, Report report,
            const SourceMap& sources, const LossOf& loss_of) {
  if (!refusal) return;
  const std::string message = "'" + path + "' " + refusal.reason;
  if (refusal.cause == Refusal::Cause::options) throw py::value_error(message);
  std::erase_if(report.diagnostics, [&](const Diagnostic& one) { return !loss_of(one); });
  raise_error(message, to_findings(std::move(report.diagnostics), sources));
}

void refuse(const Scene& scene, const Refusal& refusal, Report report) {
  const SourceMap& sources = scene.owner->sources();
  refuse(scene->path, refusal, std::move(report), sources,
         [&](const Diagnostic& one) { return loss_in_scene(one, *scene, sources); });
}

namespace {

py::list names_to_list(const std::vector<std::string>& names) {
  py::list list;
  for (const std::string& name : names) list.append(to_path(name));
  return list;
}

/// A word of an enumeration, in its order.
template <class Enum>
Enum from_word(const py::handle& value, const char* argument,
               std::initializer_list<const char*> words) {
  const std::string text = from_text(value, argument);
  std::string known;
  std::size_t index = 0;
  for (const char* word : words) {
    if (text == word) return static_cast<Enum>(index);
    ++index;
    known += std::string(known.empty() ? "" : ", ") + word;
  }
  throw py::value_error(std::string(argument) + " is not one of " + known);
}

AppliedAnnotations from_applied(const py::handle& value) {
  AppliedAnnotations applied;
  for (const std::string& name : from_texts(value, "apply")) {
    if (name == "materials") {
      applied.materials = true;
    } else if (name == "limits") {
      applied.limits = true;
    } else if (name == "dynamics") {
      applied.dynamics = true;
    } else if (name == "mimic") {
      applied.mimic = true;
    } else {
      throw py::value_error("apply: '" + name +
                            "' is not one of materials, limits, dynamics, mimic");
    }
  }
  return applied;
}

/// A smurf.Urdf.
py::object to_urdf(const Model& self, const py::object& output_folder, const py::object& mesh_uri,
                   const py::object& apply, const py::object& prefix, const py::object& base,
                   const py::object& keep, bool collapse_fixed, bool strip_comments,
                   bool strip_extensions, bool canonical, bool force) {
  // Where names stand in rebase ... keep, package is left out: see smurf2urdf.
  constexpr std::array kUris = {MeshUri::rebase, MeshUri::relative, MeshUri::absolute,
                                MeshUri::file, MeshUri::keep};
  const auto uri = from_word<std::size_t>(mesh_uri, "mesh_uri",
                                          {"rebase", "relative", "absolute", "file", "keep"});
  UrdfRequest request;
  request.force = force;
  UrdfExport& options = request.options;
  options.output_folder = from_path(output_folder);
  options.mesh_uri = kUris[uri];
  options.apply = from_applied(apply);
  options.prefix = from_text(prefix, "prefix");
  options.base = from_word<BaseJoint>(base, "base", {"as-is", "fixed", "floating"});
  options.keep = from_texts(keep, "keep");
  options.collapses_fixed = collapse_fixed;
  options.strips_comments = strip_comments;
  options.strips_extensions = strip_extensions;
  options.is_canonical = canonical;
  Session& session = *self.owner->session;
  std::optional<LoadedModel> of_scene;
  if (!self.owner->model) of_scene.emplace(session.load_model(self->path, self.owner->settings));
  LoadedModel& loaded = of_scene ? *of_scene : *self.owner->model;
  UrdfResult result = convert_to_urdf(session, loaded, request);
  refuse(self->path, result.refusal, std::move(result.report), self.owner->sources(),
         [&](const Diagnostic& one) { return loss_in_urdf(one, loaded.model, options); });
  return py::module_::import("smurf._urdf")
      .attr("Urdf")(py::bytes(result.text),
                    to_findings(std::move(result.losses), self.owner->sources()));
}

template <class T, class Names>
Ref<T> find(const Model& self, const std::vector<T>& values, const Names& names,
            const py::object& name, const char* what) {
  const std::string text = from_text(name, "name");
  const auto index = names.find(text);
  if (!index) throw py::key_error(std::string("the model has no ") + what + " '" + text + "'");
  return {self.owner, &values[*index]};
}

template <class T>
void add_section(py::class_<Model>& model, const char* name, std::vector<T> Annotations::*member,
                 const char* doc) {
  model.def_property_readonly(
      name, [member](const Model& self) { return to_list(self.owner, self->annotations.*member); },
      doc);
}

void bind_files(py::class_<Model>& model) {
  model
      .def_property_readonly(
          "path", [](const Model& self) { return to_path(self->path); },
          "The path it was loaded by.")
      .def_property_readonly(
          "name",
          [](const Model& self) {
            const Field<std::string>& own = self->main.modelname;
            if (own || !self->robot) return to_object(own);
            return to_object(self->robot->name);
          },
          "`modelname` of the .smurf, else the name of the robot; None when there is neither.")
      .def_property_readonly(
          "files",
          [](const Model& self) {
            std::vector<std::string> paths;
            for (const ModelFile& file : self->files) {
              paths.push_back(self.owner->sources().path(file.source));
            }
            return names_to_list(paths);
          },
          "The paths of all files that were read, meshes left out, in their order.")
      .def_property_readonly(
          "urdf_path",
          [](const Model& self) -> py::object {
            if (self->urdf_path.empty()) return py::none();
            return to_path(self->urdf_path);
          },
          "The path of the URDF; None when there is none.")
      .def_property_readonly(
          "is_complete", [](const Model& self) { return self->is_complete; },
          "False when a file is missing or broken.")
      .def("__repr__",
           [](const Model& self) {
             return py::str("<smurf.Model {!r}>").format(to_path(self->path));
           })
      .def("__eq__",
           [](const Model& a, const py::object& b) {
             return py::isinstance<Model>(b) && a == b.cast<const Model&>();
           })
      .def("__hash__", [](const Model& self) { return std::hash<const void*>()(self.value); });
}

void bind_elements(py::class_<Model>& model) {
  model
      .def_property_readonly(
          "links",
          [](const Model& self) {
            return self->robot ? to_list(self.owner, self->robot->links) : py::list();
          },
          "A new list of smurf.Link, in the order of the URDF.")
      .def_property_readonly(
          "joints",
          [](const Model& self) {
            return self->robot ? to_list(self.owner, self->robot->joints) : py::list();
          },
          "A new list of smurf.Joint, in the order of the URDF.")
      .def_property_readonly(
          "materials",
          [](const Model& self) {
            return self->robot ? to_list(self.owner, self->robot->materials) : py::list();
          },
          "A new list of smurf.Material: those of the robot.")
      .def_property_readonly(
          "roots",
          [](const Model& self) {
            py::list roots;
            for (const LinkIndex root : self->tree.roots) {
              roots.append(Ref<urdf::Link>{self.owner, &self->link(root)});
            }
            return roots;
          },
          "A new list of the links without a parent joint; poses are those in the first one.")
      .def(
          "link",
          [](const Model& self, const py::object& name) {
            static const std::vector<urdf::Link> none;
            return find(self, self->robot ? self->robot->links : none, self->link_names, name,
                        "link");
          },
          py::arg("name"), "The link of a name; KeyError when there is none.")
      .def(
          "joint",
          [](const Model& self, const py::object& name) {
            static const std::vector<urdf::Joint> none;
            return find(self, self->robot ? self->robot->joints : none, self->joint_names, name,
                        "joint");
          },
          py::arg("name"), "The joint of a name; KeyError when there is none.");
  add_section(model, "motors", &Annotations::motors, "A new list of smurf.Motor.");
  add_section(model, "sensors", &Annotations::sensors, "A new list of smurf.Sensor.");
  add_section(model, "controllers", &Annotations::controllers, "A new list of smurf.Controller.");
  add_section(model, "material_annotations", &Annotations::materials,
              "A new list of smurf.MaterialAnnotation.");
  add_section(model, "collision_annotations", &Annotations::collisions,
              "A new list of smurf.CollisionAnnotation.");
  add_section(model, "visual_annotations", &Annotations::visuals,
              "A new list of smurf.VisualAnnotation.");
  add_section(model, "link_annotations", &Annotations::links,
              "A new list of smurf.LinkAnnotation.");
  add_section(model, "node_annotations", &Annotations::nodes,
              "A new list of smurf.NodeAnnotation.");
  add_section(model, "joint_annotations", &Annotations::joints,
              "A new list of smurf.JointAnnotation.");
  add_section(model, "joint_tasks", &Annotations::joint_tasks, "A new list of smurf.JointTask.");
  add_section(model, "lights", &Annotations::lights, "A new list of smurf.Light.");
  add_section(model, "graphics", &Annotations::graphics, "A new list of smurf.Graphics.");
  add_section(model, "poses", &Annotations::poses, "A new list of smurf.JointPoseSet.");
  add_section(model, "submechanisms", &Annotations::submechanisms,
              "A new list of smurf.Submechanism.");
  add_section(model, "exoskeletons", &Annotations::exoskeletons,
              "A new list of smurf.Exoskeleton.");
  add_section(model, "interfaces", &Annotations::interfaces, "A new list of smurf.Interface.");
  add_section(model, "submodels", &Annotations::submodels, "A new list of smurf.Submodel.");
}

void bind_functions(py::class_<Model>& model) {
  model
      .def(
          "check",
          [](const Model& self) {
            if (!self.owner->model) {
              throw py::value_error("the model is part of a scene; check that, or the file");
            }
            return to_report(check_owned(*self.owner), self.owner->sources());
          },
          "Checks the model as it was loaded, and returns a smurf.Report.")
      .def(
          "to_urdf", &to_urdf, py::kw_only(), py::arg("output_folder") = ".",
          py::arg("mesh_uri") = "rebase", py::arg("apply") = py::tuple(), py::arg("prefix") = "",
          py::arg("base") = "as-is", py::arg("keep") = py::tuple(),
          py::arg("collapse_fixed") = false, py::arg("strip_comments") = false,
          py::arg("strip_extensions") = false, py::arg("canonical") = false,
          py::arg("force") = false,
          "The plain URDF as bytes with `losses`, a smurf.Urdf, as smurf2urdf writes it: the model's "
          "own, with mesh paths that resolve from `output_folder`, and what the options ask for. It is "
          "read again and compared with the model. Raises smurf.Error for errors that make it wrong, "
          "unless `force`; nothing is written.")
      .def(
          "to_json",
          [](const Model& self) {
            auto text = write_model_json(*self, self.owner->sources());
            if (!text) throw py::value_error("the model is too large for a JSON text");
            return to_text(*text);
          },
          "Everything that was read, as JSON text (schemas/model-dump.schema.json).");
}

}  // namespace

void bind_model(py::module_& module) {
  py::class_<Model> model(module, "Model",
                          "A model: a .smurf with its URDF and annotations, or a URDF.");
  bind_files(model);
  bind_elements(model);
  bind_functions(model);
  bind_kinematics(model);
  bind_joint_orders(model);
  bind_exports(model);
  bind_pickle(model);
}

}  // namespace smurf::python
