# SPDX-License-Identifier: GPL-3.0-or-later
"""Text as programs of many countries write it: read as it is meant, or refused in a sentence."""

from __future__ import annotations

from pathlib import Path

import neuralmesh
import pytest
from neuralmesh.files import text

EXPECTED = [[1.5, -2.25, 1500.0], [0.5, 3.0, 0.25]]


@pytest.mark.parametrize(
    "content",
    [
        "1,5\t-2,25\t1,5e3\n0,5\t3\t,25\n",
        "1,5 -2,25 1,5e3\n0,5 3 0,25\n",
        "1,5;-2,25;1500\n0,5;3;0,25\n",
        "3;3;3\n1,5;-2,25;1500\n0,5;3;0,25\n",
        '"1,5";"-2,25";"1500"\n"0,5";"3";"0,25"\n',
        '"1.5","-2.25","1500"\n"0.5","3","0.25"\n',
        '"1.5" "-2.25" "1500" "a, 5 b"\n"0.5" "3" "0.25" "c"\n',
        "1.5D+00 -2.25d0 1.5D+03\n5.D-1 3 .25D0\n",
        "x;y;z;note\n1,5;-2,25;1500;a, b\n0,5;3;0,25;12.5.2025 v1.2\n",
        "1.5\t-2.25 1500\n0.5\t3 0.25\n",
        "x y z time\n1,5 -2,25 1500 12:30:01.5\n0,5 3 0,25 12:30:02.5\n",
    ],
    ids=range(11),
)
def test_numbers_are_read_as_they_are_meant(content: str, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text(content, "utf-8")
    assert neuralmesh.read(tmp_path / "a.txt").points.tolist()[-2:] == EXPECTED


@pytest.mark.parametrize("encoding", ["latin-1", "utf-16", "utf-32", "utf-8", "utf-8-sig"])
def test_headers_are_read_in_any_encoding(encoding: str, tmp_path: Path) -> None:
    content = "# vermessen in Köln\r\nHöhe;Rechtswert;Hochwert\r\n1500;1,5;-2,25\r\n0,25;0,5;3\r\n"
    (tmp_path / "a.csv").write_bytes(content.encode(encoding))
    assert neuralmesh.read(tmp_path / "a.csv").points.tolist() == EXPECTED


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("1,5,2,5,3,5\n", "it is unknown whether commas part columns or decimals: '1,5,2,5,3,5'"),
        ("1,5, 2,5, 3,5\n", "it is unknown whether commas part columns or decimals"),
        ("1,5E+3,2,5E+0,3,5E+0\n", "it is unknown whether commas part columns or decimals"),
        ("1,5,2,5,0\n", "it is unknown whether commas part columns or decimals"),
        ("1,5,2,3\n1,5,2,5,3\n", "it is unknown whether commas part columns or decimals"),
        ('"1,500","2,5","3,5"\n', 'whether commas part decimals or thousands: "1,500"'),
        ("1,234 2.5 3\n", "some of its numbers have points and others commas"),
        ("1.5;2.5;3.5\n1,234;2;3\n", "some of its numbers have points and others commas"),
        ("1,234.5 2,345.5 3,456.5\n", "none of points: '1,234.5 2,345.5 3,456.5'"),
        ("1 2\n3 4\n", "its lines have fewer than three numbers, as '1 2' has"),
        ("1 2 3\n4 5 1.234,5\n", "none of points: '4 5 1.234,5'"),
        ("1 2 3\n4 5", "it is cut short, or its last line is none of points: '4 5'"),
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(
    content: str, sentence: str, tmp_path: Path
) -> None:
    (tmp_path / "a.txt").write_text(content, "utf-8")
    with pytest.raises(ValueError, match=sentence):
        neuralmesh.read(tmp_path / "a.txt")


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("1 2 3\n".encode("utf-16-le"), "it is not text, or UTF-16 without its mark"),
        ("1 2 3\n".encode("utf-16")[:-1], "it is cut short, or not text as its mark says"),
    ],
)
def test_what_is_no_text_says_so(content: bytes, sentence: str, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes(content)
    with pytest.raises(ValueError, match=sentence):
        neuralmesh.read(tmp_path / "a.txt")


def test_a_change_of_decimals_is_refused_in_a_later_block(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(text, "LINES", 2)
    (tmp_path / "a.txt").write_text("1.5 2 3\n1 2 3\n1,234 2 3\n", "utf-8")
    with pytest.raises(ValueError, match="some of its numbers have points and others commas"):
        neuralmesh.read(tmp_path / "a.txt")


@pytest.mark.parametrize(
    ("content", "points"),
    [
        ("x,y,z,r,g,b\n1,5,2,5,3,5\n", [[1, 5, 2]]),  # named
        ("1,-5,2,5,3,5\n", [[1, -5, 2]]),  # decimals have no sign
        ("1,2,3\n4,5,6\n", [[1, 2, 3], [4, 5, 6]]),  # decimals would leave two numbers
        ("1,2.5,3,4\n5,6,7,8\n", [[1, 2.5, 3], [5, 6, 7]]),  # decimals have points
    ],
)
def test_whole_numbers_between_commas_are_read_where_they_can_be_told(
    content: str, points: list[list[float]], tmp_path: Path
) -> None:
    (tmp_path / "a.csv").write_text(content, "utf-8")
    assert neuralmesh.read(tmp_path / "a.csv").points.tolist() == points


@pytest.mark.parametrize(
    ("name", "row", "colours"),
    [
        ("a.xyz", "1 2 3 0 0 1", None),  # a normal
        ("a.xyz", "1 2 3 0 0 -1", None),
        ("a.xyz", "1 2 3 256 0 0", None),
        ("a.xyz", "1 2 3 0 0 2", [0, 0, 2]),
        ("a.xyz", "1 2 3 0.5 9 8 7", [9, 8, 7]),
        ("a.xyz", "1 2 3 9 8 7 0.5", [9, 8, 7]),
        ("a.xyz", "1 2 3 9 8 7 6", None),  # either of both
        ("a.pts", "1 2 3 9 8 7 6", [8, 7, 6]),
        ("a.xyz", "1 2 3 9 8 7 0 0 -1", None),  # behind an intensity, or before a normal
    ],
)
def test_colours_are_told_from_normals(
    name: str, row: str, colours: list[int] | None, tmp_path: Path
) -> None:
    (tmp_path / name).write_text(f"{row}\n{row}\n", "utf-8")
    found = neuralmesh.read(tmp_path / name).colours
    assert (None if found is None else found[1].tolist()) == colours


def test_lines_of_an_obj_may_begin_with_blanks(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text("  v 1.5 -2.25 1500\n\tv\t0.5 3 0.25\n vn 0 0 1\n", "utf-8")
    assert neuralmesh.read(tmp_path / "a.obj").points.tolist() == EXPECTED
