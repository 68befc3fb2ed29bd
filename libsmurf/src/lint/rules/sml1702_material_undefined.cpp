// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1702_material_undefined_file {
namespace {

constexpr Circumstance kNameless{"empty name"};

/// Whether a material has more than a name. exportURDF of urdfdom adds an empty texture to each.
bool has_content(const LinkedModel& model, const urdf::Material& material) {
  const xml::View element(model.robot->document, material.element);
  return element.child("color") || material.texture.written;
}

class MaterialCheck {
 public:
  MaterialCheck(const LinkedModel& model, Findings& findings) : model_(model), findings_(findings) {
    for_each_material(model, [&](const urdf::Material& material) {
      if (!material.name) return;
      if (has_content(model, material)) defined_.add(*material.name, 0);
      ++uses_[*material.name];
    });
  }

  /// A material of the robot that is not defined there either.
  void definition(const urdf::Material& material) {
    if (!material.name || has_content(model_, material)) return;
    reported_.add(*material.name, 0);
    findings_
        .report(material.name.span,
                "the material " + quoted(*material.name) + " has neither colour nor texture")
        .note("urdfdom drops it with a message");
  }

  void use(const urdf::Material& material) {
    const Field<std::string>& name = material.name;
    if (!name || has_content(model_, material)) return;
    if (defined_.contains(*name) || reported_.contains(*name)) return;
    reported_.add(*name, 0);
    Diagnostic& diagnostic =
        findings_.report(name.span, "the material " + quoted(*name) + " is not defined anywhere");
    if (name->empty()) diagnostic.when(kNameless);
    if (uses_[*name] > 1) {
      diagnostic.note("it is used " + std::to_string(uses_[*name]) + " times");
    }
    if (const auto near = findings_.suggest(*name, defined_.names())) {
      diagnostic.help("did you mean " + quoted(*near) + "?");
      diagnostic.fixes.push_back({Applicability::unsafe, {{name.span, escape_xml(*near)}}});
    }
  }

 private:
  const LinkedModel& model_;
  Findings& findings_;
  NameTable defined_, reported_;
  std::map<std::string_view, std::size_t> uses_;
};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  MaterialCheck materials(model, findings);
  for (const urdf::Material& material : model.robot->materials) materials.definition(material);
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      if (visual.material) materials.use(*visual.material);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "leaves the visual without colour and prints a message",
     kRun},
    {&readers::drake, Effect::changes, "uses its own colour", kRun, when(kNameless)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1702_material_undefined{
    .id = "SML1702",
    .name = "material-undefined",
    .severity = Severity::warning,
    .summary = "A material is used or declared, but has no colour or texture anywhere.",
    .remedy = "Define the material at robot level, or give it a colour here.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1702_material_undefined_file
