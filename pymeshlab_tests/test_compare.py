# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/compare.py: a page that answers, in a browser that has no network."""

from __future__ import annotations

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from batches import wait_for
from browser import chromium
from documents import mesh_from, sphere_points
from selenium.webdriver import Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from neuralmesh_tools.generated_clouds import bumpy_ellipsoid, write_ply
from neuralmesh_tools.project import SCRIPTS

DRAWN = "return [...arguments[0].querySelectorAll('[data-figure]')].every(p => p.dataset.drawn)"
METHODS = ["neural-mesh", "poisson", "ball-pivoting"]

pytestmark = pytest.mark.usefixtures("plugin")


def compare(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run scripts/compare.py."""
    command = [sys.executable, str(SCRIPTS / "compare.py"), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=400, check=False)


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of a closed and an open cloud, and of a file that holds too few points."""
    folder = tmp_path_factory.mktemp("compare")
    whole = bumpy_ellipsoid(3000, 1)
    write_ply(folder / "whole.ply", whole)
    write_ply(folder / "half.ply", whole[whole[:, 2] > 0])
    write_ply(folder / "few.ply", np.eye(3))
    clouds = [folder / f"{name}.ply" for name in ("whole", "half", "few")]
    run = compare(*clouds, "--out", folder / "out", "--methods", ",".join(METHODS))
    assert run.returncode == 1, run.stdout + run.stderr  # one of the three has no answer
    return folder / "out"


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory, report: Path) -> Iterator[Chrome]:
    """A browser in which the page has been opened from its file."""
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        driver.get((report / "report.html").as_uri())
        yield driver


@pytest.fixture
def page(browser: Chrome) -> Chrome:
    """The page with the first cloud shown and drawn."""
    if not browser.find_element(By.ID, "cloud0").is_displayed():
        browser.find_element(By.ID, "tab0").click()
    wait_until_drawn(browser, 0)
    return browser


def wait_until_drawn(browser: Chrome, cloud: int) -> None:
    panel = browser.find_element(By.ID, f"cloud{cloud}")
    WebDriverWait(browser, 120).until(lambda driver: driver.execute_script(DRAWN, panel))


def test_the_page_opens_from_a_file_without_network_and_errors(page: Chrome):
    severe = [entry for entry in page.get_log("browser") if entry["level"] == "SEVERE"]
    assert severe == []
    sent = (json.loads(entry["message"])["message"] for entry in page.get_log("performance"))
    addresses = {
        message["params"]["request"]["url"]
        for message in sent
        if message["method"] == "Network.requestWillBeSent"
    }
    assert any(address.startswith("file:") for address in addresses)
    assert [a for a in addresses if a.startswith(("http", "ws"))] == []


def test_each_result_has_a_view_and_all_share_one_colour_scale(page: Chrome):
    for cloud in (0, 1):
        page.find_element(By.ID, f"tab{cloud}").click()
        wait_until_drawn(page, cloud)
        views = page.find_element(By.CSS_SELECTOR, f"#cloud{cloud} .views")
        canvases = views.find_elements(By.CSS_SELECTOR, ".gl-container canvas")
        assert len(canvases) == 1 + len(METHODS)  # the cloud, and its meshes
        assert all(canvas.size["width"] > 100 < canvas.size["height"] for canvas in canvases)
        axes = "return arguments[0].data.filter(t => t.type === 'mesh3d').map(t => t.coloraxis)"
        assert page.execute_script(axes, views) == ["coloraxis"] * len(METHODS)
        scale = page.execute_script("return arguments[0].layout.coloraxis", views)
        assert scale["cmin"] == 0 < scale["cmax"]
        assert "% of the diagonal" in scale["colorbar"]["title"]["text"]


