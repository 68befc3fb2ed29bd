#!/usr/bin/env node
// SPDX-License-Identifier: BSD-3-Clause
import "smurf-tools/bin/smurf-lint.mjs";
