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
#include "syntax/yaml_errors.hpp"
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
      : text_(sources.text(id)),
        mark_shift_(byte_order_mark_size(text_)),
        limits_(limits),
        sink_(sink) {
    document_.source = id;
  }

  yaml::Document take() { return std::move(document_); }
  /// The innermost bracket that is open; an empty span when there is none.
  Span open_bracket() const {
    if (frames_.empty() || !frames_.back().flow) return {document_.source, 0, 0};
    const std::uint32_t begin = document_.nodes[index(frames_.back().node)].span.begin;
    return {document_.source, begin, begin + 1};
  }
  /// One past the last byte of the root.
  std::uint32_t end() const {
    return document_.root == kNoNode ? 0 : document_.nodes[index(document_.root)].span.end;
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    // An absent value carries the mark of the next token; only a written null has a place.
    const std::uint32_t begin = skip_properties(text_, offset(mark));
    const std::uint32_t size = written_null(begin);
    Node node;
    node.span = {document_.source, begin, begin + size};
    if (size == 0) {
      const std::uint32_t at = absent_place(offset(mark));
      node.span = {document_.source, at, at};
      check_absent(offset(mark));
    }
    append(node, anchor, 1);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const std::uint32_t begin = offset(mark);
    std::uint32_t end = begin + 1;
    while (end < text_.size() &&
           std::string_view(" \t\r\n,[]{}").find(text_[end]) == std::string_view::npos) {
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
    const bool is_complex = value.kind == Kind::sequence || value.kind == Kind::mapping;
    if (is_complex && expects_key()) {
      sink_.report(rules::sml0012_complex_key, node.span, "a list or mapping is used as a key")
          .help = "use a plain text, or put it in quotes";
    }
    append(node, 0, sizes_[index(target->second)]);
  }

  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    const ScalarExtent extent = scalar_extent(text_, offset(mark), value);
    Node node;
    node.kind = Kind::scalar;
    node.style = extent.style;
    node.span = {document_.source, extent.begin, extent.end};
    if (extent.begin == extent.end) {  // only a tag is written
      node.span.begin = node.span.end = absent_place(offset(mark));
    }
    if (!extent.closed) {
      sink_.report(rules::sml0010_yaml_syntax, {document_.source, extent.begin, extent.begin + 1},
                   "this quote is never closed");
    }
    const std::string_view bytes = text_.substr(extent.begin, extent.end - extent.begin);
    const std::string_view inner = extent.style == yaml::Style::plain || bytes.size() < 2
                                       ? bytes
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
    std::uint32_t end = 0;  ///< of the last key or value so far
    YAML::anchor_t anchor = 0;
    bool flow = false;     ///< in brackets
    bool has_key = false;  ///< a mapping that waits for the value of `key`
    bool is_key = false;   ///< this collection itself stands where a key should
    std::string_view key;
    Span key_span;
  };

  static std::size_t index(NodeId id) { return static_cast<std::size_t>(id); }
  Node& at(NodeId id) { return document_.nodes[index(id)]; }
  std::uint32_t offset(const YAML::Mark& mark) const {
    return std::min(static_cast<std::uint32_t>(mark.pos) + mark_shift_,
                    static_cast<std::uint32_t>(text_.size()));
  }

  bool expects_key() const {
    return !frames_.empty() && !frames_.back().has_key &&
           document_.nodes[index(frames_.back().node)].kind == Kind::mapping;
  }

  /// Where an absent value would stand: behind the dash or the colon before it.
  std::uint32_t absent_place(std::uint32_t mark) const {
    if (frames_.empty() || expects_key()) return mark;
    const Frame& frame = frames_.back();
    const std::uint32_t before = frame.has_key ? frame.key_span.end : frame.end;
    const std::uint32_t sign = skip_blank(text_, before);
    const bool is_sign = sign < text_.size() && text_[sign] == (frame.has_key ? ':' : '-');
    return is_sign ? sign + 1 : frame.has_key ? before : mark;
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
      const bool is_key = after < text_.size() && text_[after] == ':';
      return is_key && !expects_key() ? 0 : static_cast<std::uint32_t>(word.size());
    }
    return 0;
  }

  /// yaml-cpp reads `[1,,2]` and `{,}` as holding nulls; YAML has no such entries.
  void check_absent(std::uint32_t at_offset) {
    if (frames_.empty() || !frames_.back().flow) return;
    const Frame& frame = frames_.back();
    if (frame.has_key || at_offset >= text_.size() || text_[at_offset] != ',') return;
    sink_.report(rules::sml0010_yaml_syntax, {document_.source, at_offset, at_offset + 1},
                 "there is no entry before this comma");
  }

  void append(Node node, YAML::anchor_t anchor, std::uint64_t size) {
    if (!takes_key(node)) {
      const NodeId id = add(node, size);
      if (anchor != 0) anchors_[anchor] = id;
    } else if (anchor != 0) {
      anchors_[anchor] = add_unlinked(node);
    }
  }

  /// True when the node is the key of an open mapping, which is then stored in the frame.
  bool takes_key(const Node& node) {
    if (!expects_key()) return false;
    Frame& frame = frames_.back();
    frame.has_key = true;
    // A pair inside a flow list, [a: 1], is a mapping without brackets of its own.
    if (node.span.begin == at(frame.node).span.begin) frame.flow = false;
    const bool is_null = node.kind == Kind::null && node.target == kNoNode;
    frame.key =
        is_null ? text_.substr(node.span.begin, node.span.end - node.span.begin) : node.text;
    frame.key_span = node.span;
    frame.end = std::max(frame.end, node.span.end);
    return true;
  }

  /// A key that something refers to: it has a node, but no place in the tree.
  NodeId add_unlinked(const Node& node) {
    document_.nodes.push_back(node);
    sizes_.push_back(1);
    return NodeId{static_cast<std::uint32_t>(document_.nodes.size() - 1)};
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
      node.position = parent.child_count++;
      if (frame.last_child == kNoNode) {
        parent.first_child = id;
      } else {
        at(frame.last_child).next_sibling = id;
      }
      frame.last_child = id;
      frame.has_key = false;
      frame.end = std::max(frame.end, node.span.end);
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
    frame.end = node.span.begin;
    frame.flow = style == YAML::EmitterStyle::Flow;
    frame.anchor = anchor;
    if (takes_key(node)) {
      sink_.report(rules::sml0012_complex_key, node.span, "a list or mapping is used as a key")
          .help = "use a plain text, or put it in quotes";
      frame.is_key = true;
      frame.node = add_unlinked(node);
    } else {
      frame.node = add(node, 1);
    }
    frames_.push_back(frame);
  }

  void close() {
    const Frame frame = frames_.back();
    frames_.pop_back();
    Node& node = at(frame.node);
    node.span.end = frame.end;
    if (frame.flow) node.span.end = flow_end(text_, std::max(frame.end, node.span.begin + 1));
    if (frame.anchor != 0) anchors_[frame.anchor] = frame.node;
    if (frames_.empty()) return;
    frames_.back().end = std::max(frames_.back().end, node.span.end);
    if (frame.is_key) {
      frames_.back().key_span = node.span;
    } else {
      grow(frames_.back().node, sizes_[index(frame.node)] - 1);
    }
  }

  void report_duplicates(NodeId mapping) {
    struct Entry {
      std::string_view key;
      NodeId id;
    };
    std::vector<Entry> entries;
    for (NodeId child = at(mapping).first_child; child != kNoNode; child = at(child).next_sibling) {
      // A list or mapping as a key has no text; it is reported as such.
      const Span key = at(child).key_span;
      if (at(child).key.empty() && !key.empty() && text_[key.begin] != '"' &&
          text_[key.begin] != '\'') {
        continue;
      }
      entries.push_back({at(child).key, child});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.key < b.key; });
    for (std::size_t i = 1, first = 0; i < entries.size(); ++i) {
      if (entries[i].key != entries[first].key) {
        first = i;
        continue;
      }
      at(entries[i].id).is_repeated = true;
      Diagnostic& diagnostic =
          sink_.report(rules::sml0011_duplicate_key, at(entries[i].id).key_span,
                       "duplicate key `" + std::string(entries[i].key) + "` in one mapping");
      diagnostic.caret = "repeated here";
      diagnostic.labels.push_back({at(entries[first].id).key_span, "first set here"});
      diagnostic.notes.push_back("MARS takes the first value, Phobos (PyYAML) the last");
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

/// `first_end` is where the content of the first document ends.
void check_second_document(YAML::Parser& parser, std::string_view text, std::uint32_t first_end,
                           SourceId id, DiagnosticSink& sink) {
  SecondDocument second;
  try {
    parser.HandleNextDocument(second);
  } catch (const StopParsing&) {
  } catch (const YAML::Exception&) {
    second.has_content = true;
  }
  if (!second.has_content) return;
  const std::uint32_t at = std::min(static_cast<std::uint32_t>(std::max(second.start.pos, 0)) +
                                        byte_order_mark_size(text),
                                    static_cast<std::uint32_t>(text.size()));
  // yaml-cpp ends a document where nothing fits any more; only marks may do that.
  const std::string_view between = text.substr(first_end, std::max(at, first_end) - first_end);
  const bool has_mark = text.substr(at).starts_with("---") || text.substr(at).starts_with('%') ||
                        between.find("\n...") != std::string_view::npos;
  if (!has_mark) {
    sink.report(rules::sml0010_yaml_syntax, {id, at, at + 1},
                "this line does not fit what stands above it");
    return;
  }
  sink.report(rules::sml0013_several_documents, {id, at, at}, "a second YAML document begins here")
      .notes.push_back(
          "MARS reads the first document and drops the rest, PyYAML (Phobos) refuses the file");
}

/// The text up to a place where far more brackets seem to be open than any file needs, with these
/// brackets closed; empty when there is none. Brackets inside of texts and comments are counted
/// too.
std::string suspicious_part(std::string_view text, const Limits& limits) {
  const std::size_t suspicious = 4 * std::size_t{limits.yaml_depth};
  std::string closing;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '[' || text[at] == '{') closing += text[at] == '[' ? ']' : '}';
    if ((text[at] == ']' || text[at] == '}') && !closing.empty()) closing.pop_back();
    if (closing.size() <= suspicious) continue;
    std::reverse(closing.begin(), closing.end());
    return std::string(text.substr(0, at + 1)) + closing;
  }
  return {};
}

