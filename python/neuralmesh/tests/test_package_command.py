# SPDX-License-Identifier: GPL-3.0-or-later
"""The command: files in, a mesh out, exit codes, one screen of help."""

from __future__ import annotations

import json
import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

import neuralmesh
import numpy as np
import pytest
from neuralmesh.command import main
from numpy.typing import NDArray

Points = NDArray[np.float64]


def command(*arguments: object, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run the command in a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "neuralmesh", *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


@pytest.fixture
def ball_file(ball: Points, tmp_path: Path) -> Path:
    np.savetxt(tmp_path / "ball.xyz", ball, fmt="%.17g")
    return tmp_path / "ball.xyz"


def test_a_cloud_becomes_a_mesh(bunny_file: Path, bunny: Points, tmp_path: Path) -> None:
    run = command(bunny_file, "-n", 1000, "-o", "out.ply", folder=tmp_path)
    assert run.returncode == 0, run.stderr
    assert run.stdout == "out.ply\n"
    assert "bunny.obj: 28,088 points." in run.stderr
    assert "1,000 vertices, 1,996 faces" in run.stderr
    expected = neuralmesh.reconstruct(bunny, 1000)
    assert np.array_equal(neuralmesh.read(tmp_path / "out.ply").points, expected.vertices)


def test_results_as_json(ball_file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = ball_file.with_suffix(".obj")
    options = ["-n", "200", "--snapshots", "50,100", "--random-seed", "3", "-q", "--json"]
    assert main([str(ball_file), "-o", str(out), *options]) == 0
    printed, told = capsys.readouterr()
    assert told == ""
    info = json.loads(printed)
    assert info["vertices"] == 200
    assert info["seed"] == 3
    assert [Path(file).name for file in info["files"]] == [
        "ball_50.obj",
        "ball_100.obj",
        "ball.obj",
    ]
    assert all(Path(file).is_file() for file in info["files"])


def test_every_parameter_has_an_option(ball_file: Path, ball: Points) -> None:
    out = ball_file.with_suffix(".npz")
    given = (
        "-n 100 --topology start --start-mesh icosahedron --split-rule paper --edge-flips no "
        "--transfer-attributes no --winner-rate 0.07 --smoothing-rate 0.04 --smoothing-passes 4 "
        "--signals-per-split 50 --inactivity-factor 20 --threads 2 --counter-decay 0.99 "
        "--no-surface-fit --boundaries closed --max-hole-size 5% -q"
    )
    assert main([str(ball_file), "-o", str(out), *given.split()]) == 0
    expected = neuralmesh.reconstruct(
        ball,
        100,
        topology=0,
        start_mesh=2,
        split_rule=1,
        edge_flips=False,
        transfer_attributes=False,
        winner_rate=0.07,
        smoothing_rate=0.04,
        smoothing_passes=4,
        signals_per_split=50,
        inactivity_factor=20,
        threads=2,
        counter_decay=0.99,
        surface_fit=False,
        max_hole_size="5 %",
    )
    assert np.array_equal(np.load(out)["vertices"], expected.vertices)


def test_tiles_of_a_folder_make_one_cloud(ball: Points, tmp_path: Path) -> None:
    tiles = tmp_path / "tiles"
    tiles.mkdir()
    for number in range(4):
        np.save(tiles / f"tile_{number}.npy", ball[number::4])
    (tiles / "readme.md").write_text("not a tile", "utf-8")
    (tiles / "._tile_0.npy").write_bytes(b"what macOS keeps beside a file")
    out = tmp_path / "ball.ply"
    assert main([str(tiles), "--merge", "-n", "200", "-o", str(out), "-q"]) == 0
    merged = np.vstack([ball[number::4] for number in range(4)])
    expected = neuralmesh.reconstruct(merged, 200)
    assert np.array_equal(neuralmesh.read(out).points, expected.vertices)


def test_what_a_folder_holds_besides_tiles_is_named_and_counted(
    ball: Points, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tiles = tmp_path / "tiles"
    (tiles / "older").mkdir(parents=True)
    np.save(tiles / "tile.npy", ball)
    np.savetxt(tiles / "tile.txt", ball[:100])
    (tiles / "notes.txt").write_text("Scanned on a Friday, by rain.", "utf-8")
    (tiles / "readme.md").write_text("not a tile", "utf-8")
    assert main([str(tiles), "--merge", "-n", "100", "-o", str(tmp_path / "ball.ply")]) == 0
    told = capsys.readouterr().err
    assert "2 files: 5,100 points" in told
    assert (
        "tiles': left out: 1 × .md (readme.md); 1 × subfolder (older); "
        "1 × text without points (notes.txt)." in told
    )


def test_info_of_a_folder_describes_all_that_it_can(
    ball_file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    ball_file.with_name("a_broken.laz").write_bytes(b"hello")
    assert main(["info", str(ball_file.parent)]) == 1
    printed, told = capsys.readouterr()
    assert "ball.xyz: points as text, 5,000 points" in printed
    assert "a_broken.laz': it is no LAS or LAZ file" in told


def test_a_cloud_that_is_too_large_is_chosen_from_and_said_so(
    ball_file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = ball_file.with_suffix(".ply")
    assert main([str(ball_file), "-n", "200", "-o", str(out), "--most-points", "3000"]) == 0
    told = capsys.readouterr().err
    assert "ball.xyz: 5,000 points; 3,000 of them, a uniform choice, are kept in memory" in told


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["nowhere.ply", "-o", "out.ply"], "'nowhere.ply': there is no such file."),
        (["ball.xyz", "-o", "out.doc"], "'out.doc': its ending must be one of .ply, .obj"),
        (["ball.xyz", "-o", "no/out.ply"], "'no/out.ply': there is no folder 'no'."),
        (
            ["ball.xyz", "-n", "6000", "-o", "out.ply"],
            "--vertices is 6000, but there are only 5000 distinct points",
        ),
        (
            ["ball.xyz", "-o", "out.ply", "--winner-rate", "2"],
            "--winner-rate must lie between 0 and 1",
        ),
        (
            ["ball.xyz", "-o", "out.ply", "--max-hole-size", "wide"],
            "--max-hole-size must be a length or a percentage, not 'wide'.",
        ),
        (["ball.xyz", "-o", "out.ply", "--most-points", "-1"], "--most-points must be at least 0"),
    ],
)
def test_what_cannot_be_used_is_a_sentence_and_exit_code_1(
    arguments: list[str],
    sentence: str,
    ball_file: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(ball_file.parent)
    assert main(arguments) == 1
    assert sentence in capsys.readouterr().err
    assert [path.name for path in ball_file.parent.iterdir()] == ["ball.xyz"]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ([], "required: INPUT, -o/--output"),
        (["ball.xyz"], "required: -o/--output"),
        (["ball.xyz", "ball.xyz", "-o", "out.ply"], "several inputs make one cloud with --merge"),
        ([".", "-o", "out.ply"], "is a folder: its files make one cloud with --merge"),
        (["ball.xyz", "-o", "out.ply", "--boundaries", "half"], "invalid choice: 'half'"),
        (["ball.xyz", "-n", "3", "-o", "out.ply"], "-n/--vertices: must be at least 4, not 3"),
        (["ball.xyz", "-n", "many", "-o", "out.ply"], "must be a whole number, not 'many'"),
    ],
)
def test_a_wrong_command_line_ends_with_2(
    arguments: list[str],
    sentence: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert sentence in capsys.readouterr().err


def test_help_fits_on_a_screen(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments in (["--help"], ["info", "--help"], ["--help-parameters"]):
        with pytest.raises(SystemExit) as caught:
            main(arguments)
        assert caught.value.code == 0
        lines = capsys.readouterr().out.splitlines()
        assert len(lines) <= 40
        assert max(map(len, lines)) <= 95


def test_info_describes_what_it_can_and_names_the_rest(
    ball_file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    broken = ball_file.with_name("broken.laz")
    broken.write_bytes(b"hello")
    assert main(["info", str(broken), str(ball_file)]) == 1
    printed, told = capsys.readouterr()
    assert "ball.xyz: points as text, 5,000 points" in printed
    assert "broken.laz': it is no LAS or LAZ file" in told
    assert main(["info", "--json", str(ball_file)]) == 0
    info = json.loads(capsys.readouterr().out)
    assert info["points"] == 5000
    assert info["has_colours"] is False
    assert info["diagonal"] == pytest.approx(2 * np.sqrt(3), rel=0.01)


def test_a_bar_is_shown_in_a_terminal(bunny_file: Path, tmp_path: Path) -> None:
    outside, inside = pty.openpty()
    with subprocess.Popen(
        [sys.executable, "-m", "neuralmesh", bunny_file, "-n", "3000", "-o", "out.ply"],
        cwd=tmp_path,
        stderr=inside,
        stdout=subprocess.DEVNULL,
        env=os.environ | {"TERM": "xterm", "COLUMNS": "100"},
    ) as process:
        os.close(inside)
        shown = b""
        try:
            while part := os.read(outside, 65536):
                shown += part
        except OSError:  # the terminal is closed
            pass
    os.close(outside)
    assert process.returncode == 0
    assert b"Growing the network" in shown
    assert "━".encode() in shown


def test_ctrl_c_ends_at_once_with_130_and_no_file(bunny_file: Path, tmp_path: Path) -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "neuralmesh", bunny_file, "-n", "25000", "-o", "out.ply"],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
        # Shells have their background jobs ignore the signal.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as process:
        assert process.stderr is not None
        assert "28,088 points" in process.stderr.readline()
        time.sleep(0.5)
        sent = time.time()
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=30) == 130
        assert time.time() - sent < 0.5  # the sentence, and the end of the interpreter
        assert process.stderr.read() == "neuralmesh: Interrupted.\n"
    assert list(tmp_path.iterdir()) == []
