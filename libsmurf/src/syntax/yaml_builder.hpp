// SPDX-License-Identifier: BSD-3-Clause
// yaml-cpp's events into our tree. Stays inside of syntax/, as all that shows yaml-cpp does.
#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/yaml.hpp"
#include "syntax/text_check.hpp"

namespace smurf {

/// Thrown through yaml-cpp to leave a document that exceeds a limit.
struct StopParsing {};

/// Reports SML0002, SML0010-SML0012 and SML0014-SML0016 on the way.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const SourceMap& sources, SourceId id, const Limits& limits, DiagnosticSink& sink)
      : text_(sources.text(id)),
        mark_shift_(byte_order_mark_size(text_)),
        limits_(limits),
        sink_(sink) {
    document_.source = id;
    // A node takes 12 to 20 bytes of text; what is too much of a large file is never touched.
    document_.nodes.reserve(std::min<std::size_t>(text_.size() / 16, 1U << 16U));
  }

  yaml::Document take() {
    document_.nodes.shrink_to_fit();
    return std::move(document_);
  }
  /// The innermost bracket that is open; an empty span when there is none.
  Span open_bracket() const;
  /// One past the last byte of the root.
  std::uint32_t end() const {
    return document_.root == yaml::kNoNode ? 0 : document_.nodes[index(document_.root)].span.end;
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    open(yaml::Kind::sequence, mark, anchor, style);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    open(yaml::Kind::mapping, mark, anchor, style);
  }
  void OnMapEnd() override {
    report_duplicates(frames_.back().node);
    close();
  }

 private:
  struct Frame {
    yaml::NodeId node = yaml::kNoNode;
    yaml::NodeId last_child = yaml::kNoNode;
    std::uint32_t end = 0;  ///< of the last key or value so far
    YAML::anchor_t anchor = 0;
    bool flow = false;     ///< in brackets
    bool has_key = false;  ///< a mapping that waits for the value of `key`
    bool is_key = false;   ///< this collection itself stands where a key should
    std::string_view key;
    Span key_span;
  };

  struct Entry {
    std::string_view key;
    yaml::NodeId id;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.key != b.key ? a.key < b.key : a.id < b.id;
    }
  };

  static std::size_t index(yaml::NodeId id) { return static_cast<std::size_t>(id); }
  yaml::Node& at(yaml::NodeId id) { return document_.nodes[index(id)]; }
  std::uint32_t offset(const YAML::Mark& mark) const {
    return std::min(static_cast<std::uint32_t>(mark.pos) + mark_shift_,
                    static_cast<std::uint32_t>(text_.size()));
  }

  bool expects_key() const {
    return !frames_.empty() && !frames_.back().has_key &&
           document_.nodes[index(frames_.back().node)].kind == yaml::Kind::mapping;
  }

  /// Where an absent value would stand: behind the dash or the colon before it.
  std::uint32_t absent_place(std::uint32_t mark) const;
  std::uint32_t written_null(std::uint32_t begin) const;

  /// yaml-cpp reads `[1,,2]` and `{,}` as holding nulls; YAML has no such entries.
  void check_absent(std::uint32_t at_offset);
  void check_colon();
  void append(yaml::Node node, YAML::anchor_t anchor, std::uint64_t size);

  /// True when the node is the key of an open mapping, which is then stored in the frame.
  bool takes_key(const yaml::Node& node);

  /// A key that something refers to: it has a node, but no place in the tree.
  yaml::NodeId add_unlinked(const yaml::Node& node);
  yaml::NodeId add(yaml::Node& node, std::uint64_t size);
  /// Reports that a limit is reached, and leaves the document.
  [[noreturn]] void stop(const Rule& rule, Span place, std::string message, std::string_view limit);
  void grow(yaml::NodeId parent, std::uint64_t size);
  void open(yaml::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor,
            YAML::EmitterStyle::value style);
  void close();

  void report_duplicates(yaml::NodeId mapping);

  std::string_view text_;
  std::uint32_t mark_shift_;  ///< yaml-cpp does not count a byte order mark
  const Limits& limits_;
  DiagnosticSink& sink_;
  yaml::Document document_;
  std::vector<Frame> frames_;
  std::vector<Entry> entries_;        ///< of report_duplicates(), kept for its memory
  std::vector<std::uint64_t> sizes_;  ///< nodes below and including each node, aliases expanded
  std::unordered_map<YAML::anchor_t, yaml::NodeId> anchors_;
};

}  // namespace smurf
