// SPDX-License-Identifier: BSD-3-Clause
// Code that all parts of the module share: objects that keep their owners alive, texts, places.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "smurf/check.hpp"

namespace smurf::python {

namespace py = pybind11;

/// A model or scene with the session that has loaded it. Everything that Python holds of it shares
/// it, so that nothing outlives what it points into.
struct Owner {
  std::shared_ptr<Session> session;
  CheckSettings settings;
  /// The function of the module that has loaded it, with its arguments: (name, path, settings).
  /// Null if it may have read texts that are on no disk.
  py::object recipe = {};
  std::optional<LoadedModel> model = {};  ///< one of the two
  std::optional<LoadedScene> scene = {};
  /// Of all URDFs, by where a file is named; made when it is first asked for.
  std::unordered_map<std::uint64_t, const MeshReference*> meshes = {};

  const SourceMap& sources() const { return session->loaded_sources(); }
  const MeshReference* mesh_at(Span span);
};
using OwnerPtr = std::shared_ptr<Owner>;

/// A value of a model or scene, as Python sees it.
template <class T>
struct Ref {
  OwnerPtr owner;
  const T* value = nullptr;

  const T& operator*() const { return *value; }
  const T* operator->() const { return value; }
  friend bool operator==(const Ref& a, const Ref& b) { return a.value == b.value; }
};

/// Bytes that are no UTF-8 become U+FFFD: nothing that a file holds makes Python fail.
py::str to_text(std::string_view text);
/// As os.fsdecode() has it.
py::str to_path(const std::string& path);
/// A str, bytes or os.PathLike; TypeError for others, ValueError for one with a zero byte.
std::string from_path(const py::handle& path);
/// A str; TypeError for others, with the name of the argument.
std::string from_text(const py::handle& text, const char* argument);
/// A str or an iterable of them.
std::vector<std::string> from_texts(const py::handle& texts, const char* argument);

/// Where something is written, with what it takes to know that later.
struct Place {
  std::string file;
  Position begin, end;
};
Place place_of(Span span, const SourceMap& sources);

/// Filled by the caller. The only place that makes arrays.
py::array_t<double> new_array(const std::vector<py::ssize_t>& shape);
/// Homogeneous, row-major: an array of shape (4, 4).
py::array_t<double> to_matrix4(const Pose& pose);
void write_matrix4(const Pose& pose, double* to);
/// Shape (3,).
py::array_t<double> to_array(const Vector3& vector);

py::object to_object(const Field<std::string>& field);
py::object to_object(const Field<double>& field);
py::object to_object(const Field<std::int64_t>& field);
py::object to_object(const Field<bool>& field);
py::object to_object(const Field<NameList>& field);
py::object to_object(const Field<Vector3>& field);
py::object to_object(const Field<Color>& field);
py::object to_object(const Field<std::array<double, 4>>& field);

/// A list of references to what is in a vector.
template <class T>
py::list to_list(const OwnerPtr& owner, const std::vector<T>& values) {
  py::list list(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) list[i] = py::cast(Ref<T>{owner, &values[i]});
  return list;
}

template <class T>
py::object to_optional(const OwnerPtr& owner, const T* value) {
  if (value == nullptr) return py::none();
  return py::cast(Ref<T>{owner, value});
}
template <class T>
py::object to_optional(const OwnerPtr& owner, const std::optional<T>& value) {
  return to_optional(owner, value ? &*value : nullptr);
}
template <class T>
py::object to_optional(const OwnerPtr& owner, const std::unique_ptr<T>& value) {
  return to_optional<T>(owner, value.get());
}

/// A target or one of its releases; ValueError for unknown names.
const Reader* from_target(const std::string& name);

/// Keyword arguments of check(), load_model() and load_scene(); TypeError for unknown ones,
/// ValueError for values that mean nothing.
CheckSettings settings_of(const py::kwargs& keywords);

/// A smurf.Scene.
py::object load_scene(const std::shared_ptr<Session>& session, const std::string& path,
                      const CheckSettings& settings, bool is_shared, const py::object& recipe);

/// Raises smurf.Error.
[[noreturn]] void raise_error(const std::string& message, const py::list& findings);

/// A smurf.Report; raises smurf.Error when something could not be read.
py::object to_report(Report report, const SourceMap& sources);
/// Findings as a list of smurf.Finding.
py::list to_findings(std::vector<Diagnostic> diagnostics, const SourceMap& sources);

void bind_places(py::module_& module);
void bind_findings(py::module_& module);
void bind_robot(py::module_& module);
void bind_annotations(py::module_& module);
void bind_model(py::module_& module);
void bind_scene(py::module_& module);
void bind_session(py::module_& module);
void bind_export(py::module_& module);
void bind_comparison(py::module_& module);

}  // namespace smurf::python
