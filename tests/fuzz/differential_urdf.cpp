// SPDX-License-Identifier: BSD-3-Clause
// Compares our readers of URDF with others: the XML with tinyxml2, the robot with urdfdom.
#include <console_bridge/console.h>
#include <tinyxml2.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"
#include "smurf/convert.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/xml_references.hpp"

namespace smurf::test {  // where `urdf` is ours, and `::urdf` that of urdfdom
namespace {

using Broken = std::vector<std::string>;

/// Texts that we refuse as XML although another reader accepts them. We accept all other texts that
/// the readers accept.
struct Refusal {
  std::string_view rule;
  std::string_view message;  ///< a part of the message
  bool by_tinyxml2;          ///< whether it accepts such a text
  bool by_urdfdom;
  std::string_view reason;
};
constexpr Refusal kRefusals[] = {
    {"SML0003", "", true, true, "no reader in C++ looks at bytes; Python and browsers do"},
    {"SML0004", "", true, true, "XML forbids control characters; readers in C++ take them"},
    {"SML0014", "", false, true, "elements in each other are limited before tinyxml2 gives up"},
    {"SML1001", "is never closed", true, true,
     "a quote, tag or instruction ends at one behind it, and what is between is lost"},
    {"SML1001", "this end tag is not closed by `>`", true, true, "both skip to the next `>`"},
    {"SML1001", "closes nothing", true, false, "tinyxml2 stops at such an end tag behind the root"},
    {"SML1001", "does not begin an element here", true, true, "both take such a `<` for text"},
    {"SML1001", "this is not an attribute of the XML declaration", true, true,
     "neither looks for attributes it does not know there"},
    {"SML1001", "has no quotes", false, true, "TinyXML 1 needs none"},
    {"SML1001", "text before the root element", true, true, "both skip it"},
    {"SML1001", "text after the root element", true, true,
     "TinyXML 1 reads it as a text; tinyxml2 takes CDATA sections, and refuses other texts"},
    {"SML1001", "a document type must come before the root element", true, true,
     "XML forbids it behind the root; both skip such a node wherever it is"},
    {"SML1001", "urdfdom (TinyXML) reads", true, true,
     "urdfdom reads what is behind it, if that is a robot"},
    {"SML1008", "", true, true, "neither knows UTF-16; both read bytes"},
    {"SML0005", "UTF-16", true, true, "the same for a file that begins like UTF-16"},
    {"SML1010", "Git LFS", true, true, "both skip the text before the root element"},
    {"SML1006", "", true, true, "both take the first element"},
};

bool is_documented(std::span<const Diagnostic> diagnostics, bool Refusal::*reader) {
  return std::ranges::any_of(diagnostics, [&](const Diagnostic& one) {
    return std::ranges::any_of(kRefusals, [&](const Refusal& refusal) {
      return refusal.*reader && one.rule->id == refusal.rule &&
             one.message.find(refusal.message) != std::string::npos;
    });
  });
}

/// Texts that tinyxml2 refuses, and TinyXML, which urdfdom uses, accepts.
bool is_refused_by_tinyxml2(std::span<const Diagnostic> diagnostics) {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& one) {
    return one.rule->id == "SML1015" || one.rule->id == "SML1016";
  });
}

std::string first_error(std::span<const Diagnostic> diagnostics) {
  for (const Diagnostic& one : diagnostics) {
    if (one.severity == Severity::error) return std::string(one.rule->id) + ' ' + one.message;
  }
  return "nothing";
}

// --- XML -----------------------------------------------------------------------------------------

class XmlComparison {
 public:
  XmlComparison(const SourceMap& sources, Broken& broken) : sources_(sources), broken_(broken) {}

  // Recursion is bounded by Limits::xml_depth.
  void same(xml::View ours, const tinyxml2::XMLElement& theirs) {
    if (ours.name() != theirs.Name()) return note("element", ours.span());
    same_text(ours, theirs.GetText());
    same_attributes(ours, theirs.FirstAttribute());
    const tinyxml2::XMLElement* other = theirs.FirstChildElement();
    for (const xml::View child : ours) {
      if (other == nullptr) return note("element", child.span());
      same(child, *other);
      other = other->NextSiblingElement();
    }
    if (other != nullptr) note("number of children", ours.span());
  }

