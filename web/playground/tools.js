// SPDX-License-Identifier: BSD-3-Clause
// Runs the tools in a worker that can be stopped.

export class Stopped extends Error {}

export class Tools {
  #worker;
  #jobs = new Map();
  #count = 0;

  /** Calls `onWork` with the seconds since the tools started, and with undefined when they are done. */
  constructor(onWork) {
    this.onWork = onWork;
  }

  #start() {
    const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data: { id, result, error } }) => {
      const { done, failed } = this.#jobs.get(id);
      this.#jobs.delete(id);
      if (error === undefined) done({ ...result, files: new Map(Object.entries(result.files)) });
      else failed(new Error(error));
      if (this.#jobs.size === 0) this.#rest();
    });
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.#end(new Error(event.message || "the tools could not be loaded"));
    });
    return worker;
  }

  #rest() {
    clearInterval(this.clock);
    this.clock = undefined;
    this.onWork(undefined);
  }

  #watch() {
    if (this.clock !== undefined) return;
    const began = performance.now();
    this.clock = setInterval(() => this.onWork((performance.now() - began) / 1000), 500);
  }

  #end(reason) {
    this.#worker?.terminate();
    this.#worker = undefined;
    for (const { failed } of this.#jobs.values()) failed(reason);
    this.#jobs.clear();
    this.#rest();
  }

  /** {code, stdout, stderr, files: the written files} */
  run(tool, args, files) {
    this.#worker ??= this.#start();
    this.#watch();
    const id = ++this.#count;
    return new Promise((done, failed) => {
      this.#jobs.set(id, { done, failed });
      this.#worker.postMessage({ id, tool, args, files });
    });
  }

  stop() {
    this.#end(new Stopped("stopped"));
  }
}
