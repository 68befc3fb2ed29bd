// SPDX-License-Identifier: BSD-3-Clause
// smurf-view: a robot or scene in 3D, in the browser.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/path.hpp"
#include "common/cli/browser.hpp"
#include "common/cli/process.hpp"
#include "common/convert/converter.hpp"
#include "common/convert/pictured_scene.hpp"
#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "common/files/stamps.hpp"
#include "render/printable.hpp"
#include "smurf-view/server.hpp"
#include "smurf/write_scene.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kTool = "smurf-view";

struct Options {
  ConverterOptions common;
  std::string shown;
  bool watches = false;
  bool opens_nothing = false;
};

Command make_command(Options& options) {
  Command command;
  command.name = kTool;
  command.summary = "Shows a robot or a scene in 3D, in the browser.";
  command.operands = "FILE [NAME:=VALUE]...";
  command.details =
      "FILE is a URDF, xacro, MJCF or SDF, a .smurf or .smurfs file, an archive, or a folder with "
      "one of these; NAME:=VALUE is an argument of the .xacro. The page is written to a temporary file, which "
      "stays: it needs neither a network nor this program. With --watch, this program serves the "
      "page to this machine only, and the page follows every save of the files: the camera, the "
      "joints and the selection stay as they are. When a file cannot be read, the page keeps the "
      "last robot and names the line.";
  command.options =
      converter_options(options.common, "Write the page to FILE, not to a temporary file.");
  const auto add = [&](Option option) {
    option.group = "Showing";
    command.options.push_back(std::move(option));
  };
  add({.name = "watch",
       .help = "Show each change of the files at once, until Ctrl-C.",
       .set = set_flag(options.watches)});
  add({.name = "no-open",
       .help = "Do not open a browser; print the address of the page.",
       .set = set_flag(options.opens_nothing)});
  command.set_operand = take_one_operand(options.shown, options.common.xacro);
  command.examples = {{"smurf-view robot.urdf", "Look at a robot:"},
                      {"smurf-view --watch robot.urdf", "See each change while writing it:"},
                      {"smurf-view robot.urdf.xacro side:=left", "Look at a xacro file:"},
                      {"smurf-view scene.smurfs -o scene.html", "Keep the page:"}};
  command.exit_with_1 = "the file cannot be shown";
  return command;
}

/// What a browser can show of the files, and which files these are.
struct Picture {
  std::string page;
  std::string problem;
  std::set<std::string> asked;
};

/// "arm.urdf, line 49: `abc` is not a number"
std::string describe(const Diagnostic& error, const SourceMap& sources) {
  const Span span = error.span;
  const std::string name = render::escape(path::file_name(sources.path(span.source)));
  if (!sources.is_readable(span.source)) return name + ": " + error.message;
  const auto size = static_cast<std::uint32_t>(sources.text(span.source).size());
  const Position at = sources.position(span.source, std::min(span.begin, size));
  return name + ", line " + std::to_string(at.line) + ": " + error.message;
}

std::optional<std::string> why_not_shown(const Diagnostic& finding) {
  if (finding.severity != Severity::error || !is_broken_off(&finding)) return std::nullopt;
  return "the robot cannot be read to its end";
}

/// Makes the page of a loaded scene, or says what keeps it from being made.
Picture picture_of(const Conversion& conversion, PicturedScene& scene) {
  Picture picture;
  const std::optional<SceneExport> to_write = scene.to_write();
  const LoadedScene& loaded = scene.loaded();
  const Diagnostic* const error = first_error(loaded);
  if (error != nullptr) {
    picture.problem = describe(conversion.placed(loaded, *error), *loaded.sources);
  }
  if (to_write && !is_broken_off(error)) {
    picture.page = find_scene_format("html")->write(*to_write);
    if (picture.page.size() > to_write->most_bytes) {
      picture.page.clear();
      picture.problem =
          "the page would have more than " + std::to_string(to_write->most_bytes) + " bytes";
    }
  }
  return picture;
}

const std::vector<InputKind> kKinds{InputKind::scene, InputKind::model, InputKind::urdf};

/// Prints the address, or opens the page.
ExitCode present(const Options& options, const std::string& target) {
  if (options.opens_nothing) return write_output(kTool, "-", target + "\n") ? kDone : kFailed;
  return show_page(kTool, target) ? kDone : kFailed;
}

