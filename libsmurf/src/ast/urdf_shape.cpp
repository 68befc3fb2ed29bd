// SPDX-License-Identifier: BSD-3-Clause
// Compares a document with the element table: finds unknown, misspelt, misplaced, repeated and
// absent elements and attributes.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "ast/urdf_reader.hpp"
#include "ast/urdf_schema.hpp"
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

using urdf::AttributeSpec;
using urdf::ChildSpec;
using urdf::ElementSpec;
using xml::View;

bool holds(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The position of a name in a table; the size of the table if it is absent. The search starts at
/// `first`, because most files have the order of the table.
template <class Spec>
std::size_t index_of(std::span<const Spec> table, std::string_view name, std::size_t first) {
  for (std::size_t i = first; i < table.size(); ++i) {
    if (is_same(table[i].name, name)) return i;
  }
  for (std::size_t i = 0; i < first; ++i) {
    if (is_same(table[i].name, name)) return i;
  }
  return table.size();
}

/// The rule that reports a missing child.
struct Missing {
  std::string_view parent, child;
  const Rule* rule;
};
constexpr Missing kMissing[] = {
    {"joint", "parent", &rules::sml1203_parent_or_child_missing},
    {"joint", "child", &rules::sml1203_parent_or_child_missing},
    {"inertial", "mass", &rules::sml1504_mass_missing},
    {"inertial", "inertia", &rules::sml1505_inertia_missing},
    {"visual", "geometry", &rules::sml1110_geometry_missing},
    {"collision", "geometry", &rules::sml1110_geometry_missing},
};

class ShapeChecker {
 public:
  explicit ShapeChecker(DiagnosticSink& sink) : sink_(sink) {}

  void document(View root, const ElementSpec& spec) {
    element(root, spec);
    report_foreign();
  }

 private:
  // The depth of the document is bounded by Limits::xml_depth.
  void element(View element, const ElementSpec& spec, bool is_first = true) {
    attributes(element, spec, is_first);
    text(element);
    std::uint64_t seen = 0;  // children by their position in the short table
    bool is_repeated = false;
    for (const View child : element) {
      const std::size_t i = index_of(spec.children, child.name(), 0);
      if (i == spec.children.size()) {
        foreign_child(element, child, spec);
        continue;
      }
      const std::uint64_t bit = std::uint64_t{1} << i;
      const bool is_second = spec.children[i].single && (seen & bit) != 0;
      is_repeated = is_repeated || is_second;
      seen |= bit;
      if (const ElementSpec* known = spec_of(spec.children[i])) {
        this->element(child, *known, !is_second);
      }
    }
    if (is_repeated) repeated(element, spec);
  }

  const ElementSpec* spec_of(const ChildSpec& child) {
    const auto [known, is_new] = specs_.try_emplace(&child);
    if (is_new) known->second = urdf::find_element_spec(child.name);
    return known->second;
  }

  /// Whether nothing is unknown and nothing is missing, as in nearly every element.
  static bool has_what_it_needs(View element, const ElementSpec& spec) {
    std::ptrdiff_t required = 0;  // bits of the children that are present; none occurs twice
    std::size_t next = 0;
    for (const xml::Attribute& at : element.attributes()) {
      const std::size_t i = index_of(spec.attributes, at.name(), next);
      if (i == spec.attributes.size()) return false;
      required += spec.attributes[i].is_required() ? 1 : 0;
      next = i + 1;
    }
    return required ==
           std::count_if(spec.attributes.begin(), spec.attributes.end(),
                         [](const AttributeSpec& known) { return known.is_required(); });
  }

  /// Readers use the first of several elements, so a missing attribute matters only there.
  void attributes(View element, const ElementSpec& spec, bool is_first) {
    if (has_what_it_needs(element, spec)) return;
    std::vector<std::string_view> absent;
    for (const AttributeSpec& known : spec.attributes) {
      if (element.attribute(known.name) == nullptr) absent.push_back(known.name);
    }
    std::vector<const xml::Attribute*> foreign;
    for (const xml::Attribute& attribute : element.attributes()) {
      const std::string_view name = attribute.name();
      // A prefix marks another vocabulary (drake:..., xmlns:...).
      if (spec.attribute(name) != nullptr || name.find(':') != std::string_view::npos ||
          name == "xmlns" || holds(spec.extensions, name)) {
        continue;
      }
      if (const auto meant = urdf::meant_name(name, absent)) {
        misspelt_attribute(element, attribute, *meant, spec.attribute(*meant)->is_required());
        // One finding per cause: the name that was meant is not also reported as missing.
        std::erase(absent, *meant);
      } else {
        foreign.push_back(&attribute);
      }
    }
    if (is_first && required_attributes(element, spec, absent, foreign)) return;
    // SML1110 reports an empty geometry.
    if (element.name() == "geometry" && element.begin() == element.end()) return;
    for (const xml::Attribute* attribute : foreign) {
      add_foreign(rules::sml1107_unknown_attribute, attribute->name_span(),
                  "unknown attribute " + quoted(attribute->name()) + " of " +
                      quoted(element.name()),
                  as_vector(element, attribute->name(), absent));
    }
  }

  /// The attribute in which a URDF has three numbers that are written apart: "write `xyz="0 0 1"`".
  static std::string as_vector(View element, std::string_view foreign,
                               const std::vector<std::string_view>& absent) {
    constexpr std::pair<std::string_view, std::array<std::string_view, 3>> kVectors[] = {
        {"xyz", {"x", "y", "z"}}, {"rpy", {"roll", "pitch", "yaw"}}, {"rpy", {"r", "p", "y"}}};
    for (const auto& [name, parts] : kVectors) {
      const bool is_apart = std::find(parts.begin(), parts.end(), foreign) != parts.end();
      if (!is_apart || std::find(absent.begin(), absent.end(), name) == absent.end()) continue;
      std::string numbers;
      for (const std::string_view part : parts) {
        const xml::Attribute* one = element.attribute(part);
        numbers += (numbers.empty() ? "" : " ") + std::string(one == nullptr ? "0" : one->value());
      }
      return "write `" + std::string(name) + "=\"" + numbers + "\"`";
    }
    return {};
  }

  void misspelt_attribute(View element, const xml::Attribute& attribute, std::string_view meant,
                          bool is_required) {
    Diagnostic& diagnostic = sink_.report(rules::sml1107_unknown_attribute, attribute.name_span(),
                                          "unknown attribute " + quoted(attribute.name()) + " of " +
                                              quoted(element.name()));
    diagnostic.note("URDF readers silently ignore it");
    diagnostic.severity = Severity::error;
    if (is_required) {
      diagnostic.consequences.push_back(&rules::sml1113_required_attribute_missing);
      add_owner_of_name(element, diagnostic);
    }
    diagnostic.help("did you mean " + quoted(meant) + "?");
    diagnostic.fixes.push_back({Applicability::unsafe,
                                {{attribute.name_span(), std::string(meant)}},
                                Fix::NewName{element.tag_span(), std::string(meant)}});
  }

  /// For a link without a name, that is the only finding. The material of a visual needs no name if
  /// it has a colour.
  static void add_owner_of_name(View element, Diagnostic& diagnostic) {
    if (element.name() == "link") diagnostic.when(cases::kLinkTag);
    const bool is_look = element.name() == "material" && element.parent().name() == "visual";
    if (is_look && !element.child("color")) diagnostic.when(cases::kColourless);
  }

  /// Whether an attribute is missing. Shows the text or child that may contain its value.
  bool required_attributes(View element, const ElementSpec& spec,
                           const std::vector<std::string_view>& absent,
                           const std::vector<const xml::Attribute*>& instead) {
    std::string missing;
    for (const AttributeSpec& attribute : spec.attributes) {
      // Reported as an attribute that is written as an element.
      if (!attribute.is_required() || !holds(absent, attribute.name) ||
          element.child(attribute.name)) {
        continue;
      }
      missing += (missing.empty() ? " has no " : " and no ") + quoted(attribute.name);
    }
    if (missing.empty()) return false;
    Diagnostic& diagnostic =
        sink_.report(rules::sml1113_required_attribute_missing, element.name_span(),
                     "the element " + quoted(element.name()) + missing);
    add_owner_of_name(element, diagnostic);
    for (const xml::Attribute* attribute : instead) {
      diagnostic.label(attribute->name_span(), "no attribute of URDF");
    }
    if (!element.text_span().empty()) {
      diagnostic.label(element.text_span(), "readers ignore text");
      help_with_text(element, missing, diagnostic);
    }
    return true;
  }

  /// `<mass>1.5</mass>`, as SDF writes it.
  static void help_with_text(View element, std::string_view missing, Diagnostic& diagnostic) {
    constexpr std::size_t kLongest = 60;
    const std::string text(trimmed(element.text()));
    if (text.empty() || text.size() > kLongest || missing.find(" and ") != std::string::npos)
      return;
    const std::size_t begin = missing.find('`') + 1;
    const std::string name(missing.substr(begin, missing.find('`', begin) - begin));
    diagnostic.help("this is the way of SDF; in a URDF, write `<" + std::string(element.name()) +
                    " " + name + "=\"" + text + "\"/>`");
  }

  /// In URDF, all values are attributes. An element without any required attribute is reported as
  /// such, even if it has other contents.
  void text(View element) {
    const Span place = element.text_span();
    const bool is_empty = element.attributes().empty();
    if (place.empty() || (is_empty && needs_attributes(element.name()))) return;
    Diagnostic& diagnostic =
        sink_.report(rules::sml1119_stray_text, place,
                     quoted(element.name()) + " contains text, which readers ignore");
    if (is_empty && element.name() == "origin") diagnostic.help("write `<origin xyz=\"...\"/>`");
  }

  static bool needs_attributes(std::string_view name) {
    constexpr std::string_view kNames[] = {
        "axis",  "box",  "capsule", "child", "color",  "cylinder",          "dynamics", "inertia",
        "limit", "mass", "mesh",    "mimic", "parent", "safety_controller", "sphere"};
    return holds(kNames, name);
  }

  void foreign_child(View parent, View child, const ElementSpec& spec) {
    const std::string_view name = child.name();
    if (holds(spec.extensions, name) || name.find(':') != std::string_view::npos) return;
    if (const AttributeSpec* attribute = spec.attribute(name)) {
      // `<version>2025-09-17</version>` is that of the robot, not that of URDF.
      const bool is_of_urdf = name != "version" || trimmed(child.text()).starts_with("1.");
      if (is_of_urdf) return attribute_as_element(parent, child, attribute->is_required());
    }
    // Robots contain elements of many vendors, so only probable misspellings are reported there.
    std::vector<std::string_view> names;
    for (const ChildSpec& allowed : spec.children) names.push_back(allowed.name);
    const auto near = urdf::meant_name(name, names);
    const bool is_misplaced = urdf::find_element_spec(name) != nullptr;
    if (is_misplaced) return misplaced(parent, child);
    if (near && path::to_lower(name) == *near) return wrong_case(parent, child, *near);
    if (near || parent.name() != "robot") unknown_child(parent, child, near);
  }

  void attribute_as_element(View parent, View child, bool is_required) {
    const std::string name(child.name());
    Diagnostic& diagnostic = sink_.report(rules::sml1106_unknown_element, child.name_span(),
                                          quoted(name) + " must be an attribute of " +
                                              quoted(parent.name()) + ", not an element");
    diagnostic.severity = Severity::error;
    if (is_required) {
      diagnostic.consequences.push_back(&rules::sml1113_required_attribute_missing);
      add_owner_of_name(parent, diagnostic);
    }
    diagnostic.note("URDF readers silently ignore it");
    diagnostic.help("write `<" + std::string(parent.name()) + " " + name + "=\"...\"/>`");
  }

  void unknown_child(View parent, View child, std::optional<std::string_view> near) {
    std::string message =
        "unknown element " + quoted(child.name()) + " in " + quoted(parent.name());
    if (!near) {
      add_foreign(rules::sml1106_unknown_element, child.name_span(), std::move(message),
                  help_with_foreign(child.name(), parent.name()));
      return;
    }
    Diagnostic& diagnostic =
        sink_.report(rules::sml1106_unknown_element, child.name_span(), std::move(message));
    const bool is_alone = !parent.child(*near);
    diagnostic.note(
        "URDF readers silently ignore it, with all its contents" +
        (is_alone ? ", so " + quoted(parent.name()) + " has no " + quoted(*near) : std::string()));
    diagnostic.severity = Severity::error;
    diagnostic.help("did you mean " + quoted(*near) + "?");
  }

  /// What to do with an element that is right elsewhere; empty if it is not known.
  static std::string help_with_foreign(std::string_view name, std::string_view parent) {
    if (name == "gazebo" && (parent == "link" || parent == "joint")) {
      return "move it to `robot`, as `<gazebo reference=\"NAME\">` with the name of the " +
             std::string(parent) + ": Gazebo reads it only there";
    }
    constexpr std::string_view kOfXacro[] = {"if",    "include",  "insert_block",
                                             "macro", "property", "unless"};
    if (!holds(kOfXacro, name)) return {};
    return "write `xacro:" + std::string(name) + "`: without the prefix, xacro copies it";
  }

  /// Names of other vocabularies occur in every joint; each name is reported once.
  void add_foreign(const Rule& rule, Span place, std::string message, std::string help = {}) {
    const auto [known, is_new] = foreign_by_message_.emplace(message, foreign_.size());
    if (is_new) foreign_.push_back({&rule, place, std::move(message), std::move(help), 0});
    ++foreign_[known->second].count;
  }

  void report_foreign() {
    for (Foreign& foreign : foreign_) {
      Diagnostic& diagnostic =
          sink_.report(*foreign.rule, foreign.place, std::move(foreign.message));
      diagnostic.note("readers that do not know it silently ignore it");
      if (foreign.count > 1) {
        diagnostic.note("it occurs " + std::to_string(foreign.count) + " times in this file");
      }
      if (!foreign.help.empty()) diagnostic.help(std::move(foreign.help));
    }
  }

  void misplaced(View parent, View child) {
    sink_
        .report(rules::sml1108_misplaced_element, child.name_span(),
                quoted(child.name()) + " does not belong in " + quoted(parent.name()))
        .note("URDF readers silently ignore it");
  }

  /// Whether a robot is broken for readers that ignore this link: a joint names it, or
  /// there is no other link.
  bool is_needed(View robot, View link) {
    if (!named_links_) {
      named_links_.emplace();
      for (const View one : robot) {
        if (is_same(one.name(), "link")) has_links_ = true;
        for (const View end : one) {
          if (const xml::Attribute* at = end.attribute("link")) named_links_->emplace(at->value());
        }
      }
    }
    const xml::Attribute* name = link.attribute("name");
    return !has_links_ || (name != nullptr && named_links_->count(std::string(name->value())) > 0);
  }

  /// What readers that ignore this joint miss.
  void describe_joint(View robot, View joint, Diagnostic& diagnostic) {
    if (!leaders_) {
      leaders_.emplace();
      for (const View one : robot) {
        for (const View part : one) {
          const bool is_mimic = part.name() == "mimic";
          const xml::Attribute* at = part.attribute(is_mimic ? "joint" : "link");
          if (at == nullptr) continue;
          if (is_mimic) leaders_->emplace(at->value());
          if (part.name() == "parent") parents_.emplace(at->value());
        }
      }
    }
    diagnostic.when(cases::kJointTag);
    const View end = joint.child("child");
    const xml::Attribute* link = end ? end.attribute("link") : nullptr;
    if (link != nullptr && parents_.count(std::string(link->value())) > 0) {
      diagnostic.when(cases::kChainTag);
    }
    const xml::Attribute* name = joint.attribute("name");
    if (name != nullptr && leaders_->count(std::string(name->value())) > 0) {
      diagnostic.consequences.push_back(&rules::sml1432_mimic_target_unknown);
    }
  }

  void wrong_case(View parent, View child, std::string_view name) {
    Diagnostic& diagnostic =
        sink_.report(rules::sml1114_tag_case, child.name_span(),
                     "the element " + quoted(child.name()) + " must be written " + quoted(name));
    diagnostic.note("URDF readers silently ignore it, with all its contents");
    if (name == "link" && is_needed(parent, child)) diagnostic.when(cases::kLinkTag);
    if (name == "joint") describe_joint(parent, child, diagnostic);
    if (name == "material" && parent.name() == "robot") {
      diagnostic.when(cases::kSharedMaterialTag);
    }
    // Our own reader accepts the wrong case, so that other rules still find the element.
    const auto missing =
        std::find_if(std::begin(kMissing), std::end(kMissing), [&](const Missing& one) {
          return one.parent == parent.name() && one.child == name;
        });
    if (missing != std::end(kMissing)) diagnostic.consequences.push_back(missing->rule);
  }

  void repeated(View element, const ElementSpec& spec) {
    for (const ChildSpec& child_spec : spec.children) {
      if (!child_spec.single) continue;
      View first;
      for (const View child : element) {
        if (child.name() != child_spec.name) continue;
        if (!first) {
          first = child;
          continue;
        }
        Diagnostic& diagnostic =
            sink_.report(rules::sml1109_duplicate_singleton, child.name_span(),
                         "a second " + quoted(child.name()) + " in one " + quoted(element.name()));
        diagnostic.label(first.name_span(), "the first one");
        diagnostic.help("keep one of them; which one is read depends on the reader");
      }
    }
  }

  struct Foreign {
    const Rule* rule = nullptr;
    Span place;
    std::string message;
    std::string help;  ///< empty: that of the rule
    std::size_t count = 0;
  };

  DiagnosticSink& sink_;
  std::unordered_map<const ChildSpec*, const ElementSpec*> specs_;  ///< of children, a cache
  std::vector<Foreign> foreign_;
  std::map<std::string, std::size_t> foreign_by_message_;
  std::optional<std::unordered_set<std::string>> named_links_;  ///< by joints, once they are needed
  std::optional<std::unordered_set<std::string>> leaders_;      ///< of joints that mimic them
  std::unordered_set<std::string> parents_;                     ///< of joints; with leaders_
  bool has_links_ = false;
};

}  // namespace

void check_urdf_shape(const xml::Document& document, DiagnosticSink& sink) {
  const View root = document.view();
  if (const ElementSpec* spec = urdf::find_element_spec(root.name())) {
    ShapeChecker(sink).document(root, *spec);
  }
}

}  // namespace smurf
