// SPDX-License-Identifier: BSD-3-Clause
// The steps before a conversion: load, check, report on standard error, refuse.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/cli/command.hpp"
#include "common/cli/report.hpp"
#include "common/files/input.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/check.hpp"
#include "smurf/conversion.hpp"
#include "smurf/old_scene.hpp"
#include "smurf/readers.hpp"

namespace smurf::tools {

struct ConverterOptions {
  std::string output;
  std::vector<ReportRequest> reports;
  Threshold threshold{.fail_on = std::nullopt, .max_warnings = {}, .exit_zero = false};
  ColorChoice color = ColorChoice::automatic;
  std::string stdin_filename;
  std::map<std::string, std::string> packages;
  XacroSettings xacro;
  bool allow_outside = false;  ///< read files that models name, wherever they are
  Limits limits;
  std::uint64_t max_seconds = kMaxSeconds;
  bool has_loss_report = false;  ///< the tool has --loss-report
  bool quiet = false;
  bool force = false;                  ///< convert although findings make the result wrong
  std::vector<const Reader*> targets;  ///< targets of the result; empty: all
};

/// The number of losses in each section of the annotations: "3 entries in poses".
std::string count_by_section(std::span<const Diagnostic> losses);

/// Rows of the option table that all converters have.
std::vector<Option> converter_options(ConverterOptions& options, std::string_view output_help);

/// A setter for exactly one operand.
Setter take_one_operand(std::string& operand);
/// The same, and for the arguments of a xacro file, `name:=value`.
Setter take_one_operand(std::string& operand, XacroSettings& xacro);

/// One run of a converter. Findings go to standard error, or to the file given by --report.
class Conversion {
 public:
  /// `kinds` are the kinds of inputs, in the order in which a folder is searched for its only
  /// model. `tool` and `options` must outlive this object.
  Conversion(std::string_view tool, const ConverterOptions& options, std::vector<InputKind> kinds);

  /// Reports an error and returns none if the file cannot be read.
  std::optional<LoadedModel> load_model(const std::string& path);
  /// Expands a xacro file.
  std::optional<LoadedExpansion> load_xacro(const std::string& path);
  /// Also reads archives (.zsmurf, .zsmurfs, .zsmurfa), in memory.
  std::optional<LoadedScene> load_scene(const std::string& path);
  /// Lets a file that the user named be read, wherever it is. If it cannot be read, reports this
  /// and returns false.
  bool allow(const std::string& path);
  /// An SRDF that the user named, wherever it is. If it cannot be read, or is none, reports this.
  std::optional<xml::Document> load_srdf(const std::string& path, Loaded& beside);

  /// Reports the findings of a conversion. kFindings if one of them makes the result wrong, or
  /// reaches the threshold; why() returns the reason. `refusal` is that of the conversion, if it
  /// has one despite --force.
  ExitCode report(Report report, const LossOf& loss_of, const Refusal& refusal = {});
  /// The same for an expansion that is the result: only its failure is a reason to refuse it.
  ExitCode report(const LoadedExpansion& loaded, std::vector<Diagnostic> found);
  const std::string& why() const { return why_; }

  /// Call it after reading all inputs and before writing. If an output, or a file of --report, is
  /// an input, reports this and returns false.
  bool keeps_inputs(std::vector<std::string> outputs) const;

  /// Writes the losses to `file` unless it is "", and returns false if that fails.
  bool write_losses(std::span<const Diagnostic> losses, const std::string& file) const;

  /// "smurf2urdf: PATH reason"; kFindings.
  ExitCode refuse(std::string_view reason) const;
  ExitCode refuse(const Refusal& refusal) const;
  /// Lists the losses first.
  ExitCode refuse_losses(std::span<const Diagnostic> losses) const;
  /// Prints "smurf2urdf: wrote arm.urdf: 7 joints" on standard error, unless the user asked for
  /// silence or for a report there.
  void tell_written(const std::string& what, std::span<const std::string> remarks = {}) const;
  ExitCode fail() const { return kFailed; }

  /// Where a finding of loading belongs: one in an expanded robot to its xacro.
  Diagnostic placed(const LoadedScene& loaded, const Diagnostic& found) const;

  Session& session() { return session_; }
  const FileReader& files() const { return session_.files(); }
  const InputFiles& inputs() const { return inputs_; }

 private:
  CheckSettings settings() const;
  std::optional<std::string> open(const std::string& path);
  bool is_accepted(const std::string& path) const;
  std::string render_for_people(const Report& report, const LossOf& loss_of, bool is_converted);

  std::string_view tool_;
  const ConverterOptions& options_;
  const std::vector<InputKind> kinds_;
  ConfinedFiles disk_;
  InputFiles inputs_{disk_};
  ArchiveFiles archives_{inputs_, options_.limits};
  MemoryFiles files_{&archives_};
  Session session_{files_, options_.limits};
  std::string path_;
  std::string why_;
};

}  // namespace smurf::tools
