#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the programs' pages in a browser, from disk, and uses them: clicks, cuts, reads their tables.

usage: html_pages.py --build FOLDER [--keep FOLDER] [NAME...]
  --build FOLDER   where the programs are
  --keep FOLDER    leave the pages and screenshots there
  NAME             only the tests whose names hold this

Needs Debian's chromium, chromium-driver and python3-selenium. Exit code 77 where one is absent: skipped.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    print("skipped: python3-selenium is not installed")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
# A file's name cannot hold a slash: this one closes no tag, but opens some.
NASTY = "a'b\"><script>hacked=1<!--<script><img src=x onerror=hacked=1>&amp;"


def browser(chromium, driver, webgl=True):
    options = Options()
    options.binary_location = chromium
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1300,1000", "--hide-scrollbars"):
        options.add_argument(argument)
    for argument in ("--use-angle=swiftshader", "--enable-unsafe-swiftshader") if webgl else ("--disable-gpu", "--disable-3d-apis"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(driver), options=options)


class Page:
    """A page in the browser: what it shows, and what one can do with it."""

    def __init__(self, driver, path):
        self.driver = driver
        driver.get(pathlib.Path(path).resolve().as_uri())
        if driver.find_elements(By.ID, "view"):
            self.wait(lambda: self.view("ready"), "the view is ready")

    def wait(self, holds, what, seconds=60):
        end = time.monotonic() + seconds
        while not holds():
            assert time.monotonic() < end, f"not within {seconds} s: {what}; selected {self.view('selected')!r}"
            time.sleep(0.02)

    def view(self, name):
        found = self.driver.find_elements(By.ID, "view")
        return found[0].get_attribute("data-" + name) if found else None

    def click(self, element_id):
        self.driver.execute_script("arguments[0].click()", self.driver.find_element(By.ID, element_id))

    def text(self, element_id):
        return self.driver.find_element(By.ID, element_id).text

    def rows(self, table):
        return self.driver.execute_script(
            "return Array.from(document.querySelectorAll('#' + arguments[0] + ' tbody tr'),"
            " row => Array.from(row.cells, cell => cell.textContent))", table)

    def canvas(self):
        return self.driver.find_element(By.CSS_SELECTOR, "#stage canvas")

    def pixels(self):
        """What the view shows: whether anything touches its frame, and how many pixels have the chosen finding's colour."""
        return self.driver.execute_script("""
            const from = arguments[0], to = document.createElement('canvas');
            to.width = from.width; to.height = from.height;
            const context = to.getContext('2d');
            context.drawImage(from, 0, 0);
            const p = context.getImageData(0, 0, to.width, to.height).data;
            let touches = false, chosen = 0;
            for (let i = 0; i < p.length; i += 4) {
              const x = i / 4 % to.width, y = Math.floor(i / 4 / to.width);
              if ((x < 2 || y < 2 || x >= to.width - 2 || y >= to.height - 2) && p[i] + p[i + 1] + p[i + 2] < 750) touches = true;
              if (p[i] > 150 && p[i + 1] > 100 && p[i + 2] < 80) ++chosen;
            }
            return {touches, chosen};""", self.canvas())

    def console(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]


def same_number(text, value):
    return text == "" if value is None else float(text) == value


