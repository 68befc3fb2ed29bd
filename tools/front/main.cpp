// SPDX-License-Identifier: BSD-3-Clause
// smurf: one name for all tools; `smurf check` runs smurf-lint, and so on.
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/path.hpp"
#include "base/text/did_you_mean.hpp"
#include "common/cli/command.hpp"
#include "common/cli/process.hpp"
#include "common/files/output.hpp"
#include "render/wrap.hpp"
#include "smurf/write_scene.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurf";

struct Verb {
  std::string_view name;
  std::string_view tool;                  ///< the program that it runs; "": that of the format
  std::vector<std::string_view> options;  ///< what comes before the arguments of the user
  std::string_view does;

  /// The program whose options are offered behind the verb.
  std::string_view completed_as() const { return tool.empty() ? "smurfs-flatten" : tool; }
};

/// The command line of a program that converts.
struct ConvertLine {
  std::string tool;
  std::vector<std::string> arguments;
  std::string problem;         ///< why nothing can be converted; "" if it can
  bool asks_for_help = false;  ///< `--to help`
};

/// Names of formats by their extensions, where the two differ.
struct Extension {
  std::string_view extension;
  std::string_view format;
};

constexpr Extension kExtensions[] = {{".xml", "mjcf"},
                                     {".mjcf", "mjcf"},
                                     {".world", "sdf"},
                                     {".smurfs", "smurfs"},
                                     {".smurf", "smurf"}};

std::string format_of(std::string_view output) {
  const std::string extension = path::to_lower(path::extension(output));
  if (extension.empty()) return "smurf";  // a folder
  for (const Extension& row : kExtensions) {
    if (row.extension == extension) return std::string(row.format);
  }
  return extension.substr(1);
}

bool is_scene(std::string_view input) {
  const std::string extension = path::to_lower(path::extension(input));
  return extension == ".smurfs" || extension == ".smurfa" || extension == ".zsmurfs" ||
         extension == ".svg";
}

std::vector<std::string_view> known_formats() {
  std::vector<std::string_view> names{"urdf", "smurf"};
  for (const SceneFormat* format : scene_formats()) {
    if (format->name != "urdf") names.push_back(format->name);
  }
  return names;
}

/// What is written on the command line of `convert`.
struct Words {
  std::string input;
  std::string output;
  std::optional<std::string> format;
  std::vector<std::string> others;
};

/// Takes the value of an option that is written in one word or in two; false if it is another.
bool take(std::span<const std::string> arguments, std::size_t& i, std::string_view name,
          std::optional<std::string>& value) {
  const std::string& word = arguments[i];
  if (word == name) {
    value = i + 1 < arguments.size() ? arguments[++i] : "";
    return true;
  }
  if (!word.starts_with(std::string(name) + "=")) return false;
  value = word.substr(name.size() + 1);
  return true;
}

Words read_words(std::span<const std::string> arguments) {
  Words words;
  bool has_options = false;  // an operand behind one may be its value
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    std::optional<std::string> output;
    if (take(arguments, i, "--to", words.format)) continue;
    if (take(arguments, i, "--output", output) || take(arguments, i, "-o", output)) {
      words.output = *output;
      continue;
    }
    const bool is_operand = !word.starts_with('-') && word.find(":=") == std::string::npos;
    if (is_operand && !has_options && words.input.empty()) {
      words.input = word;
    } else if (is_operand && !has_options && words.output.empty()) {
      words.output = word;
    } else {
      has_options = has_options || word.starts_with('-');
      words.others.push_back(word);
    }
  }
  return words;
}

std::span<const Verb> verbs() {
  static const std::vector<Verb> kVerbs{
      {"check", "smurf-lint", {}, "Check robots, scenes and the files around them (smurf-lint)."},
      {"fix",
       "smurf-lint",
       {"--fix"},
       "Check, and correct what has one safe answer (smurf-lint --fix)."},
      {"explain",
       "smurf-lint",
       {"--explain"},
       "Explain a rule, such as SML1508, or a key (smurf-lint --explain)."},
      {"init",
       "smurf-lint",
       {"--init"},
       "Set up a folder: write a configuration for it (smurf-lint --init)."},
      {"convert",
       "",
       {},
       "Convert a robot or a scene: `smurf convert arm.urdf arm.xml` (smurf2urdf, urdf2smurf or smurfs-flatten)."},
      {"flatten",
       "smurfs-flatten",
       {},
       "List a scene as instances in the world frame (smurfs-flatten)."},
      {"diff", "smurf-diff", {}, "Compare two versions of a robot or a scene (smurf-diff)."},
      {"view", "smurf-view", {}, "Show a robot or a scene in 3D, in the browser (smurf-view)."},
      {"simulate",
       "smurf-load-check",
       {},
       "Build it in a physics engine, and let it stand and hang (smurf-load-check)."},
      {"lsp", "smurf-lsp", {}, "Start the language server, as editors do (smurf-lsp)."}};
  return kVerbs;
}

/// Null if no verb has this name.
const Verb* find_verb(std::string_view name) {
  const auto found = std::find_if(verbs().begin(), verbs().end(),
                                  [&](const Verb& verb) { return verb.name == name; });
  return found == verbs().end() ? nullptr : &*found;
}

