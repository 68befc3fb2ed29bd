// SPDX-License-Identifier: BSD-3-Clause
// One table row a key: a new setting is one row and one function.
#include "smurf/config.hpp"

#include <algorithm>

#include "ast/keys.hpp"
#include "base/path.hpp"
#include "base/rules.hpp"
#include "base/suggest.hpp"
#include "smurf/limits.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

std::string quoted(std::string_view text) { return "`" + std::string(text) + "`"; }

class ConfigReader {
 public:
  ConfigReader(std::string path, SourceMap& sources, const FileReader& files, DiagnosticSink& sink)
      : path_(std::move(path)), sources_(sources), files_(files), sink_(sink) {}

  Config run() {
    const std::optional<SourceId> source = read(path_, {});
    if (!source) return {};
    const auto document = parse_yaml(sources_, *source, Limits{}, sink_);
    const yaml::View root = document ? document->view() : yaml::View();
    if (!root || root.is_null()) return {};
    if (!root.is_mapping()) {
      wrong(root, "the configuration is a mapping of settings, not " + describe(root));
    } else {
      read_mapping(root, kConfigKeys, "setting");
    }
    return std::move(config_);
  }

  void read_select(yaml::View value) { read_rules(value, config_.selection.select); }
  void read_ignore(yaml::View value) { read_rules(value, config_.selection.ignore); }

  void read_severity(yaml::View value) {
    if (!value.is_mapping()) return expect(value, "a mapping from rules to levels");
    for (const yaml::View level : value) {
      if (!is_rule(level, level.key(), level.key_span())) continue;
      const auto known = {Severity::error, Severity::warning, Severity::info};
      const auto* found = std::find_if(known.begin(), known.end(), [&](Severity severity) {
        return to_string(severity) == level.text();
      });
      if (found == known.end()) {
        expect(level, "error, warning or info");
      } else {
        config_.selection.severities[std::string(level.key())] = *found;
      }
    }
  }

  void read_schemas(yaml::View value) {
    if (!value.is_mapping()) return expect(value, "`sections` and `entities`");
    read_mapping(value, kSchemaKeys, "kind of schemas");
  }

  void read_section_schemas(yaml::View value) {
    read_schema_files(value, [&](std::string name, SourceId schema) {
      config_.schemas.add_section(std::move(name), schema, sources_, sink_);
    });
  }

  void read_entity_schemas(yaml::View value) {
    read_schema_files(value, [&](std::string type, SourceId schema) {
      config_.schemas.add_entity_type(std::move(type), schema, sources_, sink_);
    });
  }

  void read_targets(yaml::View value) {
    for_each_text(value, "a list of readers",
                  [&](yaml::View target) { config_.targets.emplace_back(target.text()); });
  }

 private:
  struct Key {
    std::string_view name;
    void (ConfigReader::*read)(yaml::View value);
  };
  static constexpr Key kConfigKeys[] = {
      {"ignore", &ConfigReader::read_ignore},   {"schemas", &ConfigReader::read_schemas},
      {"select", &ConfigReader::read_select},   {"severity", &ConfigReader::read_severity},
      {"targets", &ConfigReader::read_targets},
  };
  static constexpr Key kSchemaKeys[] = {
      {"entities", &ConfigReader::read_entity_schemas},
      {"sections", &ConfigReader::read_section_schemas},
  };

  void read_mapping(yaml::View mapping, std::span<const Key> keys, std::string_view what) {
    for (const yaml::View value : mapping) {
      const auto key = std::find_if(keys.begin(), keys.end(),
                                    [&](const Key& one) { return one.name == value.key(); });
      if (key == keys.end()) {
        report_unknown(value, keys, what);
      } else if (!value.is_null() && !value.is_repeated()) {
        (this->*key->read)(value);
      }
    }
  }

  void report_unknown(yaml::View value, std::span<const Key> keys, std::string_view what) {
    Diagnostic& diagnostic =
        sink_.report(rules::sml9001_unknown_setting, value.key_span(),
                     "there is no " + std::string(what) + " " + quoted(value.key()));
    diagnostic.pointer = yaml::pointer(value.document(), value.id());
    std::vector<std::string_view> names;
    for (const Key& key : keys) names.push_back(key.name);
    suggest(diagnostic, value.key(), names, value.key_span());
    if (!diagnostic.help.empty()) return;
    diagnostic.help = "known are";
    for (const std::string_view name : names) {
      diagnostic.help += (name == names.front() ? " " : ", ") + quoted(name);
    }
  }

