// SPDX-License-Identifier: BSD-3-Clause
// Inlay hints: degrees beside radians, and the defaults of missing keys.
#include <algorithm>
#include <optional>

#include "base/numbers/numbers.hpp"
#include "config/key_help.hpp"
#include "link/describe.hpp"
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

struct Hint {
  std::uint32_t offset = 0;
  std::string label;
  std::string tooltip = {};
};

/// The unit: "rad", or "rad or m" for a turning joint.
bool is_angle(std::string_view unit, const urdf::Joint* joint) {
  if (unit == "rad") return true;
  if (!unit.starts_with("rad or m") && !unit.starts_with("rad/s or m/s")) return false;
  return joint != nullptr &&
         (joint->type == urdf::JointType::revolute || joint->type == urdf::JointType::continuous);
}

/// "90 deg" for "1.5708", "0 90 0 deg" for "0 1.5708 0"; none if all are 0.
std::optional<std::string> degrees_of(std::string_view text, std::string_view unit) {
  std::string label;
  bool has_any = false;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.empty()) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    const auto number = parse_number(text.substr(0, end));
    if (!number) return std::nullopt;
    std::string degrees = in_degrees(*number);
    degrees.resize(degrees.rfind(' '));
    label += (label.empty() ? "" : " ") + degrees;
    has_any = has_any || *number != 0;
    text.remove_prefix(end);
  }
  if (!has_any) return std::nullopt;
  return label + (unit.starts_with("rad/s") ? " deg/s" : " deg");
}

/// The joint that an element belongs to.
const urdf::Joint* joint_around(const LinkedModel& model, xml::View element) {
  for (; element; element = element.parent()) {
    if (element.name() != "joint") continue;
    const xml::Attribute* name = element.attribute("name");
    return name != nullptr ? model.find_joint(name->value()) : nullptr;
  }
  return nullptr;
}

/// The joint of an entry: from its key `joint`, otherwise from its name.
const urdf::Joint* joint_of(const LinkedModel& model, yaml::View entry) {
  for (const char* key : {"joint", "name"}) {
    const yaml::View value = entry.find(key);
    if (!value || !value.is_scalar()) continue;
    if (const urdf::Joint* joint = model.find_joint(value.text())) return joint;
  }
  return nullptr;
}

class Hints {
 public:
  Hints(const Client& client, const FileView& view, Span range)
      : client_(client), view_(view), range_(range) {}

  std::vector<Hint> of_xml() {
    const xml::Document& document = *view_.xml;
    for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
      const xml::View element(document, xml::ElementId{i});
      if (!is_wanted(element.tag_span())) continue;
      const auto help = element_help(element.name());
      if (help && client_.shows_degrees) add_attributes(element, *help);
    }
    return std::move(hints_);
  }

  std::vector<Hint> of_yaml(KeyLanguage language) {
    const yaml::Document& document = *view_.yaml;
    for (std::uint32_t i = 0; i < document.nodes.size(); ++i) {
      const yaml::View node(document, yaml::NodeId{i});
      if (document.nodes[i].is_alias() || !node.is_mapping() || !is_wanted(node.span())) continue;
      const auto keys = keys_in(language, key_path(document, node.id()));
      if (keys.empty()) continue;
      if (client_.shows_degrees) add_angles(node, keys);
      if (client_.shows_defaults) add_defaults(node, keys);
    }
    return std::move(hints_);
  }

 private:
  bool is_wanted(Span span) const { return span.begin <= range_.end && range_.begin <= span.end; }

  void add_attributes(xml::View element, const ElementHelp& help) {
    for (const KeyHelp& key : help.attributes) {
      const xml::Attribute* attribute = element.attribute(key.name);
      if (attribute == nullptr || key.unit.empty() || !is_wanted(attribute->span())) continue;
      const urdf::Joint* joint =
          view_.model != nullptr ? joint_around(*view_.model, element) : nullptr;
      if (!is_angle(key.unit, joint)) continue;
      if (auto label = degrees_of(attribute->value(), key.unit)) {
        hints_.push_back({attribute->span().end, *std::move(label)});
      }
    }
  }

  void add_angles(yaml::View entry, const std::vector<KeyHelp>& keys) {
    for (const yaml::View value : entry) {
      const auto key = std::find_if(keys.begin(), keys.end(),
                                    [&](const KeyHelp& one) { return one.name == value.key(); });
      if (key == keys.end() || key->unit.empty() || !value.is_scalar()) continue;
      const urdf::Joint* joint = view_.model != nullptr ? joint_of(*view_.model, entry) : nullptr;
      if (!is_angle(key->unit, joint) || !is_wanted(value.span())) continue;
      if (auto label = degrees_of(value.text(), key->unit)) {
        hints_.push_back({value.span().end, *std::move(label)});
      }
    }
  }

  /// The place of the hints: after the first key of the entry.
  void add_defaults(yaml::View entry, const std::vector<KeyHelp>& keys) {
    constexpr std::size_t kShown = 3;
    std::vector<std::string> absent;
    for (const KeyHelp& key : keys) {
      if (key.fallback.empty() || entry.find(key.name)) continue;
      absent.push_back(key.name + ": " + std::string(key.fallback));
    }
    if (absent.empty() || entry.begin() == entry.end()) return;
    Hint hint{(*entry.begin()).span().end, "default: "};
    for (std::size_t i = 0; i < absent.size(); ++i) {
      if (i < kShown) hint.label += (i == 0 ? "" : ", ") + absent[i];
      hint.tooltip += absent[i] + "\n";
    }
    if (absent.size() > kShown) hint.label += ", ...";
    hints_.push_back(std::move(hint));
  }

  const Client& client_;
  const FileView& view_;
  Span range_;
  std::vector<Hint> hints_;
};

}  // namespace

Json inlay_hints(Context& context, const Json& params) {
  const std::string path = path_in(params);
  const Positions positions = loaded_positions(context);
  Json found = Json::array();
  for (const FileView& view : context.workspace.views(path)) {
    const Span range{view.source, positions.offset(view.source, at(params, {"range", "start"})),
                     positions.offset(view.source, at(params, {"range", "end"}))};
    Hints hints(context.client, view, range);
    std::vector<Hint> list;
    if (view.xml != nullptr) {
      list = hints.of_xml();
    } else if (const auto language = key_language(path); language && view.yaml != nullptr) {
      list = hints.of_yaml(*language);
    }
    for (const Hint& hint : list) {
      Json one = {{"position", positions.position(view.source, hint.offset)},
                  {"label", hint.label},
                  {"paddingLeft", true}};
      if (!hint.tooltip.empty()) one["tooltip"] = hint.tooltip;
      found.push_back(std::move(one));
    }
    break;  // one model is enough
  }
  return found;
}

}  // namespace smurf::lsp
