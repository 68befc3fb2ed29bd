// SPDX-License-Identifier: BSD-3-Clause
// Builds our tree from yaml-cpp's events, never from YAML::Node (which loses duplicate keys and is
// slow), and reports what yaml-cpp accepts although stricter readers refuse it.
#include "syntax/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <streambuf>
#include <unordered_map>

#include "base/rules.hpp"
#include "syntax/text_check.hpp"
#include "syntax/yaml_spans.hpp"

namespace smurf {
namespace {

using yaml::Kind;
using yaml::kNoNode;
using yaml::Node;
using yaml::NodeId;

/// Reads from memory that somebody else owns.
class ViewBuffer final : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // never written to: no put area is set
    setg(begin, begin, begin + text.size());
  }
};

/// Thrown through yaml-cpp to leave a document that exceeds a limit; caught in parse_yaml.
struct StopParsing {};

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const SourceMap& sources, SourceId id, const Limits& limits, DiagnosticSink& sink)
      : text_(sources.text(id)), mark_shift_(byte_order_mark_size(text_)), limits_(limits),
        sink_(sink) {
    document_.source = id;
  }

  yaml::Document take() { return std::move(document_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    // An absent value carries the mark of the next token; only a written null has a place.
    const std::uint32_t begin = skip_properties(text_, offset(mark));
    const std::uint32_t size = written_null(begin);
    Node node;
    node.span = {document_.source, begin, begin + size};
    if (size == 0) {
      node.span = {};
      node.span.source = document_.source;
      check_absent(offset(mark));
    }
    append(node, anchor, 1);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const std::uint32_t begin = offset(mark);
    std::uint32_t end = begin + 1;
    while (end < text_.size() && std::string_view(" \t\r\n,]}").find(text_[end]) ==
                                     std::string_view::npos) {
      ++end;
    }
    Node node;
    node.span = {document_.source, begin, end};
    const auto target = anchors_.find(anchor);
    if (target == anchors_.end()) {
      sink_.report(rules::sml0016_cyclic_alias, node.span,
                   "the alias `" + std::string(text_.substr(begin, end - begin)) +
                       "` stands inside the value it repeats");
      append(node, 0, 1);
      return;
    }
    const Node& value = at(target->second);
    node.kind = value.kind;
    node.target = target->second;
    node.text = value.text;
    append(node, 0, sizes_[index(target->second)]);
  }

  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    const ScalarExtent extent = scalar_extent(text_, offset(mark), value);
    Node node;
    node.kind = Kind::scalar;
    node.style = extent.style;
    node.span = {document_.source, extent.begin, extent.end};
    if (!extent.closed) {
      sink_.report(rules::sml0010_yaml_syntax, {document_.source, extent.begin, extent.begin + 1},
                   "this quote is never closed");
    }
    const std::string_view bytes = text_.substr(extent.begin, extent.end - extent.begin);
    const std::string_view inner =
        extent.style == yaml::Style::plain || bytes.size() < 2 ? bytes
                                                               : bytes.substr(1, bytes.size() - 2);
    node.text = inner == value ? inner : std::string_view(document_.decoded.emplace_back(value));
    append(node, anchor, 1);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    open(Kind::sequence, mark, anchor, style);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    open(Kind::mapping, mark, anchor, style);
  }
  void OnMapEnd() override {
    report_duplicates(frames_.back().node);
    close();
  }

 private:
  struct Frame {
    NodeId node = kNoNode;
    NodeId last_child = kNoNode;
    YAML::anchor_t anchor = 0;
    bool flow = false;
    bool has_key = false;   ///< a mapping that waits for the value of `key`
    bool is_key = false;    ///< this collection itself stands where a key should
    std::string_view key;
    Span key_span;
  };

  static std::size_t index(NodeId id) { return static_cast<std::size_t>(id); }
  Node& at(NodeId id) { return document_.nodes[index(id)]; }
  std::uint32_t offset(const YAML::Mark& mark) const {
    return std::min(static_cast<std::uint32_t>(mark.pos) + mark_shift_,
                    static_cast<std::uint32_t>(text_.size()));
  }

  std::uint32_t written_null(std::uint32_t begin) const {
    for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
      if (!text_.substr(begin).starts_with(word)) continue;
      std::size_t after = begin + word.size();
      if (after < text_.size() &&
          std::string_view(" \t\r\n,]}:").find(text_[after]) == std::string_view::npos) {
        continue;
      }
      after = std::min(text_.find_first_not_of(" \t", after), text_.size());
      const bool is_next_key = after < text_.size() && text_[after] == ':';
      return is_next_key ? 0 : static_cast<std::uint32_t>(word.size());
    }
    return 0;
  }

  /// yaml-cpp reads `[1,,2]` and `{,}` as holding nulls; YAML has no such entries.
  void check_absent(std::uint32_t at_offset) {
    if (frames_.empty() || !frames_.back().flow) return;
    const Frame& frame = frames_.back();
    const bool is_entry = at(frame.node).kind == Kind::sequence || !frame.has_key;
    if (!is_entry || at_offset >= text_.size() || text_[at_offset] != ',') return;
    sink_.report(rules::sml0010_yaml_syntax, {document_.source, at_offset, at_offset + 1},
                 "there is no entry before this comma");
  }

  void append(Node node, YAML::anchor_t anchor, std::uint64_t size) {
    if (!frames_.empty() && takes_key(node)) return;
    const NodeId id = add(node, size);
    if (anchor != 0) anchors_[anchor] = id;
  }

  /// True when the node is the key of an open mapping, which is then stored in the frame.
  bool takes_key(const Node& node) {
    Frame& frame = frames_.back();
    if (at(frame.node).kind != Kind::mapping || frame.has_key) return false;
    frame.has_key = true;
    frame.key = node.text;
    frame.key_span = node.span;
    return true;
  }

  NodeId add(Node& node, std::uint64_t size) {
    const NodeId id{static_cast<std::uint32_t>(document_.nodes.size())};
    if (frames_.empty()) {
      document_.root = id;
    } else {
      Frame& frame = frames_.back();
      node.parent = frame.node;
      node.key = frame.key;
      node.key_span = frame.key_span;
      Node& parent = at(frame.node);
      ++parent.child_count;
      if (frame.last_child == kNoNode) {
        parent.first_child = id;
      } else {
        at(frame.last_child).next_sibling = id;
      }
      frame.last_child = id;
      frame.has_key = false;
    }
    document_.nodes.push_back(node);
    sizes_.push_back(size);
    if (!frames_.empty()) grow(frames_.back().node, size);
    return id;
  }

  void grow(NodeId parent, std::uint64_t size) {
    std::uint64_t& total = sizes_[index(parent)];
    total += size;
    if (total <= limits_.yaml_expanded_nodes) return;
    sink_.report(rules::sml0015_alias_expansion, at(parent).span,
                 "aliases make this value larger than " +
                     std::to_string(limits_.yaml_expanded_nodes) + " nodes");
    throw StopParsing();
  }

  void open(Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor,
            YAML::EmitterStyle::value style) {
    Node node;
    node.kind = kind;
    const std::uint32_t begin = skip_properties(text_, offset(mark));
    node.span = {document_.source, begin, begin + 1};
    if (frames_.size() >= limits_.yaml_depth) {
      sink_.report(rules::sml0014_nesting_too_deep, node.span,
                   "lists and mappings are nested deeper than " +
                       std::to_string(limits_.yaml_depth) + " levels");
      throw StopParsing();
    }
    Frame frame;
    frame.flow = style == YAML::EmitterStyle::Flow;
    frame.anchor = anchor;
    if (!frames_.empty() && takes_key(node)) {
      sink_.report(rules::sml0012_complex_key, node.span,
                   "a list or mapping is used as a key");
      // Kept out of the tree: the collection gets a node that nothing links to.
      frame.is_key = true;
      frame.node = NodeId{static_cast<std::uint32_t>(document_.nodes.size())};
      document_.nodes.push_back(node);
      sizes_.push_back(1);
    } else {
      frame.node = add(node, 1);
    }
    frames_.push_back(frame);
  }

  void close() {
    const Frame frame = frames_.back();
    frames_.pop_back();
    Node& node = at(frame.node);
    std::uint32_t end = node.span.begin + 1;
    if (frame.last_child != kNoNode) {
      const Node& last = at(frame.last_child);
      end = last.span.empty() ? std::max(end, last.key_span.end) : last.span.end;
    }
    node.span.end = frame.flow ? flow_end(text_, end) : end;
    if (frame.is_key) {
      frames_.back().key_span = node.span;
      return;
    }
    if (frame.anchor != 0) anchors_[frame.anchor] = frame.node;
    if (!frames_.empty()) grow(frames_.back().node, sizes_[index(frame.node)] - 1);
  }

  void report_duplicates(NodeId mapping) {
    struct Entry {
      std::string_view key;
      NodeId id;
    };
    std::vector<Entry> entries;
    for (NodeId child = at(mapping).first_child; child != kNoNode; child = at(child).next_sibling) {
      entries.push_back({at(child).key, child});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.key < b.key; });
    for (std::size_t i = 1, first = 0; i < entries.size(); ++i) {
      if (entries[i].key != entries[first].key) {
        first = i;
        continue;
      }
      Diagnostic& diagnostic =
          sink_.report(rules::sml0011_duplicate_key, at(entries[i].id).key_span,
                       "duplicate key `" + std::string(entries[i].key) + "` in one mapping");
      diagnostic.caret = "repeated here";
      diagnostic.labels.push_back({at(entries[first].id).key_span, "first set here"});
      diagnostic.notes.push_back(
          "MARS takes the first value, Phobos (PyYAML) the last");
      diagnostic.help = "delete one of the two";
    }
  }

  std::string_view text_;
  std::uint32_t mark_shift_;  ///< yaml-cpp does not count a byte order mark
  const Limits& limits_;
  DiagnosticSink& sink_;
  yaml::Document document_;
  std::vector<Frame> frames_;
  std::vector<std::uint64_t> sizes_;  ///< nodes below and including each node, aliases expanded
  std::unordered_map<YAML::anchor_t, NodeId> anchors_;
};