  static void suggest(Diagnostic& diagnostic, std::string_view text,
                      std::span<const std::string_view> known, Span place) {
    const auto near = nearest(text, known);
    if (!near) return;
    diagnostic.help = "did you mean " + quoted(*near) + "?";
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{without_quotes(place, text), std::string(*near)}}});
  }

  Diagnostic& wrong(yaml::View value, std::string message) {
    return wrong(value, value.place(), std::move(message));
  }

  Diagnostic& wrong(yaml::View value, Span place, std::string message) {
    Diagnostic& diagnostic = sink_.report(rules::sml9002_wrong_setting, place, std::move(message));
    diagnostic.pointer = yaml::pointer(value.document(), value.id());
    return diagnostic;
  }

  void expect(yaml::View value, std::string_view expected) {
    const std::string subject = value.key().empty() ? "an item" : quoted(value.key());
    wrong(value, subject + " takes " + std::string(expected) + ", not " + describe(value));
  }

  /// One text, or a list of them.
  template <class Visit>
  void for_each_text(yaml::View value, std::string_view expected, Visit visit) {
    if (value.is_scalar()) return visit(value);
    if (!value.is_sequence()) return expect(value, expected);
    for (const yaml::View item : value) {
      if (item.is_scalar()) {
        visit(item);
      } else {
        expect(item, "a text");
      }
    }
  }

  void read_rules(yaml::View value, std::vector<std::string>& patterns) {
    for_each_text(value, "a list of rules", [&](yaml::View item) {
      if (is_rule(item, item.text(), item.span())) patterns.emplace_back(item.text());
    });
  }

  bool is_rule(yaml::View value, std::string_view pattern, Span place) {
    std::vector<std::string_view> known;
    for (const Rule* rule : all_rules()) {
      if (matches(*rule, pattern)) return true;
      known.push_back(rule->id);
      known.push_back(rule->name);
    }
    suggest(wrong(value, place, "there is no rule " + quoted(pattern)), pattern, known, place);
    return false;
  }

  template <class Register>
  void read_schema_files(yaml::View value, Register add) {
    if (!value.is_mapping()) return expect(value, "a mapping from names to schema files");
    for (const yaml::View file : value) {
      if (file.is_repeated()) continue;
      if (!file.is_scalar()) {
        expect(file, "the path of a schema file");
        continue;
      }
      const auto schema = read(path::join(path::parent(path_), file.text()), file.span());
      if (schema) add(std::string(file.key()), *schema);
    }
  }

  /// A file that cannot be read is reported where it is named.
  std::optional<SourceId> read(const std::string& path, Span reference) {
    FileContent content = files_.read(path, Limits{}.file_bytes);
    if (content.status == ReadStatus::ok) return sources_.add(path, std::move(content.text));
    const Rule& rule =
        reference.empty() ? rules::sml0001_unreadable_file : rules::sml9002_wrong_setting;
    if (reference.empty()) reference.source = sources_.add_unreadable(path);
    sink_.report(rule, reference, "cannot read " + quoted(path) + ": " + content.reason);
    return std::nullopt;
  }

  std::string path_;
  SourceMap& sources_;
  const FileReader& files_;
  DiagnosticSink& sink_;
  Config config_;
};

}  // namespace

Config read_config(const std::string& path, SourceMap& sources, const FileReader& files,
                   DiagnosticSink& sink) {
  return ConfigReader(path::normalize(path), sources, files, sink).run();
}

namespace rules {

constinit const Rule sml9001_unknown_setting{
    .id = "SML9001",
    .name = "unknown-setting",
    .severity = Severity::error,
    .summary = "The configuration has a key that is no setting.",
    .why = "It has no effect, and what was meant by it does not happen.",
    .remedy = "Write the key as suggested, or take it out.",
    .sources = "smurf-lint."};

constinit const Rule sml9002_wrong_setting{
    .id = "SML9002",
    .name = "wrong-setting",
    .severity = Severity::error,
    .summary = "A setting of the configuration has a value that it cannot take.",
    .why = "It is ignored: a rule that does not exist selects nothing, a schema that cannot be "
           "read checks nothing.",
    .remedy = "Write a value as the message asks for; `--list-rules` shows the rules.",
    .sources = "smurf-lint."};

}  // namespace rules
}  // namespace smurf
