// SPDX-License-Identifier: BSD-3-Clause
// After the first visit, the site works without network: sw.js beside this file keeps all pages.
if ("serviceWorker" in navigator && location.protocol !== "file:") {
  navigator.serviceWorker.register(new URL("sw.js", document.currentScript.src));
}
