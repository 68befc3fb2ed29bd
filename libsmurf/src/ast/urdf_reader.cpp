// SPDX-License-Identifier: BSD-3-Clause
// Reads elements into structs, in document order. Absent or unreadable values stay absent.
#include "ast/urdf_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "ast/urdf_attributes.hpp"
#include "ast/urdf_numbers.hpp"
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "base/ranges.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

using xml::View;

/// Names are compared without case: a link written `Link` is reported, and read as a link.
bool is(View element, std::string_view name) {
  return std::equal(element.name().begin(), element.name().end(), name.begin(), name.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

View child_of(View element, std::string_view name) {
  View other;
  for (const View child : element) {
    if (child.name() == name) return child;
    if (!other && is(child, name)) other = child;
  }
  return other;
}

class RobotReader {
 public:
  explicit RobotReader(DiagnosticSink& sink) : sink_(sink) {}

  void robot(View root, urdf::Robot& robot) {
    attributes(root, urdf::kRobot, robot);
    // These elements are large, and growing vectors reserve up to twice the needed memory.
    const auto count = [&](std::string_view name) {
      return static_cast<std::size_t>(
          std::count_if(root.begin(), root.end(), [&](View child) { return is(child, name); }));
    };
    robot.links.reserve(count("link"));
    robot.joints.reserve(count("joint"));
    has_quaternions_ = robot.version && *robot.version != "1.0";
    for (const View child : root) {
      if (is(child, "link")) {
        link(child, robot.links.emplace_back());
      } else if (is(child, "joint")) {
        joint(child, robot.joints.emplace_back());
      } else if (is(child, "material")) {
        robot.materials.push_back(material(child));
      } else {
        robot.extensions.push_back(child.id());
      }
    }
  }

 private:
  template <class T>
  static void place(View element, T& out) {
    out.element = element.id();
    out.span = element.span();
  }

  /// Reads the attributes that a table names. Most elements have them in the order of the table, so
  /// that few are searched.
  template <class T>
  void attributes(View element, urdf::Rows<T> rows, T& out) {
    const std::span<const xml::Attribute> given = element.attributes();
    std::size_t next = 0;
    urdf::for_each_field(rows, out, [&](const urdf::AttributeSpec& spec, auto& field) {
      const bool is_next = next < given.size() && is_same(given[next].name(), spec.name);
      const xml::Attribute* attribute = is_next ? &given[next] : element.attribute(spec.name);
      if (attribute == nullptr) return;
      ++next;
      field.span = attribute->value_span();
      field.written = true;
      value(element, *attribute, field);
    });
  }

  /// The attributes of a child element, if there is one.
  template <class T>
  void child(View parent, std::string_view name, urdf::Rows<T> rows, T& out) {
    if (const View element = child_of(parent, name)) attributes(element, rows, out);
  }

  /// A child element that is a part of its own, if there is one.
  template <class Owner, class T = std::remove_reference_t<decltype(*std::declval<Owner&>())>>
  void part(View parent, std::string_view name, urdf::Rows<T> rows, Owner& out) {
    const View element = child_of(parent, name);
    if (!element) return;
    if constexpr (std::is_same_v<Owner, std::optional<T>>) {
      out.emplace();
    } else {
      out = std::make_unique<T>();
    }
    place(element, *out);
    attributes(element, rows, *out);
  }
  static void value(View, const xml::Attribute& attribute, Field<std::string>& out) {
    out.set(std::string(attribute.value()));
  }

  void value(View element, const xml::Attribute& attribute, Field<double>& out) {
    double value = 0;
    if (!read_numbers(attribute, {&value, 1}, sink_)) return;
    if (!is_quantity(value) && std::fabs(value) > largest_in(element)) {
      return report_too_large(element, attribute, largest_in(element), value < 0);
    }
    out.set(value);
  }

  /// Limits of joints are only compared, and are often the largest double; inertias are rotated and
  /// added.
  static double largest_in(View element) {
    const std::string_view name = element.name();
    if (name == "inertia") return 1e300;
    const bool is_bound = name == "limit" || name == "safety_controller" || name == "dynamics";
    return is_bound ? std::numeric_limits<double>::max() : kLargestQuantity;
  }

  void report_too_large(View element, const xml::Attribute& attribute, double most,
                        bool is_negative) {
    Diagnostic& diagnostic =
        sink_.report(rules::sml1810_overflow_underflow, attribute.value_span(),
                     quoted(attribute.name()) + " is too large: at most " + format_rounded(most) +
                         " can be used in computations");
    diagnostic.when(cases::kTooLarge);
    if (!is_negative) return;
    constexpr std::string_view kShapes[] = {"box", "sphere", "cylinder", "capsule"};
    if (ranges::contains(kShapes, element.name())) {
      diagnostic.consequences.push_back(&rules::sml1601_size_not_positive);
    } else if (element.name() == "mass") {
      diagnostic.consequences.push_back(&rules::sml1509_mass_negative);
    }
  }

  template <std::size_t N>
  void value(View element, const xml::Attribute& attribute, Field<std::array<double, N>>& out) {
    std::array<double, N> values{};
    if (!read_numbers(attribute, values, sink_)) return;
    if (!std::all_of(values.begin(), values.end(), is_quantity)) {
      const bool is_negative = *std::min_element(values.begin(), values.end()) < 0;
      return report_too_large(element, attribute, kLargestQuantity, is_negative);
    }
    out.set(values);
  }

  void origin(View parent, urdf::Origin& out) {
    const View element = child_of(parent, "origin");
    if (!element) return;
    out.element = element.id();
    attributes(element, urdf::kOrigin, out);
    if (has_quaternions_) quaternion(element, out.rpy);
  }

  /// Reads the quaternion that URDF 1.1 allows instead of rpy. Readers ignore it in URDF 1.0.
  void quaternion(View element, Field<Vector3>& rpy) {
    const xml::Attribute* attribute = element.attribute("quat_xyzw");
    if (attribute == nullptr) return;
    Field<std::array<double, 4>> xyzw{{}, attribute->value_span()};
    value(element, *attribute, xyzw);
    if (!xyzw) return;
    const auto& [x, y, z, w] = *xyzw;
    const Quaternion q{w, x, y, z};
    if (norm(q) > 0) rpy = {to_rpy(normalized(q)), xyzw.span};
  }

  void inertial(View element, urdf::Inertial& out) {
    place(element, out);
    origin(element, out.origin);
    child(element, "mass", urdf::kMass, out);
    child(element, "inertia", urdf::kInertia, out);
  }

  void geometry(View parent, urdf::Geometry& out) {
    const View element = child_of(parent, "geometry");
    if (!element) return;
    out.element = element.id();
    // Like urdfdom (link.cpp:224), uses the first child, even if it is a foreign element.
    for (const View shape : element) {
      out.shape_element = shape.id();
      out.shape = this->shape(shape);
      break;
    }
  }

  urdf::Shape shape(View element) {
    if (element.name() == "box") return shape<urdf::Box>(element, urdf::kBox);
    if (element.name() == "sphere") return shape<urdf::Sphere>(element, urdf::kSphere);
    if (element.name() == "cylinder") return shape<urdf::Cylinder>(element, urdf::kCylinder);
    if (element.name() == "capsule") return shape<urdf::Capsule>(element, urdf::kCapsule);
    if (element.name() == "mesh") return shape<urdf::Mesh>(element, urdf::kMesh);
    return std::monostate{};
  }
  template <class T>
  T shape(View element, urdf::Rows<T> rows) {
    T out;
    attributes(element, rows, out);
    return out;
  }

  urdf::Material material(View element) {
    urdf::Material out;
    place(element, out);
    attributes(element, urdf::kMaterial, out);
    if (out.name && out.name->find('%') != std::string::npos) {
      report_percent(out.name.span, *out.name, sink_);
    }
    child(element, "color", urdf::kColor, out);
    child(element, "texture", urdf::kTexture, out);
    return out;
  }

  void link(View element, urdf::Link& out) {
    place(element, out);
    attributes(element, urdf::kLink, out);
    for (const View child : element) {
      if (is(child, "inertial") && !out.inertial) {
        inertial(child, out.inertial.emplace());
      } else if (is(child, "visual")) {
        urdf::Visual& visual = out.visuals.emplace_back();
        geometry_use(child, urdf::kVisual, visual);
        if (const View paint = child_of(child, "material")) visual.material = material(paint);
      } else if (is(child, "collision")) {
        geometry_use(child, urdf::kCollision, out.collisions.emplace_back());
      }
    }
  }

  /// Members that visuals and collisions share.
  template <class T>
  void geometry_use(View element, urdf::Rows<T> rows, T& out) {
    place(element, out);
    attributes(element, rows, out);
    origin(element, out.origin);
    geometry(element, out.geometry);
  }

  void joint(View element, urdf::Joint& out) {
    place(element, out);
    attributes(element, urdf::kJoint, out);
    if (out.type_name) out.type = urdf::joint_type(*out.type_name);
    origin(element, out.origin);
    child(element, "parent", urdf::kParent, out);
    child(element, "child", urdf::kChild, out);
    if (const View axis = child_of(element, "axis")) {
      out.axis_element = axis.id();
      attributes(axis, urdf::kAxis, out);
    }
    part(element, "limit", urdf::kLimit, out.limit);
    part(element, "dynamics", urdf::kDynamics, out.dynamics);
    part(element, "mimic", urdf::kMimic, out.mimic);
    part(element, "safety_controller", urdf::kSafetyController, out.safety_controller);
    part(element, "calibration", urdf::kCalibration, out.calibration);
  }

  DiagnosticSink& sink_;
  bool has_quaternions_ = false;
};

/// What was not expanded, which is one cause each. Readers fail on some places and ignore others.
enum class XacroResidue : std::uint8_t { element, in_joint, elsewhere };

void report_xacro(XacroResidue residue, Span place, std::string_view text, DiagnosticSink& sink) {
  const bool is_element = residue == XacroResidue::element;
  Diagnostic& diagnostic =
      sink.report(rules::sml1009_xacro_residue, place,
                  quoted(text) + " is a xacro " + (is_element ? "element" : "expression") +
                      " that was never expanded");
  diagnostic.others_are = is_element ? "such elements" : "such expressions";
  diagnostic.habit = static_cast<std::uint32_t>(residue);
  if (text.starts_with("file:")) diagnostic.when(cases::kUnexpandedUri);
  diagnostic.help("name the file .urdf.xacro; smurf-lint and smurf2urdf expand it");
}

bool is_xacro_definition(View element) {
  return element.name() == "xacro:property" || element.name() == "xacro:arg";
}

std::set<std::string_view> link_names(const xml::Document& document) {
  std::set<std::string_view> names;
  for (const View child : document.view()) {
    const xml::Attribute* name = child.name() == "link" ? child.attribute("name") : nullptr;
    if (name != nullptr) names.insert(name->value());
  }
  return names;
}

/// Readers ignore xacro elements, but fail on expressions, especially in joints. So there is one
/// finding each for expressions in joints, other expressions, and elements. A reference to a link
/// whose name has the same expression is found, and not reported.
void report_xacro(const xml::Document& document, DiagnosticSink& sink) {
  if (has_only_xacro_definitions(document)) return;
  std::optional<std::set<std::string_view>> links;
  std::set<xml::ElementId> dropped;  // with all that is in them
  for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
    const View element(document, xml::ElementId{i});
    const bool is_xacro_element = element.name().starts_with("xacro:");
    if (is_xacro_element) {
      report_xacro(XacroResidue::element, element.name_span(), element.name(), sink);
    }
    if (is_xacro_element || (!dropped.empty() && dropped.contains(element.element().parent))) {
      dropped.insert(element.id());
      continue;
    }
    for (const xml::Attribute& at : element.attributes()) {
      if (!is_xacro(at.value())) continue;
      const bool is_in_joint = element.parent() && element.parent().name() == "joint";
      if (is_in_joint && at.name() == "link") {
        if (!links) links = link_names(document);
        if (links->contains(at.value())) continue;
      }
      report_xacro(is_in_joint ? XacroResidue::in_joint : XacroResidue::elsewhere, at.value_span(),
                   at.value(), sink);
    }
  }
}

}  // namespace

