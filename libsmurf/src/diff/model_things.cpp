// SPDX-License-Identifier: BSD-3-Clause
// Collects the things of a main file and its annotations, by the key tables.
#include <algorithm>

#include "ast/model_reader.hpp"
#include "ast/sections.hpp"
#include "base/ranges.hpp"
#include "diff/collect.hpp"

namespace smurf {
namespace {

/// Whether a URDF has things of this kind, too: then a difference must name the annotation.
constexpr std::string_view kOfRobot[] = {"link", "joint", "visual", "collision", "material"};

std::string kind_of(const SectionSpec& section) {
  const bool is_of_robot = ranges::contains(kOfRobot, section.entry);
  return std::string(section.entry) + (is_of_robot ? " annotation" : "");
}

/// The paths of its files are not a property of a model.
bool is_told(std::string_view key) { return key != "files"; }
bool is_no_name(std::string_view key) { return key != "name"; }

class AnnotationCollector {
 public:
  AnnotationCollector(const LinkedModel& model, YamlProperties& properties, Things& things)
      : model_(model), properties_(properties), things_(things) {}

  void run() {
    if (model_.has_main) main_file();
    for (const SectionSpec* section : all_sections()) {
      const std::vector<const KeySpec*> rows = section->keys();
      for (const Annotation* entry : section->list.entries(model_.annotations)) {
        this->entry(*section, rows, *entry);
      }
    }
    for (const CustomSection& section : model_.annotations.custom) custom(section);
    for (const CustomSection& section : model_.main.extra) custom(section);
  }

 private:
  Thing& add(std::string kind, std::string_view name, Span place) {
    Thing& thing = things_.all.emplace_back();
    thing.kind = std::move(kind);
    thing.name = name;
    thing.place = place;
    return thing;
  }

  void main_file() {
    const auto file = ranges::find(model_.files, ModelFile::Kind::main, &ModelFile::kind);
    if (file == model_.files.end() || !file->document || !file->document->view()) return;
    std::vector<const KeySpec*> rows;
    for (const Key<Model>& key : main_keys()) rows.push_back(&key.spec);
    const yaml::View root = file->document->view();
    Thing& thing = add("model", {}, {root.span().source, root.span().begin, root.span().begin});
    thing.properties = group_property({}, thing.place);
    for (const KeySpec* row : rows) {
      const yaml::View value = is_told(row->name) ? root.find(row->name) : yaml::View();
      if (value) add_member(thing.properties, properties_.value(row->name, value, row));
    }
  }

  void entry(const SectionSpec& section, YamlProperties::Rows rows, const Annotation& entry) {
    const yaml::Document* document = model_.document(entry.span.source);
    if (document == nullptr) return;
    const yaml::View value(*document, entry.node);
    const Span start{entry.span.source, entry.span.begin, entry.span.begin};
    Thing& thing =
        add(kind_of(section), entry.name.value_or(""), entry.name ? entry.name.span : start);
    const auto row = ranges::find(rows, "name", &KeySpec::name);
    if (row != rows.end()) {
      const Naming naming = (*row)->names_in != nullptr ? (*row)->names_in(value) : (*row)->names;
      if (naming.defines) thing.names = naming.kinds.first();
    }
    thing.properties = properties_.mapping({}, value, rows, entry.name ? is_no_name : nullptr);
    if (&section == &sections::motors || &section == &sections::joint)
      choose_units_of(thing, value);
  }

  /// An annotation of a joint without `joint` has the name of the joint.
  void choose_units_of(Thing& thing, yaml::View entry) const {
    yaml::View name = entry.find("joint");
    if (!name) name = entry.find("name");
    if (!model_.robot || !name || !name.is_scalar()) return;
    const auto joint = model_.joint_names.find(name.text());
    if (joint) choose_units(thing.properties, model_.robot->joints[*joint]);
  }

  void custom(const CustomSection& section) {
    const yaml::Document* document = model_.document(section.name.span.source);
    if (document == nullptr) return;
    Thing& thing = add("section", section.name.value, section.name.span);
    thing.properties = group_property({}, section.span);
    Property property = properties_.value({}, {*document, section.node}, nullptr);
    if (property.form == Property::Form::group) {
      thing.properties = std::move(property);
    } else {
      const bool is_list =
          property.form == Property::Form::list || property.form == Property::Form::texts;
      property.key = is_list ? "" : "value";
      add_member(thing.properties, std::move(property));
    }
  }

  const LinkedModel& model_;
  YamlProperties& properties_;
  Things& things_;
};

}  // namespace

void collect_annotations(const LinkedModel& model, YamlProperties& properties, Things& things) {
  AnnotationCollector(model, properties, things).run();
}

void sort_by_place(std::vector<Reference>& references) {
  const auto is_first = [](const Reference& a, const Reference& b) {
    return is_before(a.span, b.span);
  };
  // Sorting temporarily needs half as much memory again, and the things of one file are already in
  // order.
  if (std::is_sorted(references.begin(), references.end(), is_first)) return;
  std::stable_sort(references.begin(), references.end(), is_first);
}

Things collect(const LinkedModel& model, Scope scope, YamlProperties& properties) {
  Things things;
  if (scope == Scope::all) collect_annotations(model, properties, things);
  collect_robot(model, things);
  things.references = references_of(model);
  sort_by_place(things.references);
  return things;
}

}  // namespace smurf
