// SPDX-License-Identifier: BSD-3-Clause
// Models and scenes in the formats of other programs, and as pictures in notebooks.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model.hpp"
#include "smurf/conversion.hpp"

namespace smurf::python {
namespace {

/// A text in a format, and what it lacks.
struct Export {
  std::string format;
  std::string text;
  py::list losses;
};

/// A page in a frame of its own: its styles and its scripts do not meet those of the notebook.
std::string in_frame(std::string_view page, std::string_view title) {
  const auto escaped = [](std::string_view text) {
    std::string out;
    for (const char c : text) {
      if (c == '&') {
        out += "&amp;";
      } else if (c == '"') {
        out += "&quot;";
      } else {
        out += c;
      }
    }
    return out;
  };
  // The page of the viewer shows its lists in a frame of this name (web/viewer/host.js).
  return "<iframe name=\"smurf-view\" title=\"" + escaped(title) +
         "\" sandbox=\"allow-scripts allow-downloads\" style=\"box-sizing: border-box; width: 100%; "
         "height: 480px; border: 1px solid #8884\" srcdoc=\"" +
         escaped(page) + "\"></iframe>";
}

const SceneFormat& from_format(const py::object& name) {
  const std::string text = from_text(name, "format");
  if (const SceneFormat* format = find_scene_format(text)) {
    const std::string_view why = format->obstacle ? format->obstacle() : "";
    if (!why.empty()) throw py::value_error("this build cannot write html: " + std::string(why));
    return *format;
  }
  std::string known;
  for (const SceneFormat* format : scene_formats()) known += " " + std::string(format->name);
  throw py::value_error("'" + text + "' is not one of the formats:" + known);
}

SceneForm from_form(const SceneFormat& format, const py::object& form) {
  if (form.is_none()) return usual_form(format);
  const std::string text = from_text(form, "form");
  if (text != "expand" && text != "reference") {
    throw py::value_error("form is not one of expand, reference");
  }
  const SceneForm chosen = text == "expand" ? SceneForm::expand : SceneForm::reference;
  if (has_form(format, chosen)) return chosen;
  throw py::value_error("the format " + std::string(format.name) + " has no form '" + text + "'");
}

std::optional<BaseChoice> from_base(const py::object& base) {
  if (base.is_none()) return std::nullopt;
  const std::string text = from_text(base, "base");
  if (text == "fixed") return BaseChoice::fixed;
  if (text == "floating") return BaseChoice::floating;
  throw py::value_error("base is not one of fixed, floating");
}

Export write(const Scene& self, const py::object& format_name, const py::object& output_folder,
             const py::object& dialect, const py::object& form, const py::object& base, bool ground,
             bool links, bool force) {
  const SceneFormat& format = from_format(format_name);
  const SceneRequest request{.format = format,
                             .form = from_form(format, form),
                             .dialect = from_dialect(dialect),
                             .base = from_base(base),
                             .ground = ground,
                             .links = links,
                             .output_folder = from_path(output_folder),
                             .force = force};
  if (ground && (!format.has_ground || request.form != SceneForm::expand)) {
    throw py::value_error("ground: the format " + std::string(format.name) + " has no floor");
  }
  SceneResult result = convert_scene(*self.owner->session, *self.owner->scene, request);
  refuse(self, result.refusal, std::move(result.report));
  return {std::string(format.name), std::move(result.text),
          to_findings(std::move(result.losses), self.owner->sources())};
}

/// A model is written as a scene of one entity.
Scene scene_of(const Model& model) {
  const std::string& path = model->path;
  return load_scene(model.owner->session, path, model.owner->settings, true, py::object())
      .cast<Scene>();
}

template <class Thing>
py::object to_html(const Thing& self) {
  if (find_scene_format("html")->obstacle) {
    if (!find_scene_format("html")->obstacle().empty()) return py::none();
  }
  const py::object thing = py::cast(self);
  const auto page = thing.attr("write")("html", py::arg("force") = true).template cast<Export>();
  return to_text(in_frame(page.text, self->path));
}

constexpr const char* kWriteDoc =
    "The text of a format of smurfs-flatten (`mjcf`, `sdf`, `urdf`, `usda`, `gltf`, `html`, ...), as "
    "a smurf.Export. Paths in it start at `output_folder`. `form` is \"expand\" or \"reference\", "
    "`base` \"fixed\" or \"floating\" for models that are anchored nowhere; `ground` adds a floor, "
    "`links` the poses of all links. Raises smurf.Error for errors that leave a pose unknown, and, "
    "unless `force`, for others that make the result wrong.";

template <class Class, class Write>
void add_write(Class& one, const Write& write_one) {
  one.def("write", write_one, py::arg("format"), py::kw_only(), py::arg("output_folder") = ".",
          py::arg("dialect") = "spec", py::arg("form") = py::none(), py::arg("base") = py::none(),
          py::arg("ground") = false, py::arg("links") = false, py::arg("force") = false, kWriteDoc);
}

}  // namespace

void bind_exports(py::class_<Scene>& scene) {
  add_write(scene, &write);
  scene.def("_repr_html_", &to_html<Scene>, "The page of the format html, for notebooks.");
}

void bind_exports(py::class_<Model>& model) {
  add_write(model, [](const Model& self, const py::object& format, const py::object& output_folder,
                      const py::object& dialect, const py::object& form, const py::object& base,
                      bool ground, bool links, bool force) {
    return write(scene_of(self), format, output_folder, dialect, form, base, ground, links, force);
  });
  model.def("_repr_html_", &to_html<Model>, "The page of the format html, for notebooks.");
}

void bind_export(py::module_& module) {
  py::class_<Export>(module, "Export", "A model or scene as the text of a format.")
      .def_property_readonly(
          "format", [](const Export& self) { return to_text(self.format); },
          "Name of the format: \"mjcf\".")
      .def_property_readonly(
          "text", [](const Export& self) { return to_text(self.text); }, "What the file contains.")
      .def_property_readonly(
          "losses", [](const Export& self) { return py::list(self.losses); },
          "A new list of smurf.Finding: what the format cannot express.")
      .def(
          "save",
          [](const Export& self, const py::object& path) {
            py::module_::import("smurf._save").attr("save")(path, py::bytes(self.text));
          },
          py::arg("path"), "Writes the text into a file, which is replaced as a whole.")
      .def("__str__", [](const Export& self) { return to_text(self.text); })
      .def(
          "_repr_html_",
          [](const Export& self) -> py::object {
            if (self.format == "svg") return to_text(self.text);
            if (self.format != "html") return py::none();
            return to_text(in_frame(self.text, self.format));
          },
          "Pages and drawings, for notebooks; None for other formats.")
      .def("__repr__", [](const Export& self) {
        return py::str("<smurf.Export of the format {}: {} bytes, {} losses>")
            .format(to_text(self.format), self.text.size(), py::len(self.losses));
      });
}

}  // namespace smurf::python
