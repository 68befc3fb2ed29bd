# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lsp in Emacs with eglot, started by the snippet of docs/editors.md: what is asserted is the state of the editor.
The snippets for editors that are not here are read for their syntax.

emacs_test.py SMURF-LSP   Ends with 77, which CTest shows as skipped, without Emacs and eglot (scripts/setup --readers).
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from neovim_test import ROOT, snippet  # noqa: E402

TOOL = None

STEPS = r"""
(require 'json)
(setq eglot-confirm-server-initiated-edits nil create-lockfiles nil make-backup-files nil result nil)
(remove-hook 'yaml-mode-hook 'eglot-ensure)
(remove-hook 'nxml-mode-hook 'eglot-ensure)
(fset 'y-or-n-p (lambda (&rest _) t))  ; whether files that are not open may be changed
(defun note (name value) (push (cons name value) result))
(defun wait (name condition)
  (let ((left 400))
    (while (and (> left 0) (not (funcall condition)))
      (accept-process-output nil 0.05)
      (setq left (1- left)))
    (when (= left 0) (note 'failed name))))
(condition-case problem
    (progn
      (find-file motors)
      (apply #'eglot (eglot--guess-contact))
      (wait "a server" (lambda () (eglot-managed-p)))
      (flymake-mode 1)
      (flymake-start)
      (wait "a finding" (lambda () (flymake-diagnostics)))
      (let ((one (car (flymake-diagnostics))))
        (note 'diagnostic (buffer-substring (flymake-diagnostic-beg one) (flymake-diagnostic-end one)))
        (note 'message (flymake-diagnostic-text one)))
      (goto-char (point-min))
      (search-forward "joynt1")
      (let ((inhibit-message t)) (replace-match "joint1"))
      (eglot--signal-textDocument/didChange)
      (wait "no finding" (lambda () (not (flymake-diagnostics))))
      (goto-char (point-min))
      (search-forward "joint: joint1_")
      (let ((table (nth 2 (run-hook-with-args-until-success 'completion-at-point-functions))))
        (note 'completed (vconcat (mapcar #'substring-no-properties (all-completions "" table)))))
      (xref-find-definitions (thing-at-point 'symbol))
      (note 'jumped (buffer-name))
      (note 'line (string-trim (thing-at-point 'line t)))
      (switch-to-buffer "arm_motors.yml")
      (eglot-rename "waist")
      (save-some-buffers t)
      (note 'renamed (buffer-string)))
  (error (note 'problem (format "%S" problem))))
(with-temp-file output (insert (json-encode result)))
"""


class Emacs(unittest.TestCase):
    maxDiff = None

    @unittest.skipUnless(shutil.which("emacs"), "emacs is not installed")
    def test_everything(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-lsp-")).resolve()
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        shutil.copytree(ROOT / "fixtures/models/arm", folder / "arm")
        motors = folder / "arm/smurf/arm_motors.yml"
        motors.write_text(motors.read_text().replace("joint: joint1_waist", "joint: joynt1_waist"))
        output = folder / "result.json"
        script = folder / "test.el"
        script.write_text(f"(setq motors {json.dumps(str(motors))} output {json.dumps(str(output))})\n"
                          + "(package-initialize)\n" + snippet("elisp") + STEPS)
        environment = {**os.environ, "HOME": str(folder),
                       "PATH": f"{pathlib.Path(TOOL).resolve().parent}:{os.environ['PATH']}"}
        done = subprocess.run(["emacs", "--batch", "-l", script], cwd=folder, env=environment, capture_output=True,
                              text=True, timeout=300, check=False)
        self.assertTrue(output.exists(), done.stdout + done.stderr)
        result = json.loads(output.read_text())
        self.assertNotIn("problem", result)
        self.assertNotIn("failed", result)
        self.assertEqual(result["diagnostic"], "joynt1_waist")
        self.assertIn("which the model does not have", result["message"])
        self.assertIn("joint3_elbow", result["completed"])
        self.assertEqual(result["jumped"], "arm.urdf")
        self.assertIn('<joint name="joint1_waist"', result["line"])
        self.assertIn("joint: waist", result["renamed"])
        for name in ("urdf/arm.urdf", "smurf/arm_motors.yml", "smurf/arm_sensors.yml"):
            self.assertIn("waist", (folder / "arm" / name).read_text().replace("joint1_waist", ""), name)

    def test_others_can_be_read(self):
        helix = tomllib.loads(snippet("toml"))
        self.assertEqual(helix["language-server"]["smurf-lsp"]["command"], "smurf-lsp")
        self.assertEqual({one["name"] for one in helix["language"]}, {"yaml", "xml"})
        kate = json.loads(snippet("json"))
        self.assertEqual({one["command"][0] for one in kate["servers"].values()}, {"smurf-lsp"})


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    has_eglot = shutil.which("emacs") and subprocess.run(
        ["emacs", "--batch", "--eval", "(progn (package-initialize) (require 'eglot) (require 'yaml-mode))"],
        capture_output=True, check=False).returncode == 0
    if not has_eglot:
        print("skipped: emacs with eglot and yaml-mode is not installed; scripts/setup --readers installs them")
        sys.exit(77)
    unittest.main()
