// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/conversion.hpp"
#include "syntax/tinyxml2_referee.hpp"

namespace smurf {

Referees all_referees() { return {ask_urdfdom, read_by_tinyxml2}; }

}  // namespace smurf
