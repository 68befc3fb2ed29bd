#!/usr/bin/env node
// SPDX-License-Identifier: BSD-3-Clause
import { main } from "../command.mjs";

main("smurf-lint");
