# SPDX-License-Identifier: BSD-3-Clause
"""Tests the page of a scene: poses equal the flat JSON, only the viewer's script runs, and the page is accessible.

Usage: viewer_test.py TOOL BUILD
"""
import viewer
from viewer import READ, cli, reader, set_positions

ARM = cli.FIXTURES / "models/arm/urdf/arm.urdf"
CHAIN = """<robot name="chain"><link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="apart"/>
<joint name="first" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 1"/>
  <axis xyz="1 2 -1"/><limit lower="-1" upper="2" effort="1" velocity="1"/></joint>
<joint name="second" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="0 2 0"/>
  <mimic joint="first" multiplier="-0.5" offset="0.25"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
<joint name="third" type="continuous"><parent link="c"/><child link="d"/><axis xyz="0 0 1"/>
  <mimic joint="second" multiplier="3" offset="-1"/></joint></robot>"""
HOSTILE = """<img src=x onerror="window.hacked=1"> </script><script>window.hacked=2</script> <!-- <script> javascript:alert(1)"""
SOLIDS = """<robot name="solids"><link name="root">
<visual><geometry><box size="0.1 0.2 0.3"/></geometry><material name="m"><color rgba="1 0.5 0 0.5"/></material></visual>
<visual><origin xyz="1 0 0"/><geometry><sphere radius="0.2"/></geometry></visual>
<visual><origin xyz="2 0 0" rpy="1 0 0"/><geometry><cylinder radius="0.1" length="0.5"/></geometry></visual>
<visual><origin xyz="3 0 0"/><geometry><capsule radius="0.1" length="0.5"/></geometry></visual>
<visual><origin xyz="4 0 0"/><geometry><mesh filename="good.stl" scale="2 -1 1"/></geometry></visual>
<visual><origin xyz="5 0 0"/><geometry><mesh filename="broken.stl"/></geometry></visual>
<visual><origin xyz="6 0 0"/><geometry><mesh filename="hull.dae"/></geometry></visual>
<visual><origin xyz="7 0 0"/><geometry><mesh filename="parts.dae" scale="1 2 1"/></geometry></visual>
<visual><origin xyz="8 0 0"/><geometry><mesh filename="parts.dae"/></geometry><material name="n"><color rgba="1 0.5 0 1"/></material></visual>
<collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link></robot>"""
STL = """solid s
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet
facet normal 0 0 1 outer loop vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 endloop endfacet
endsolid s
"""
DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>
<unit meter="0.5"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="pa" count="9">0 0 0 1 0 0 0 1 1</float_array><technique_common><accessor source="#pa" count="3" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
LOOKAT = DAE.replace("<node>", "<node><lookat>0 0 0 1 0 0 0 0 1</lookat>")
# Two triangles, one of them red.
PARTS = DAE.replace("</triangles>", """</triangles><triangles count="1" material="red">
<input semantic="VERTEX" source="#v" offset="0"/><p>2 1 0</p></triangles>""").replace("<library_geometries>", """<library_effects>
<effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>1 0 0.25 1</color></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects><library_materials><material id="red"><instance_effect url="#e"/></material>
</library_materials><library_geometries>""")


