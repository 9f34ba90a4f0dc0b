# SPDX-License-Identifier: GPL-3.0-or-later
"""Points as text: columns are those that the header names, and a count is a promise."""

from __future__ import annotations

from pathlib import Path

import neuralmesh
import pytest


@pytest.mark.parametrize(
    ("header", "row"),
    [
        ("GPS Time,X,Y,Z,Intensity", "1000.5,4.5,-2,1e3,7"),
        ("GPS Time;X;Y;Z;Intensity", "1000,5;4,5;-2;1e3;7"),
        ("GPS Time\tX\tY\tZ", "1000.5\t4.5\t-2\t1e3"),
        ("GPS Time\tX\tY\tZ", "1000.5 4.5 -2 1e3"),
        ("# GPS Time,X,Y,Z", "1000.5,4.5,-2,1e3"),
        ("# GPS_Time X Y Z\n# a note", "1000.5 4.5 -2 1e3"),
        ('"scalar one","Points:0","Points:1","Points:2"', "7,4.5,-2,1e3"),
        ('"a, b","Points:0","Points:1","Points:2"', "7,4.5,-2,1e3"),
        ('"scalar one" X Y Z', "7 4.5 -2 1e3"),
        (",x,y,z", "0,4.5,-2,1e3"),
        ("x,y,z,label", "4.5,-2,1e3,"),
        ("x y z", "4.5,-2,1e3"),
        ("Easting,Northing,Elevation", "4.5,-2,1e3"),
        ("id,Northing [m],Easting [m],Height [m]", "1,-2,4.5,1e3"),
        ("t [s] x [m] y [m] z [m]", "9 4.5 -2 1e3"),
        ("z_m,y_m,x_m", "1e3,-2,4.5"),
        ("Nx,Ny,Nz,Position X,Position Y,Position Z", "0,0,1,4.5,-2,1e3"),
        ("Height,X,Y,Z", "9,4.5,-2,1e3"),
    ],
)
def test_coordinates_are_the_columns_that_the_header_names(
    header: str, row: str, tmp_path: Path
) -> None:
    path = tmp_path / "a.csv"
    path.write_text(f"{header}\n{row}\n{row}\n", "utf-8")
    assert neuralmesh.read(path).points.tolist() == [[4.5, -2, 1000]] * 2


@pytest.mark.parametrize(
    "header", ["Point ID,X,Y,Z,R,G,B", "id,x [m],y [m],z [m],r,g,b", "id,x,y,z,RGB:0,RGB:1,RGB:2"]
)
def test_colours_are_the_columns_that_the_header_names(header: str, tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text(f"{header}\n1,4.5,-2,1e3,10,20,30\n", "utf-8")
    found = neuralmesh.read(path)
    assert found.points.tolist() == [[4.5, -2, 1000]]
    assert found.colours is not None
    assert found.colours.tolist() == [[10, 20, 30]]


@pytest.mark.parametrize(
    ("header", "row", "sentence"),
    [
        ("GPS Time X Y Z", "1000.5 4.5 -2 1e3", "its header has 5 titles, but its first line of"),
        ("# GPS Time X Y Z", "1000.5 4.5 -2 1e3", "its header has 5 titles, but its first line"),
        ("time,x,y,z", "4.5,-2,1e3", "its header has 4 titles, but its first line of points 3 num"),
        ("x,y,x,y,z", "1,2,3,4,5", "its header names a coordinate twice: 'x,y,x,y,z'"),
        ("lat,lon,depth", "4.5,-2,1e3", "its header names no coordinates, such as x, y and z: 'la"),
    ],
)
def test_a_header_that_does_not_fit_is_refused(
    header: str, row: str, sentence: str, tmp_path: Path
) -> None:
    (tmp_path / "a.csv").write_text(f"{header}\n{row}\n", "utf-8")
    with pytest.raises(ValueError, match=sentence):
        neuralmesh.read(tmp_path / "a.csv")


@pytest.mark.parametrize(
    "comment", ["# points as x y z", "# x y z of a long scan", "# X and Y and Z", "# note: x-ray"]
)
def test_prose_before_points_is_no_header(comment: str, tmp_path: Path) -> None:
    (tmp_path / "a.xyz").write_text(f"{comment}\n4.5 -2 1e3\n", "utf-8")
    assert neuralmesh.read(tmp_path / "a.xyz").points.tolist() == [[4.5, -2, 1000]]


@pytest.mark.parametrize(
    ("content", "counts"),
    [
        ("3\n1 2 3\n4 5 6\n", "of 3 points it holds 2"),
        ("2\n1 2 3\n4 5 6\n2\n7 8 9\n", "of 4 points it holds 3"),
    ],
)
def test_a_count_that_the_lines_do_not_keep_is_told(
    content: str, counts: str, tmp_path: Path
) -> None:
    (tmp_path / "a.pts").write_text(content, "utf-8")
    with pytest.raises(ValueError, match=f"it is cut short: {counts}"):
        neuralmesh.read(tmp_path / "a.pts")