 private:
  void note(const std::string& what, Span place) {
    broken_.push_back("tinyxml2 reads another " + what + " at byte " + std::to_string(place.begin));
  }

  /// tinyxml2 corrupts a text with a wrong reference (its issue 1082); we keep it as
  /// written.
  bool is_compared(Span place) const { return !has_wrong_reference(sources_.text(place)); }

  void same_text(xml::View ours, const char* theirs) {
    const std::string_view text = theirs == nullptr ? "" : theirs;
    // Readers of URDF ignore texts of spaces; to tinyxml2, \v and \f are spaces.
    const auto is_blank = [](std::string_view one) {
      return one.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos;
    };
    if (is_blank(text) && is_blank(ours.text())) return;
    if (ours.text() != text && is_compared(ours.text_span())) note("text", ours.span());
  }

  void same_attributes(xml::View ours, const tinyxml2::XMLAttribute* theirs) {
    for (const xml::Attribute& one : ours.attributes()) {
      if (theirs == nullptr || one.name() != theirs->Name()) {
        return note("attribute", one.span());
      }
      if (one.value() != theirs->Value() && is_compared(one.value_span())) {
        note("value", one.span());
      }
      theirs = theirs->Next();
    }
    if (theirs != nullptr) note("number of attributes", ours.span());
  }

  const SourceMap& sources_;
  Broken& broken_;
};

/// Whether we accept the text as XML.
bool compare_xml(const std::string& text, Broken& broken) {
  SourceMap sources;
  DiagnosticSink sink;
  const auto ours = parse_xml(sources, sources.add("r.urdf", text), {}, sink);
  const std::vector<Diagnostic> found = sink.take();
  tinyxml2::XMLDocument theirs;
  const bool is_read = theirs.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS &&
                       theirs.RootElement() != nullptr;
  if (ours && is_refused_by_tinyxml2(found)) {
    if (is_read) broken.push_back("tinyxml2 reads what it should refuse");
  } else if (ours && !is_read) {
    broken.push_back(std::string("tinyxml2 refuses what we read: ") + theirs.ErrorName());
  } else if (ours) {
    XmlComparison(sources, broken).same(ours->view(), *theirs.RootElement());
  } else if (is_read && !is_documented(found, &Refusal::by_tinyxml2)) {
    broken.push_back("tinyxml2 reads what we refuse: " + first_error(found));
  }
  // TinyXML treats the control character DEL and the following bytes as letters.
  const bool has_delete = text.find('\x7f') != std::string::npos;
  if (!ours && !has_delete && !is_documented(found, &Refusal::by_urdfdom) &&
      ask_urdfdom(text).accepts) {
    broken.push_back("urdfdom reads what we refuse: " + first_error(found));
  }
  return ours.has_value();
}

// --- the robot -----------------------------------------------------------------------------------

/// Findings that are not errors, but at which urdfdom drops parts of a link.
struct Exception {
  std::string_view rule;
  std::string_view reason;
};
constexpr Exception kNotCompared[] = {
    {"SML1108", "a mass beside its inertial is misplaced, a warning, and not missing as well"},
};

bool is_compared(const Diagnostic& finding) {
  return finding.severity != Severity::error &&
         std::ranges::none_of(kNotCompared, [&](const Exception& exception) {
           return exception.rule == finding.rule->id;
         });
}

/// Every file exists, so only the URDF decides about its errors.
class AloneFile final : public FileReader {
 public:
  explicit AloneFile(const std::string& text) { files_.add("r.urdf", text); }
  FileContent read(const std::string& path, std::uint64_t max_bytes) const override {
    return files_.read(path, max_bytes);
  }
  bool is_file(const std::string&) const override { return true; }
  std::vector<std::string> list(const std::string& folder) const override {
    return files_.list(folder);
  }

 private:
  MemoryFiles files_;
};

class RobotComparison {
 public:
  RobotComparison(const ::urdf::ModelInterface& theirs, Broken& broken)
      : theirs_(theirs), broken_(broken) {}