/// Notices a second document and reads nothing of it.
class SecondDocument final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { start = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override { found(); }
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {
    found();
  }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    found();
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    found();
  }
  void OnMapEnd() override {}

  YAML::Mark start;
  bool has_content = false;

 private:
  void found() {
    has_content = true;
    throw StopParsing();
  }
};

/// yaml-cpp's words are about its grammar; these are about the file.
std::string explain_error(const std::string& message) {
  struct Row {
    std::string_view yaml_cpp;
    std::string_view ours;
  };
  constexpr Row kRows[] = {
      {"bad file", "the lists and mappings are nested too deeply to be read"},
      {"illegal map value", "a second `:` on this line, or a value where none may stand; quote the "
                            "value if it holds a colon"},
      {"end of map not found", "this line does not fit the mapping above: its indentation or a "
                               "missing `:` breaks it"},
      {"end of sequence not found", "this line does not fit the list above: its indentation or a "
                                    "missing `-` breaks it"},
      {"end of sequence flow not found", "this `[` is never closed"},
      {"end of map flow not found", "this `{` is never closed"},
  };
  for (const Row& row : kRows) {
    if (message == row.yaml_cpp) return std::string(row.ours);
  }
  return message;
}

void report_parser_error(const YAML::Exception& error, std::string_view text, SourceId id,
                         DiagnosticSink& sink) {
  const std::uint32_t shift = byte_order_mark_size(text);
  const auto size = static_cast<std::uint32_t>(text.size());
  std::uint32_t at =
      error.mark.is_null() ? 0 : std::min(static_cast<std::uint32_t>(error.mark.pos) + shift, size);
  std::string message = explain_error(error.msg);
  // A tab in the indentation is reported by yaml-cpp at the following colon, in other words.
  const std::size_t line_start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::size_t content = std::min(text.find_first_not_of(" \t", line_start), text.size());
  const std::string_view indent = text.substr(line_start, content - line_start);
  if (const std::size_t tab = indent.find('\t'); tab != std::string_view::npos) {
    at = static_cast<std::uint32_t>(line_start + tab);
    message = "a tab is used for indentation; YAML allows only spaces there";
  }
  const std::uint32_t end = at < size && text[at] != '\n' && text[at] != '\r' ? at + 1 : at;
  sink.report(rules::sml0010_yaml_syntax, {id, at, end}, message);
}

