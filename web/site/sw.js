// SPDX-License-Identifier: BSD-3-Clause
// Keeps the files of one version of the site, which scripts/site lists. The playground has a worker of its own.
const kName = "smurf-site-@SUM@";
const kFiles = [/* @FILES@ */];

async function keepAll() {
  const cache = await caches.open(kName);
  await cache.addAll(kFiles);
  await self.skipWaiting();
}

async function dropOthers() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith("smurf-site-") && name !== kName);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

async function answer(request) {
  const cache = await caches.open(kName);
  return (await cache.match(request, { ignoreSearch: true })) ?? fetch(request);
}

self.addEventListener("install", (event) => event.waitUntil(keepAll()));
self.addEventListener("activate", (event) => event.waitUntil(dropOthers()));
self.addEventListener("fetch", (event) => {
  if (event.request.method === "GET") event.respondWith(answer(event.request));
});