class PosesTest(viewer.ViewerTest):
    def test_scenes_stand_where_the_flat_json_says(self):
        scenes = {**reader.SCENES, "terrain": cli.FIXTURES / "scenes/terrain/terrain.smurfs",
                  "arm": cli.FIXTURES / "models/arm/smurf/arm.smurf",
                  "phobos": next((cli.FIXTURES / "models/arm_phobos2").rglob("*.smurf"))}
        pages = {name: self.page(scene, f"{name}.html") for name, scene in scenes.items()}
        answers = self.browse(*({"page": page, "steps": [READ]} for page in pages.values()))
        for (name, scene), page, answer in zip(scenes.items(), pages.values(), answers):
            with self.subTest(name):
                number = self.assert_poses(answer["results"][0], self.data(page)[0], self.flat(scene)["instances"], name)
                self.assertGreater(number, 1)

    def test_joints_move_as_in_the_library(self):
        for name, urdf in (("arm", ARM.read_text()), ("chain", CHAIN)):
            with self.subTest(name):
                self.write("robot.urdf", urdf)
                page = self.page("robot.urdf")
                data, _ = self.data(page)
                configurations = viewer.joint_configurations(data["models"][0], 5, name)
                if name == "chain":  # the position of a mimicking joint can be set, and its own followers follow
                    configurations += [{"second": 0.5}, {"first": 0.5, "third": 2}, {}]
                instances = self.posed(urdf, configurations)
                steps = [step for one in configurations for step in (set_positions(0, one), READ)]
                results = self.browse({"page": page, "steps": steps})[0]["results"][1::2]
                for read, instance in zip(results, instances):
                    self.assert_poses(read, data, [instance], f"{name} {instance['path']}")
                moved = [read["links"][0][3] for read in results]
                self.assertEqual(len({str(matrix) for matrix in moved}), len(moved))

    def test_what_is_anchored_to_a_link_moves_with_it(self):
        self.write("robot.urdf", CHAIN)
        self.write("s.smurfs", """entities:
- {name: A, file: robot.urdf, position: [1, 2, 3], rotation: [0, 0, 90]}
- {name: B, file: robot.urdf, parent: "A::d", anchor: parent, position: [0, 0, 1]}
- {name: C, file: robot.urdf, anchor: "B::c"}
- {name: D, file: robot.urdf, anchor: "E::c"}
- {name: E, file: robot.urdf, anchor: "D::c"}
""")
        page = self.page("s.smurfs")
        results = self.browse({"page": page, "steps": [READ, set_positions(0, {"first": 1}), READ]})[0]["results"]
        before, after = results[0], results[2]
        self.assert_poses(before, self.data(page)[0], self.flat("s.smurfs")["instances"], "start")
        moves = [viewer.distance(a, b) > 0.1 for a, b in zip(before["entities"], after["entities"])]
        self.assertEqual(moves, [False, True, True, False, False])
        for one in (before, after):  # B keeps its place on the link
            self.assertAlmostEqual(viewer.distance(one["links"][0][3], one["entities"][1]), 1)


class SafetyTest(viewer.ViewerTest):
    def test_names_are_text(self):
        escaped = HOSTILE.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
        urdf = CHAIN.replace('"a"', f'"{escaped}"').replace('"first"', '"constructor"').replace('"third"', '"__proto__"')
        self.write("robot.urdf", urdf)
        self.write("robot.smurf", "modelname: robot\nfiles: [robot.urdf, poses.yml]\n")
        self.write("poses.yml", "poses:\n- {name: toString, joints: {constructor: 1, __proto__: 2}}\n")
        self.write("s.smurfs", viewer.json.dumps({"entities": [
            {"name": HOSTILE, "file": "robot.smurf"}, {"name": "__proto__", "type": HOSTILE, HOSTILE: HOSTILE}]}))
        page = self.page("s.smurfs")
        text = page.read_text()
        self.assertEqual((text.count("<script"), text.count("</script"), text.count("onerror=\"")), (2, 2, 0))
        steps = ["smurfViewer.select(0, 0)", "document.querySelector('#facts h3').textContent",
                 "document.getElementById('poses').value = '0'", "document.getElementById('poses').dispatchEvent(new Event('change'))",
                 "smurfViewer.motion.position(0, 2)", "document.getElementById('names').click()",
                 "[window.hacked, document.images.length, document.scripts.length, document.links.length]",
                 "smurfViewer.select(1)", "document.querySelector('#facts h3').textContent"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[1], HOSTILE)
        self.assertEqual(results[4], 2)
        self.assertEqual(results[6], [None, 0, 2, 0])
        self.assertEqual(results[8], "__proto__")

    def test_marks_that_reorder_text_are_visible(self):
        self.write("robot.urdf", CHAIN.replace('"a"', '"ab\u202ecd"'))
        results = self.browse({"page": self.page("robot.urdf"), "steps": [
            "smurfViewer.select(0, 0)", "document.body.innerText"]})[0]["results"]
        self.assertIn("ab\\u202ecd", results[1])
        self.assertNotIn("\u202e", results[1])

    def test_nothing_else_runs_and_nothing_is_fetched(self):
        self.check_nothing_else_runs(self.page(ARM))

    def test_pages_are_small_and_always_the_same(self):
        links = "".join(f'<link name="l{i}"><visual><geometry><box size="1 1 1"/></geometry></visual></link>' for i in range(40))
        joints = "".join(f'<joint name="j{i}" type="continuous"><parent link="l{i}"/><child link="l{i + 1}"/></joint>'
                         for i in range(39))
        self.write("robot.urdf", f'<robot name="r">{links}{joints}</robot>')
        page = self.page("robot.urdf")
        self.assertLess(page.stat().st_size, 1_000_000)
        self.assertEqual(page.read_bytes(), self.page("robot.urdf", "again.html").read_bytes())