void check_second_document(YAML::Parser& parser, std::string_view text, SourceId id,
                           DiagnosticSink& sink) {
  SecondDocument second;
  try {
    parser.HandleNextDocument(second);
  } catch (const StopParsing&) {
  } catch (const YAML::Exception&) {
    second.has_content = true;
  }
  if (!second.has_content) return;
  const std::uint32_t at = std::min(
      static_cast<std::uint32_t>(std::max(second.start.pos, 0)) + byte_order_mark_size(text),
      static_cast<std::uint32_t>(text.size()));
  sink.report(rules::sml0013_several_documents, {id, at, at},
              "a second YAML document begins here")
      .notes.push_back("readers take the first document and drop the rest without a word");
}

}  // namespace

std::optional<yaml::Document> parse_yaml(const SourceMap& sources, SourceId id,
                                         const Limits& limits, DiagnosticSink& sink) {
  if (!check_text(sources, id, sink)) return std::nullopt;
  const std::string_view text = sources.text(id);
  TreeBuilder builder(sources, id, limits, sink);
  try {
    ViewBuffer buffer(text);
    std::istream stream(&buffer);
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder)) check_second_document(parser, text, id, sink);
  } catch (const StopParsing&) {
    return std::nullopt;
  } catch (const YAML::Exception& error) {
    report_parser_error(error, text, id, sink);
    return std::nullopt;
  }
  return builder.take();
}

}  // namespace smurf
