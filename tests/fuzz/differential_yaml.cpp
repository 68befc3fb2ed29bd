// SPDX-License-Identifier: BSD-3-Clause
// Compares both of our YAML engines with yaml-cpp's own reader, YAML::Load.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <span>

#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"
#include "support/described_yaml.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

/// Texts that we refuse although yaml-cpp accepts them. We accept all other texts that yaml-cpp
/// accepts.
struct Refusal {
  std::string_view rule;
  std::string_view message;  ///< the beginning of the message
  std::string_view reason;
};
constexpr Refusal kRefusals[] = {
    {"SML0003", "", "yaml-cpp takes any bytes; Python, and so Phobos, only UTF-8"},
    {"SML0004", "", "yaml-cpp takes any bytes; YAML forbids control characters"},
    {"SML0005", "", "yaml-cpp reads UTF-16 and UTF-32; no other reader of models does"},
    {"SML0010", "a merge conflict left its markers", "yaml-cpp reads them as texts"},
    {"SML0010", "no `---` follows this directive", "yaml-cpp reads on, PyYAML does not"},
    {"SML0010", "this line does not fit", "yaml-cpp ends the document there and says nothing"},
    {"SML0010", "there is no entry before this comma", "yaml-cpp reads a null there"},
    {"SML0010", "this quote is never closed", "yaml-cpp takes the rest of the file for the text"},
    {"SML0014", "", "lists and mappings in each other are limited before yaml-cpp gives up"},
    {"SML0015", "", "yaml-cpp counts no values; who copies aliases runs out of memory"},
};

bool is_documented(std::span<const Diagnostic> diagnostics) {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& one) {
    return std::ranges::any_of(kRefusals, [&](const Refusal& refusal) {
      return one.rule->id == refusal.rule && one.message.starts_with(refusal.message);
    });
  });
}

class Comparison {
 public:
  Comparison(std::string_view text, std::vector<std::string>& broken)
      : text_(text), broken_(broken) {}

  // Recursion is bounded by Limits::yaml_depth.
  void same(yaml::View ours, const YAML::Node& theirs) {
    const yaml::Node& node = ours.document().nodes[static_cast<std::size_t>(ours.id())];
    const auto [anchored, is_new] =
        anchored_.try_emplace(node.is_alias() ? node.target() : ours.id(), theirs);
    if (!is_new) {
      if (!anchored->second.is(theirs)) note("an alias of another value", ours);
      return;
    }
    switch (ours.kind()) {
    case yaml::Kind::null:
      if (is_cycle(ours)) return;
      if (!theirs.IsNull()) note("a null", ours);
      return;
    case yaml::Kind::scalar: return same_scalar(ours, theirs);
    case yaml::Kind::sequence: return same_sequence(ours, theirs);
    case yaml::Kind::mapping: return same_mapping(ours, theirs);
    }
  }

 private:
  /// An alias in the value it repeats: SML0016, and a null in our tree.
  bool is_cycle(yaml::View ours) const { return text_.substr(ours.span().begin).starts_with('*'); }

  void note(const std::string& what, yaml::View ours) {
    broken_.push_back("yaml-cpp reads something else than " + what + " at byte " +
                      std::to_string(ours.span().begin));
  }

  void same_scalar(yaml::View ours, const YAML::Node& theirs) {
    if (!theirs.IsScalar() || theirs.Scalar() != ours.text()) return note("this text", ours);
    // Nodes with this tag are neither quoted nor blocks.
    if (theirs.Tag() == "?" && ours.style() != yaml::Style::plain) note("a quoted text", ours);
  }

  void same_sequence(yaml::View ours, const YAML::Node& theirs) {
    if (!theirs.IsSequence() || theirs.size() != ours.size()) return note("this list", ours);
    auto item = theirs.begin();
    for (const yaml::View child : ours) same(child, *item++);
  }

  void same_mapping(yaml::View ours, const YAML::Node& theirs) {
    if (!theirs.IsMap() || theirs.size() != ours.size()) return note("this mapping", ours);
    auto entry = theirs.begin();
    for (const yaml::View child : ours) {
      const auto [key, value] = static_cast<std::pair<YAML::Node, YAML::Node>>(*entry++);
      if (key.IsScalar() && key.Scalar() != child.key()) note("this key", child);
      same(child, value);
    }
  }

  std::string_view text_;
  std::vector<std::string>& broken_;
  std::map<yaml::NodeId, YAML::Node> anchored_;
};

void compare(YamlEngine engine, const std::string& text, std::vector<std::string>& broken) {
  SourceMap sources;
  DiagnosticSink sink;
  const SourceId id = sources.add("a.yml", text);
  const auto ours = parse_yaml_by(engine, sources, id, {}, sink);
  YAML::Node theirs;
  std::string refusal;
  try {
    theirs = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    refusal = error.what();
  }
  if (!refusal.empty()) {
    if (ours) broken.push_back("yaml-cpp refuses what we read: " + refusal);
  } else if (!ours) {
    const std::vector<Diagnostic> found = sink.take();
    if (!is_documented(found)) {
      const Diagnostic& first = found.front();
      broken.push_back("yaml-cpp reads what we refuse: " + std::string(first.rule->id) + ' ' +
                       first.message);
    }
  } else if (ours->root != yaml::kNoNode) {
    Comparison(text, broken).same(ours->view(), theirs);
  } else if (!theirs.IsNull()) {
    broken.emplace_back("yaml-cpp reads something, and we nothing");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string text(reinterpret_cast<const char*>(data), size);
  Exercise result;
  if (described_yaml(YamlEngine::scanner_first, text) !=
      described_yaml(YamlEngine::yaml_cpp, text)) {
    result.broken.emplace_back("the scanner and yaml-cpp's events disagree");
  }
  compare(YamlEngine::yaml_cpp, text, result.broken);
  require_kept(result);
  return 0;
}
