// SPDX-License-Identifier: BSD-3-Clause
// The state of an expansion. Its functions are in expand.cpp (elements), macro.cpp, include.cpp,
// texts.cpp (texts with expressions), substitution.cpp ($(...)) and yaml_values.cpp.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/xacro.hpp"
#include "smurf/xml.hpp"
#include "smurf/yaml.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/node.hpp"

namespace smurf::xacro {

struct Macro {
  struct Parameter {
    std::string_view name;  ///< "*name" and "**name" for blocks
    bool forwards = false;  ///< takes the property of the caller
    std::optional<std::string_view> value;
    Span place;  ///< of the default
    bool is_exact = false;
    bool has_default() const { return forwards || value.has_value(); }
  };
  std::string_view name;
  const Node* body = nullptr;
  std::vector<Parameter> parameters;
};

/// Macros by name; each table hangs below that of the caller.
class MacroTable {
 public:
  explicit MacroTable(MacroTable* parent = nullptr) : parent_(parent) {}
  struct Entry {
    Macro* macro = nullptr;
    MacroTable* name_space = nullptr;
  };
  const Entry* find(std::string_view name) const;
  const Entry* own(std::string_view name) const;
  void set(std::string_view name, Entry entry) { entries_[name] = entry; }
  void append_names(std::vector<std::string_view>& names) const;

 private:
  MacroTable* parent_;
  std::map<std::string_view, Entry> entries_;
};

class Expander final : public Host {
 public:
  Expander(SourceId root, const Settings& settings, Context& context);
  Expansion run();
  std::uint64_t steps() const { return meter_.steps(); }

  // Host
  Value resolve(Table& table, Table::Entry& entry, std::string_view name) override;
  Value load_yaml(const std::string& path) override;
  std::string whole_path(const std::string& path) override;
  Value argument(const std::string& name) override;
  Value environment(const std::string& name, const Value* fallback) override;
  Value find_package(const std::string& name) override;
  void say(std::string_view kind, const std::string& text) override;
  void assign(Table& table, std::string_view name, const Value& value) override;

 private:
  struct Scope {
    MacroTable& macros;
    Table& symbols;
  };
  struct File {
    SourceId source{};
    std::string path;
    std::optional<xml::Document> document;
    const Node* root = nullptr;
  };
  struct Argument {
    std::string text;
    OriginId origin = kComputed;
  };

  void expand_root();
  /// Does something that returns false after a failure; an expansion that has used up what it may
  /// is one. Nothing is thrown beyond this.
  template <class Work>
  bool guarded(Span place, const Work& work);
  // expand.cpp. All return false after a failure.
  bool evaluate(const Node& in, Node& out, Scope scope);
  bool evaluate_attributes(const Node& in, Node& out, Table& symbols);
  bool evaluate_children(const Node& in, Node& out, Scope scope);
  bool evaluate_element(const Node& in, Node& out, Scope scope);
  bool run_element(const Node& in, Node& out, Scope scope);
  bool evaluate_text_node(const Node& in, Node& out, Table& symbols);
  bool copy_element(const Node& in, Node& out, Scope scope);
  bool insert_block(const Node& in, Node& out, Scope scope);
  bool define_property(const Node& in, Node& out, Table& symbols);
  bool define_argument(const Node& in, Node& out, Table& symbols);
  bool set_attribute(const Node& in, Node& out, Table& symbols);
  bool rename_element(const Node& in, Node& out, Scope scope);
  bool choose(const Node& in, Node& out, Scope scope);
  Table* target_table(const Node& in, std::string_view scope, Table& symbols);
  const NodeAttribute* required(const Node& in, std::string_view name);
  void warn_of_others(const Node& in, std::initializer_list<std::string_view> known);
  std::optional<bool> truth_of(const Value& value);
  Node& new_node(NodeKind kind);
  void remove_comments(Node& out);
  void set_xmlns(Node& out, const Node& from);
  bool has_room();

  // macro.cpp
  bool define_macro(const Node& in, Node& out, MacroTable& macros);
  void read_parameters(Macro& macro, const NodeAttribute& params);
  bool call_macro(const Node& in, std::string_view name, Node& out, Scope scope);
  bool call_by_name(const Node& in, Node& out, Scope scope);
  struct Resolved {
    MacroTable* macros = nullptr;
    Table* symbols = nullptr;
    Macro* macro = nullptr;
  };
  Resolved resolve_macro(std::string_view name, Scope scope);
  bool run_macro(const Node& in, const Resolved& resolved, Node& out, Scope scope);
  bool pass_parameters(const Node& in, const Macro& macro, Table& inner, Scope scope,
                       std::vector<const Macro::Parameter*>& left, std::string& shown);
  bool pass_blocks(const Node& in, const Macro& macro, Table& inner, Scope scope,
                   std::vector<const Macro::Parameter*>& left);
  bool pass_defaults(const Node& in, const Macro& macro, Table& inner, Scope scope,
                     std::vector<const Macro::Parameter*>& left);
  bool fail_unknown_macro(const Node& in, std::string_view name, Scope scope);

  // include.cpp
  bool include(const Node& in, Node& out, Scope scope);
  bool include_file(const Node& in, const std::string& path, Node& out, Scope scope);
  std::vector<std::string> glob(const std::string& pattern);
  File* open(const std::string& path, Span reference);
  bool parse(File& file);
  std::string help_with_path(const Failure& failure) const;
  /// A path below the folder of a package; `folder` is empty for others.
  struct PackagePath {
    std::string path;
    std::string folder, rest;
  };
  PackagePath package_path(const std::string& path) const;
  std::string path_before_install(const PackagePath& wanted);

