// SPDX-License-Identifier: BSD-3-Clause
// smurf2urdf: the plain URDF of a SMURF model, checked before it is written.
#include <filesystem>

#include "base/path.hpp"
#include "common/converter.hpp"
#include "smurf/convert.hpp"
#include "smurf2urdf/verify.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurf2urdf";

struct Options {
  ConverterOptions common;
  std::string model;
  bool force = false;
  bool prove = false;
};

Command make_command(Options& options) {
  Command command;
  command.name = kTool;
  command.summary =
      "Exports the plain URDF of a SMURF model: its own URDF, byte for byte, with mesh "
      "paths that resolve from where it is written.";
  command.operands = "MODEL";
  command.details =
      "MODEL is a .smurf or .urdf file. A model with errors is refused. The result is read again "
      "and compared with the source before it is written: urdfdom must accept it, and every link "
      "pose, mass, inertia and limit must be equal.";
  command.options = converter_options(options.common, "Write the URDF to FILE; without it, or with "
                                                      "'-', to standard output.");
  command.options.push_back({.group = "Conversion",
                             .name = "force",
                             .help = "Export a model with errors as well.",
                             .set = set_flag(options.force)});
  command.options.push_back({.group = "Conversion",
                             .name = "prove",
                             .help = "Print what was compared, on standard error.",
                             .set = set_flag(options.prove)});
  command.set_operand = take_one_operand(options.model);
  command.examples = {{"smurf2urdf robot.smurf -o robot.urdf", "export a model"},
                      {"smurf2urdf robot.smurf | check_urdf /dev/stdin", "pass it on"}};
  return command;
}

/// Standard output counts as the current folder.
UrdfExport export_options(const Options& options) {
  const std::string& output = options.common.output;
  const bool to_stdout = output.empty() || output == "-";
  return {.output_folder = to_stdout ? "." : std::string(path::parent(output)),
          .current_folder = std::filesystem::current_path().generic_string()};
}

}  // namespace

int main(int argc, char** argv) {
  prepare_streams();
  Options options;
  if (const auto code = parse_command_line(make_command(options), argc, argv)) return *code;

  Conversion conversion(kTool, options.common);
  const auto model = conversion.load_model(options.model);
  if (!model) return conversion.fail();
  const ExitCode verdict = conversion.report(*model);
  if (!model->robot) return kFindings;
  if (verdict != kDone && !options.force) return conversion.refuse("has errors; see --force");

  const std::string urdf = export_urdf(*model, conversion.sources(), export_options(options));
  const Verification verification = verify(*model, urdf, verdict == kDone);
  if (options.prove) write_error(describe(verification));
  if (!verification.holds()) return conversion.refuse(verification.problem);
  return write_output(kTool, options.common.output, urdf) ? kDone : kFailed;
}
