// SPDX-License-Identifier: BSD-3-Clause
// Classes whose attributes are fields of a file: one row per attribute names the value and its
// place.
#pragma once

#include <functional>
#include <utility>

#include "common.hpp"

namespace smurf::python {

/// A class of references to `T`, with `place` when T has a span, and `places` of its fields.
template <class T>
class ReferenceClass {
 public:
  ReferenceClass(py::module_& module, const char* name, const char* doc)
      : class_(module, name, doc) {
    class_.def("__eq__", [](const Ref<T>& a, const py::object& b) {
      return py::isinstance<Ref<T>>(b) && a == b.cast<const Ref<T>&>();
    });
    class_.def("__hash__", [](const Ref<T>& self) { return std::hash<const T*>()(self.value); });
    class_.def_property_readonly(
        "places",
        [](const Ref<T>& self) {
          py::dict places;
          for (const auto& [key, span] : rows()) {
            if (const Span* written = span(*self)) {
              places[key] = py::cast(place_of(*written, self.owner->sources()));
            }
          }
          return places;
        },
        "Where each attribute is written: a dict of smurf.Place. What is written and cannot be "
        "understood is None as an attribute, and has a place.");
    if constexpr (requires(const T& value) { value.span; }) {
      class_.def_property_readonly(
          "place", [](const Ref<T>& self) { return place_of(self->span, self.owner->sources()); },
          "Where it is written.");
    }
    if constexpr (requires(const T& value) { value.name; }) {
      class_.def("__repr__", [type = std::string(name)](const Ref<T>& self) {
        return py::str("<smurf.{} {!r}>").format(type, to_object(self->name));
      });
    }
  }

  template <class V>
  ReferenceClass& field(const char* name, Field<V> T::*member, const char* doc) {
    return field_of<T, V>(name, member, doc);
  }
  /// A member of a base class.
  template <class Base, class V>
  ReferenceClass& field_of(const char* name, Field<V> Base::*member, const char* doc) {
    rows().emplace_back(name, [member](const T& value) -> const Span* {
      const Field<V>& field = value.*member;
      return field.written ? &field.span : nullptr;
    });
    class_.def_property_readonly(
        name, [member](const Ref<T>& self) { return to_object((*self).*member); }, doc);
    return *this;
  }
  template <class Call>
  ReferenceClass& method(const char* name, const Call& call) {
    class_.def(name, call);
    return *this;
  }
  /// What is made of a reference.
  template <class Get>
  ReferenceClass& attribute(const char* name, const Get& get, const char* doc) {
    class_.def_property_readonly(name, get, doc);
    return *this;
  }

 private:
  using Row = std::pair<const char*, std::function<const Span*(const T&)>>;
  static std::vector<Row>& rows() {
    static std::vector<Row> rows;
    return rows;
  }

  py::class_<Ref<T>> class_;
};

}  // namespace smurf::python