/// Reads `INPUT OUTPUT [OPTION]...` or `INPUT --to FORMAT [OPTION]...`. Options that are not
/// `convert`'s own are handed on.
ConvertLine read_convert_line(std::span<const std::string> arguments) {
  ConvertLine line;
  const Words words = read_words(arguments);
  line.asks_for_help = words.format == "help" || std::find(words.others.begin(), words.others.end(),
                                                           "--help") != words.others.end();
  if (line.asks_for_help) return line;
  if (words.input.empty()) {
    line.problem = "name the input first: `smurf convert arm.urdf arm.xml`";
    return line;
  }
  if (words.output.empty() && !words.format) {
    line.problem = "name the output, as in `smurf convert " + words.input +
                   " arm.xml`, or its format: `--to mjcf` (`--to help` lists them)";
    return line;
  }
  const std::string format = words.format ? *words.format : format_of(words.output);
  const std::vector<std::string_view> known = known_formats();
  if (std::find(known.begin(), known.end(), format) == known.end()) {
    line.problem = words.format ? "--to: " + none_of(format, known)
                                : "no format has the extension '." + format +
                                      "'; add `--to FORMAT` (`--to help` lists them)";
    return line;
  }
  line.arguments.push_back(words.input);
  if (format == "smurf") {
    line.tool = "urdf2smurf";
    if (words.output.empty()) {
      line.problem = "name the folder of the model: `smurf convert " + words.input + " FOLDER`";
    }
  } else if (format == "urdf" && !is_scene(words.input)) {
    line.tool = "smurf2urdf";
  } else {
    line.tool = "smurfs-flatten";
    line.arguments.insert(line.arguments.end(), {"--format", format});
  }
  if (!words.output.empty()) line.arguments.insert(line.arguments.end(), {"-o", words.output});
  line.arguments.insert(line.arguments.end(), words.others.begin(), words.others.end());
  return line;
}

Command make_command() {
  Command command;
  command.name = kTool;
  command.summary = "Checks, fixes, converts, compares and shows robots and scenes.";
  command.operands = "VERB [ARGUMENT]...";
  command.details =
      "VERB is one of the verbs below; what follows it is for the program that the verb runs, and "
      "`smurf VERB --help` lists its options. `convert` takes the input, the output or `--to FORMAT`, "
      "and then options; `--to help` lists the formats.";
  for (const Verb& verb : verbs()) {
    command.verbs.push_back({verb.name, verb.completed_as(), verb.does});
  }
  command.examples = {
      {"smurf check robots/", "Check every robot below a folder:"},
      {"smurf convert arm.urdf arm.xml", "Make an MJCF for MuJoCo; the name says the format:"},
      {"smurf convert --to help", "List the formats, with what each keeps:"},
      {"smurf fix robots/", "Correct what has one safe answer:"},
      {"smurf view arm.urdf.xacro", "Look at a robot in the browser:"},
      {"smurf diff old.urdf new.urdf", "See what changed for the robot:"}};
  command.exit_with_1 = "findings, or a result refused for them";
  return command;
}

/// The formats of `convert`: those of models, then those of scenes.
std::string formats_page() {
  struct Row {
    std::string_view name;
    std::string_view help;
  };
  std::vector<Row> rows{
      {"urdf",
       "A URDF (.urdf). Keeps the file byte for byte; a xacro is expanded; a scene becomes one URDF"},
      {"smurf",
       "A SMURF model (a folder, or .smurf): the URDF byte for byte, with motors, sensors, materials "
       "and poses beside it"}};
  for (const SceneFormat* format : scene_formats()) {
    if (format->name != "urdf") rows.push_back({format->name, format->help});
  }
  constexpr std::size_t kIndent = 10;
  std::string page = "Formats of `smurf convert INPUT OUTPUT`, or `--to FORMAT`:\n\n";
  for (const Row& row : rows) {
    std::string head = "  " + std::string(row.name);
    head.resize(kIndent, ' ');
    page += head + render::wrap(row.help, kIndent, 80).substr(kIndent);
  }
  return page + "\nWhat each format loses: " + std::string(kSite) + "/scene-formats/\n";
}

/// Runs `convert`: chooses the program by the format.
int convert(const std::string& self, const std::vector<std::string>& arguments) {
  const ConvertLine line = read_convert_line(arguments);
  if (line.asks_for_help) return write_output(kTool, "", formats_page()) ? kDone : kFailed;
  if (!line.problem.empty()) {
    complain(kTool, line.problem);
    return kFailed;
  }
  return run_beside(self, line.tool, line.arguments);
}

std::string unknown_verb(std::string_view word) {
  std::vector<std::string_view> known;
  for (const Verb& verb : verbs()) known.push_back(verb.name);
  if (path::extension(word).empty() && word.find('/') == std::string_view::npos) {
    return "there is no verb " + none_of(word, known).substr(0, word.size() + 2) +
           did_you_mean(word, known) + " (see --help)";
  }
  return "'" + std::string(word) + "' is no verb; `smurf check " + std::string(word) +
         "` checks it (see --help)";
}

}  // namespace

int smurf_main(int argc, char** argv) {
  prepare_process();
  const std::vector<std::string> given = arguments_of(argc, argv);
  if (given.size() < 2 || given[1].starts_with('-')) {
    if (given.size() < 2) {
      complain(kTool, "a verb is missing, such as `smurf check .` (see --help)");
      return kFailed;
    }
    if (const auto code = parse_command_line(make_command(), argc, argv)) return *code;
    complain(kTool, "a verb is missing, such as `smurf check .` (see --help)");
    return kFailed;
  }
  const Verb* const verb = find_verb(given[1]);
  if (verb == nullptr) {
    complain(kTool, unknown_verb(given[1]));
    return kFailed;
  }
  std::vector<std::string> rest(given.begin() + 2, given.end());
  if (verb->name == "convert") return convert(given[0], rest);
  const bool asks_for_help = !rest.empty() && (rest[0] == "--help" || rest[0] == "-h");
  if (!asks_for_help) rest.insert(rest.begin(), verb->options.begin(), verb->options.end());
  return run_beside(given[0], std::string(verb->tool), rest);
}