/// yaml-cpp needs 230 bytes a bracket before it tells of the first. So the part of the text that
/// looks too deep is read alone; true when it is, which is reported.
bool is_too_deep(const SourceMap& sources, SourceId id, const Limits& limits,
                 DiagnosticSink& sink) {
  const std::string part = suspicious_part(sources.text(id), limits);
  if (part.empty()) return false;
  DiagnosticSink found;
  TreeBuilder builder(sources, id, limits, found);
  try {
    ViewBuffer buffer(part);
    std::istream stream(&buffer);
    YAML::Parser(stream).HandleNextDocument(builder);
  } catch (const StopParsing&) {
  } catch (const YAML::Exception&) {
  }
  for (const Diagnostic& diagnostic : found.diagnostics()) {
    if (diagnostic.rule != &rules::sml0014_nesting_too_deep) continue;
    sink.report(*diagnostic.rule, diagnostic.span, diagnostic.message);
    return true;
  }
  return false;
}

}  // namespace

std::optional<yaml::Document> parse_yaml(const SourceMap& sources, SourceId id,
                                         const Limits& limits, DiagnosticSink& sink) {
  if (!check_text(sources, id, sink)) return std::nullopt;
  if (is_too_deep(sources, id, limits, sink)) return std::nullopt;
  const std::string_view text = sources.text(id);
  TreeBuilder builder(sources, id, limits, sink);
  try {
    ViewBuffer buffer(text);
    std::istream stream(&buffer);
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder)) {
      check_second_document(parser, text, builder.end(), id, sink);
    }
  } catch (const StopParsing&) {
    return std::nullopt;
  } catch (const YAML::Exception& error) {
    report_parser_error(error.msg, error.mark.is_null() ? 0 : error.mark.pos,
                        builder.open_bracket(), sources, sink);
    return std::nullopt;
  }
  return builder.take();
}

}  // namespace smurf
