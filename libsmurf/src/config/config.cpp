// SPDX-License-Identifier: BSD-3-Clause
// One table row per key: a new setting needs one row and one function.
#include "smurf/config.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"
#include "base/files/path.hpp"
#include "base/findings/rule_patterns.hpp"
#include "base/findings/rules.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "config/companion_setting.hpp"
#include "config/setting_findings.hpp"
#include "config/xacro_setting.hpp"
#include "smurf/limits.hpp"
#include "smurf/readers.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

std::optional<Severity> to_severity(std::string_view word) {
  for (const Severity severity : {Severity::error, Severity::warning, Severity::info}) {
    if (to_string(severity) == word) return severity;
  }
  return std::nullopt;
}

using Texts = std::vector<Spanned<std::string>>;
using Levels = std::map<std::string, Spanned<Severity>>;
using Files = std::map<std::string, Spanned<std::string>>;

constexpr std::size_t kLongestChain = 16;  // limit for configurations that extend each other
// Bytes. Thousands of folders may extend one configuration; a thousand sections may name one
// schema.
constexpr std::uint64_t kMostOfConfig = 100'000, kMostOfSchemas = 2'000'000;
/// Entries of one setting. Each is compared with every rule or file.
constexpr std::size_t kMostEntries = 1000;

class ConfigReader {
 public:
  ConfigReader(SourceMap& sources, const FileReader& files, DiagnosticSink& sink,
               std::span<const std::string_view> formats, ConfigOrigin origin)
      : sources_(sources), files_(files), sink_(sink), formats_(formats), origin_(origin) {}

  /// `reference` is the place where another configuration names it; empty for the first.
  void read(const std::string& path, Span reference) {
    read_.insert(files_.identity(path));
    const std::optional<SourceId> source = open(path, reference, kMostOfConfig);
    if (!source) return;
    const auto document = parse_yaml(sources_, *source, Limits{}, sink_);
    const yaml::View root = document ? document->view() : yaml::View();
    if (!root || root.is_null()) return;
    if (!root.is_mapping()) {
      wrong(root, "the configuration must be a mapping of settings, not " + describe(root));
      return;
    }
    chain_.push_back(path);
    // Extended configurations are read first, wherever they are named, so the settings here
    // override theirs.
    if (const yaml::View bases = root.find("extends"); bases && !bases.is_null()) read_bases(bases);
    folder_ = path::parent(path);
    read_mapping(root, kSettings, "setting");
    chain_.pop_back();
  }

  Config take() {
    register_schemas();
    return std::move(config_);
  }

  static std::vector<SettingSpec> settings() { return specs_of(kSettings); }
  static std::vector<SettingSpec> path_settings() { return specs_of(kPathSettings); }

 private:
  struct Setting {
    SettingSpec spec;
    void (ConfigReader::*read)(yaml::View value);
  };
  static const Setting kSettings[17];
  static const Setting kPathSettings[2];
  static const Setting kSchemaSettings[2];

  static std::vector<SettingSpec> specs_of(std::span<const Setting> settings) {
    std::vector<SettingSpec> specs;
    for (const Setting& setting : settings) specs.push_back(setting.spec);
    return specs;
  }

  void read_bases(yaml::View value) {
    const std::string folder(path::parent(chain_.back()));
    for_each_text(value, "a configuration file or a list of them", [&](yaml::View item) {
      const std::string base = path::join(folder, item.text());
      const std::string id = files_.identity(base);
      const auto is_this = [&](const std::string& one) { return files_.identity(one) == id; };
      if (std::any_of(chain_.begin(), chain_.end(), is_this)) {
        wrong(item, "the configuration extends itself" +
                        std::string(is_this(chain_.back()) ? "" : " through other configurations"));
      } else if (chain_.size() >= kLongestChain) {
        wrong(item, std::to_string(kLongestChain) + " configurations extend each other already");
      } else if (!read_.contains(id)) {
        read(base, item.span());
      }
    });
  }

  void skip_bases(yaml::View) {}  // read_bases() was there

