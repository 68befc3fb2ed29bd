// SPDX-License-Identifier: BSD-3-Clause
// The file of a model with all files that it includes, the settings of its compiler and its classes
// of defaults.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjcf/reading.hpp"
#include "mjcf/schema.hpp"

namespace smurf::mjcf {

enum class InertiaFromGeom : std::uint8_t { no, yes, automatic };

/// `<compiler>`: attributes of later elements win, one by one.
struct Compiler {
  bool is_degree = true;
  std::string eulerseq = "xyz";
  bool autolimits = true;
  InertiaFromGeom inertiafromgeom = InertiaFromGeom::automatic;
  std::array<double, 2> inertiagrouprange{0, 5};
  double boundmass = 0, boundinertia = 0;
  bool balanceinertia = false;
  double settotalmass = -1;
  bool fusestatic = false;
  bool discardvisual = false;
  bool alignfree = false;
  bool fitaabb = false;
  bool strippath = false;
  std::string meshdir, texturedir;
  std::optional<Span> angle_place;  ///< the value of `angle`, if it is written
};

/// A class of defaults: it began as a copy of the class around it.
struct DefaultClass {
  std::string name;
  std::string outer;  ///< the name of the class around it
  Span place;         ///< of the name; of the tag for `main`
  /// By element, the attributes that are set, the weakest first: a `size` of one number leaves the
  /// others.
  std::map<std::string_view, std::vector<const Attribute*>> elements;
};

/// The record to which an element belongs: all actuators are one.
std::string_view record_of(std::string_view element);

class ModelFile {
 public:
  ModelFile(SourceId root, Reporter& reporter);

  /// Reads the file and its includes; false if there is no root.
  bool read();
  View root() const { return root_; }
  const Compiler& compiler() const { return compiler_; }
  const std::string& folder() const { return folder_; }
  Reporter& reporter() const { return reporter_; }
  std::deque<xml::Document>& documents() { return documents_; }
  const std::map<SourceId, Span>& includes() const { return include_places_; }
  const std::map<std::string, DefaultClass, std::less<>>& classes() const { return classes_; }
  const DefaultClass* find_class(std::string_view name) const;
  /// The class that an attribute names; null if there is none, which is refused.
  const DefaultClass* named_class(const Attribute& name) const;
  /// The class of an element: the one that it names, else `other`, else `main`.
  const DefaultClass* class_of(View element, const DefaultClass* other) const;
  /// Reports classes that nothing uses, nor one inside of them.
  void report_unused_classes() const;

  /// Visits the children with those of included files in place of each `<include>`.
  template <class F>
  void each(View parent, const F& visit) const {
    for (const View child : parent) {
      if (child.name() != "include") {
        visit(child);
      } else if (const auto found = included_.find({&child.document(), child.id()});
                 found != included_.end()) {
        each(found->second, visit);
      }
    }
  }
  /// Visits the children of all sections of a name.
  template <class F>
  void each_in(std::string_view section, const F& visit) const {
    each(root_, [&](View one) {
      if (one.name() == section) each(one, visit);
    });
  }

 private:
  bool parse(SourceId source, View& root);
  void include(View element);
  void check(View element, const Grammar& grammar, bool is_loose);
  void check_attributes(View element, const Grammar& grammar, bool is_loose);
  void check_needs(View element, const Grammar& grammar);
  void check_value(const Attribute& attribute, const Value& value);
  void read_compiler(View element);
  void read_default(View element, const DefaultClass* outer);

  Reporter& reporter_;
  SourceId source_;
  View root_;
  std::string folder_;
  std::deque<xml::Document> documents_;
  std::map<std::pair<const xml::Document*, xml::ElementId>, View> included_;
  std::map<std::string, Span> files_;  ///< by path, with the `file` that named it
  std::map<SourceId, Span> include_places_;
  Compiler compiler_;
  std::map<std::string, DefaultClass, std::less<>> classes_;
};

/// What is set for an element: by itself, or by its class.
class Settings {
 public:
  Settings() = default;
  Settings(View element, const DefaultClass* of_class);

  View element() const { return element_; }
  /// The strongest value; null if nothing is set.
  const Attribute* find(std::string_view name) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  std::string_view text(std::string_view name) const;
  /// Writes the numbers of each layer over those of the weaker ones.
  std::size_t numbers(std::string_view name, std::span<double> values, std::size_t least,
                      Reporter& reporter) const;
  double number(std::string_view name, double usual, Reporter& reporter) const;
  /// `usual` also stands for a value that is not an integer; the check of the schema reports it.
  std::int32_t integer(std::string_view name, std::int32_t usual, Reporter& reporter) const;
  /// The value of an attribute, or the tag if it is not set.
  Place place(std::initializer_list<std::string_view> names) const;
  const DefaultClass* default_class() const { return class_; }

 private:
  View element_;
  const DefaultClass* class_ = nullptr;
  const std::vector<const Attribute*>* layers_ = nullptr;
};

}  // namespace smurf::mjcf
