// SPDX-License-Identifier: BSD-3-Clause
// Sources: launch and launch_ros of humble, jazzy and rolling, run on calls with each mistake.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "link/surroundings/launch_mistakes.hpp"
#include "link/surroundings/launch_words.hpp"

namespace smurf::launch {
namespace {

using Kind = LaunchMistake::Kind;
using python::WrittenCall;
using Argument = WrittenCall::Argument;

constexpr std::string_view kBuiltins =
    "abs aiter all anext any ascii bin bool breakpoint bytearray bytes callable chr classmethod "
    "compile complex delattr dict dir divmod enumerate eval exec exit filter float format frozenset "
    "getattr globals hasattr hash help hex id input int isinstance issubclass iter len list locals "
    "map max memoryview min next object oct open ord pow print property quit range repr reversed "
    "round set setattr slice sorted staticmethod str sum super tuple type vars zip __import__ "
    "BaseException Exception ArithmeticError AssertionError AttributeError EOFError ImportError "
    "IndexError KeyError KeyboardInterrupt LookupError ModuleNotFoundError NameError "
    "NotImplementedError OSError FileNotFoundError PermissionError RuntimeError StopIteration "
    "SyntaxError SystemExit TypeError UnicodeDecodeError ValueError ZeroDivisionError IOError "
    "EnvironmentError TimeoutError Warning DeprecationWarning UserWarning RuntimeWarning";

std::string_view last_of(std::string_view callee) {
  return callee.substr(callee.rfind('.') == std::string_view::npos ? 0 : callee.rfind('.') + 1);
}

class PythonMistakes {
 public:
  PythonMistakes(const python::File& python, const Texts& texts, LaunchFile& file)
      : python_(python), texts_(texts), file_(file) {}

  void run() {
    entry();
    gather();
    for (const WrittenCall& call : python_.written) look_at(call);
    for (const python::BadSum& sum : python_.bad_sums) {
      report(Kind::type, sum.span,
             "this is no text: launch replaces it by its value later, and Python cannot add it",
             "write the parts in a list: `['text', LaunchConfiguration('name')]`");
    }
    for (const python::Value& call : python_.calls) {
      const bool is_condition = is_one_of(call.callee, {"IfCondition", "UnlessCondition"});
      if (is_condition && is_launch(call.callee) && !call.items.empty())
        check_condition(texts_.of(call.items.front()), file_);
    }
    check_packages(file_);
    for (const LaunchNode& node : file_.nodes) {
      check_node_name(node.name, file_);
      check_namespace(node.name_space, file_);
    }
  }

 private:
  void report(Kind kind, Span span, std::string message, std::string help,
              std::string replacement = {}) {
    file_.mistakes.push_back(
        {kind, span, std::move(message), std::move(help), std::move(replacement)});
  }

  /// The function that `ros2 launch` calls.
  void entry() {
    constexpr std::string_view kEntry = "generate_launch_description";
    for (const auto& one : python_.functions) {
      if (one.name == kEntry && !one.returns) {
        report(Kind::word, one.span, quoted(kEntry) + " returns nothing",
               "write `return` before the launch description");
      }
    }
    if (python_.bound.contains(kEntry) || python_.has_star_import) return;
    if (python_.bound.contains("generate_test_description")) return;  // of launch_testing
    constexpr std::string_view kKnown[] = {kEntry};
    for (const auto& one : python_.functions) {
      if (!only_nearest(one.name, kKnown)) continue;
      report(Kind::word, one.span, "`ros2 launch` calls " + quoted(kEntry) + ", which is not here",
             "did you mean " + quoted(kEntry) + "?", std::string(kEntry));
      return;
    }
  }

  /// Whether a class is one of launch or launch_ros here.
  bool is_launch(std::string_view callee) const {
    const std::string_view root = callee.substr(0, callee.find('.'));
    const auto from = python_.imported.find(root);
    if (from == python_.imported.end()) return false;
    return from->second.starts_with("launch") && (root != callee || find_class(root) != nullptr);
  }