  void same(const urdf::Robot& ours) {
    text("name of the robot", "", ours.name, theirs_.getName());
    count("links", "", ours.links.size(), theirs_.links_.size());
    count("joints", "", ours.joints.size(), theirs_.joints_.size());
    for (const urdf::Link& one : ours.links) {
      const auto other = theirs_.getLink(one.name.value_or(""));
      if (!other) return note("link", one.name.value_or(""));
      link(one, *other);
    }
    for (const urdf::Joint& one : ours.joints) {
      const auto other = theirs_.getJoint(one.name.value_or(""));
      if (!other) return note("joint", one.name.value_or(""));
      joint(one, *other);
    }
  }

 private:
  void note(const std::string& what, const std::string& where) {
    broken_.push_back("urdfdom reads another " + what + " of `" + where + "`");
  }
  void text(const char* what, const std::string& where, const Field<std::string>& ours,
            const std::string& theirs) {
    if (ours.value_or("") != theirs) note(what, where);
  }
  void count(const char* what, const std::string& where, std::size_t ours, std::size_t theirs) {
    if (ours != theirs) note(std::string("number of ") + what, where);
  }
  /// The last bit may differ between from_chars and a stream.
  void number(const char* what, const std::string& where, double ours, double theirs) {
    if (ours != theirs && std::nextafter(ours, theirs) != theirs) note(what, where);
  }
  void number(const char* what, const std::string& where, const Field<double>& ours, double theirs,
              double absent = 0) {
    number(what, where, ours.value_or(absent), theirs);
  }
  void vector(const char* what, const std::string& where, const Field<Vector3>& ours,
              const ::urdf::Vector3& theirs, const Vector3& absent = {}) {
    const Vector3 value = ours.value_or(absent);
    number(what, where, value[0], theirs.x);
    number(what, where, value[1], theirs.y);
    number(what, where, value[2], theirs.z);
  }

  void origin(const std::string& where, const urdf::Origin& ours, const ::urdf::Pose& theirs) {
    vector("position", where, ours.xyz, theirs.position);
    const Quaternion q = urdf::to_pose(ours).orientation;
    const ::urdf::Rotation& r = theirs.rotation;
    // The same sines and cosines of half the angles, though not multiplied in the same order; and q
    // and -q are one orientation.
    constexpr double kTolerance = 1e-15;
    const auto differ = [&](double sign) {
      return std::max({std::fabs(q.w - sign * r.w), std::fabs(q.x - sign * r.x),
                       std::fabs(q.y - sign * r.y), std::fabs(q.z - sign * r.z)});
    };
    if (!(std::min(differ(1), differ(-1)) <= kTolerance)) note("orientation", where);
  }

  void link(const urdf::Link& ours, const ::urdf::Link& theirs) {
    const std::string& where = theirs.name;
    if (ours.inertial.has_value() != (theirs.inertial != nullptr)) return note("inertial", where);
    if (ours.inertial) {
      const urdf::Inertial& inertial = *ours.inertial;
      origin(where, inertial.origin, theirs.inertial->origin);
      number("mass", where, inertial.mass, theirs.inertial->mass);
      number("ixx", where, inertial.ixx, theirs.inertial->ixx);
      number("ixy", where, inertial.ixy, theirs.inertial->ixy);
      number("ixz", where, inertial.ixz, theirs.inertial->ixz);
      number("iyy", where, inertial.iyy, theirs.inertial->iyy);
      number("iyz", where, inertial.iyz, theirs.inertial->iyz);
      number("izz", where, inertial.izz, theirs.inertial->izz);
    }
    geometries("visuals", where, ours.visuals, theirs.visual_array);
    geometries("collisions", where, ours.collisions, theirs.collision_array);
  }

