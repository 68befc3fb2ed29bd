// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/suggest.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  NameTable defined;
  for_each_material(model, [&](const urdf::Material& material) {
    const xml::View element(model.robot->document, material.element);
    if (material.name && (element.child("color") || element.child("texture"))) {
      defined.add(*material.name, 0);
    }
  });
  std::map<std::string_view, std::size_t> uses;
  for_each_material(model, [&](const urdf::Material& material) {
    if (material.name) ++uses[*material.name];
  });
  NameTable reported;
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      if (!visual.material || !visual.material->name) continue;
      const Field<std::string>& name = visual.material->name;
      if (name->empty() || defined.contains(*name) || reported.contains(*name)) continue;
      reported.add(*name, 0);
      Diagnostic& diagnostic =
          findings.report(name.span, "the material " + quoted(*name) + " is defined nowhere");
      if (uses[*name] > 1) {
        diagnostic.notes.push_back("it is used " + std::to_string(uses[*name]) + " times");
      }
      if (const auto near = nearest(*name, defined.names())) {
        diagnostic.help = "did you mean " + quoted(*near) + "?";
        diagnostic.fixes.push_back({Applicability::unsafe, {{name.span, std::string(*near)}}});
      }
    }
  });
}

}  // namespace

extern constinit const Rule sml1702_material_undefined{
    .id = "SML1702",
    .name = "material-undefined",
    .severity = Severity::warning,
    .summary = "A visual uses a material that is defined nowhere.",
    .why = "urdfdom leaves the visual without colour and prints a message, Drake refuses the "
           "file.",
    .remedy = "Define the material at robot level, or give it a colour here.",
    .sources = "urdfdom 3.0.1, executed; Drake detail_urdf_geometry.cc.",
    .check_model = check};

}  // namespace smurf::rules