  void read_select(yaml::View value) {
    config_.select.clear();
    read_rules(value, config_.select);
  }

  void read_ignore(yaml::View value) { read_rules(value, config_.ignore); }
  void read_severity(yaml::View value) { read_levels(value, config_.severities); }

  void read_tolerances(yaml::View value) {
    if (!value.is_mapping()) return expect(value, "a mapping from rules to numbers");
    for_each_entry(value, [&](yaml::View number) {
      if (!is_rule(number, number.key(), number.key_span())) return;
      const Rule* rule = find_rule(number.key());
      if (rule == nullptr || rule->tolerance.meaning.empty()) {
        wrong(number, number.key_span(), quoted(number.key()) + " has no tolerance")
            .help(rule == nullptr ? "name one rule" : "`--list-rules=json` shows which have one");
      } else if (const auto given = number.number();
                 given && std::isfinite(*given) && *given >= 0) {
        config_.tolerances[std::string(rule->id)] = {*given, number.span()};
      } else {
        expect(number, "a number from 0");
      }
    });
  }

  void read_paths(yaml::View value) {
    if (!value.is_mapping()) return expect(value, "a mapping from patterns to settings");
    for_each_entry(value, [&](yaml::View settings) {
      if (settings.is_null() || settings.is_repeated()) return;
      if (!settings.is_mapping()) return expect(settings, "`ignore` and `severity`");
      config_.paths.push_back(
          {{{std::string(settings.key()), settings.key_span()}, folder_}, {}, {}});
      read_mapping(settings, kPathSettings, "setting of paths");
    });
  }
  void read_path_ignore(yaml::View value) { read_rules(value, config_.paths.back().ignore); }
  void read_path_severity(yaml::View value) { read_levels(value, config_.paths.back().severities); }

  void read_exclude(yaml::View value) {
    for_each_text(value, "a pattern or a list of them", [&](yaml::View item) {
      config_.exclude.push_back({{std::string(item.text()), item.span()}, folder_});
    });
  }

  void read_force_exclude(yaml::View value) {
    const auto given = value.is_scalar() ? value.boolean() : std::nullopt;
    if (!given) return expect(value, "true or false");
    config_.force_exclude = {*given, value.span()};
  }

  void read_packages(yaml::View value) { read_files(value, "folders", config_.packages); }

  void read_xacro(yaml::View value) {
    read_xacro_setting(value, folder_, files_, sink_, config_.xacro);
  }

  void read_companions(yaml::View value) {
    read_companion_setting(value, folder_, files_, sink_, config_.companions);
  }

  void read_schemas(yaml::View value) {
    if (!value.is_mapping()) return expect(value, "`sections` and `entities`");
    read_mapping(value, kSchemaSettings, "kind of schemas");
  }
  void read_section_schemas(yaml::View value) {
    read_files(value, "schema files", config_.section_schemas);
  }
  void read_entity_schemas(yaml::View value) {
    read_files(value, "schema files", config_.entity_schemas);
  }

  void read_targets(yaml::View value) {
    config_.targets.clear();
    for_each_text(value, "a reader or a list of them", [&](yaml::View item) {
      if (find_target(item.text()) != nullptr) {
        config_.targets.push_back({std::string(item.text()), item.span()});
      } else {
        report_word(item, item.text(), "target", target_names());
      }
    });
  }

  void read_format(yaml::View value) {
    config_.formats.clear();
    std::set<std::string> places;
    for_each_text(value, "FORMAT[=FILE] or a list of them", [&](yaml::View item) {
      const std::string_view text = item.text();
      const std::size_t equals = std::min(text.find('='), text.size());
      const std::string name(text.substr(0, equals));
      const std::string_view file = text.substr(std::min(equals + 1, text.size()));
      const std::string place = file.empty() ? std::string("-") : path::join(folder_, file);
      if (!formats_.empty() &&
          std::find(formats_.begin(), formats_.end(), name) == formats_.end()) {
        report_word(item, name, "format", formats_);
      } else if (!file.empty() && origin_ == ConfigOrigin::found) {
        wrong(item, "a configuration that was found beside the files must not name a file to write")
            .help("name it on the command line, `--format " + name +
                  "=FILE`, or name the configuration with `--config`");
      } else if (!places.insert(place).second) {
        wrong(item, "two reports go to " + (place == "-" ? "standard output" : quoted(file)))
            .help("write " + quoted(name + "=FILE"));
      } else {
        config_.formats.push_back({place == "-" ? name : name + "=" + place, item.span()});
      }
    });
  }