class Tests:
    def __init__(self, arguments, folder):
        self.build = arguments.build.resolve()
        self.folder = folder
        self.drivers = {}

    def run(self, program, *arguments, codes=(0,)):
        done = subprocess.run([self.build / program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        assert done.returncode in codes, f"{program} {arguments}: exit {done.returncode}: {done.stderr}{done.stdout}"
        return done

    def open(self, path, webgl=True):
        if webgl not in self.drivers:
            self.drivers[webgl] = browser(shutil.which("chromium"), shutil.which("chromedriver"), webgl)
        return Page(self.drivers[webgl], self.folder / path)

    def shot(self, page, name):
        page.driver.save_screenshot(str(self.folder / (name + ".png")))

    def verified(self, mesh, *arguments, name="page", codes=(0, 1, 4)):
        self.run("tetproof-verify", mesh, *arguments, "--json", name + ".json", "--html", name + ".html", codes=codes)
        return json.loads((self.folder / (name + ".json")).read_text())

    # --- the tests

    def test_a_broken_mesh_flies_and_selects(self):
        report = self.verified(ROOT / "corpus/bad-meshes/blocks-face-to-face.msh")
        page = self.open("page.html")
        findings = [(check["id"], finding) for check in report["checks"] for finding in check["findings"]]
        rows = page.rows("findings")
        assert len(rows) == len(findings) > 0
        for row, (check, finding) in zip(rows, findings):
            assert row[1] == check and finding["what"] in row[2], row
        seen = page.pixels()
        assert not seen["touches"] and seen["chosen"] == 0, seen   # all of it is in view, and nothing is chosen yet
        before = page.view("target")
        buttons = page.driver.find_elements(By.CSS_SELECTOR, "#findings button[data-target]")
        assert len(buttons) == len(findings)
        buttons[-1].click()
        page.wait(lambda: page.view("selected") == "target %d" % (len(findings) - 1), "the flight ends")
        assert page.view("target") != before
        assert page.pixels()["chosen"] > 500   # it stands out among the others
        top = page.driver.execute_script("return document.getElementById('stage').getBoundingClientRect().top")
        assert top >= 0, top   # however long its text is
        told = page.text("told")
        check, finding = findings[-1]
        assert told.startswith(check + ": "), told
        for number in finding["tets"][:5]:   # the file's own numbers
            assert str(number) in told
        self.shot(page, "broken")
        assert page.console() == []

    def test_tables_equal_the_report(self):
        grid = self.folder / "torus.msh"
        self.run("tetproof-mesh", "torus:R=1,r=0.4,n=2000", "-o", grid, "--cells", 12, "--points", 0, "--quiet", codes=(0, 1))
        report = self.verified(grid, "torus:R=1,r=0.4,n=2000")
        page = self.open("page.html")
        assert page.text("verdict") == report["verdict"]
        for row, check in zip(page.rows("checks"), report["checks"], strict=True):
            assert row[:4] == [check["id"], check["verdict"], str(check["count"]), str(check["consequences"])], row
            assert same_number(row[4], check["measured"]) and same_number(row[5], check["allowed"]), row
        shapes = {row[0]: row[1:] for row in page.rows("shapes")}
        for name in ("mesh", "surface"):
            assert shapes[name][0] == str(report[name]["points"])
            assert float(shapes[name][-1]) == report[name]["volume"]
        values = [float(row[1]) for row in page.rows("surface-measures")]
        for value in (report["volume"]["voxel_inside"], report["fidelity"]["mesh_to_surface"], report["fidelity"]["surface_to_mesh"]):
            assert value in values, value
        bars = page.driver.execute_script(
            "return Array.from(document.querySelectorAll('#dihedral-angles .bar title'), t => Number(t.textContent.split(': ').pop()))")
        assert bars == report["quality"]["dihedral_angles"]["histogram"]["counts"]
        # the places of the largest distances
        page.driver.find_element(By.CSS_SELECTOR, "#surface-measures button").click()
        page.wait(lambda: (page.view("selected") or "").startswith("target"), "the flight ends")
        assert "largest distance" in page.text("told")
        for colour in ("value", "quality", "plain"):
            page.click("colour-" + colour)
            page.wait(lambda: page.view("colouring") == colour, colour)
            self.shot(page, "torus-" + colour)
        assert page.console() == []

    def test_the_cut_shows_whole_tetrahedra(self):
        grid = self.folder / "sphere.msh"
        self.run("tetproof-mesh", "sphere:r=1,n=500", "-o", grid, "--cells", 10, "--points", 0, "--quiet", codes=(0, 1))
        report = self.verified(grid)
        page = self.open("page.html")
        assert "boundary" in page.view("shown").split()
        assert page.view("cut-tets") == "0"
        counts = {}
        for axis in "xyz":
            page.click("cut-" + axis)
            page.wait(lambda: 0 < int(page.view("cut-tets")) < report["mesh"]["tets"], "cut across " + axis)
            counts[axis] = int(page.view("cut-tets"))
            assert "boundary" not in page.view("shown").split()   # the cut takes its place
        page.click("cut-flip")   # what is behind, and what is in front: nothing is lost
        page.wait(lambda: int(page.view("cut-tets")) + counts["z"] >= report["mesh"]["tets"], "the other side")
        self.shot(page, "cut")
        # a click on the cut names a tetrahedron that is in the file
        ActionChains(page.driver).move_to_element(page.canvas()).click().perform()
        page.wait(lambda: (page.view("selected") or "").startswith("tet "), "a tetrahedron is selected")
        told = page.text("told")
        assert "volume " in told and "dihedral angles " in told and "points " in told, told
        page.click("cut-none")
        page.wait(lambda: page.view("cut-tets") == "0" and "boundary" in page.view("shown").split(), "the boundary is back")
        page.click("show-boundary")
        page.wait(lambda: "boundary" not in page.view("shown").split(), "the boundary is hidden")
        assert page.console() == []

    def test_axes_box_and_keys(self):
        """Where things are, in the file's own unit; and the view without a mouse."""
        text = (ROOT / "corpus/bad-meshes/blocks-face-to-face.msh").read_text()
        head, nodes, tail = re.split(r"\$Nodes\n|\$EndNodes\n", text)
        lines = nodes.splitlines()
        moved = [lines[0]] + [f"{n} {float(x) * 10 + 500} {float(y) * 10} {float(z) * 10 - 7}" for n, x, y, z in map(str.split, lines[1:])]
        (self.folder / "moved.msh").write_text(head + "$Nodes\n" + "\n".join(moved) + "\n$EndNodes\n" + tail)
        self.verified(self.folder / "moved.msh")
        page = self.open("page.html")
        assert page.text("box") == "What is drawn lies in x 500 to 520, y 0 to 10, z -7 to 13.", page.text("box")
        assert [e.text for e in page.driver.find_elements(By.CLASS_NAME, "axis-name")] == ["x", "y", "z"]
        for axis, middle in (("x", 510), ("y", 5), ("z", 3)):
            page.click("cut-" + axis)
            assert page.text("cut-place") == f"{axis} = {middle}", page.text("cut-place")
        page.driver.execute_script("const e = arguments[0]; e.value = 0.25; e.dispatchEvent(new Event('input'))", page.driver.find_element(By.ID, "cut-at"))
        assert page.text("cut-place") == "z = 8", page.text("cut-place")
        page.click("cut-none")
        assert page.text("cut-place") == ""
        before, distance = page.view("camera"), float(page.view("distance"))
        page.canvas().send_keys(Keys.ARROW_LEFT)
        page.wait(lambda: page.view("camera") != before, "it turns")
        assert abs(float(page.view("distance")) - distance) < 1e-4
        page.canvas().send_keys(Keys.ARROW_RIGHT)
        page.wait(lambda: page.view("camera") == before, "it turns back")
        page.canvas().send_keys("+")
        page.wait(lambda: float(page.view("distance")) < 0.9 * distance, "it comes nearer")
        # A page for a small window scrolls downwards only; wide tables scroll by themselves.
        page.driver.set_window_size(500, 900)
        wide = page.driver.execute_script("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
        page.driver.set_window_size(1300, 1000)
        assert wide <= 0, wide
        assert page.console() == []

    def test_what_is_not_drawn_is_said(self):
        """Elements that are no tetrahedra are not judged, and the view lacks them."""
        nodes = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (5, 0, 0), (6, 0, 0), (5, 1, 0), (5, 0, 1), (6, 0, 1), (5, 1, 1)]
        (self.folder / "prism.msh").write_text(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n" + "".join(f"{i + 1} {x} {y} {z}\n" for i, (x, y, z) in enumerate(nodes)) +
            "$EndNodes\n$Elements\n2\n1 4 0 1 2 3 4\n2 6 0 5 6 7 8 9 10\n$EndElements\n")
        report = self.verified("prism.msh", codes=(4,))
        assert report["not_judged"][0]["count"] == 1
        page = self.open("page.html")
        text = page.driver.find_element(By.TAG_NAME, "main").text
        assert "1 prism" in text and "parts that were not judged are not drawn" in text, text[:600]
        self.verified(ROOT / "corpus/bad-meshes/blocks-face-to-face.msh")
        assert "not drawn" not in self.open("page.html").driver.find_element(By.TAG_NAME, "main").text

    def test_how_a_grid_was_made(self):
        """The page of tetproof-mesh: plots, tables, plane cuts, and tetrahedra from small to large."""
        self.run("tetproof-mesh", "sphere:r=1,n=400", "-o", "ball.msh", "--cells", 8, "--v0", 0.1, "--json", "page.json",
                 "--html", "page.html", codes=(0, 1))
        report = json.loads((self.folder / "page.json").read_text())
        page = self.open("page.html")
        assert page.text("verdict") == report["verdict"]
        for table, counts in (("table2", report["generation"]["cases"]), ("table3", report["generation"]["table3"]),
                              ("table4", report["adaptation"]["rows"])):
            assert [[row[0], int(row[1])] for row in page.rows(table)] == [[name, n] for name, n in counts.items()], table
        cuts = page.driver.execute_script("return Array.from(document.querySelectorAll('figure svg title'), t => t.textContent)")
        assert [title for title in cuts if "ut" in title] == ["The grid cut open"] + ["Cut across " + axis for axis in "xyz"], cuts
        dots = page.driver.find_element(By.CSS_SELECTOR, "#volumes .dots").get_attribute("d").count("M")
        assert dots == min(4000, report["mesh"]["tets"]), (dots, report["mesh"]["tets"])   # a sample, as the plot says
        curve = page.driver.find_element(By.CSS_SELECTOR, "#e-avg .curve").get_attribute("d").count("L")
        assert curve == report["adaptation"]["insertions"], curve
        page.click("show-boundary")
        page.click("show-chosen")
        page.wait(lambda: "chosen" in page.view("shown").split() and "boundary" not in page.view("shown").split(), "they are shown")
        self.shot(page, "chosen")
        assert page.console() == []

    def test_where_two_traces_part(self):
        trace = (ROOT / "corpus/vectors/traces/bumps.jsonl").read_text().splitlines(keepends=True)
        at = [i for i, line in enumerate(trace) if json.loads(line)["record"] == "insertion"][3]
        record = json.loads(trace[at])
        record["point"][0] += 0.01
        (self.folder / "other.jsonl").write_text("".join(trace[:at]) + json.dumps(record) + "\n" + "".join(trace[at + 1:]))
        self.run("tetproof-compare", "other.jsonl", ROOT / "corpus/vectors/traces/bumps.jsonl", "--json", "page.json",
                 "--html", "page.html", "--surface", ROOT / "corpus/vectors/traces/bumps.obj", codes=(1, 4))
        result = json.loads((self.folder / "page.json").read_text())
        page = self.open("page.html")
        rows = {row[0]: row[1:] for row in page.rows("record")}
        assert rows["point"][2] == "differs" and rows["tet"][2] == "same", rows
        assert float(rows["e_avg"][0]) == record["e_avg"]   # both choices, with their E'avg
        assert [row[3] for row in page.rows("sides")] == [result["reference"]["says"], result["other"]["says"]]
        for i, button in enumerate(page.driver.find_elements(By.CSS_SELECTOR, "#sides button")):
            button.click()
            page.wait(lambda: page.view("selected") == f"target {i}", "the flight ends")
            name = ("reference", "other")[i]
            assert page.text("told") == f"{name}: {result[name]['says']}"
        assert {"reference", "other", "surface"} <= set(page.view("shown").split())
        self.shot(page, "traces")
        assert page.console() == []

    def test_what_only_one_grid_has(self):
        for name, cells in (("a.msh", 6), ("b.msh", 7)):
            self.run("tetproof-mesh", "sphere:r=1,n=200", "-o", name, "--cells", cells, "--points", 0, "--quiet", codes=(0, 1))
        self.run("tetproof-compare", "a.msh", "b.msh", "--json", "page.json", "--html", "page.html", codes=(1,))
        result = json.loads((self.folder / "page.json").read_text())
        page = self.open("page.html")
        for side in ("reference", "other"):
            rows = page.rows(side + "-only")
            listed = [f"tetrahedron {t['number']}" for t in result[side]["first_tets"]] + [
                f"point {p['number']}" for p in result[side]["first_points"]]
            assert [row[0] for row in rows] == listed, rows
        page.driver.find_element(By.CSS_SELECTOR, "#other-only button").click()
        page.wait(lambda: (page.view("selected") or "").startswith("target"), "the flight ends")
        assert page.console() == []

    def test_a_campaign_and_its_findings(self):
        self.run("tetproof-fuzz", "--cases", 12, "--seed", 5, "--out", "campaign", "--shrink", 2, "--html", "page.html", "--json", "page.json",
                 "--quiet", "--", self.build / "tetproof-faulty-mesher", "duplicate", "{surface}", "{mesh}", codes=(1,))
        report = json.loads((self.folder / "page.json").read_text())
        page = self.open("page.html")
        rows = page.rows("groups")
        assert [row[:4] for row in rows] == [[g["mesher"], g["outcome"], g["signature"], str(len(g["cases"]))] for g in report["groups"]], rows
        image = page.driver.find_element(By.CSS_SELECTOR, "#groups img")
        assert page.driver.execute_script("return arguments[0].naturalWidth > 0", image)
        text = page.driver.find_element(By.TAG_NAME, "main").text
        assert f"again: tetproof-fuzz --replay 5:{report['groups'][0]['cases'][0]['case']}" in text, text   # it can be seen again
        self.shot(page, "campaign")
        assert page.console() == []
        page.driver.find_element(By.CSS_SELECTOR, "#groups a").click()
        page.wait(lambda: page.view("ready") == "yes", "the finding's page is ready")
        assert page.text("verdict") == "defective"
        assert len(page.rows("findings")) > 0
        self.shot(page, "finding")
        assert page.console() == []

    def test_a_finding_is_judged_as_it_was(self):
        """A boundary that is off by 1e-6 is a finding for a campaign, and must not be sound on its page."""
        self.run("tetproof-fuzz", "--cases", 6, "--seed", 5, "--out", "moved", "--shrink", 1, "--html", "page.html", "--quiet",
                 "--", self.build / "tetproof-faulty-mesher", "move", "{surface}", "{mesh}", codes=(1,))
        page = self.open("page.html")
        assert page.rows("groups")[0][1] == "wrong-against-surface", page.rows("groups")
        page.driver.find_element(By.CSS_SELECTOR, "#groups a").click()
        page.wait(lambda: page.view("ready") == "yes", "the finding's page is ready")
        assert page.text("verdict") == "defective", page.text("verdict")

    def test_checkers_and_readers(self):
        """Who misses what, and what crashes on damaged files: tables equal the JSON, and each finding says how to see it again."""
        self.run("tetproof-fuzz", "--judge", "true {mesh}", "--judge", "tetproof-verify", "--kinds", "sound,flat,inverted-inside", "--cases", 1,
                 "--out", "judged", "--json", "page.json", "--html", "page.html", "--quiet", codes=(1,))
        report = json.loads((self.folder / "page.json").read_text())
        page = self.open("page.html")
        assert page.text("verdict") == "2 groups of findings", page.text("verdict")
        totals = {row[0]: row[1:4] for row in page.rows("checkers")}
        assert totals == {name: [str(counts[key]) for key in ("meshes", "seen", "accepted")] for name, counts in report["by_checker"].items()}, totals
        assert [row[:2] for row in page.rows("kinds")] == [["sound", "1 accepted"], ["flat", "1 missed"], ["inverted-inside", "1 missed"]]
        text = page.driver.find_element(By.TAG_NAME, "main").text
        assert "true:missed:flat" in text and "again: true mesh.msh" in text.replace("/usr/bin/", ""), text
        assert page.console() == []
        self.run("tetproof-fuzz", "--reader", "sh -c 'kill -SEGV $$' {file}", "--formats", "off", "--cases", 20, "--out", "read",
                 "--json", "page.json", "--html", "page.html", "--quiet", codes=(1,))
        report = json.loads((self.folder / "page.json").read_text())
        page = self.open("page.html")
        assert page.text("verdict") == f"{report['new_groups']} new" and report["new_groups"] > 0
        assert [row[:2] for row in page.rows("damages")] == [[name, str(counts["files"])] for name, counts in report["by_damage"].items()]
        assert report["groups"][0]["id"] in page.driver.find_element(By.TAG_NAME, "main").text
        assert page.console() == []

    def test_names_become_no_code(self):
        """Names of files, surfaces and groups that try to be markup and script are shown, and never run."""
        mesh = (ROOT / "corpus/bad-meshes/blocks-face-to-face.msh").read_text()
        name = NASTY.replace('"', "'") + "</script><script>hacked=1</script>"   # a name in .msh stands in quotes
        at = mesh.index("$EndMeshFormat\n") + len("$EndMeshFormat\n")
        mesh = mesh[:at] + f'$PhysicalNames\n1\n3 2 "{name}"\n$EndPhysicalNames\n' + mesh[at:]
        mesh = re.sub(r"^(\d+) 4 2 0 ", lambda m: f"{m[1]} 4 2 {1 + int(m[1]) % 2} ", mesh, flags=re.M)
        path = self.folder / (NASTY + "<b>.msh")
        path.write_text(mesh)
        self.verified(path)
        page = self.open("page.html")
        assert page.driver.title == str(path), page.driver.title
        assert any(name in row[0] for row in page.rows("shapes")), page.rows("shapes")
        page.click("colour-region")
        assert page.driver.execute_script("return typeof hacked") == "undefined"
        assert page.driver.execute_script("return document.querySelectorAll('h1 b, h1 img, h1 script, img').length") == 0
        scripts = page.driver.execute_script("return Array.from(document.scripts, s => s.type)")
        assert scripts == ["application/json"] + 8 * [""], scripts
        # Even if something of a name became a script, the page's policy would not run it.
        page.driver.execute_script("const s = document.createElement('script'); s.textContent = 'hacked = 2'; document.body.append(s)")
        assert page.driver.execute_script("return typeof hacked") == "undefined"
        assert any("Content Security Policy" in message for message in page.console())

    def test_without_webgl_all_else_stays(self):
        report = self.verified(ROOT / "corpus/bad-meshes/blocks-face-to-face.msh")
        page = self.open("page.html", webgl=False)
        assert page.view("ready") == "without"
        assert len(page.rows("checks")) == len(report["checks"])
        assert len(page.rows("findings")) == sum(len(check["findings"]) for check in report["checks"])
        picture = page.driver.find_element(By.CSS_SELECTOR, "#picture svg")
        assert picture.is_displayed() and page.driver.execute_script("return document.querySelectorAll('#picture svg path').length") > 10
        assert not page.driver.find_element(By.ID, "view").is_displayed()
        assert "WebGL" in page.text("no-view")
        assert "Without scripts" in (self.folder / "page.html").read_text()
        self.shot(page, "without-webgl")
        assert [m for m in page.console() if "WebGL" not in m] == []

    def test_strange_coordinates(self):
        """The largest and the smallest doubles, and points that are no numbers, are drawn or said."""
        for name, scale in (("large", "1e300"), ("small", "1e-300")):
            text = "4 3 0 0\n" + "".join(f"{i} {x}\n" for i, x in enumerate(
                ("0 0 0", f"{scale} {scale} 0", f"{scale} 0 {scale}", f"0 {scale} {scale}")))
            (self.folder / f"{name}.node").write_text(text)
            (self.folder / f"{name}.ele").write_text("1 4 0\n0 0 2 1 3\n")
            self.verified(self.folder / f"{name}.ele", name=name)
            page = self.open(name + ".html")
            ActionChains(page.driver).move_to_element(page.canvas()).click().perform()
            page.wait(lambda: page.view("selected") == "tet 0", "the tetrahedron is selected")
            exponent = {"large": "e899", "small": "e-901"}[name]
            assert exponent in page.text("told"), page.text("told")
            assert page.console() == []
        (self.folder / "nan.node").write_text("4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 nan 0\n3 0 0 1\n")
        (self.folder / "nan.ele").write_text("1 4 0\n0 0 1 2 3\n")
        self.verified(self.folder / "nan.ele")
        page = self.open("page.html")
        assert "1 tetrahedron cannot be drawn" in page.driver.find_element(By.TAG_NAME, "main").text
        assert page.console() == []

    def close(self):
        for driver in self.drivers.values():
            driver.quit()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    for program in ("chromium", "chromedriver"):
        if not shutil.which(program):
            print(f"skipped: {program} is not installed")
            return 77
    failed = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        tests = Tests(arguments, folder.resolve())
        try:
            for name in sorted(name for name in dir(tests) if name.startswith("test_")):
                if arguments.names and not any(part in name for part in arguments.names):
                    continue
                start = time.monotonic()
                try:
                    getattr(tests, name)()
                    print(f"ok      {name} ({time.monotonic() - start:.1f} s)", flush=True)
                except Exception as error:
                    failed += 1
                    print(f"FAILED  {name}: {type(error).__name__}: {error}", flush=True)
        finally:
            tests.close()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
