// SPDX-License-Identifier: BSD-3-Clause
// yaml-cpp's events for our builder. Used only within syntax/, like all code that exposes yaml-cpp.
#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <algorithm>
#include <string>

#include "syntax/text_check.hpp"
#include "syntax/yaml_builder.hpp"

namespace smurf {

/// Events have no spans: yaml-cpp reports where a value begins, and the text shows where it ends.
/// Reports SML0010 where yaml-cpp is less strict than YAML.
class YamlEvents final : public YAML::EventHandler {
 public:
  YamlEvents(std::string_view text, YamlBuilder& builder, DiagnosticSink& sink)
      : text_(text), mark_shift_(byte_order_mark_size(text)), builder_(builder), sink_(sink) {}

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
  void OnMapEnd() override { close(); }

 private:
  std::uint32_t offset(const YAML::Mark& mark) const {
    return std::min(static_cast<std::uint32_t>(mark.pos) + mark_shift_,
                    static_cast<std::uint32_t>(text_.size()));
  }

  /// The place of an absent value: after the dash or the colon before it.
  std::uint32_t absent_place(std::uint32_t mark) const;
  /// Size of the null that is written there; 0 if there is none.
  std::uint32_t written_null(std::uint32_t begin) const;
  bool is_in_flow() const;

  /// yaml-cpp reads nulls in `[1,,2]` and `{,}`; YAML does not allow such entries.
  void check_absent(std::uint32_t at_offset);
  void check_colon();

  void open(yaml::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor,
            YAML::EmitterStyle::value style);
  void close();

  std::string_view text_;
  std::uint32_t mark_shift_;  ///< yaml-cpp does not count a byte order mark
  YamlBuilder& builder_;
  DiagnosticSink& sink_;
};

}  // namespace smurf