def test_views_show_surfaces_and_not_an_empty_canvas(page: Chrome):
    views = page.find_element(By.CSS_SELECTOR, "#cloud0 .views")
    images = page.execute_async_script(
        """const [place, done] = arguments;
        Plotly.toImage(place, { format: "png", width: 900, height: 600 }).then(source => {
          const image = new Image();
          image.onload = () => {
            const canvas = document.createElement("canvas");
            [canvas.width, canvas.height] = [900, 600];
            const context = canvas.getContext("2d", { willReadFrequently: true });
            context.drawImage(image, 0, 0);
            const part = [];  // of each cell: share of pixels with colour
            for (let row = 0; row < 2; row++) for (let column = 0; column < 3; column++) {
              const pixels = context.getImageData(column * 270 + 10, row * 300 + 60, 240, 230).data;
              let coloured = 0;
              for (let p = 0; p < pixels.length; p += 4) {
                const rgb = pixels.slice(p, p + 3);
                coloured += Math.max(...rgb) - Math.min(...rgb) > 40;
              }
              part.push(coloured / (pixels.length / 4));
            }
            done(part);
          };
          image.src = source;
        });""",
        views,
    )
    # The cloud is grey, three meshes are in colour, and the next cell is empty.
    assert all(share > 0.1 for share in images[1:4]), images
    assert images[0] < 0.05 > images[4]


def test_turning_one_view_turns_all(page: Chrome):
    views = page.find_element(By.CSS_SELECTOR, "#cloud0 .views")
    eye = {"x": 1.5, "y": 0.5, "z": 0.5}
    page.execute_script(
        "Plotly.relayout(arguments[0], {'scene2.camera': {eye: arguments[1]}})", views, eye
    )
    cameras = "return ['scene', 'scene3', 'scene4'].map(s => arguments[0].layout[s].camera.eye)"
    WebDriverWait(page, 60).until(lambda driver: driver.execute_script(cameras, views) == [eye] * 3)


def test_the_table_sorts_both_ways_by_numbers_and_by_names(page: Chrome):
    def column(number: int) -> list[str]:
        cells = f"#cloud0 .figures tbody tr > :nth-child({number + 1})"
        found = page.find_elements(By.CSS_SELECTOR, cells)
        return [cell.get_attribute("data-value") for cell in found]

    def click(number: int) -> str:
        heading = page.find_elements(By.CSS_SELECTOR, "#cloud0 .figures thead th")[number]
        page.execute_script("arguments[0].querySelector('button').click()", heading)
        return heading.get_attribute("aria-sort")

    rms = 4
    assert click(rms) == "ascending"
    values = [float(text) for text in column(rms)]
    assert values == sorted(values)
    assert len(values) == len(METHODS)
    assert click(rms) == "descending"
    assert [float(text) for text in column(rms)] == values[::-1]
    assert click(0) == "ascending"
    assert column(0) == sorted(column(0))


def test_an_answer_for_each_cloud_stands_on_top(page: Chrome):
    verdicts = page.find_elements(By.CSS_SELECTOR, ".card .verdict")
    whole, half, few = (verdict.text for verdict in verdicts)
    assert whole.startswith("Use ")
    assert half.startswith("The scan is open: use ball pivoting")
    assert few == "It holds 3 points; 17 are the least."
    about = page.find_element(By.ID, "about").text
    assert "PyMeshLab 2025.7.post1" in about
    assert "cores" in about


