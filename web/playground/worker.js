// SPDX-License-Identifier: BSD-3-Clause
// Runs the tools in a worker, so that the page never waits for them.
import { load, run } from "../smurf/index.mjs";

load().catch(() => {}); // the first job reports the error

addEventListener("message", async ({ data: { id, tool, args, files } }) => {
  try {
    postMessage({ id, result: await run(tool, args, Object.fromEntries(files)) });
  } catch (error) {
    postMessage({ id, error: error.message });
  }
});
