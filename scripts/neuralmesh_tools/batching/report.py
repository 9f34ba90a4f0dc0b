# SPDX-License-Identifier: GPL-3.0-or-later
"""report.json and report.csv, made from the records of all items, whichever run did them."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from typing import Any

from neuralmesh_tools.batching.folder import OutFolder, Record
from neuralmesh_tools.batching.inputs import Item
from neuralmesh_tools.batching.left_out import LeftOut
from neuralmesh_tools.batching.recipe import Recipe
from neuralmesh_tools.files import shown, write_in_one_step
from neuralmesh_tools.machine import machine

COLUMNS = (
    "name",
    "input",
    "input_sha256",
    "output",
    "outcome",
    "error",
    "warning",
    "seconds",
    "peak_megabytes",
    "seed",
    "filter",
    "parameters",
    "versions",
    "finished",
    "host",
    "run",
)


def pending_record(item: Item) -> Record:
    """The report's line for an item that has not been done."""
    return {
        **dict.fromkeys(COLUMNS),
        "name": item.name,
        "input": shown(item.source),
        "outcome": "pending",
        "error": "It has not been done: the batch was stopped.",
        "results": {},
    }


def write_report(
    folder: OutFolder, records: Sequence[Record], recipe: Recipe, left_out: Sequence[LeftOut]
) -> None:
    """Write both files, in the order of the inputs, each in one step."""
    report = {
        "recipe": {
            "filter": "" if recipe.script else recipe.filter,
            "parameters": {} if recipe.script else recipe.parameters,
            "script": recipe.script,
            "versions": recipe.versions,
        },
        "machine": machine(),
        "items": len(records),
        "failed": sum(bool(record["error"]) for record in records),
        "doubtful": sum(bool(record.get("warning")) for record in records),
        "left_out": [{"path": shown(f.path), "kind": shown(f.kind)} for f in left_out],
        "records": list(records),
    }
    write_in_one_step(folder.root / "report.json", json.dumps(report, indent=1) + "\n")
    write_in_one_step(folder.root / "report.csv", _csv(records))


def _csv(records: Sequence[Record]) -> str:
    """One line an item; a result that is a list stays in report.json."""
    results = dict.fromkeys(
        name
        for record in records
        for name, value in record["results"].items()
        if name not in COLUMNS and not isinstance(value, list)
    )
    text = io.StringIO()
    table = csv.DictWriter(text, [*COLUMNS, *results], extrasaction="ignore", lineterminator="\n")
    table.writeheader()
    for record in records:
        table.writerow(
            {
                **record["results"],
                **record,
                "parameters": _pairs(record["parameters"]),
                "versions": _pairs(record["versions"]),
            }
        )
    return text.getvalue()


def _pairs(values: dict[str, Any] | None) -> str:
    return " ".join(f"{name}={value}" for name, value in (values or {}).items())
