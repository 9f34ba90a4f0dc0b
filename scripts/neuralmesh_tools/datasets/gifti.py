# SPDX-License-Identifier: GPL-3.0-or-later
"""GIFTI surfaces, as FreeSurfer exports them."""

from __future__ import annotations

import base64
import zlib
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from neuralmesh_tools.geometry import Faces, Points

TYPES = {"NIFTI_TYPE_FLOAT32": "<f4", "NIFTI_TYPE_INT32": "<i4"}


def read_gifti_surface(xml: bytes) -> tuple[Points, Faces]:
    """Read the point set (n, 3) and the triangles (m, 3) of a GIFTI surface.

    Covers what FreeSurfer's exports hold: base64 of zlib, little endian, row major.
    Raises ValueError on anything else.
    """
    arrays: dict[str, NDArray[np.generic]] = {}
    for node in ElementTree.fromstring(xml).iter("DataArray"):
        kind = node.attrib["DataType"]
        if node.attrib["Encoding"] != "GZipBase64Binary" or node.attrib["Endian"] != "LittleEndian":
            raise ValueError("GIFTI: only little-endian GZipBase64Binary arrays are read")
        if node.attrib["ArrayIndexingOrder"] != "RowMajorOrder" or kind not in TYPES:
            raise ValueError("GIFTI: only row-major float32 and int32 arrays are read")
        raw = zlib.decompress(base64.b64decode(node.findtext("Data") or ""))
        arrays[node.attrib["Intent"]] = np.frombuffer(raw, TYPES[kind]).reshape(-1, 3)
    points = arrays["NIFTI_INTENT_POINTSET"].astype(np.float64)
    return points, arrays["NIFTI_INTENT_TRIANGLE"].astype(np.int32)