  void gather() {
    for (const WrittenCall& call : python_.written) {
      const std::string_view name = last_of(call.callee);
      if (is_one_of(name, {"IncludeLaunchDescription", "OpaqueFunction"})) has_others_ = true;
      if (!is_one_of(name, {"DeclareLaunchArgument", "SetLaunchConfiguration"})) continue;
      const Argument* first = argument(call, "name", 0);
      if (first == nullptr || first->text.empty() || call.has_star) {
        has_others_ = true;
      } else {
        set_.insert(first->text);
      }
    }
    names_.assign(set_.begin(), set_.end());
    // An author's function may declare arguments.
    for (const auto& [name, module] : python_.imported) {
      const std::string root = module.substr(0, module.find('.'));
      if (!is_one_of(root, {"launch", "launch_ros", "launch_xml", "launch_yaml", "os", "pathlib",
                            "ament_index_python", "xacro", "yaml", "sys", "typing", "math", "json",
                            "re", "subprocess", "tempfile"}))
        has_others_ = true;
    }
    has_others_ = has_others_ || python_.has_loops || python_.has_star_import;
  }

  static const Argument* argument(const WrittenCall& call, std::string_view name, std::size_t at) {
    std::size_t position = 0;
    for (const Argument& one : call.arguments) {
      if (one.name == name) return &one;
      if (one.name.empty() && position++ == at) return &one;
    }
    return nullptr;
  }

  void look_at(const WrittenCall& call) {
    const std::string_view root = std::string_view(call.callee).substr(0, call.callee.find('.'));
    const bool is_known = python_.bound.contains(root) || python_.has_star_import ||
                          root.starts_with("__") || has_word(kBuiltins, root);
    if (!is_known && !root.empty()) return unbound(call, root);
    const std::string_view name = last_of(call.callee);
    check_texts(call, name);
    const Class* known = is_launch(call.callee) ? find_class(name) : nullptr;
    if (known == nullptr) return;
    keywords(call, *known);
    types(call, *known);
    const Argument* first = argument(call, name == "FindExecutable" ? "name" : "variable_name", 0);
    if (first == nullptr || first->kind != Argument::Kind::text) return;
    if (name == "FindExecutable") check_program(first->text, first->span, file_);
    const bool has_default = argument(call, "default", kNever) != nullptr;
    if (name != "LaunchConfiguration" || has_default || set_.contains(first->text)) return;
    check_argument(first->text, first->span, names_, false, near_, file_);
    LaunchMistake& found = file_.mistakes.back();
    if (has_others_ && found.replacement.empty())
      file_.mistakes.pop_back();
    else if (has_others_)
      found.is_doubtful = true;
  }

  void unbound(const WrittenCall& call, std::string_view root) {
    if (bound_.empty()) bound_.assign(python_.bound.begin(), python_.bound.end());
    const auto near = near_.of(root, bound_);
    const bool is_class = find_class(root) != nullptr;
    std::string help = near       ? "did you mean " + quoted(*near) + "?"
                       : is_class ? "import it from launch or launch_ros"
                                  : "import or define it";
    report(Kind::word, call.span, "nothing here defines the name " + quoted(root), std::move(help),
           near && call.span.end - call.span.begin == root.size() ? std::string(*near) : "");
  }

  void keywords(const WrittenCall& call, const Class& known) {
    int positions = 0;
    bool has_unknown = false;
    const std::string name(known.name);
    for (const Argument& one : call.arguments) {
      if (one.name.empty()) {
        ++positions;
        continue;
      }
      if (has_word(known.keywords, one.name)) continue;
      has_unknown = true;
      std::vector<std::string_view> words;
      for (std::size_t at = 0;;) {
        const std::string_view word = next_word(known.keywords, at);
        if (word.empty()) break;
        words.push_back(word);
      }
      std::string right;
      constexpr std::pair<std::string_view, std::string_view> kOld[] = {
          {"exec", "executable"},       {"pkg", "package"},      {"args", "arguments"},
          {"params", "parameters"},     {"param", "parameters"}, {"ns", "namespace"},
          {"default", "default_value"}, {"remap", "remappings"}};
      for (const auto& [old, now] : kOld) {
        if (one.name == old && has_word(known.keywords, now)) right = now;
      }
      if (one.name.starts_with("node_") && has_word(known.keywords, one.name.substr(5)))
        right = one.name.substr(5);
      if (right.empty()) right = only_nearest(one.name, words).value_or("");
      report(Kind::word, one.name_span, quoted(name) + " has no argument " + quoted(one.name),
             right.empty() ? std::string("delete it") : "did you mean " + quoted(right) + "?",
             right);
    }
    if (positions > known.positions && !call.has_star) {
      report(Kind::word, call.span,
             quoted(name) + " takes " +
                 (known.positions == 0 ? std::string("all its arguments by their names")
                                       : "at most " + std::to_string(known.positions) +
                                             " arguments without their names"),
             "write `NAME=` before the others");
      return;
    }
    if (call.has_star || has_unknown) return;
    int index = 0;
    for (std::size_t at = 0;; ++index) {
      const std::string_view word = next_word(known.required, at);
      if (word.empty()) break;
      if (index < positions || argument(call, word, kNever) != nullptr) continue;
      report(Kind::word, call.span, quoted(name) + " needs the argument " + quoted(word),
             "add " + quoted(std::string(word) + "=..."));
    }
  }

