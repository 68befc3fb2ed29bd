// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smurf::tools {

/// Call it at the start of main. A closed pipe and a limit on file sizes then fail a write instead
/// of killing the process; files cannot replace closed standard streams; memory comes in large
/// pages where possible; and the run ends with kFailed when memory is exhausted.
void prepare_process();

}  // namespace smurf::tools