def test_tables_hold_what_was_measured(report: Path):
    with (report / "results.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["method"] for row in rows] == [*METHODS, *METHODS, ""]
    assert rows[-1]["failure"] == "It holds 3 points; 17 are the least."
    ours = rows[0]
    assert (ours["vertices"], ours["genus"], ours["boundary_edges"]) == ("750", "0", "0")
    # 3,000 points lie 1.5 % of the diagonal apart: the faces between them are off by far less.
    whole = json.loads((report / "results.json").read_text(encoding="utf-8"))["clouds"][0]
    assert 0 < float(ours["rms_percent"]) < 0.5
    assert ours["coverage_percent"] == "100.0"
    assert (ours["doubts"], rows[1]["coverage_percent"]) == ("", "")
    half = rows[3]
    assert half["doubts"].endswith("% of the mesh lies where there are no points.")
    assert float(half["unsupported_area_percent"]) > 20
    assert whole["input"]["normals"].startswith("estimated from 16 neighbours")
    assert whole["verdict"].startswith("Use ")
    counts = [count for count, _ in whole["results"][0]["error_by_vertices"]]
    assert counts == [188, 375, 750]


def test_a_method_that_takes_too_long_is_a_row(tmp_path: Path):
    write_ply(tmp_path / "cloud.ply", bumpy_ellipsoid(20_000, 1))
    methods = ("--methods", "neural-mesh,ball-pivoting", "--timeout", 0.01)
    run = compare(tmp_path / "cloud.ply", "--out", tmp_path / "out", *methods)
    assert run.returncode == 1
    assert run.stdout.count("It timed out: it was not done after computing for 0.01 s.") == 2
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert "No method gave a mesh." in page
    assert "Neural Mesh and ball pivoting timed out: a longer --timeout may change" in page
    assert page.count('<td colspan="3">timed out</td>') == 2


def test_a_reference_is_measured_against_instead_of_the_cloud(tmp_path: Path):
    points, faces = mesh_from(sphere_points(5000), targetvertnum=2000)
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(1.1 * points, faces))
    document.save_current_mesh(str(tmp_path / "larger.ply"))
    write_ply(tmp_path / "sphere.ply", sphere_points(5000, seed=1))
    arguments = (tmp_path / "sphere.ply", "--reference", tmp_path / "larger.ply")
    run = compare(*arguments, "--out", tmp_path / "out", "--methods", "neural-mesh")
    assert run.returncode == 0, run.stdout + run.stderr
    found = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert found["about"]["against"] == "the surface larger.ply"
    # Every point of the unit sphere is 0.1 off the larger one; faces are 1e-3 inside of theirs.
    diagonal = found["clouds"][0]["input"]["diagonal"]
    percent = found["clouds"][0]["results"][0]["values"]["rms_percent"]
    assert percent * diagonal / 100 == pytest.approx(0.1, rel=0.02)


@pytest.mark.parametrize("out", ["", "/proc", "{cloud}/out", "/proc/self/new"])
def test_a_folder_that_cannot_be_written_to_is_named_before_anything_runs(tmp_path: Path, out: str):
    cloud = tmp_path / "cloud.ply"
    write_ply(cloud, bumpy_ellipsoid(100, 1))
    run = compare(cloud, "--out", out.format(cloud=cloud))
    assert run.returncode == 2
    assert "cannot be written to" in run.stderr or "is empty: it names no folder" in run.stderr
    assert "Traceback" not in run.stderr
    assert run.stdout == ""


def test_the_same_command_does_the_clouds_that_are_missing_only(tmp_path: Path):
    clouds = [tmp_path / name for name in ("a/cloud.ply", "b/cloud.ply", "[/]:x:.ply")]
    for seed, cloud in enumerate(clouds):
        cloud.parent.mkdir(parents=True, exist_ok=True)
        write_ply(cloud, bumpy_ellipsoid(200, seed))
    odd = os.fsdecode(bytes(tmp_path) + b"/\xff.ply")
    shutil.copy(clouds[0], odd)
    arguments = ("--out", tmp_path / "out", "--methods", "ball-pivoting")
    assert compare(clouds[0], *arguments).returncode == 0
    first = json.loads((tmp_path / "out" / "results.json").read_text())["clouds"]
    run = compare(*clouds, odd, *arguments)
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.count("done before") == 2  # the fourth is a copy of the first
    found = json.loads((tmp_path / "out" / "results.json").read_text())["clouds"]
    assert [cloud["cloud"] for cloud in found] == ["a/cloud.ply", "b/cloud.ply", "]:x:", "%FF"]
    assert found[0]["results"] == first[0]["results"]
    run = compare(*clouds, *arguments, "--vertices", 20)
    assert "done before" not in run.stdout