  void read_fail_on(yaml::View value) {
    const auto level = value.is_scalar() ? to_severity(value.text()) : std::nullopt;
    if (!level && !(value.is_scalar() && value.text() == "never")) {
      return expect(value, "error, warning, info or never");
    }
    config_.fail_on = {level, value.span()};
  }

  void read_max_warnings(yaml::View value) {
    const auto number = value.is_scalar() ? value.integer() : std::nullopt;
    if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) {
      return expect(value, "a whole number from 0");
    }
    config_.max_warnings = {static_cast<int>(*number), value.span()};
  }

  void read_baseline(yaml::View value) {
    if (!value.is_scalar()) return expect(value, "the path of a file");
    config_.baseline = {path::join(folder_, value.text()), value.span()};
  }

  void read_mapping(yaml::View mapping, std::span<const Setting> settings, std::string_view what) {
    KeyRenames renames(mapping);
    for_each_entry(mapping, [&](yaml::View value) {
      const auto setting = std::find_if(settings.begin(), settings.end(), [&](const Setting& one) {
        return one.spec.name == value.key();
      });
      if (setting == settings.end()) {
        report_unknown(value, settings, what, renames);
      } else if (!value.is_null() && !value.is_repeated()) {
        (this->*setting->read)(value);
      }
    });
  }

  void report_unknown(yaml::View value, std::span<const Setting> settings, std::string_view what,
                      KeyRenames& renames) {
    Diagnostic& diagnostic =
        sink_.report(rules::sml9001_unknown_setting, value.key_span(),
                     "there is no " + std::string(what) + " " + quoted(value.key()));
    diagnostic.pointer = yaml::pointer(value.document(), value.id());
    std::vector<std::string_view> names;
    for (const Setting& setting : settings) names.push_back(setting.spec.name);
    if (const auto near = sink_.suggest(value.key(), names)) {
      diagnostic.help("did you mean " + quoted(*near) + "?");
      renames.offer(diagnostic.fixes, value, *near);
    }
    if (diagnostic.help_text.empty()) diagnostic.help("known are " + listed(all_quoted(names)));
  }

  /// "there is no target `mujuco`", for one of few words.
  void report_word(yaml::View value, std::string_view word, std::string_view what,
                   std::span<const std::string_view> known) {
    Span place = value.span();
    Diagnostic& diagnostic = wrong(value, "there is no " + std::string(what) + " " + quoted(word));
    if (word == value.text()) suggest(diagnostic, word, known, place);
    if (diagnostic.help_text.empty()) diagnostic.help("known are " + listed(all_quoted(known)));
  }

  void suggest(Diagnostic& diagnostic, std::string_view text,
               std::span<const std::string_view> known, Span place) {
    const auto near = sink_.suggest(text, known);
    if (!near) return;
    diagnostic.help("did you mean " + quoted(*near) + "?");
    const auto word = within_quotes(place, text);
    if (!word) return;
    diagnostic.fixes.push_back({Applicability::unsafe, {{*word, std::string(*near)}}});
  }

  Diagnostic& wrong(yaml::View value, std::string message) {
    return wrong(value, value.place(), std::move(message));
  }

  Diagnostic& wrong(yaml::View value, Span place, std::string message) {
    return wrong_setting(value, place, std::move(message), sink_);
  }

  void expect(yaml::View value, std::string_view expected) {
    expect_setting(value, expected, sink_);
  }

  /// The items of a list or the values of a mapping.
  template <class Visit>
  void for_each_entry(yaml::View many, Visit visit) {
    std::size_t count = 0;
    for (const yaml::View entry : many) {
      if (++count > kMostEntries) {
        wrong(entry, "this is entry " + std::to_string(count) + "; only the first " +
                         std::to_string(kMostEntries) + " are read");
        return;
      }
      visit(entry);
    }
  }

  /// One text, or a list of them.
  template <class Visit>
  void for_each_text(yaml::View value, std::string_view expected, Visit visit) {
    if (value.is_scalar()) return visit(value);
    if (!value.is_sequence()) return expect(value, expected);
    for_each_entry(value, [&](yaml::View item) {
      if (item.is_scalar()) {
        visit(item);
      } else {
        expect(item, "a text");
      }
    });
  }

  void read_rules(yaml::View value, Texts& patterns) {
    for_each_text(value, "a rule or a list of rules", [&](yaml::View item) {
      if (!is_rule(item, item.text(), item.span())) return;
      patterns.push_back({std::string(item.text()), item.span()});
    });
  }

  void read_levels(yaml::View value, Levels& levels) {
    if (!value.is_mapping()) return expect(value, "a mapping from rules to levels");
    for_each_entry(value, [&](yaml::View level) {
      if (!is_rule(level, level.key(), level.key_span())) return;
      if (const auto severity = level.is_scalar() ? to_severity(level.text()) : std::nullopt) {
        levels[std::string(level.key())] = {*severity, level.span()};
      } else {
        report_level(level);
      }
    });
  }

  /// Other linters know the level `off`.
  void report_level(yaml::View level) {
    Diagnostic& diagnostic = wrong(
        level, quoted(level.key()) + " must be error, warning or info, not " + describe(level));
    constexpr std::string_view kOff[] = {"off",      "none",  "ignore", "disable",
                                         "disabled", "false", "0"};
    if (!level.is_scalar()) return;
    if (std::find(std::begin(kOff), std::end(kOff), level.text()) == std::end(kOff)) return;
    diagnostic.help("to switch a rule off: `ignore: [" + std::string(level.key()) + "]`");
  }

  bool is_rule(yaml::View value, std::string_view pattern, Span place) {
    if (!rules_matching(pattern).empty()) return true;
    const std::vector<std::string_view>& words = rule_words();
    suggest(wrong(value, place, "there is no rule " + quoted(pattern)), pattern, words, place);
    return false;
  }

  void read_files(yaml::View value, std::string_view what, Files& files) {
    if (!value.is_mapping()) return expect(value, "a mapping from names to " + std::string(what));
    for_each_entry(value, [&](yaml::View file) {
      if (file.is_repeated()) return;
      if (file.is_scalar()) {
        files[std::string(file.key())] = {path::join(folder_, file.text()), file.span()};
      } else {
        expect(file, "a path");
      }
    });
  }

  /// Last, so that only files of the final settings are read.
  void register_schemas() {
    for (const auto& [name, file] : config_.section_schemas) {
      if (const auto schema = open_schema(file)) {
        config_.schemas.add_section(name, *schema, sources_, sink_);
      }
    }
    for (const auto& [type, file] : config_.entity_schemas) {
      if (const auto schema = open_schema(file)) {
        config_.schemas.add_entity_type(type, *schema, sources_, sink_);
      }
    }
  }

  std::optional<SourceId> open_schema(const Spanned<std::string>& file) {
    const auto source = open(file.value, file.span, kMostOfSchemas - schema_bytes_);
    if (source) schema_bytes_ += sources_.text(*source).size();
    return source;
  }

  /// A file that cannot be read is reported at the place that names it.
  std::optional<SourceId> open(const std::string& path, Span reference, std::uint64_t most) {
    FileContent content = files_.read(path, most);
    if (content.status == ReadStatus::too_large) content.reason += ", which is the limit";
    if (content.status == ReadStatus::ok) return sources_.add(path, std::move(content.text));
    const bool is_named = reference != Span{};  // an absent path also has a place
    const Rule& rule = is_named ? rules::sml9002_wrong_setting : rules::sml0001_unreadable_file;
    if (!is_named) reference.source = sources_.add_unreadable(path);
    sink_.report(rule, reference, "cannot read " + quoted(path) + ": " + content.reason);
    return std::nullopt;
  }

  SourceMap& sources_;
  const FileReader& files_;
  DiagnosticSink& sink_;
  std::span<const std::string_view> formats_;
  const ConfigOrigin origin_;
  std::vector<std::string> chain_;  ///< each extends the next
  std::set<std::string> read_;      ///< by identity
  std::string folder_;              ///< of the configuration that is being read
  std::uint64_t schema_bytes_ = 0;
  Config config_;
};

