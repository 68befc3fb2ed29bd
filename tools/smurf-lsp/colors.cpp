// SPDX-License-Identifier: BSD-3-Clause
// Colour boxes of materials, and new colours in the notation of the file.
#include <algorithm>
#include <array>
#include <optional>

#include "base/numbers/numbers.hpp"
#include "config/key_help.hpp"
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

using Rgba = std::array<double, 4>;

struct ColorPlace {
  Span span;
  Rgba rgba{0, 0, 0, 1};
};

std::optional<Rgba> parse_color(std::string_view text) {
  Rgba rgba{0, 0, 0, 1};
  std::size_t count = 0;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.empty()) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    const auto number = parse_number(text.substr(0, end));
    if (!number || *number < 0 || *number > 1 || count == rgba.size()) return std::nullopt;
    rgba[count++] = *number;
    text.remove_prefix(end);
  }
  return count == rgba.size() ? std::optional(rgba) : std::nullopt;
}

std::vector<ColorPlace> colors_of(const xml::Document& document) {
  std::vector<ColorPlace> places;
  for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
    const xml::View element(document, xml::ElementId{i});
    const auto help = element.name() == "color" ? element_help(element.name()) : std::nullopt;
    if (!help) continue;
    for (const KeyHelp& key : help->attributes) {
      const xml::Attribute* attribute = key.is_color ? element.attribute(key.name) : nullptr;
      const auto rgba = attribute != nullptr ? parse_color(attribute->value()) : std::nullopt;
      if (rgba) places.push_back({attribute->value_span(), *rgba});
    }
  }
  return places;
}

std::optional<Rgba> read(yaml::View mapping) {
  Rgba rgba{0, 0, 0, 1};
  constexpr const char* kParts[] = {"r", "g", "b", "a"};
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    const yaml::View part = mapping.find(kParts[i]);
    if (!part) continue;
    const auto number = part.number();
    if (!number || !(*number >= 0 && *number <= 1)) return std::nullopt;
    rgba[i] = *number;
  }
  return rgba;
}

std::vector<ColorPlace> colors_of(const yaml::Document& document, KeyLanguage language) {
  std::vector<ColorPlace> places;
  for (std::uint32_t i = 0; i < document.nodes.size(); ++i) {
    const yaml::View node(document, yaml::NodeId{i});
    if (document.nodes[i].is_alias() || !node.is_mapping() || !node.find("r")) continue;
    const auto help = key_help(language, key_path(document, node.id()));
    const auto rgba = help && help->is_color ? read(node) : std::nullopt;
    if (rgba) places.push_back({node.span(), *rgba});
  }
  return places;
}

std::string shown(double part) { return format_rounded(part, 3); }

}  // namespace

Json colors(Context& context, const Json& params) {
  const std::string path = path_in(params);
  Json found = Json::array();
  for (const FileView& view : context.workspace.views(path)) {
    std::vector<ColorPlace> places;
    if (view.xml != nullptr) {
      places = colors_of(*view.xml);
    } else if (const auto language = key_language(path); language && view.yaml != nullptr) {
      places = colors_of(*view.yaml, *language);
    }
    for (const auto& [span, rgba] : places) {
      found.push_back(
          {{"range", loaded_positions(context).range(span)},
           {"color",
            {{"red", rgba[0]}, {"green", rgba[1]}, {"blue", rgba[2]}, {"alpha", rgba[3]}}}});
    }
    break;  // the same in every model
  }
  return found;
}

Json color_presentations(Context&, const Json& params) {
  Rgba rgba{};
  constexpr const char* kParts[] = {"red", "green", "blue", "alpha"};
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    const Json& part = at(params, {"color", kParts[i]});
    rgba[i] = part.is_number() ? std::clamp(part.get<double>(), 0.0, 1.0) : 1.0;
  }
  const bool is_yaml = key_language(path_in(params)).has_value();
  const std::string text =
      is_yaml ? "{r: " + shown(rgba[0]) + ", g: " + shown(rgba[1]) + ", b: " + shown(rgba[2]) +
                    ", a: " + shown(rgba[3]) + "}"
              : shown(rgba[0]) + " " + shown(rgba[1]) + " " + shown(rgba[2]) + " " + shown(rgba[3]);
  return {{{"label", text}, {"textEdit", {{"range", at(params, {"range"})}, {"newText", text}}}}};
}

}  // namespace smurf::lsp