  template <class Ours, class Theirs>
  void geometries(const char* what, const std::string& where, const std::vector<Ours>& ours,
                  const std::vector<Theirs>& theirs) {
    count(what, where, ours.size(), theirs.size());
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
      origin(where, ours[i].origin, theirs[i]->origin);
      shape(where, ours[i].geometry.shape, *theirs[i]->geometry);
    }
  }

  void shape(const std::string& where, const urdf::Shape& ours, const ::urdf::Geometry& theirs) {
    if (const auto* box = std::get_if<urdf::Box>(&ours)) {
      const auto* other = dynamic_cast<const ::urdf::Box*>(&theirs);
      if (other == nullptr) return note("shape", where);
      vector("size", where, box->size, other->dim);
    } else if (const auto* sphere = std::get_if<urdf::Sphere>(&ours)) {
      const auto* other = dynamic_cast<const ::urdf::Sphere*>(&theirs);
      if (other == nullptr) return note("shape", where);
      number("radius", where, sphere->radius, other->radius);
    } else if (const auto* cylinder = std::get_if<urdf::Cylinder>(&ours)) {
      const auto* other = dynamic_cast<const ::urdf::Cylinder*>(&theirs);
      if (other == nullptr) return note("shape", where);
      number("radius", where, cylinder->radius, other->radius);
      number("length", where, cylinder->length, other->length);
    } else if (const auto* mesh = std::get_if<urdf::Mesh>(&ours)) {
      const auto* other = dynamic_cast<const ::urdf::Mesh*>(&theirs);
      if (other == nullptr) return note("shape", where);
      text("mesh", where, mesh->filename, other->filename);
      vector("scale", where, mesh->scale, other->scale, {1, 1, 1});
    } else {
      note("shape", where);
    }
  }

  static urdf::JointType type_of(const ::urdf::Joint& joint) {
    using enum urdf::JointType;
    switch (joint.type) {
    case ::urdf::Joint::REVOLUTE: return revolute;
    case ::urdf::Joint::CONTINUOUS: return continuous;
    case ::urdf::Joint::PRISMATIC: return prismatic;
    case ::urdf::Joint::FIXED: return fixed;
    case ::urdf::Joint::FLOATING: return floating;
    case ::urdf::Joint::PLANAR: return planar;
    default: return unknown;
    }
  }

  void joint(const urdf::Joint& ours, const ::urdf::Joint& theirs) {
    const std::string& where = theirs.name;
    if (ours.type != type_of(theirs)) note("type", where);
    text("parent", where, ours.parent, theirs.parent_link_name);
    text("child", where, ours.child, theirs.child_link_name);
    origin(where, ours.origin, theirs.parent_to_joint_origin_transform);
    const bool has_axis = ours.has_one_axis() || ours.type == urdf::JointType::planar;
    if (has_axis) vector("axis", where, ours.axis, theirs.axis, {1, 0, 0});
    if (ours.limit.has_value() != (theirs.limits != nullptr)) return note("limit", where);
    if (ours.limit) {
      number("lower", where, ours.limit->lower, theirs.limits->lower);
      number("upper", where, ours.limit->upper, theirs.limits->upper);
      number("effort", where, ours.limit->effort, theirs.limits->effort);
      number("velocity", where, ours.limit->velocity, theirs.limits->velocity);
    }
    if ((ours.mimic != nullptr) != (theirs.mimic != nullptr)) return note("mimic", where);
    if (ours.mimic) {
      text("mimicked joint", where, ours.mimic->joint, theirs.mimic->joint_name);
      number("multiplier", where, ours.mimic->multiplier, theirs.mimic->multiplier, 1);
      number("offset", where, ours.mimic->offset, theirs.mimic->offset);
    }
  }

  const ::urdf::ModelInterface& theirs_;
  Broken& broken_;
};

void compare_robots(const std::string& text, Broken& broken) {
  SourceMap sources;
  DiagnosticSink sink;
  const AloneFile files(text);
  LoadContext context{sources, files, sink, {}, {}};
  const LinkedModel model = load_model("r.urdf", context);
  lint_model(model, {}, sink);
  const auto findings = apply_selection(sink.take(), sources, {});
  if (!model.robot || !std::ranges::all_of(findings, is_compared)) return;
  const RefereeVerdict verdict = ask_urdfdom(text);
  if (!verdict.was_asked) return;
  if (!verdict.accepts) {
    broken.push_back("urdfdom refuses what has no errors: " + verdict.messages);
    return;
  }
  console_bridge::noOutputHandler();
  RobotComparison(*::urdf::parseURDF(text), broken).same(*model.robot);
  console_bridge::restorePreviousOutputHandler();
}

void compare_all(const std::string& text, Broken& broken) {
  if (compare_xml(text, broken)) compare_robots(text, broken);
}

}  // namespace
}  // namespace smurf::test

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string text(reinterpret_cast<const char*>(data), size);
  smurf::test::Exercise result;
  smurf::test::compare_all(text, result.broken);
  smurf::test::require_kept(result);
  return 0;
}
