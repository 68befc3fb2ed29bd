// SPDX-License-Identifier: BSD-3-Clause
// Caches the files of the playground, so that it works without a network. assemble.mjs replaces the words between "@".
const kVersion = "@VERSION@";
const kFiles = ["@FILES@"];
const kPrefix = `smurf playground ${self.registration.scope} `;
const kCache = kPrefix + kVersion;

async function keep() {
  const cache = await caches.open(kCache);
  await cache.addAll(kFiles.map((file) => new Request(file, { cache: "no-cache" })));
}

async function begin() {
  const names = await caches.keys();
  await Promise.all(
    names.filter((name) => name.startsWith(kPrefix) && name !== kCache).map((name) => caches.delete(name)),
  );
  await self.clients.claim();
}

async function answer(request) {
  const cache = await caches.open(kCache);
  return (await cache.match(request, { ignoreSearch: true })) ?? fetch(request);
}

// A new version waits until all pages of the old one are closed, so no page mixes files of both.
self.addEventListener("install", (event) => event.waitUntil(keep()));
self.addEventListener("activate", (event) => event.waitUntil(begin()));
self.addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  if (method === "GET" && new URL(url).origin === self.location.origin)
    event.respondWith(answer(event.request));
});
