// SPDX-License-Identifier: BSD-3-Clause
// Names in the sections outside of the tree, which must be names of something.
#include <algorithm>
#include <map>
#include <set>

#include "base/text/quoted.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

struct NameReference {
  std::string_view attribute, kind;
};
constexpr NameReference kReferences[] = {
    {"joint", "joint"},         {"joint1", "joint"},   {"joint2", "joint"},
    {"jointinparent", "joint"}, {"body", "body"},      {"body1", "body"},
    {"body2", "body"},          {"site", "site"},      {"site1", "site"},
    {"site2", "site"},          {"cranksite", "site"}, {"slidersite", "site"},
    {"refsite", "site"},        {"sidesite", "site"},  {"geom", "geom"},
    {"geom1", "geom"},          {"geom2", "geom"},     {"tendon", "tendon"},
    {"tendon1", "tendon"},      {"tendon2", "tendon"}, {"actuator", "actuator"},
    {"camera", "camera"}};
constexpr std::string_view kSections[] = {"actuator", "sensor", "equality", "contact", "tendon"};

class Names {
 public:
  explicit Names(const Model& model) {
    for (const Body& body : model.bodies) {
      add("body", body.name, body.element);
      for (const Joint& one : body.joints) add("joint", one.name, one.settings.element());
      for (const Geom& one : body.geoms) add("geom", one.name, one.settings.element());
    }
    for (const Site& one : model.sites) add("site", one.name, one.element);
    for (const Camera& one : model.cameras) add("camera", one.name, one.settings.element());
    for (const Reference& one : model.sections) {
      const Attribute* name = one.element.attribute("name");
      if (name == nullptr) continue;
      const std::string_view section = one.section;
      if (section == "actuator" || section == "tendon") {
        add(section, full_name(name->value(), one.around), one.element);
      }
    }
  }

  /// Also the name of something that was copied.
  bool has(std::string_view kind, const std::string& name) const {
    const auto found = names_.find(kind);
    return found != names_.end() && found->second.contains(name);
  }
  std::vector<std::string_view> all(std::string_view kind) const {
    const auto found = names_.find(kind);
    if (found == names_.end()) return {};
    return {found->second.begin(), found->second.end()};
  }

 private:
  void add(std::string_view kind, const std::string& name, View element) {
    std::set<std::string, std::less<>>& names = names_[kind];
    if (!name.empty()) names.insert(name);
    const Attribute* written = element.attribute("name");
    if (written != nullptr) names.insert(std::string(written->value()));
  }
  std::map<std::string_view, std::set<std::string, std::less<>>> names_;
};

class Checker {
 public:
  Checker(const Model& model, Reporter& reporter) : names_(model), reporter_(reporter) {}

  void check_target(const Camera& camera, const ModelFile& file) {
    const Attribute* target = camera.settings.find("target");
    Surroundings around;
    around.file = &file;
    if (target != nullptr && !target->value().empty()) check(*target, "body", around);
  }

  void check(View element, const Surroundings& around) {
    for (const Attribute& one : element.attributes()) {
      const auto row =
          std::find_if(std::begin(kReferences), std::end(kReferences),
                       [&](const NameReference& known) { return known.attribute == one.name(); });
      if (row != std::end(kReferences)) check(one, row->kind, around);
    }
    for (const auto& [type, name] :
         {std::pair{"objtype", "objname"}, std::pair{"reftype", "refname"}}) {
      const Attribute* kind = element.attribute(type);
      const Attribute* value = element.attribute(name);
      if (kind == nullptr || value == nullptr) continue;
      const std::string_view known = kind->value() == "xbody" ? "body" : kind->value();
      if (known == "body" || known == "geom" || known == "site" || known == "camera") {
        check(*value, known, around);
      }
    }
    around.file->each(element, [&](View child) { check(child, around); });
  }

 private:
  void check(const Attribute& value, std::string_view kind, const Surroundings& around) {
    if (names_.has(kind, full_name(value.value(), around)) ||
        names_.has(kind, std::string(value.value())))
      return;
    Diagnostic& found = reporter_.refuse_name(
        value.value_span(), "there is no " + std::string(kind) + " " + quoted(value.value()),
        "write the name of a " + std::string(kind));
    const auto known = names_.all(kind);
    if (const auto near = reporter_.context().sink.suggest(value.value(), known)) {
      found.help("did you mean " + quoted(*near) + "?");
    }
  }

  Names names_;
  Reporter& reporter_;
};

}  // namespace

void check_references(const Model& model, Reporter& reporter) {
  Checker checker(model, reporter);
  for (const Reference& one : model.sections) {
    // Of an attached model, only what belongs to the attached part is taken over.
    if (one.around.file != &model.files.front() || !one.around.prefix.empty()) continue;
    const std::string_view section = one.section;
    const bool is_checked =
        std::find(std::begin(kSections), std::end(kSections), section) != std::end(kSections);
    if (is_checked) checker.check(one.element, one.around);
  }
  for (const Camera& one : model.cameras) checker.check_target(one, model.files.front());
}

}  // namespace smurf::mjcf
