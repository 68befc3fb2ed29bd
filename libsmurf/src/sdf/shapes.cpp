// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "imports/joint_xml.hpp"
#include "sdf/colours.hpp"

namespace smurf::sdformat {
namespace {

constexpr double kThickness = 0.001;  // of a plane
constexpr double kEndless = 100;      // the sides of a plane that touches: SDF knows no end of it

constexpr std::pair<std::string_view, Shape::Kind> kKinds[] = {
    {"box", Shape::Kind::box},
    {"sphere", Shape::Kind::sphere},
    {"cylinder", Shape::Kind::cylinder},
    {"capsule", Shape::Kind::capsule},
    {"ellipsoid", Shape::Kind::ellipsoid},
    {"cone", Shape::Kind::cone},
    {"plane", Shape::Kind::plane},
    {"mesh", Shape::Kind::mesh},
    {"polyline", Shape::Kind::polyline},
    {"heightmap", Shape::Kind::heightmap},
    {"image", Shape::Kind::image}};

/// The shortest turn that takes z to a direction.
Quaternion turn_from_z(const Vector3& direction) {
  const double across = hypotenuse(direction[0], direction[1]);
  if (across == 0) return direction[2] < 0 ? Quaternion{0, 1, 0, 0} : Quaternion{};
  return from_axis_angle({-direction[1] / across, direction[0] / across, 0},
                         arc_tangent(across, direction[2]));
}

}  // namespace

Shape read_shape(View owner) {
  Shape shape;
  const View geometry = owner.child("geometry");
  if (!geometry) return shape;
  for (const View one : geometry) {
    const auto* row = std::find_if(std::begin(kKinds), std::end(kKinds),
                                   [&](const auto& kind) { return kind.first == one.name(); });
    if (row == std::end(kKinds)) continue;
    shape.kind = row->second;
    shape.element = one;
    break;
  }
  const View e = shape.element;
  auto& s = shape.size;
  switch (shape.kind) {
  case Shape::Kind::box: s = vector_in(e, "size", {1, 1, 1}); break;
  case Shape::Kind::ellipsoid: s = vector_in(e, "radii", {1, 1, 1}); break;
  case Shape::Kind::mesh: s = vector_in(e, "scale", {1, 1, 1}); break;
  case Shape::Kind::sphere: s[0] = number_in(e, "radius", 1); break;
  case Shape::Kind::cylinder:
  case Shape::Kind::cone: s = {number_in(e, "radius", 1), number_in(e, "length", 1), 0}; break;
  case Shape::Kind::capsule: s = {number_in(e, "radius", 0.5), number_in(e, "length", 1), 0}; break;
  case Shape::Kind::plane: {
    const auto sides = sdf::streamed_numbers(text_in(e, "size"), 2);
    s = {sides.size() == 2 ? sides[0] : 1, sides.size() == 2 ? sides[1] : 1, 0};
    Vector3 n = vector_in(e, "normal", {0, 0, 1});
    const double length = hypotenuse(n[0], n[1], n[2]);
    if (length > 0) shape.normal = {n[0] / length, n[1] / length, n[2] / length};
    break;
  }
  default: break;
  }
  return shape;
}

Pose pose_of_shape(View owner, const Link& link, Frames& frames) {
  const View pose = owner.child("pose");
  if (!pose) return {};
  const Pose raw = pose_in(pose).value_or(Pose{});
  Scope& scope = *link.vertex->scope;
  const Attribute* name = pose.attribute("frame");
  if (scope.file->version > 6 || name == nullptr) name = pose.attribute("relative_to");
  if (name == nullptr || name->value().empty()) return raw;
  const auto X_SF = frames.express_late(scope, name->value(), name->value_span());
  return X_SF ? inverse(frames.in_scope(*link.vertex)) * *X_SF * raw : raw;
}

bool becomes_ground(const Model& model, const Link& link) {
  return model.is_entity && link.is_static;
}

bool ShapeWriter::has_geometry(const Shape& shape) {
  const auto lost = [&](std::string what, std::string help) {
    reporter_
        .lose(shape.element.name_span(), "a URDF has no " + what + ", so this shape is lost",
              "lost shapes")
        .help(std::move(help));
    return false;
  };
  switch (shape.kind) {
  case Shape::Kind::none: return false;
  case Shape::Kind::ellipsoid: return lost("ellipsoid", "use a capsule, a sphere or a mesh");
  case Shape::Kind::cone: return lost("cone", "use a cylinder or a mesh");
  case Shape::Kind::polyline: return lost("extruded polyline", "use a mesh");
  case Shape::Kind::heightmap: return lost("heightmap", "keep the SDF for it, or use a mesh");
  case Shape::Kind::image: return lost("shape from an image", "use a mesh");
  case Shape::Kind::mesh:
    if (text_in(shape.element, "uri").empty()) return false;
    if (const View part = shape.element.child("submesh")) {
      reporter_
          .lose(part.name_span(), "a URDF has no parts of a mesh, so the whole mesh is shown",
                "such meshes")
          .help("write the part into a file of its own");
    }
    return true;
  default:
    return std::all_of(shape.size.begin(), shape.size.end(),
                       [](double one) { return std::isfinite(one); });
  }
}

void ShapeWriter::write(const Link& link) {
  for (const View one : link.vertex->element) {
    if (one.name() == "visual" || one.name() == "collision") this->one(link, one);
  }
}

void ShapeWriter::one(const Link& link, View element) {
  const Shape shape = read_shape(element);
  if (shape.kind == Shape::Kind::heightmap && becomes_ground(model_, link)) return;
  if (!has_geometry(shape)) return;
  const xacro::FrameId frame = link.vertex->scope->frame;
  const Place tag = tag_of(element, frame);
  const bool is_visual = element.name() == "visual";
  xml_.open(element.name(), tag);
  if (const Attribute* name = element.attribute("name")) {
    // In SDF, each link has names of its own, so rules on names of a robot are not meant for it.
    xml_.attribute("name", name->value(), {name->value_span(), element.tag_span(), frame, true},
                   true);
  }
  Pose X = pose_of_shape(element, link, frames_);
  if (shape.kind == Shape::Kind::plane)
    X = X * Pose{{}, turn_from_z(shape.normal)} * Pose{{0, 0, -kThickness / 2}, {}};
  imports::add_origin(xml_, X, tag, place_in(element, "pose", frame));
  xml_.open("geometry", tag);
  geometry(shape, link);
  xml_.close();
  if (is_visual) material(element, frame);
  xml_.close();
}

void ShapeWriter::geometry(const Shape& shape, const Link& link) {
  const View e = shape.element;
  const xacro::FrameId frame = link.vertex->scope->frame;
  const Place tag = tag_of(e, frame);
  const auto& s = shape.size;
  switch (shape.kind) {
  case Shape::Kind::box:
    xml_.open("box", tag);
    xml_.attribute("size", words_of(s), place_in(e, "size", frame));
    break;
  case Shape::Kind::sphere:
    xml_.open("sphere", tag);
    xml_.number("radius", s[0], place_in(e, "radius", frame));
    break;
  case Shape::Kind::plane: {
    const bool touches = e.parent().parent().name() == "collision";
    xml_.open("box", tag, true);
    xml_.attribute("size",
                   words_of({touches ? std::max(s[0], kEndless) : s[0],
                             touches ? std::max(s[1], kEndless) : s[1], kThickness}),
                   place_in(e, "size", frame), true);
    break;
  }
  case Shape::Kind::mesh: {
    xml_.open("mesh", tag);
    const View uri = e.child("uri");
    const SdfFile& file = *link.vertex->scope->file;
    if (text_of(uri).starts_with("model://") && files_.path_of(text_of(uri), file).empty()) {
      reporter_
          .lose(uri.text_span(), "there is no " + quoted(text_of(uri)) + ", so this shape is lost",
                "lost meshes")
          .help("put the folder of the model beside that of this one or into `models`");
    }
    Place place = place_of(uri, frame);
    place.is_exact = true;
    xml_.attribute("filename", files_.resource(text_of(uri), *link.vertex->scope->file), place);
    if (s != std::array<double, 3>{1, 1, 1})
      xml_.attribute("scale", words_of(s), place_in(e, "scale", frame));
    break;
  }
  default:
    xml_.open(e.name(), tag);  // a cylinder or a capsule
    xml_.number("length", s[1], place_in(e, "length", frame));
    xml_.number("radius", s[0], place_in(e, "radius", frame));
    break;
  }
  xml_.close();
}

std::optional<ShapeWriter::Colour> ShapeWriter::colour(View visual, xacro::FrameId frame) {
  const View material = visual.child("material");
  if (!material) return std::nullopt;
  const double alpha = 1 - std::clamp(number_in(visual, "transparency", 0), 0.0, 1.0);
  const View script = material.child("script");
  const std::string_view named = script ? text_in(script, "name") : std::string_view();
  Colour result;
  if (const View diffuse = material.child("diffuse")) {
    const auto rgba = colour_in(text_of(diffuse));
    if (!rgba) return std::nullopt;
    result.rgba = *rgba;
    result.place = place_of(diffuse, frame);
  } else if (const auto known = colour_of(named)) {
    result.rgba = {(*known)[0], (*known)[1], (*known)[2], 1};
    result.place = place_in(script, "name", frame);
    if (alpha == 1) result.name = named;
  } else {
    const View lost = material.child("pbr") ? material.child("pbr") : script;
    if (lost) {
      reporter_
          .lose(lost.name_span(),
                "a material of a URDF has one colour and one picture, so this one is lost",
                "lost materials")
          .help("write `<diffuse>` for readers of the URDF");
    }
    return std::nullopt;
  }
  result.rgba[3] *= alpha;
  if (result.name.empty()) {
    result.name = "rgba";
    for (const double one : result.rgba) result.name += "_" + format_rounded(one, 4);
  }
  return result;
}

void ShapeWriter::material(View visual, xacro::FrameId frame) {
  const auto colour = this->colour(visual, frame);
  if (!colour) return;
  std::string text;
  for (const double one : colour->rgba)
    text += (text.empty() ? "" : " ") + format_number(std::isfinite(one) ? one : 1);
  xml_.open("material", colour->place);
  xml_.attribute("name", colour->name, colour->place, true);
  xml_.open("color", colour->place);
  xml_.attribute("rgba", text, colour->place);
  xml_.close();
  xml_.close();
}

}  // namespace smurf::sdformat
