"""Figures of benchmarks: bench/results/*.json, how they are read from what a command prints, and docs/benchmarks.md.

A file holds {"title"?, "what", "command", "machine", "commit", "date", "order"?, "values"}, and "page": false where it is
not for users; a value {"name", "value",
"unit", "note"?, "find"?}. `find` says where the command's output has it: [row, column] of the first Markdown table with
both ([row, column, n] of the n-th such table, -1 is the last), or a regular expression with one group.
"""

import collections
import datetime
import json
import os
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "bench/results"
PAGE = ROOT / "docs/benchmarks.md"
LONGEST_PAGE = 12 * 1024  # bytes: figures for users, and no diary

HEAD = """# Benchmarks

Made by `bench/run --docs` from the files in bench/results; do not edit it. `bench/run NAME` measures one of them again,
`bench/run --record NAME` also puts the figures into its file, `bench/run` alone lists them. In the commands `$OUT` is an
empty folder; most need a build of everything (`scripts/test` makes one). Figures are of the commit that is named, by
rules and offline; they depend on the furniture that is installed (Debian 12's `sweethome3d-furniture`).
"""


def load():
    """Results by name, in the order of the page."""
    files = {path.stem: json.loads(path.read_text()) for path in FOLDER.glob("*.json")}
    return dict(sorted(files.items(), key=lambda item: (item[1].get("order", 10**6), item[0])))


def save(name, result):
    """A line for each value, so that a change of one figure is a change of one line."""
    values = ",\n".join("  " + json.dumps(value, ensure_ascii=False) for value in result["values"])
    lines = [f" {json.dumps(key)}: {json.dumps(value, ensure_ascii=False)}" for key, value in result.items()
             if key != "values"]
    text = "{\n" + ",\n".join(lines) + f',\n "values": [\n{values}\n ]\n}}\n'
    (FOLDER / f"{name}.json").write_text(text)


def tables(text):
    """The Markdown tables of a text, each a list of rows of cells, the head first."""
    found, rows = [], []
    for line in [*text.splitlines(), ""]:
        if line.startswith("|"):
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not all(re.fullmatch(r":?-+:?", cell) for cell in cells):
                rows.append(cells)
        elif rows:
            found.append(rows)
            rows = []
    return found


def cell(text, row, column, which=1):
    """What the table has in that row and column; None where no table has both."""
    found = []
    for head, *rows in tables(text):
        wanted = [r for r in rows if r[0] == row] or [r for r in rows if r[0].startswith(row)]
        if column in head and wanted and head.index(column) < len(wanted[0]):
            found.append(wanted[0][head.index(column)])
    place = which - 1 if which > 0 else which
    return found[place] if -len(found) <= place < len(found) else None


def figure(text, find, before):
    """The figure that `find` tells of; a number of the same sort where the one before was one. None if it is not there."""
    if isinstance(find, str):
        match = re.search(find, text, re.MULTILINE)
        said = match and match.group(1)
    else:
        said = cell(text, *find)
    if said is None or isinstance(before, str):
        return said
    number = re.search(r"-?\d+(\.\d+)?", said.replace(",", ""))
    return number and type(before)(float(number[0]))


def record(name, text):
    """Puts what a benchmark printed into its file. Returns the names of the values that were not found: they stay, with
    the commit that they are of."""
    result, missing = load()[name], []
    for value in result["values"]:
        found = figure(text, value["find"], value["value"]) if "find" in value else None
        if found is not None:
            value["value"] = found
            if value.get("note", "").startswith("at "):
                del value["note"]
        else:
            missing.append(value["name"])
            value.setdefault("note", f"at {result['commit']}")
    git = ["git", "-C", str(ROOT), "rev-parse", "--short=8", "HEAD"]
    result["commit"] = subprocess.run(git, capture_output=True, text=True, check=True).stdout.strip()
    result["date"] = datetime.date.today().isoformat()
    # The benchmark itself may have kept all of its cores busy, but no more than that.
    busy = os.getloadavg()[0] > os.cpu_count() + 0.5
    result["machine"] = f"{os.cpu_count()} cores{', beside other work' if busy else ''}"
    save(name, result)
    return missing


def title(name, result):
    return result.get("title") or name.replace("-", " ").capitalize()


def section(name, result, usual_machine):
    commands = "; ".join(f"`{command}`" for command in result["command"].split("; "))
    machine = "" if result["machine"] == usual_machine else f", {result['machine']}"
    lines = [f"## {title(name, result)}", "", result["what"], "", "| | |", "|---|---|"]
    for value in result["values"]:
        said = value["value"] if isinstance(value["value"], str) else f"{value['value']:,}"
        note = f" ({value['note']})" if value.get("note") else ""
        lines.append(f"| {value['name']} | {said}{' ' if value['unit'] else ''}{value['unit']}{note} |")
    return "\n".join([*lines, "", f"{commands} ({result['commit']}, {result['date']}{machine})", ""])


def page():
    """docs/benchmarks.md as the results give it."""
    results = {name: result for name, result in load().items() if result.get("page", True)}
    usual = collections.Counter(result["machine"] for result in results.values()).most_common(1)[0][0]
    sections = [section(name, result, usual) for name, result in results.items()]
    return "\n".join([HEAD + f"Unless said otherwise the machine had {usual}.\n", *sections])