def test_a_report_is_there_after_each_cloud_and_ctrl_c_is_no_traceback(tmp_path: Path):
    write_ply(tmp_path / "small.ply", bumpy_ellipsoid(100, 1))
    write_ply(tmp_path / "large.ply", bumpy_ellipsoid(2_000_000, 1))
    command = [sys.executable, str(SCRIPTS / "compare.py"), "small.ply", "large.ply"]
    running = subprocess.Popen(
        [*command, "--out", "out", "--methods", "ball-pivoting"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    page = tmp_path / "out" / "report.html"
    wait_for(page.is_file, "the report of the first cloud")
    running.send_signal(signal.SIGINT)
    output, _ = running.communicate(timeout=60)
    assert running.returncode == 130, output
    assert "stopped; 1 of 2 clouds done; the same command goes on from here" in output
    assert "Traceback" not in output
    assert "1 of 2 so far; the same command does the rest" in page.read_text("utf-8")


@pytest.fixture
def screen(browser: Chrome) -> Iterator[Callable[[int], Chrome]]:
    """The page on a screen of a width in pixels, its second cloud shown and drawn."""

    def of(width: int) -> Chrome:
        size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 700}
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        browser.execute_script("location.reload()")
        WebDriverWait(browser, 60).until(lambda driver: driver.find_elements(By.ID, "tab1"))
        browser.execute_script("document.getElementById('tab1').click()")
        wait_until_drawn(browser, 1)
        return browser

    yield of
    browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


PLACES = """
const box = element => { const b = element.getBoundingClientRect();
                         return [b.left, b.top, b.right, b.bottom].map(Math.round); };
const panel = document.getElementById("cloud1");
const all = selector => [...panel.querySelectorAll(selector)].map(box);
return {
  overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth,
  views: all(".views .gl-container > div"), bar: all(".views .colorbar .cbfills")[0],
  charts: all(".charts .nsewdrag"), table: all(".scroll")[0],
  scrolls: (p => p.scrollWidth > p.clientWidth)(panel.querySelector(".scroll")),
  doubts: panel.querySelectorAll("p.doubt").length,
  shown: innerWidth,
};
"""


def test_on_a_phone_views_and_charts_stand_below_each_other(screen: Callable[[int], Chrome]):
    found = screen(390).execute_script(PLACES)
    assert found["shown"] == 390
    assert found["overflow"] <= 0
    assert found["scrolls"]
    views = found["views"]
    assert len(views) == 1 + len(METHODS)
    for above, below in pairwise(views):
        assert above[3] <= below[1]
    assert all(left >= 20 and right <= 370 and right - left > 250 for left, _, right, _ in views)
    left, top, right, bottom = found["bar"]
    assert right - left > 200 > 40 > bottom - top
    assert bottom < views[0][1]
    first, second = found["charts"]
    assert first[3] < second[1]
    assert found["doubts"] >= 1


def test_on_a_wide_screen_views_stand_side_by_side(screen: Callable[[int], Chrome]):
    found = screen(1400).execute_script(PLACES)
    assert found["overflow"] <= 0
    tops = [view[1] for view in found["views"]]
    assert tops[0] == tops[1] == tops[2] < tops[3]
    left, top, right, bottom = found["bar"]
    assert bottom - top > 200 > 40 > right - left
    first, second = found["charts"]
    assert first[2] < second[0]


@pytest.mark.parametrize("width", [390, 1400])
def test_ticks_of_errors_carry_their_full_value(screen: Callable[[int], Chrome], width: int):
    found = screen(width).execute_script(
        """const place = document.querySelector("#cloud1 .charts");
        const ticks = [...place.querySelectorAll(".ytick text")].map(tick => tick.textContent);
        const errors = place.data.filter(t => t.type === "scatter").flatMap(t => t.y);
        return { ticks, errors };"""
    )
    shown = [float(text) for text in found["ticks"]]
    assert len(shown) >= 2
    assert shown[0] <= min(found["errors"]) <= max(found["errors"]) <= shown[-1]


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["--methods", "magic"], "there is no method magic"),
        (["--vertices", "3"], "--vertices must be at least 16"),
        (["none.ply"], "there is no file none.ply"),
        (["--reference", "{cloud}"], "It has no faces, so it is no surface to measure against."),
        (["--timeout", "nan"], "must be a positive number, not 'nan'"),
        (["--threshold", "inf"], "must be a positive number, not 'inf'"),
        (["x" * 300], "there is no file xxx"),
        (["{cloud.parent}"], " is a folder: name the files in it, as "),
        (["--reference", "{cloud.parent}"], " is a folder: name the file"),
        ([""], ". is a folder: name the files in it, as *.ply"),
    ],
)
def test_what_cannot_work_is_said_at_once(tmp_path: Path, options: list[str], sentence: str):
    cloud = tmp_path / "cloud.ply"
    write_ply(cloud, bumpy_ellipsoid(100, 1))
    options = [option.format(cloud=cloud) for option in options]
    run = compare(cloud, *options, "--out", tmp_path / "out")
    assert run.returncode == 2
    assert sentence in run.stderr
    assert not (tmp_path / "out").exists()