using Reader = ConfigReader;

const ConfigReader::Setting ConfigReader::kSettings[] = {
    {{"baseline", SettingType::file,
      "The file of suppressed findings that --generate-baseline writes."},
     &Reader::read_baseline},
    {{"companions", SettingType::companions,
      "Files of ROS that belong to a robot: an SRDF, controllers.yaml, files of MoveIt."},
     &Reader::read_companions},
    {{"exclude", SettingType::patterns,
      "Files that a search of folders skips; patterns as in .gitignore."},
     &Reader::read_exclude},
    {{"extends", SettingType::files,
      "Configurations that this one extends. Settings here override theirs; ignore, exclude and "
      "paths are added."},
     &Reader::skip_bases},
    {{"fail-on", SettingType::threshold, "The lowest severity that makes the exit code 1."},
     &Reader::read_fail_on},
    {{"force-exclude", SettingType::boolean,
      "Whether excluded files are skipped even when they are named on the command line."},
     &Reader::read_force_exclude},
    {{"format", SettingType::formats,
      "Reports: FORMAT or, in a configuration named with --config, FORMAT=FILE."},
     &Reader::read_format},
    {{"ignore", SettingType::rules, "All but these rules."}, &Reader::read_ignore},
    {{"max-warnings", SettingType::count, "With more warnings than this, the exit code is 1."},
     &Reader::read_max_warnings},
    {{"packages", SettingType::folders, "The folders of the packages in package:// addresses."},
     &Reader::read_packages},
    {{"paths", SettingType::paths,
      "Settings for some files only, by patterns as in .gitignore; the last matching pattern wins."},
     &Reader::read_paths},
    {{"schemas", SettingType::schemas,
      "JSON Schemas (draft-07, as JSON or YAML) of your own annotation sections and entity types."},
     &Reader::read_schemas},
    {{"select", SettingType::rules, "Only these rules: ids, names, or prefixes such as SML3."},
     &Reader::read_select},
    {{"severity", SettingType::levels, "The severities of rules: error, warning or info."},
     &Reader::read_severity},
    {{"targets", SettingType::targets, "The readers that the files are meant for."},
     &Reader::read_targets},
    {{"tolerances", SettingType::tolerances, "The thresholds of rules; --explain describes them."},
     &Reader::read_tolerances},
    {{"xacro", SettingType::xacro,
      "Robots of xacro with their arguments; for lists of values, each combination is checked."},
     &Reader::read_xacro},
};

const ConfigReader::Setting ConfigReader::kPathSettings[] = {
    {{"ignore", SettingType::rules, "Rules that are ignored in these files."},
     &Reader::read_path_ignore},
    {{"severity", SettingType::levels, "Severities of rules in these files."},
     &Reader::read_path_severity},
};

const ConfigReader::Setting ConfigReader::kSchemaSettings[] = {
    {{"entities", SettingType::files, "Of entities of a scene, by their type."},
     &Reader::read_entity_schemas},
    {{"sections", SettingType::files, "Of annotation sections, by their name."},
     &Reader::read_section_schemas},
};

}  // namespace

Config read_config(const std::string& path, SourceMap& sources, const FileReader& files,
                   DiagnosticSink& sink, std::span<const std::string_view> formats,
                   ConfigOrigin origin) {
  ConfigReader reader(sources, files, sink, formats, origin);
  reader.read(path::normalize(path), {});
  return reader.take();
}

std::vector<SettingSpec> config_settings() { return ConfigReader::settings(); }
std::vector<SettingSpec> config_path_settings() { return ConfigReader::path_settings(); }

}  // namespace smurf
