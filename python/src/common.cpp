// SPDX-License-Identifier: BSD-3-Clause
#include "common.hpp"

#include <cstring>

namespace smurf::python {

const MeshReference* Owner::mesh_at(Span span) {
  const auto key = [](Span at) { return static_cast<std::uint64_t>(at.source) << 32U | at.begin; };
  const auto add = [&](const LinkedModel& one) {
    for (const MeshReference& mesh : one.meshes) meshes.emplace(key(mesh.span), &mesh);
  };
  if (meshes.empty()) {
    if (model) add(model->model);
    if (scene) {
      for (const LinkedModel& one : scene->scene.models) add(one);
    }
  }
  const auto found = meshes.find(key(span));
  return found == meshes.end() ? nullptr : found->second;
}

py::str to_text(std::string_view text) {
  PyObject* decoded =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

py::str to_path(const std::string& path) {
  PyObject* decoded =
      PyUnicode_DecodeFSDefaultAndSize(path.data(), static_cast<Py_ssize_t>(path.size()));
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

std::string from_path(const py::handle& path) {
  PyObject* encoded = nullptr;
  // Sets TypeError and, for a zero byte, ValueError.
  if (PyUnicode_FSConverter(path.ptr(), &encoded) == 0) throw py::error_already_set();
  const auto bytes = py::reinterpret_steal<py::bytes>(encoded);
  return std::string(bytes);
}

std::string from_text(const py::handle& text, const char* argument) {
  if (!py::isinstance<py::str>(text)) {
    throw py::type_error(std::string(argument) + " must be a str");
  }
  PyObject* encoded = PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogateescape");
  if (encoded == nullptr) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(encoded));
}

std::vector<std::string> from_texts(const py::handle& texts, const char* argument) {
  if (py::isinstance<py::str>(texts)) return {from_text(texts, argument)};
  std::vector<std::string> list;
  for (const py::handle text : py::iter(texts)) list.push_back(from_text(text, argument));
  return list;
}

Place place_of(Span span, const SourceMap& sources) {
  if (static_cast<std::size_t>(span.source) >= sources.size()) return {};
  return {sources.path(span.source), sources.position(span.source, span.begin),
          sources.position(span.source, span.end)};
}

void write_matrix4(const Pose& pose, double* to) {
  const std::array<double, 9> rotation = to_matrix(pose.orientation);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      to[4 * row + column] = rotation[3 * row + column];
    }
    to[4 * row + 3] = pose.position[row];
    to[12 + row] = 0;
  }
  to[15] = 1;
}

py::array_t<double> new_array(const std::vector<py::ssize_t>& shape) {
  // pybind11 imports numpy for its first array, and would make another thread that asks for an
  // array meanwhile wait with the lock of Python, which the import needs.
  py::module_::import("numpy");
  return py::array_t<double>(shape);
}

py::array_t<double> to_matrix4(const Pose& pose) {
  py::array_t<double> matrix = new_array({4, 4});
  write_matrix4(pose, matrix.mutable_data());
  return matrix;
}

py::array_t<double> to_array(const Vector3& vector) {
  py::array_t<double> array = new_array({3});
  std::memcpy(array.mutable_data(), vector.data(), sizeof(vector));
  return array;
}

namespace {

template <class T, class Convert>
py::object convert(const Field<T>& field, const Convert& to_python) {
  if (!field) return py::none();
  return to_python(*field);
}

}  // namespace

py::object to_object(const Field<std::string>& field) {
  return convert(field, [](const std::string& text) { return to_text(text); });
}
py::object to_object(const Field<double>& field) {
  return convert(field, [](double number) { return py::float_(number); });
}
py::object to_object(const Field<std::int64_t>& field) {
  return convert(field, [](std::int64_t number) { return py::int_(number); });
}
py::object to_object(const Field<bool>& field) {
  return convert(field, [](bool boolean) { return py::bool_(boolean); });
}
py::object to_object(const Field<NameList>& field) {
  return convert(field, [](const NameList& names) {
    py::list list;
    for (const Spanned<std::string>& name : names) list.append(to_text(name.value));
    return list;
  });
}
py::object to_object(const Field<Vector3>& field) {
  return convert(field, [](const Vector3& vector) { return to_array(vector); });
}
py::object to_object(const Field<Color>& field) {
  return convert(field, [](const Color& color) {
    return py::make_tuple(to_object(color.r), to_object(color.g), to_object(color.b),
                          to_object(color.a));
  });
}
py::object to_object(const Field<std::array<double, 4>>& field) {
  return convert(field, [](const std::array<double, 4>& rgba) {
    return py::make_tuple(rgba[0], rgba[1], rgba[2], rgba[3]);
  });
}

void raise_error(const std::string& message, const py::list& findings) {
  const py::object type = py::module_::import("smurf._errors").attr("Error");
  const py::object error = type(to_text(message), findings);
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace smurf::python
