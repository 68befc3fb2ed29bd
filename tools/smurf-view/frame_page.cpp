// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-view/frame_page.hpp"

#include <cstddef>
#include <string_view>

namespace smurf::tools {
namespace {

constexpr std::string_view kNonce = "@NONCE@";

/// web/viewer/host.js describes the messages to the frame.
constexpr std::string_view kPage = R"page(<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta
      http-equiv="Content-Security-Policy"
      content="default-src 'none'; script-src 'nonce-@NONCE@'; style-src 'nonce-@NONCE@'; connect-src 'self'; frame-src 'self'; base-uri 'none'; form-action 'none'"
    />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>smurf-view</title>
    <style nonce="@NONCE@">
      :root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
      html, body { margin: 0; height: 100%; }
      iframe { display: block; width: 100%; height: 100%; border: 0; }
      p { margin: 0; padding: 24px; max-width: 70ch; overflow-wrap: anywhere; }
      [hidden] { display: none !important; }
    </style>
  </head>
  <body>
    <main>
      <p id="message" role="status">The page is being made ...</p>
      <iframe id="viewer" name="smurf-view" title="The robot in three dimensions" hidden></iframe>
    </main>
    <script type="module" nonce="@NONCE@">
      const kPause = 500; // ms between attempts to reach the server
      const frame = document.getElementById("viewer");
      const message = document.getElementById("message");
      let state = { version: 0, scene: "", problem: "" };
      let shown = ""; // the scene in the frame
      let isReady = false; // it can receive messages

      const send = (data) => frame.contentWindow.postMessage(data, location.origin);

      function show() {
        const { scene, problem } = state;
        document.documentElement.dataset.version = state.version;
        if (scene && frame.hidden) {
          shown = scene;
          frame.src = "page";
          frame.hidden = false;
          message.hidden = true;
        } else if (!scene) {
          message.textContent = `There is no picture yet. ${problem}`;
        }
        if (!isReady) return;
        if (scene !== shown) send({ scene });
        shown = scene;
        send({ problem });
      }

      addEventListener("message", ({ data, source }) => {
        if (source !== frame.contentWindow || !data?.isReady) return;
        isReady = true;
        document.title = frame.contentDocument.title;
        show();
      });

      document.documentElement.dataset.ready = "true";
      for (;;) {
        try {
          const answer = await fetch(`changes?after=${state.version}`);
          if (!answer.ok) throw new Error(answer.statusText);
          const next = await answer.json();
          if (next.version !== state.version || state.isAlone) {
            state = next;
            show();
          }
        } catch {
          if (!state.isAlone) {
            state = { ...state, isAlone: true, problem: "smurf-view has ended, so this page does not follow the file." };
            show();
          }
          await new Promise((done) => setTimeout(done, kPause));
        }
      }
    </script>
  </body>
</html>
)page";

}  // namespace

std::string frame_page(const std::string& nonce) {
  std::string page(kPage);
  for (std::size_t at = page.find(kNonce); at != std::string::npos; at = page.find(kNonce, at)) {
    page.replace(at, kNonce.size(), nonce);
  }
  return page;
}

}  // namespace smurf::tools
