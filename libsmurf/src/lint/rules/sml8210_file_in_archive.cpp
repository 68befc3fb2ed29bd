// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8210_file_in_archive_file {

extern constinit const Rule sml8210_file_in_archive{
    .id = "SML8210",
    .name = "file-in-archive",
    .severity = Severity::warning,
    .summary = "The result names a file that lies in an archive.",
    .why =
        "Only these tools read .zsmurf and .zsmurfs archives in place; a simulator finds no file "
        "at such a path.",
    .remedy = "Copy the files with --copy-assets DIR, or unpack the archive.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8210_file_in_archive_file
