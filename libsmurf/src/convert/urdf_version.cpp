// SPDX-License-Identifier: BSD-3-Clause
// URDF 1.1 has capsules and quaternions, URDF 1.2 more limits of joints. For an older version, the
// first two are rewritten and the third is lost.
#include <algorithm>

#include "ast/urdf_numbers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "convert/passes.hpp"

namespace smurf::passes {
namespace {

class Downgrade {
 public:
  Downgrade(const LinkedModel& model, XmlEdits& edits) : model_(model), edits_(edits) {}

  void run() {
    for (const urdf::Link& link : model_.robot->links) {
      for (const urdf::Visual& visual : link.visuals) {
        replace_capsule(link, visual.element, visual.origin, visual.geometry);
      }
      for (const urdf::Collision& collision : link.collisions) {
        replace_capsule(link, collision.element, collision.origin, collision.geometry);
      }
    }
    // Readers of URDF 1.0 ignore a quaternion, and so does this function.
    const Field<std::string>& version = model_.robot->version;
    if (version && *version != "1.0") replace_quaternions();
  }

 private:
  /// A cylinder in its place, and two spheres at its ends.
  void replace_capsule(const urdf::Link& link, xml::ElementId id, const urdf::Origin& origin,
                       const urdf::Geometry& geometry) {
    const auto* capsule = std::get_if<urdf::Capsule>(&geometry.shape);
    if (capsule == nullptr || !capsule->radius || !capsule->length) return;
    const xml::View element = edits_.view(id);
    const Span shape = edits_.view(geometry.shape_element).span();
    const std::string radius = format_number(*capsule->radius);
    const std::string length = format_number(*capsule->length);
    edits_.replace(shape, new_element("cylinder", {{"radius", radius}, {"length", length}}));
    for (const auto& [end, z] :
         {std::pair{"_top", *capsule->length / 2}, std::pair{"_bottom", -*capsule->length / 2}}) {
      const Pose X_LE = urdf::to_pose(origin) * Pose{{0, 0, z}, {}};
      std::vector<Edit> changes = {edits_.origin_edit(element, origin, X_LE),
                                   {shape, new_element("sphere", {{"radius", radius}})}};
      if (const xml::Attribute* name = element.attribute("name")) {
        changes.push_back({name->value_span(), escape_xml(std::string(name->value()) + end)});
      }
      edits_.add_child(edits_.view(link.element), edits_.copy(element, changes));
    }
  }

  void replace_quaternions() {
    for (std::size_t i = 0; i < model_.robot->document.elements.size(); ++i) {
      const xml::View element = edits_.view(static_cast<xml::ElementId>(i));
      const xml::Attribute* quaternion = element.attribute("quat_xyzw");
      if (quaternion == nullptr) continue;
      DiagnosticSink known;  // invalid numbers were reported when the URDF was read
      std::array<double, 4> xyzw{};
      if (!read_numbers(*quaternion, xyzw, known)) continue;
      const Quaternion q{xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
      if (!(norm(q) > 0)) continue;
      edits_.replace(quaternion->span(), "rpy=\"" + numbers_text(to_rpy(normalized(q))) + "\"");
      if (const xml::Attribute* rpy = element.attribute("rpy")) edits_.remove(*rpy);
    }
  }

  const LinkedModel& model_;
  XmlEdits& edits_;
};

}  // namespace

std::vector<const xml::Attribute*> newer_limits(const LinkedModel& model,
                                                std::string_view version) {
  std::vector<const xml::Attribute*> found;
  if (version.empty() || version >= "1.2") return found;
  for (const urdf::Joint& joint : model.robot->joints) {
    if (!joint.limit) continue;
    const xml::View limit(model.robot->document, joint.limit->element);
    for (const char* name : {"acceleration", "deceleration", "jerk"}) {
      if (const xml::Attribute* attribute = limit.attribute(name)) found.push_back(attribute);
    }
  }
  return found;
}

void set_version(const LinkedModel& model, const std::string& version, XmlEdits& edits) {
  if (version == "1.0") Downgrade(model, edits).run();
  for (const xml::Attribute* attribute : newer_limits(model, version)) edits.remove(*attribute);
  edits.set_attribute(model.robot->document.view(), "version", version);
}

}  // namespace smurf::passes