  // texts.cpp
  /// The value of a text. Appends its pieces unless `pieces` is null.
  Value evaluate_text(std::string_view text, const Piece& place, Table& symbols,
                      std::vector<Piece>* pieces);
  Value evaluate_text(const NodeAttribute& attribute, Table& symbols);
  Value evaluate_code(std::string_view written, Table& symbols, Piece& piece);
  Value text_of_parts(std::string text, const Piece& place, const Piece* filled);
  Value evaluate_expression(std::string_view inner, const Piece& place, Table& symbols,
                            Piece& piece);
  void name_inputs();
  /// A text of the result.
  bool trace(const TracedText& in, Table& symbols, TracedText& out);
  /// Applies the literal rule: texts that are numbers or truth values become those.
  Value literal(const Value& value);
  void set(Table& table, std::string_view name, const Value& value, bool is_unevaluated,
           Span place);
  OriginId origin(const Piece& piece);
  static Piece part_of(const Piece& whole, std::size_t begin, std::size_t end);

  // substitution.cpp
  Value substitute(const std::string& inner);
  void explain_arguments(const Failure& failure, Diagnostic& diagnostic);
  Value evaluate_eval(const std::string& expression);
  std::optional<std::string> substitute_all(const std::string& text, bool only_find,
                                            OriginId& origin);
  Value substitute_one(const std::string& command);

  // remarks.cpp: warnings about what can be expanded
  void report_remarks(std::size_t first, std::string_view code, const Piece& expression,
                      std::size_t skipped);
  void check_braces(const TracedText& text, Table& symbols);
  void check_branches(const Node& in, const Node& out, Table& symbols);
  void check_parameters(const Macro& macro, const NodeAttribute& params);
  void check_prefix(const Node& in, const MacroTable& macros);
  // unused_names.cpp
  void check_unused(const Node& in, const Node& out);
  /// inertia_formulas.cpp
  void check_inertia(const Node& in, Table& symbols);

  // yaml_values.cpp
  Value yaml_value(yaml::View view, std::string_view source);
  Value yaml_mapping(yaml::View view, std::string_view source);
  Value yaml_scalar(std::string_view text, yaml::Style style, std::string_view tag, Span span);
  std::optional<Value> yaml_integer(std::string_view text);
  std::optional<Value> yaml_float(std::string_view text);
  Value yaml_tagged(std::string_view text, std::string_view tag, Span span);
  Value fail_yaml(const std::string& message, Span span, bool is_unsupported);
  Value yaml_unit(std::string_view text, double factor, Span span);

  /// Reports the failure of the evaluator, or one of an element.
  bool fail(const Rule& rule, Span place, std::string message, std::string help = {});
  /// The name of the macro that is expanded; "" if there is none.
  std::string macro_around() const;
  bool report();
  /// Completes a failure with the place of its expression.
  void place_failure(const Piece& expression, std::size_t skipped);
  /// False if a warning was reported there before.
  bool is_first_at(Span place);
  void add_frames(Diagnostic& diagnostic) const;
  const std::string& current_path() const { return file_stack_.back(); }

  const Settings& settings_;
  Context& context_;
  Meter meter_;
  Heap heap_;
  Expressions expressions_;
  Evaluator evaluator_;
  /// remove_comments() keeps the comments among the first `count` children of `parent`.
  struct {
    const Node* parent = nullptr;
    std::size_t count = 0;
    bool is_next = false;  ///< also those that the current element expands to
  } kept_;
  Expansion result_;
  Arena nodes_;
  std::deque<Table> tables_;
  std::deque<MacroTable> macro_tables_;
  std::deque<Macro> macros_;
  std::vector<Piece> pieces_;
  std::vector<Piece> traced_;  ///< of the text that is being traced
  Table* functions_ = nullptr;
  Table* eval_functions_ = nullptr;
  std::map<std::string, Argument, std::less<>> arguments_;
  std::map<std::string, std::unique_ptr<File>> files_;
  std::map<std::string, Value> yaml_files_;
  std::vector<std::string> file_stack_;
  /// Folders of packages by their absolute form, as `$(find)` gave them.
  std::map<std::string, std::string> package_folders_;
  struct PackageFolder {
    std::set<std::string> entries;
    std::optional<std::map<std::string, std::string>> moved;  ///< by its CMakeLists.txt
  };
  std::map<std::string, PackageFolder> packages_;  ///< by folder
  std::vector<std::string_view> resolving_;
  FrameId frame_ = kNoFrame;
  std::uint64_t elements_ = 0;
  std::uint64_t files_read_ = 0;
  std::uint64_t depth_ = 0;
  bool has_failed_ = false;
  bool has_yaml_tags_ = false;           ///< in the YAML file that is being read
  std::uint64_t optional_includes_ = 0;  ///< around the place that is being expanded
  std::set<std::uint64_t> warned_;       ///< places of warnings, which are reported once
};

/// Writes the tree as a text, and notes the leaves unless `leaves` is null.
void write_result(const Node& root, const std::vector<Piece>& pieces, std::string& text,
                  std::vector<Leaf>* leaves);

/// The code of a text that is one `${...}`; empty for others.
std::string_view code_of(std::string_view text);

/// Where CMake installs the folders of a package under other names: name below the package, source.
std::map<std::string, std::string> installed_folders(std::string_view cmake_lists);

}  // namespace smurf::xacro