class PageTest(viewer.ViewerTest):
    def test_a_robot_without_its_meshes_says_why_and_is_a_skeleton(self):
        mesh = '<visual><geometry><mesh filename="package://parts_of_r/{}.stl"/></geometry></visual>'
        robot = '<robot name="w"><link name="l"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>'
        links = "".join(f'<link name="l{i}">{mesh.format(i)}</link>' for i in range(4))
        joints = "".join(f'<joint name="j{i}" type="continuous"><origin xyz="0 0 0.5"/><parent link="l{i}"/><child link="l{i + 1}"/>'
                         '<axis xyz="1 0 0"/></joint>' for i in range(3))
        self.write("robot.urdf", f'<robot name="r">{links}{joints}</robot>')
        self.write("whole.urdf", robot)
        message = "document.getElementById('message').hidden ? '' : document.getElementById('message').textContent"
        bones = "[...(smurfViewer.overlays.parts.skeleton.drawn?.geometry.getAttribute('position').array ?? [])].filter((_, i) => i % 3 === 2)"
        move = "smurfViewer.joints.set(0, new Map([['j0', Math.PI / 2]]))"
        pressed = "document.getElementById('skeleton')?.getAttribute('aria-pressed')"
        box = "smurfViewer.stage.fitted.max.z"
        first, second = self.browse(
            {"page": self.page("robot.urdf"), "steps": [message, bones, pressed, box, move, bones]},
            {"page": self.page("whole.urdf", "whole.html"), "steps": [message, pressed, bones]})
        self.assertEqual(first["results"][0],
                         "4 files of the package parts_of_r were not found. Name its folder: --package parts_of_r=DIR")
        close = [round(z, 3) for z in first["results"][1]]
        self.assertEqual(close, [0, 0, 0.5, 0, 1, 0.5, 1.5, 1])
        self.assertEqual(first["results"][2], "true")
        self.assertAlmostEqual(first["results"][3], 1.5, 3)
        self.assertEqual([round(z, 3) for z in first["results"][5]], [0, 0, 0.5, 0, 0.5, 0.5, 0.5, 0.5])
        self.assertEqual(second["results"][0], "")
        self.assertEqual(second["results"][1], "false")

    def test_what_cannot_be_shown_is_told(self):
        self.write("solids.urdf", SOLIDS)
        self.write("good.stl", STL)
        self.write("broken.stl", STL[:100])
        self.write("hull.dae", LOOKAT)
        self.write("parts.dae", PARTS)
        done = self.run_tool("solids.urdf", "--format", "html", "-o", "page.html", "--force", "--report", "json=r.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        losses = [d["message"] for d in viewer.json.loads(self.read("r.json"))["diagnostics"] if d["id"] == "SML8205"]
        self.assertEqual(len(losses), 2, losses)
        self.assertEqual(self.run_tool("solids.urdf", "--format", "html", "--fail-on-loss", "--force").returncode, 1)
        drawn = "smurfViewer.shapes.solids.map(({ layer, batch }) => [layer, batch.solid.key.split(' ')[0]])"
        colour = "smurfViewer.shapes.solids[0].color.toArray().concat(smurfViewer.shapes.solids[0].batch.alpha)"
        triangles = "smurfViewer.shapes.geometries.get('mesh 0').index.count"
        steps = [drawn, colour, triangles, "[...document.querySelectorAll('#unseen-list li')].map((row) => row.textContent)",
                 "smurfViewer.shapes.solids.findLast(({ layer }) => layer === 'unseen').local.elements.slice(12, 15)"]
        parts = "smurfViewer.shapes.solids.filter(({ shape }) => shape.mesh === 1)"
        steps.append(f"{parts}.map(({{ batch, local, color }}) => [smurfViewer.shapes.geometries.get(batch.solid.key).index.count,"
                     " local.elements[12], color.toArray()])")
        steps.append(f"(({{ min, max }}) => [min.toArray(), max.toArray()])(smurfViewer.shapes.boxAround({parts}.slice(0, 2)))")
        results = self.browse({"page": self.folder / "page.html", "steps": steps})[0]["results"]
        self.assertEqual(results[0], [["visuals", "box"], ["visuals", "sphere"], ["visuals", "cylinder"], ["visuals", "capsule"],
                                      ["visuals", "mesh"], ["unseen", "box"], ["unseen", "box"], ["visuals", "mesh"], ["visuals", "mesh"],
                                      ["visuals", "mesh"], ["collisions", "box"]])
        self.assertEqual(results[1], [1, 0.5, 0, 0.5])
        self.assertEqual(results[2], 6)
        self.assertEqual([row.split(" ")[0] for row in results[3]], ["broken.stl", "hull.dae"])
        self.assertIn("is placed by <lookat>, which is not read (1 shape)", results[3][1])
        self.assertEqual(results[4], [6.25, 0.25, 0.25])
        # The file's colours, unless the visual has one; metres, as the unit says; <up_axis> is ignored, in boxes too.
        self.assertEqual(results[5], [[3, 7, [0.78, 0.79, 0.81]], [3, 7, [1, 0, 0.25]], [6, 8, [1, 0.5, 0]]])
        self.assertEqual(results[6], [[7, 0, 0], [7.5, 1, 0.5]])

    def test_a_chain_of_thousands_of_links_opens(self):
        number = 4200
        self.write("chain.urdf", '<robot name="chain">' + "".join(
            f'<link name="l{i}"><visual><geometry><box size="0.1 0.1 0.2"/></geometry></visual></link>' for i in range(number)) + "".join(
                f'<joint name="j{i}" type="continuous"><origin xyz="0.01 0 0.2" rpy="0.01 0 0"/><parent link="l{i}"/>'
                f'<child link="l{i + 1}"/></joint>' for i in range(number - 1)) + "</robot>")
        page = self.page("chain.urdf")
        selected = "[smurfViewer.tree.selected.textContent, smurfViewer.tree.selected.getAttribute('aria-level')]"
        rows = "[...document.querySelectorAll('[role=treeitem]')].filter((row) => row.offsetParent).length"
        close = "smurfViewer.tree.open(smurfViewer.tree.rows.get('0 %d'), false)"
        steps = [READ, f"smurfViewer.select(0, {number - 1})", selected, rows, close % 3000, rows, close % 20, rows,
                 "[document.querySelectorAll('#sliders .joint').length, document.querySelector('#sliders button').click(),"
                 " document.querySelectorAll('#sliders .joint').length]"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assert_poses(results[0], self.data(page)[0], self.flat("chain.urdf")["instances"], "chain")
        self.assertEqual(results[2], [f"l{number - 1}", f"{number + 1}"])
        self.assertEqual([results[3], results[5], results[7]], [number + 1, 3002, 22])
        self.assertEqual(results[8], [100, None, number - 1])

    def test_a_ring_of_links_can_be_selected(self):
        page = self.page(cli.FIXTURES / "rules/SML1205-no-root/bad/robot.urdf")
        steps = ["smurfViewer.select(0, 0)", "document.querySelector('#facts h3').textContent",
                 "document.querySelectorAll('#tree [tabindex=\"0\"]').length"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[1:], [self.data(page)[0]["models"][0]["links"][0]["name"], 1])

    def test_empty_scenes_say_so(self):
        self.write("empty.smurfs", "entities: []\n")
        self.write("bare.urdf", '<robot name="r"><link name="l"/></robot>')
        message = "document.getElementById('message').textContent"
        pages = [self.page("empty.smurfs", "e.html"), self.page("bare.urdf", "b.html")]
        empty, bare = self.browse(*({"page": page, "steps": [message]} for page in pages))
        self.assertIn("no entities", empty["results"][0])
        self.assertIn("has a shape", bare["results"][0])

    def test_picture_tree_sliders_and_keys_work_together(self):
        selected = "JSON.stringify(smurfViewer.selected ?? null) + ' ' + decodeURIComponent(location.hash)"
        pressed = "document.getElementById('collisions').getAttribute('aria-pressed')"
        slide = """(() => { const slider = document.querySelector("#sliders input[type=range]"); slider.value = 0.5;
          slider.dispatchEvent(new Event("input")); return smurfViewer.motion.position(0, 1); })()"""
        steps = [{"click": [640, 250]}, selected, {"key": "Escape"}, selected, {"key": "c"}, pressed,
                 "document.querySelector('[role=treeitem]').focus()", {"key": "ArrowDown"}, {"key": "ArrowDown"}, {"key": "Enter"},
                 selected, {"key": "ArrowLeft"}, "document.activeElement.getAttribute('aria-expanded')",
                 "[...document.querySelectorAll('#sliders [type=range]')].map((slider) => slider.disabled)", slide,
                 "document.getElementById('poses').value", "document.getElementById('reset').click()",
                 "smurfViewer.motion.positions[0].size", "document.title"]
        results = self.browse({"page": self.page(ARM), "steps": steps})[0]["results"]
        self.assertRegex(results[1], r'"link":\d.*entity=arm&link=')
        self.assertEqual(results[3], "null ")
        self.assertEqual(results[5], "true")
        self.assertRegex(results[10], r'"link":1.*link=pedestal')
        self.assertEqual(results[12], "false")
        self.assertEqual(results[13], [False] * 5 + [True])
        self.assertEqual(results[14:16], [0.5, ""])
        self.assertEqual(results[17:], [0, "arm.urdf"])

    def test_ellipsoids_have_the_inertia_of_their_links(self):
        inertias = {"plain": (2, (0.3, 0, 0, 0.4, 0, 0.5)), "turned": (0.5, (0.03, 0.004, -0.006, 0.05, 0.002, 0.04)),
                    "plate": (1, (1, 0, 0, 1, 0, 2)), "impossible": (1, (1, 0, 0, 1, 0, 3))}
        names = list(inertias)
        links = "".join(
            f'<link name="{name}"><inertial><origin xyz="0.1 0 0" rpy="0.3 0.2 0.1"/><mass value="{mass}"/><inertia '
            + " ".join(f'{key}="{value}"' for key, value in zip(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), inertia))
            + "/></inertial></link>" for name, (mass, inertia) in inertias.items())
        joints = "".join(f'<joint name="{name}" type="fixed"><parent link="plain"/><child link="{name}"/></joint>'
                         for name in names[1:])
        self.write("robot.urdf", f'<robot name="r">{links}{joints}</robot>')
        steps = ["""smurfViewer.overlays.inertias.map(({ link, local }) => [link, [...local.elements]])""",
                 "smurfViewer.select(0, 3); document.getElementById('facts').textContent", {"key": "i"},
                 "smurfViewer.overlays.parts.inertias.drawn.visible"]
        page = self.page("robot.urdf")
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual([names[link] for link, _ in results[0]], ["plain", "turned", "plate"])
        self.assertIn("no body has such moments", results[1])
        self.assertTrue(results[3])
        com = self.data(page)[0]["models"][0]["links"][0]["com"]
        turn = viewer.matrix_of({"position": com[:3], "orientation": dict(zip("wxyz", com[3:]))})
        R_LC = [[turn[4 * column + row] for column in range(3)] for row in range(3)]
        for link, columns in results[0]:
            mass, (xx, xy, xz, yy, yz, zz) = inertias[names[link]]
            inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
            wanted = [[sum(R_LC[i][k] * inertia[k][m] * R_LC[j][m] for k in range(3) for m in range(3)) for j in range(3)]
                      for i in range(3)]
            spread = [[sum(columns[4 * k + i] * columns[4 * k + j] for k in range(3)) for j in range(3)] for i in range(3)]
            trace = sum(spread[i][i] for i in range(3))
            for i in range(3):
                for j in range(3):  # a body of uniform density: I = m / 5 (trace(S) 1 - S)
                    self.assertAlmostEqual(mass / 5 * (trace * (i == j) - spread[i][j]), wanted[i][j], delta=1e-6)

    def test_copies_are_drawn_and_clicked_where_their_links_are(self):
        """Boxes are merged into one geometry. Spheres with many sides are instances."""
        colors = ("1 0 0", "0 1 0", "0 0 1")
        shapes = ['<box size="1 1 1"/>'] * 3 + ['<sphere radius="0.5"/>'] * 3
        links = "".join(f'<link name="l{i}"><visual><geometry>{shape}</geometry><material name="m{i}"><color rgba="{colors[i % 3]} 1"/>'
                        "</material></visual></link>" for i, shape in enumerate(shapes))
        joints = "".join(f'<joint name="j{i}" type="prismatic"><parent link="base"/><child link="l{i}"/><origin xyz="0 {2 * i} 0"/>'
                         '<axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>' for i in range(len(shapes)))
        self.write("robot.urdf", f'<robot name="r"><link name="base"/>{links}{joints}</robot>')
        self.write("two.smurfs", "entities:\n- {name: A, type: urdf, file: robot.urdf}\n"
                                 "- {name: B, type: urdf, file: robot.urdf, position: [0, 0, 6]}\n")
        page = self.page("two.smurfs")
        moved = {f"j{i}": 2 - i % 3 for i in range(len(shapes))}
        seen = """(({ stage, shapes }) => {
          stage.look([-60, 5, 3, 0, 5, 3]);
          stage.grid.visible = false;
          stage.renderer.render(stage.scene, stage.camera);
          const gl = stage.renderer.getContext();
          const { left, top, height } = stage.canvas.getBoundingClientRect();
          return shapes.solids.map((solid) => {
            const [x, y] = stage.toPage(shapes.boxAround([solid]).getCenter(stage.camera.position.clone()));
            const pixel = new Uint8Array(4);
            gl.readPixels(x, height - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            const [hit] = stage.hitAt({ clientX: left + x, clientY: top + y });
            return [solid.batch.mesh.isInstancedMesh === true, hit === solid, pixel.indexOf(Math.max(...pixel.slice(0, 3)))];
          });
        })(smurfViewer)"""
        count = "(smurfViewer.motion.takeMoved(), smurfViewer.motion.set(1, new Map()), [...smurfViewer.motion.moved])"
        results = self.browse({"page": page, "steps": [seen, viewer.set_positions(1, moved), seen, count]})[0]["results"]
        expected = [[i % 6 > 2, True, i % 3] for i in range(12)]
        self.assertEqual(results[0], expected)
        self.assertEqual(results[2], expected)
        self.assertEqual(results[3], [1], "only what has moved is put into the picture again")

    def test_a_selected_link_is_dragged_by_its_joint(self):
        forearm = "smurfViewer.scene.entities[0].model.links.findIndex(({ name }) => name === 'forearm')"
        center = f"""(() => {{
          const solids = smurfViewer.shapes.solids.filter(({{ link, layer }}) => link === {forearm} && layer === "visuals");
          const {{ left, top }} = smurfViewer.stage.canvas.getBoundingClientRect();
          const [x, y] = smurfViewer.stage.toPage(smurfViewer.shapes.boxAround(solids).getCenter(smurfViewer.stage.camera.position.clone()));
          return [Math.round(left + x), Math.round(top + y)]; }})()"""
        elbow = "smurfViewer.motion.positions[0].get('joint3_elbow') ?? 0"
        state = f"[{elbow}, smurfViewer.stage.view() ?? null, document.querySelector('#selected-joint .name')?.textContent ?? null]"
        page = self.page(ARM)
        [(x, y)] = self.browse({"page": page, "steps": [center]})[0]["results"]
        drag = {"drag": [x, y, x + 60, y + 5]}
        results = self.browse({"page": page, "steps": [
            state, f"smurfViewer.select(0, {forearm})", state, drag, state, center, {"key": "Escape"}, state, drag, state]})[0]["results"]
        self.assertEqual(results[0], [0, None, None])
        self.assertEqual(results[2], [0, None, "joint3_elbow"])
        self.assertGreater(abs(results[4][0]), 0.1)
        self.assertEqual(results[4][1:], [None, "joint3_elbow"], "the view has not turned")
        self.assertAlmostEqual(results[5][0], x + 60, delta=25)
        self.assertEqual(results[7][2], None)
        self.assertEqual(results[9][0], results[4][0])
        self.assertIsNotNone(results[9][1], "what is not selected turns the view")

    def test_joints_have_units_limits_and_a_search(self):
        joints = "".join(f'<link name="l{i}"/><joint name="joint_{i}" type="revolute"><parent link="base"/><child link="l{i}"/>'
                         '<axis xyz="0 0 1"/><limit lower="-1" upper="2" effort="1" velocity="1"/></joint>' for i in range(12))
        self.write("robot.urdf", f'<robot name="r"><link name="base"/>{joints}</robot>')
        rows = "[...document.querySelectorAll('#sliders .joint')].map((row) => row.innerText.split(/\\s+/).filter(Boolean).join(' '))"
        type_in = """(() => { const number = document.querySelector("#sliders input[type=number]"); number.value = 45;
          number.dispatchEvent(new Event("change")); return smurfViewer.motion.position(0, 0); })()"""
        search = """(() => { const field = document.getElementById("joint-search"); field.value = "T_11";
          field.dispatchEvent(new Event("input")); })()"""
        results = self.browse({"page": self.page("robot.urdf"), "steps": [
            rows, type_in, "document.getElementById('unit').click()", rows,
            "document.querySelector('#sliders input[type=number]').value", search, rows]})[0]["results"]
        self.assertEqual((len(results[0]), results[0][1]), (12, "joint_1 \u00b0 -57.3 114.6"))
        self.assertAlmostEqual(results[1], viewer.math.pi / 4)
        self.assertEqual(results[3][1], "joint_1 rad -1 2")
        self.assertEqual(results[4], "0.785")
        self.assertEqual(results[6], ["joint_11 rad -1 2"])

    def test_y_can_point_up(self):
        """The picture turns, and with it the grid; poses stay. Walking needs z up."""
        state = ("({ up: smurfViewer.stage.camera.up.toArray(), grid: Math.round(smurfViewer.stage.grid.rotation.x * 100), "
                 "walk: document.getElementById('walk').disabled, camera: smurfViewer.stage.camera.position.toArray().map((x) => Number(x.toFixed(6))), "
                 "link: smurfViewer.motion.links[0][3].elements })")
        first, turned, seen, back = self.browse({"page": self.page(ARM), "steps": [
            state, {"key": "u"}, state, "(smurfViewer.stage.turn(0.5, 0.1), 0)", state, {"key": "u"}, state]})[0]["results"][0::2]
        self.assertEqual((first["up"], first["grid"], first["walk"]), ([0, 0, 1], 157, False))
        self.assertEqual((turned["up"], turned["grid"], turned["walk"]), ([0, 1, 0], 0, True))
        self.assertEqual(turned["link"], first["link"])
        self.assertNotEqual(seen["camera"], turned["camera"])
        self.assertGreater(turned["camera"][1], 0)
        self.assertEqual(back, first)

    def test_lists_fold_and_layers_are_a_menu(self):
        width = "document.getElementById('stage').clientWidth"
        hidden = "document.getElementById('layers').hidden"
        results = self.browse({"page": self.page(ARM), "steps": [
            width, {"key": "["}, width, "document.getElementById('show-panel').click()", width,
            "document.getElementById('show-tree').getAttribute('aria-pressed')", {"key": "["}, width, hidden,
            "document.getElementById('show').click()", hidden, {"axe": True}, "document.getElementById('collisions').click()", hidden,
            "document.getElementById('collisions').getAttribute('aria-pressed')", {"click": [640, 500]}, hidden]})[0]["results"]
        self.assertLess(results[0], results[2])
        self.assertLess(results[2], results[4])
        self.assertEqual((results[4], results[5]), (1280, "false"))
        self.assertLess(results[7], 1280)
        self.assertEqual([results[index] for index in (8, 10, 11, 13, 14, 16)], [True, False, [], False, "true", True])

    def test_the_picture_is_saved(self):
        folder = self.folder / "saved"
        folder.mkdir()
        self.browse({"page": self.page(ARM), "steps": [{"downloads": str(folder)}, {"key": "p"}, {"file": str(folder / "arm.png")}]})
        self.assertEqual((folder / "arm.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_two_clicks_measure_a_distance(self):
        self.write("robot.urdf", '<robot name="r"><link name="a"><visual><geometry><box size="1 1 1"/></geometry>'
                                 "</visual></link></robot>")
        steps = ["smurfViewer.stage.look([3, 0, 2, 0, 0, 0])", {"key": "d"},
                 {"click": [600, 420]},
                 "document.getElementById('message').textContent", {"click": [640, 420]},
                 "document.getElementById('message').textContent", "smurfViewer.overlays.ruler.visible", {"key": "d"},
                 "[smurfViewer.overlays.ruler.visible, document.getElementById('message').hidden]"]
        results = self.browse({"page": self.page("robot.urdf"), "steps": steps})[0]["results"]
        self.assertEqual(results[3], "Click the second point.")
        self.assertRegex(results[5], r"^0\.\d+ m: x -?[\d.e-]+, y -?[\d.e-]+, z (0|-?[\d.]+e-\d+)$")
        self.assertEqual(results[6:7] + results[8:], [True, [False, True]])

    def test_the_address_shows_the_same_view_again(self):
        self.write("robot.urdf", CHAIN)
        page = self.page("robot.urdf")
        state = """[smurfViewer.motion.positions.map((one) => [...one]), smurfViewer.selected ?? null,
          smurfViewer.stage.view()?.map((number) => Number(number.toPrecision(3))) ?? null,
          document.getElementById("poses").value]"""
        change = """smurfViewer.select(0, 2); smurfViewer.stage.turn(0.3, 0.1, 0.8);
          smurfViewer.joints.set(0, new Map([["first", 0.5]])); smurfViewer.writeHash(); location.hash"""
        first = self.browse({"page": page, "steps": [change, state]})[0]["results"]
        self.assertEqual(first[1][:2], [[[["first", 0.5]]], {"entity": 0, "link": 2}])
        self.assertEqual(first[1][3], "")
        wrong = ("#joint=nonsense&joint=[1]&joint=[%22robot%22,%22first%22,null]&joint=[%22robot%22,%22__proto__%22,1]"
                 "&camera=0,0,0,0,0,0&entity=__proto__&link=b")
        again, none, bad = (one["results"][0] for one in self.browse(
            *({"page": page, "hash": hash, "steps": [state]} for hash in (first[0], "", wrong))))
        self.assertEqual(again, first[1])
        self.assertEqual(none, [[[]], None, None, "start"])
        self.assertEqual(bad, none)

    def test_everything_has_a_name_and_is_readable(self):
        page = self.page(cli.FIXTURES / "models/arm/smurf/arm.smurf")
        steps = ["smurfViewer.select(0, 4)", {"axe": True},
                 "[document.documentElement.scrollWidth, [...document.querySelectorAll('button, input, select')]"
                 ".filter((part) => part.getBoundingClientRect().right > innerWidth).length]"]
        jobs = [{"page": page, "width": width, "height": 800, "scheme": scheme, "steps": steps}
                for width, scheme in ((1280, "light"), (1280, "dark"), (400, "light"))]
        for job, answer in zip(jobs, self.browse(*jobs)):
            self.assertEqual(answer["results"][1], [], (job["width"], job["scheme"]))
            self.assertEqual(answer["results"][2], [job["width"], 0])


if __name__ == "__main__":
    viewer.main()
