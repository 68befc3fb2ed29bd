// SPDX-License-Identifier: BSD-3-Clause
// What Material for MkDocs leaves out for keyboards and screen readers: names of its search and of the buttons beside
// code, and a focus for what can be scrolled.
function label(root) {
  root.querySelector(".md-search")?.setAttribute("aria-label", "Search");
  root
    .querySelectorAll(".md-code__nav")
    .forEach((nav, index) => nav.setAttribute("aria-label", `Code ${index + 1}`));
  for (const one of root.querySelectorAll(".highlight code, pre code, .md-typeset__scrollwrap")) {
    if (one.scrollWidth > one.clientWidth) one.tabIndex = 0;
  }
}
label(document);
// Material adds the buttons after this script has run.
new MutationObserver(() => label(document)).observe(document.body, { childList: true, subtree: true });
addEventListener("resize", () => label(document));
