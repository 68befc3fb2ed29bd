// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smurf::tools {

/// At the start of main: a closed pipe and a limit on the size of files become a failed write
/// instead of a killed process, files cannot take the place of closed standard streams, memory
/// comes in large pages where it can, and without memory the run ends as failed.
void prepare_process();

}  // namespace smurf::tools