bool has_only_xacro_definitions(const xml::Document& document) {
  bool has_definitions = false;
  for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
    const View element(document, xml::ElementId{i});
    if (!element.name().starts_with("xacro:")) continue;
    if (!is_xacro_definition(element)) return false;
    has_definitions = true;
  }
  if (!has_definitions) return false;  // as nearly always, without a look at each attribute
  for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
    const View element(document, xml::ElementId{i});
    if (is_xacro_definition(element)) continue;
    for (const xml::Attribute& at : element.attributes()) {
      if (is_xacro(at.value())) return false;
    }
  }
  return true;
}

std::optional<urdf::Robot> read_urdf(xml::Document document, DiagnosticSink& sink) {
  const View root = document.view();
  if (root.name() != "robot") {
    Diagnostic& diagnostic =
        sink.report(rules::sml1101_root_not_robot, root.name_span(),
                    "the root element is `" + std::string(root.name()) + "`, not `robot`");
    if (root.name() == "sdf") diagnostic.note("this is an SDFormat file, not a URDF");
    if (root.name() == "mujoco") diagnostic.note("this is an MJCF file, not a URDF");
    // The reader of that language may load the file, which is not checked here; one that holds the
    // elements of a URDF is none.
    const bool is_sdf = root.name() == "sdf" && root.attribute("version") != nullptr &&
                        (root.child("model") || root.child("world"));
    diagnostic.when(is_sdf                    ? cases::kSdf
                    : root.name() == "mujoco" ? cases::kMjcf
                                              : cases::kForeign);
    if (path::to_lower(root.name()) == "robot") diagnostic.when(cases::kCased);
    if (!root.child("link")) diagnostic.when(cases::kWithoutLinks);
    return std::nullopt;
  }
  report_xacro(document, sink);
  check_urdf_shape(document, sink);
  urdf::Robot robot;
  RobotReader(sink).robot(root, robot);
  robot.document = std::move(document);
  return robot;
}

Pose urdf::to_pose(const Origin& origin) {
  return {origin.xyz.value_or(Vector3{0, 0, 0}), from_rpy(origin.rpy.value_or(Vector3{0, 0, 0}))};
}

}  // namespace smurf
