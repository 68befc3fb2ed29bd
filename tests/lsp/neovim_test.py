# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lsp in Neovim, started by the snippet of docs/editors.md: what is asserted is the state of the editor.

neovim_test.py SMURF-LSP   Ends with 77, which CTest shows as skipped, without Neovim (scripts/setup --readers).
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOOL = None

STEPS = r"""
local result = {}
local function wait(what, condition)
  if not vim.wait(20000, condition, 20) then result.failed = what end
end
local function ask(method, params)
  local answers = vim.lsp.buf_request_sync(0, method, params, 20000) or {}
  for _, answer in pairs(answers) do return answer.result end
end
local function go_to(text)
  vim.fn.cursor(1, 1)
  return vim.fn.search("\\V" .. text, "cW")
end

local ok, problem = pcall(function()
  vim.cmd("edit " .. motors)
  wait("a client", function() return #vim.tbl_values(vim.lsp.buf_get_clients(0)) > 0 end)

  -- A broken name: what the editor shows.
  wait("a finding", function() return #vim.diagnostic.get(0) > 0 end)
  local found = vim.diagnostic.get(0)[1]
  result.diagnostic = {found.lnum, found.col, found.end_col, found.code, found.severity, found.source}

  -- The fix that is offered, applied by the editor.
  go_to("joynt1_waist")
  local params = vim.lsp.util.make_range_params()
  params.context = {diagnostics = {}}
  for _, action in ipairs(ask("textDocument/codeAction", params)) do
    if action.title:match("^Replace") then
      vim.lsp.util.apply_workspace_edit(action.edit, "utf-16")
    end
  end
  result.fixed = vim.fn.search("joynt1_waist", "nw") == 0
  wait("no finding", function() return #vim.diagnostic.get(0) == 0 end)

  -- Completion of a name of the right kind.
  go_to("joint: joint2_shoulder")
  local line = vim.fn.getline(".")
  vim.cmd("normal! f:llD")
  local items = ask("textDocument/completion", vim.lsp.util.make_position_params())
  result.completed = vim.tbl_map(function(one) return one.label end, items.items or items)
  vim.fn.setline(".", line)

  -- From the motor to its joint in another file.
  go_to("joint: joint1_waist")
  vim.cmd("normal! f:ll")
  vim.lsp.buf.definition()
  wait("the jump", function() return vim.fn.expand("%:t") == "arm.urdf" end)
  result.jumped = {vim.fn.expand("%:t"), vim.fn.getline(".")}

  -- Another name, in all files.
  wait("a client there", function() return #vim.tbl_values(vim.lsp.buf_get_clients(0)) > 0 end)
  vim.lsp.buf.rename("waist")
  wait("the new name", function() return vim.fn.getline("."):match('"waist"') ~= nil end)
  vim.cmd("silent! wall")
  result.hover = ask("textDocument/hover", vim.lsp.util.make_position_params())
  vim.cmd("edit " .. motors)
  wait("no finding at the end", function() return #vim.diagnostic.get(0) == 0 end)
  result.left = #vim.diagnostic.get(0)

  -- A xacro, by the same lines.
  vim.cmd("edit " .. xacro)
  wait("a client at the xacro", function() return #vim.tbl_values(vim.lsp.buf_get_clients(0)) > 0 end)
  wait("a finding in the xacro", function() return #vim.diagnostic.get(0) > 0 end)
  result.xacro = {vim.bo.filetype, vim.diagnostic.get(0)[1].code}
end)
result.problem = not ok and problem or nil
local file = io.open(output, "w")
file:write(vim.fn.json_encode(result))
file:close()
vim.cmd("qall!")
"""


def snippet(language):
    """The code of this language in docs/editors.md."""
    text = (ROOT / "docs/editors.md").read_text()
    return re.search(rf"```{language}\n(.*?)```", text, re.DOTALL)[1]


class Neovim(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-lsp-")).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        shutil.copytree(ROOT / "fixtures/models/arm", self.folder / "arm")
        self.motors = self.folder / "arm/smurf/arm_motors.yml"
        text = self.motors.read_text()
        self.motors.write_text(text.replace("joint: joint1_waist", "joint: joynt1_waist"))
        self.xacro = self.folder / "bot.urdf.xacro"
        self.xacro.write_text('<robot name="bot" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
                              '  <xacro:property name="mass" value="1"/>\n  <link name="l${mas}"/>\n</robot>\n')

    def test_everything(self):
        output = self.folder / "result.json"
        script = self.folder / "test.lua"
        script.write_text(f"local motors, output, xacro = {json.dumps(str(self.motors))}, {json.dumps(str(output))}, "
                          f"{json.dumps(str(self.xacro))}\n"
                          + snippet("lua") + STEPS)
        environment = {**os.environ, "HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder / "config"),
                       "PATH": f"{pathlib.Path(TOOL).resolve().parent}:{os.environ['PATH']}"}
        done = subprocess.run(["nvim", "--headless", "-u", "NONE", "-n", "-c", f"luafile {script}"], cwd=self.folder,
                              env=environment, capture_output=True, text=True, timeout=300, check=False)
        self.assertTrue(output.exists(), done.stderr)
        result = json.loads(output.read_text())
        self.assertNotIn("problem", result)
        self.assertNotIn("failed", result)
        self.assertEqual(result["diagnostic"], [6, 9, 21, "SML3101", 1, "smurf-lint"])
        self.assertTrue(result["fixed"])
        self.assertIn("joint3_elbow", result["completed"])
        self.assertNotIn("turret", result["completed"])
        self.assertEqual(result["jumped"][0], "arm.urdf")
        self.assertIn('<joint name="joint1_waist"', result["jumped"][1])
        self.assertIn("joint `waist`", result["hover"]["contents"]["value"])
        self.assertEqual(result["left"], 0)
        self.assertEqual(result["xacro"], ["xml", "SML3301"])
        renamed = [path.name for path in sorted((self.folder / "arm").rglob("*.*"))
                   if path.suffix in (".yml", ".urdf") and re.search(r"\bwaist\b", path.read_text())]
        self.assertGreaterEqual(len(renamed), 3, renamed)
        for name in ("arm.urdf", "arm_motors.yml", "arm_sensors.yml"):
            self.assertIn(name, renamed)
        self.assertNotIn("joint: joint1_waist", self.motors.read_text())


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    if shutil.which("nvim") is None:
        print("skipped: nvim is not installed; scripts/setup --readers installs it")
        sys.exit(77)
    unittest.main()
