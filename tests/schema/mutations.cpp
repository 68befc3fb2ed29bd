// SPDX-License-Identifier: BSD-3-Clause
#include "schema/mutations.hpp"

#include <cmath>
#include <set>

#include "ast/model_reader.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/numbers/numbers.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf::test {
namespace {

constexpr std::string_view kValues[] = {"",
                                        "~",
                                        "abc",
                                        "''",
                                        "yes",
                                        "off",
                                        "true",
                                        "FALSE",
                                        "'true'",
                                        "0",
                                        "1",
                                        "1.0",
                                        "-1",
                                        "2",
                                        "7",
                                        "'7'",
                                        "\"1\"",
                                        "0x1F",
                                        "0o17",
                                        "010",
                                        "1_000",
                                        "2.5",
                                        "-0.0",
                                        "1e-5",
                                        "1e3",
                                        "1e300",
                                        "1e400",
                                        "4294967296",
                                        "99999999999999999999",
                                        ".inf",
                                        "-.inf",
                                        ".nan",
                                        "inf",
                                        "[]",
                                        "[a]",
                                        "[a, 1, true]",
                                        "[1]",
                                        "[~]",
                                        "[[1]]",
                                        "[{}]",
                                        "[1, 2]",
                                        "[1, 2, 3]",
                                        "[1, '2', 3]",
                                        "[1, .inf, 3]",
                                        "[1, 2, 3, 4]",
                                        "[1, 2, 3, 4, 5]",
                                        "{}",
                                        "{a: 1}",
                                        "{a: b}",
                                        "{a: ~, a: b}",
                                        "{x: 1, y: 2, z: 3}",
                                        "{x: 1, y: two}",
                                        "{x: ~}",
                                        "{x: 1, x: two}",
                                        "{w: 1, x: 0, y: 0, z: 0}",
                                        "{w: 1, x: 0, y: 0, z: ~}",
                                        "{w: 1, x: 0, y: 0}",
                                        "{roll: 0, pitch: 0, yaw: 90}",
                                        "{roll: [], yaw: 90}",
                                        "{r: 0.5, g: 1, b: 0, a: 1}",
                                        "{r: 2}",
                                        "{a: -1}",
                                        "{r: '1'}",
                                        "[{name: a}]",
                                        "[{name: [a]}]"};

std::vector<std::string> values_of(const KeySpec& spec) {
  std::vector<std::string> values(std::begin(kValues), std::end(kValues));
  for (const std::string_view choice : spec.choices) {
    values.emplace_back(choice);
    values.push_back("'" + std::string(choice) + "'");
    values.push_back(std::string(choice) + "x");
  }
  const Bounds bounds = bounds_of(spec);
  for (const double bound : {bounds.minimum, bounds.maximum}) {
    if (!std::isfinite(bound)) continue;
    for (const double offset : {-1.0, 0.0, 1.0}) values.push_back(format_number(bound + offset));
  }
  if (!spec.fallback.empty()) values.emplace_back(spec.fallback);
  for (const KeySpec& member : spec.members.keys()) {
    for (const std::string& value : values_of(member)) {
      const std::string mapping = "{\"" + std::string(member.name) + "\": " + value + "}";
      values.push_back(spec.type == ValueType::list ? "[" + mapping + "]" : mapping);
    }
  }
  return values;
}

/// A mapping with one key under test and the required ones beside it.
std::string entry(const std::vector<const KeySpec*>& keys, const KeySpec& tested,
                  const std::string& value) {
  std::string text = "{\"" + std::string(tested.name) + "\": " + value;
  for (const KeySpec* key : keys) {
    if (!key->required || key == &tested) continue;
    text += ", " + std::string(key->name) + ": " + (key->type == ValueType::text ? "a" : "{}");
  }
  return text + "}";
}

std::string section_text(const SectionSpec& section, const std::string& one) {
  const std::string name(section.name);
  return section.form == SectionForm::named ? name + ": {a: " + one + "}"
                                            : name + ": [" + one + "]";
}

/// Rows that several sections share get all values in the first section and some values in the
/// others.
void enumerate_section(const SectionSpec& section, std::set<const KeySpec*>& done,
                       const AddCase& add) {
  const auto keys = section.keys();
  for (const KeySpec* key : keys) {
    const bool is_new = done.insert(key).second;
    std::size_t index = 0;
    for (const std::string& value : values_of(*key)) {
      if (!is_new && index++ % 9 != 0) continue;
      const std::string one = entry(keys, *key, value);
      add(FileKind::annotations, section_text(section, one));
      if (section.form == SectionForm::list_or_mapping) {
        add(FileKind::annotations, std::string(section.name) + ": " + one);
      }
    }
    if (key->required) add(FileKind::annotations, section_text(section, "{}"));
  }
  std::vector<std::string_view> names(section.aliases.begin(), section.aliases.end());
  names.push_back(section.name);
  for (const std::string_view name : names) {
    for (const std::string_view value : kValues) {
      add(FileKind::annotations, std::string(name) + ": " + std::string(value));
      add(FileKind::model, std::string(name) + ": " + std::string(value));
    }
  }
}

/// Names of all keys and sections.
std::vector<std::string_view> known_names() {
  std::vector<std::string_view> names = section_names();
  for (const SectionSpec* section : all_sections()) {
    for (const KeySpec* key : section->keys()) names.push_back(key->name);
  }
  for (const KeySpec& key : all_entity_keys()) names.push_back(key.name);
  return names;
}

template <class T>
const T& pick(const std::vector<T>& items, std::mt19937& random) {
  return items[random() % items.size()];
}

}  // namespace

void enumerate_values(const AddCase& add) {
  std::set<const KeySpec*> done;
  for (const SectionSpec* section : all_sections()) enumerate_section(*section, done, add);
  for (const Key<Model>& key : main_keys()) {
    for (const std::string& value : values_of(key.spec))
      add(FileKind::model, entry({}, key.spec, value));
  }
  for (const KeySpec& key : scene_keys()) {
    for (const std::string& value : values_of(key)) add(FileKind::scene, entry({}, key, value));
  }
  for (const FileKind kind : {FileKind::model, FileKind::annotations, FileKind::scene}) {
    for (const std::string_view value : kValues) add(kind, std::string(value));
  }
}

std::string mutate(std::string text, std::mt19937& random) {
  static const std::vector<std::string_view> kNames = known_names();
  SourceMap sources;
  DiagnosticSink sink;
  const auto document = parse_yaml(sources, sources.add("case", text), {}, sink);
  if (!document || document->nodes.size() < 2) return text;
  const yaml::Node& node = pick(document->nodes, random);
  Span place = node.span;
  std::string replacement(kValues[random() % std::size(kValues)]);
  if (!node.key_span().empty() && random() % 3 == 0) {
    place = node.key_span();
    const bool is_unknown = random() % 2 == 0;
    replacement = "\"" + (is_unknown ? "qqq" : std::string(pick(kNames, random))) + "\"";
  }
  text.replace(place.begin, place.end - place.begin, replacement);
  return text;
}

}  // namespace smurf::test