  /// Values of a type that raises an error.
  void types(const WrittenCall& call, const Class& known) {
    for (const Argument& one : call.arguments) {
      const bool is_scalar =
          one.kind == Argument::Kind::truth || one.kind == Argument::Kind::number;
      const bool wants_text =
          is_one_of(one.name, {"default_value", "name", "package", "executable", "namespace"}) ||
          (is_one_of(known.name, {"IfCondition", "UnlessCondition", "FindPackageShare",
                                  "LaunchConfiguration"}) &&
           one.name.empty()) ||
          (known.name == "SetLaunchConfiguration" && one.name != "condition");
      if (is_scalar && wants_text) {
        std::string text = one.text;
        if (one.kind == Argument::Kind::truth) text = one.text == "True" ? "true" : "false";
        report(Kind::type, one.span,
               quoted(known.name) + " needs a text, and " + quoted(one.text) + " is none",
               "write it in quotes", "'" + text + "'");
      } else if (one.name == "parameters" &&
                 (one.kind == Argument::Kind::mapping || one.kind == Argument::Kind::text)) {
        report(Kind::type, one.span, "`parameters` needs a list", "write `[...]` around it");
      } else if (one.name == "launch_arguments" && one.kind == Argument::Kind::mapping) {
        report(Kind::type, one.span, "`launch_arguments` needs pairs, and this is a mapping",
               "write `.items()` behind it");
      } else if (one.name == "value_type" && one.kind == Argument::Kind::text) {
        report(Kind::type, one.span, "`value_type` needs a type, and this is a text",
               "write `value_type=" + one.text + "`, without quotes");
      } else if (one.name == "on_stderr" && one.kind == Argument::Kind::text &&
                 !is_one_of(one.text, {"fail", "ignore", "warn", "capture"})) {
        report(Kind::type, one.span, "`on_stderr` cannot be " + quoted(one.text),
               "write `fail`, `ignore`, `warn` or `capture`");
      } else if (one.name == "condition" &&
                 (one.kind == Argument::Kind::text || one.kind == Argument::Kind::truth ||
                  one.kind == Argument::Kind::lazy)) {
        report(Kind::type, one.span, "this is no condition", "write `IfCondition(...)`");
      }
    }
  }

  /// Functions of Python that need a text, and get what launch replaces later.
  void check_texts(const WrittenCall& call, std::string_view name) {
    if (!is_one_of(call.callee,
                   {"os.path.join", "path.join", "open", "xacro.process_file", "process_file",
                    "os.path.exists", "os.path.isfile", "Path", "pathlib.Path", "xacro.process"}))
      return;
    for (const Argument& one : call.arguments) {
      if (one.kind != Argument::Kind::lazy || !one.name.empty()) continue;
      report(Kind::type, one.span,
             quoted(name == "join" ? "os.path.join" : name) +
                 " needs a text, and launch replaces this by its value later",
             name == "join" ? "write `PathJoinSubstitution([...])`"
                            : "write `get_package_share_directory(...)`, or use `OpaqueFunction`");
    }
  }

  static constexpr std::size_t kNever = 1000;

  const python::File& python_;
  const Texts& texts_;
  LaunchFile& file_;
  std::set<std::string, std::less<>> set_;
  std::vector<std::string_view> names_;
  std::vector<std::string_view>
      bound_;  ///< the names that Python knows here, once they are asked for
  NearNames near_;
  bool has_others_ = false;  ///< what is not read may set arguments
};

}  // namespace

void find_mistakes(const python::File& python, const Texts& texts, LaunchFile& file) {
  PythonMistakes(python, texts, file).run();
}

}  // namespace smurf::launch
