// SPDX-License-Identifier: BSD-3-Clause
// The parts of the files of a bundle, and their places.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/bundle.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf::test {

inline constexpr std::string_view kBlanks = " \t\r\n";

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool empty() const { return begin == end; }
};

enum class PartKind : std::uint8_t { element, attribute, member, item };

/// A part of a file: an element, an attribute, a key with its value, or an entry of a list.
struct Part {
  PartKind kind = PartKind::element;
  Range whole;
  Range name;   ///< empty for entries of lists
  Range value;  ///< for an element, its text
  bool is_flow = false;
  std::size_t file = 0;
};

struct File {
  Range name;  ///< empty for the text before the first marker
  Range text;
};

class Parts {
 public:
  explicit Parts(std::string_view bundle) : text_(bundle) {
    find_files();
    for (std::size_t i = 0; i < files.size(); ++i) read(i);
  }

  std::string_view at(Range range) const {
    return text_.substr(range.begin, range.end - range.begin);
  }
  /// The bytes since the beginning of the line.
  std::size_t column(std::size_t offset) const {
    return offset == 0 ? 0 : offset - (text_.rfind('\n', offset - 1) + 1);
  }
  /// The text without the indentation of its place.
  std::string dedented(const Part& part) const {
    const std::size_t indent = column(part.whole.begin);
    std::string result(at(part.whole));
    for (std::size_t line = result.find('\n'); line != std::string::npos;
         line = result.find('\n', line + 1)) {
      const std::size_t first = std::min(result.find_first_not_of(' ', line + 1), result.size());
      result.erase(line + 1, std::min(indent, first - line - 1));
    }
    return result;
  }

  std::vector<File> files;
  std::vector<Part> parts;

 private:
  void find_files() {
    File file;
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size() - 1) + 1;
      if (text_.substr(at).starts_with(kBundleMark)) {
        if (!file.text.empty()) files.push_back(file);
        file.name = {at + kBundleMark.size(), end - (text_[end - 1] == '\n' ? 1 : 0)};
        file.text.begin = end;
      }
      file.text.end = at = end;
    }
    if (!file.text.empty()) files.push_back(file);
  }

  void read(std::size_t index) {
    const std::string_view text = at(files[index].text);
    SourceMap sources;
    DiagnosticSink sink;
    const SourceId id = sources.add("a", std::string(text));
    const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
    if (text.substr(first).starts_with('<')) {
      if (const auto document = parse_xml(sources, id, {}, sink)) add_xml(*document, index);
    } else if (const auto document = parse_yaml(sources, id, {}, sink)) {
      add_yaml(*document, index);
    }
  }

  Range moved(Span span, std::size_t file) const {
    const std::size_t begin = files[file].text.begin;
    return {begin + span.begin, begin + std::max(span.begin, span.end)};
  }

  void add_xml(const xml::Document& document, std::size_t file) {
    for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
      const xml::View element(document, xml::ElementId{i});
      parts.push_back({PartKind::element, moved(element.span(), file),
                       moved(element.name_span(), file), moved(element.text_span(), file), false,
                       file});
    }
    for (const xml::Attribute& one : document.attributes) {
      parts.push_back({PartKind::attribute, moved(one.span(), file), moved(one.name_span(), file),
                       moved(one.value_span(), file), false, file});
    }
  }

  void add_yaml(const yaml::Document& document, std::size_t file) {
    const auto node_at = [&](yaml::NodeId id) -> const yaml::Node& {
      return document.nodes[static_cast<std::size_t>(id)];
    };
    for (const yaml::Node& node : document.nodes) {
      if (node.parent == yaml::kNoNode) continue;
      const yaml::Node& parent = node_at(node.parent);
      Part part;
      part.file = file;
      part.value = part.whole = moved(node.span, file);
      const char first = text_[std::min(moved(parent.span, file).begin, text_.size() - 1)];
      part.is_flow = first == '[' || first == '{';
      part.kind = parent.kind() == yaml::Kind::mapping ? PartKind::member : PartKind::item;
      if (part.kind == PartKind::member) {
        part.name = moved(node.key_span(), file);
        part.whole = {part.name.begin, std::max(part.name.end, part.value.end)};
      } else if (!part.is_flow && part.whole.begin > 0) {
        const std::size_t dash = text_.find_last_not_of(kBlanks, part.whole.begin - 1);
        if (dash == std::string_view::npos || text_[dash] != '-') continue;
        part.whole.begin = dash;
      }
      parts.push_back(part);
    }
  }

  std::string_view text_;
};

}  // namespace smurf::test