ExitCode show_once(const Options& options, const std::string& current) {
  Conversion conversion(kTool, options.common, kKinds);
  auto loaded = conversion.load_scene(options.shown);
  if (!loaded) return conversion.fail();
  PicturedScene scene(std::move(*loaded), conversion.files(), options.common.limits, current);
  const Picture picture = picture_of(conversion, scene);
  if (!conversion.keeps_inputs({options.common.output})) return kFailed;
  const ExitCode verdict =
      conversion.report(conversion.session().check(scene.loaded()), why_not_shown);
  if (verdict == kFailed) return kFailed;
  if (picture.page.empty()) {
    return conversion.refuse("cannot be shown" +
                             (picture.problem.empty() ? "" : ": " + picture.problem));
  }
  if (verdict != kDone) return conversion.refuse(conversion.why());
  std::string file = options.common.output;
  if (file == "-") return write_output(kTool, file, picture.page) ? kDone : kFailed;
  if (file.empty()) {
    const std::string_view name = path::file_name(options.shown);
    file = write_temporary_page(kTool, name.substr(0, name.find('.')), picture.page);
    if (file.empty()) return kFailed;
  } else if (!write_output(kTool, file, picture.page)) {
    return kFailed;
  }
  conversion.tell_written(file);
  return present(options, file);
}

/// Loads the files again. Reports a failure, and returns nothing then.
std::optional<Picture> read_again(const Options& options, const std::string& current) {
  Conversion conversion(kTool, options.common, kKinds);
  auto loaded = conversion.load_scene(options.shown);
  if (!loaded) return std::nullopt;
  PicturedScene scene(std::move(*loaded), conversion.files(), options.common.limits, current);
  Picture picture = picture_of(conversion, scene);
  picture.asked = conversion.inputs().asked();
  return picture;
}

/// Serves until a file has changed; returns the new stamps, or none after Ctrl-C.
std::optional<Stamps> serve_until_change(PageServer& server, const std::set<std::string>& seen,
                                         const Stamps& known) {
  constexpr auto kShortest = 100ms;  // between two looks at the files
  constexpr int kShare = 10;         // of the time, one part of this many is spent on looking
  Clock::duration wait = kShortest;
  while (!Interruption::has_come()) {
    const Clock::time_point until = Clock::now() + wait;
    while (!Interruption::has_come() && Clock::now() < until) server.serve(kShortest);
    const Clock::time_point begin = Clock::now();
    Stamps now = stamps_of(seen);
    if (now != known) return now;
    wait = std::max<Clock::duration>(kShortest, kShare * (Clock::now() - begin));
  }
  return std::nullopt;
}

ExitCode watch(const Options& options, const std::string& current) {
  PageServer server;
  if (const std::string reason = server.start(); !reason.empty()) {
    complain(kTool, "cannot serve pages on this machine: " + reason);
    return kFailed;
  }
  const Interruption interruption;
  std::set<std::string> seen{options.shown};
  bool is_first = true;
  while (!Interruption::has_come()) {
    Stamps known = stamps_of(seen);
    std::optional<Picture> picture = read_again(options, current);
    if (!picture && is_first) return kFailed;
    if (!picture) picture = Picture{{}, "the file cannot be read", {}};
    // A file that cannot be read names fewer others than before.
    seen.merge(picture->asked);
    for (const std::string& path : seen) known.try_emplace(path, stamp_of(path));
    if (!picture->problem.empty() && !options.common.quiet) complain(kTool, picture->problem);
    server.show({std::move(picture->page), std::move(picture->problem)});
    if (is_first) {
      if (!options.opens_nothing && !options.common.quiet) {
        complain(kTool, "serves " + server.address() + "; Ctrl-C ends it");
      }
      // The address helps when no browser can be started here.
      present(options, server.address());
    }
    is_first = false;
    const std::optional<Stamps> now = serve_until_change(server, seen, known);
    if (now && !options.common.quiet) complain(kTool, describe_changes(known, *now));
  }
  return kDone;
}

}  // namespace

int smurf_view_main(int argc, char** argv) {
  prepare_process();
  Options options;
  if (const auto code = parse_command_line(make_command(options), argc, argv)) return *code;
  const std::string_view why = find_scene_format("html")->obstacle();
  if (!why.empty()) {
    complain(kTool, "there is no page to show: " + std::string(why));
    return kFailed;
  }
  if (options.watches && (!options.common.output.empty() || options.shown == "-")) {
    complain(kTool, options.shown == "-" ? "--watch needs a file, not standard input"
                                         : "--watch writes no page: leave out -o");
    return kFailed;
  }
  const auto current = current_folder(kTool);
  if (!current) return kFailed;
  return options.watches ? watch(options, *current) : show_once(options, *current);
}
