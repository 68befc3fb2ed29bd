// SPDX-License-Identifier: BSD-3-Clause
// Runs the tools beside the page, so that it never waits for them.
import { load, run } from "../smurf/index.mjs";

load().catch(() => {}); // a job reports it

addEventListener("message", async ({ data: { id, tool, args, files } }) => {
  try {
    postMessage({ id, result: await run(tool, args, Object.fromEntries(files)) });
  } catch (error) {
    postMessage({ id, error: error.message });
  }
});
