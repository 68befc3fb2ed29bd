// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0002_file_too_large_file {

extern constinit const Rule sml0002_file_too_large{
    .id = "SML0002",
    .name = "file-too-large",
    .severity = Severity::error,
    .summary = "A file, or something in it, exceeds a limit.",
    .why =
        "A text file of this size is not a robot model; reading it whole could exhaust the memory.",
    .remedy = "Name another file, or raise the limit (docs/limits.md).",
    .sources = "Limit of these tools."};

}  // namespace smurf::rules::sml0002_file_too_large_file
