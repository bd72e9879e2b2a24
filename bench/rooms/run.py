#!/usr/bin/env python3
"""Makes a room for every row of a CSV file and scores them: run.py ROOMGEN ROWS.csv FOLDER [--seed N] [--jobs N]
[--only 110,112] [--again] [--timeout S] [-- ARGUMENTS]

FOLDER/ID gets the room of each row's Description, FOLDER/ID.result.json exit code, seconds and messages,
FOLDER/scores.json and FOLDER/scores.md what `roomgen evaluate` says, FOLDER/table.md the table that is printed too.
A row whose room is there already is not made again unless --again. ARGUMENTS go to `roomgen generate` as they are.
"""

import argparse
import csv
import json
import statistics
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def generate(options, row, more):
    folder = options.folder / row["ID"]
    result_file = options.folder / f"{row['ID']}.result.json"
    if not options.again and result_file.exists() and (folder / "scene.json").exists():
        return
    command = [options.roomgen, "--quiet", "generate", row["Description"], "-o", folder, "--seed", str(options.seed)]
    start = time.monotonic()
    try:
        done = subprocess.run(command + more, capture_output=True, text=True, errors="replace", timeout=options.timeout)
        code, message = done.returncode, done.stderr.strip()
    except subprocess.TimeoutExpired:
        code, message = None, f"not done in {options.timeout:g} s"
    result = {"exit": code, "seconds": round(time.monotonic() - start, 3), "message": message}
    result_file.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")
    if code != 0:
        print(f"{row['ID']}: {message or f'exit {code}'}", file=sys.stderr)


def cell(share):
    return f"{share['percent']:.1f} % ({share['held']:g}/{share['of']:g})" if "percent" in share else "-"


def table(scores, results):
    columns = {"all": scores["total"], **scores.get("by_difficulty", {})}
    lines = ["| measure | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for measure in scores["total"]:
        lines.append(f"| {measure} | " + " | ".join(cell(column[measure]) for column in columns.values()) + " |")
    seconds = sorted(result["seconds"] for result in results)
    if seconds:
        lines += ["", f"{len(seconds)} rooms; seconds a room: median {statistics.median(seconds):.1f}, "
                  f"longest {seconds[-1]:.1f}; {sum(result['exit'] != 0 for result in results)} failed."]
    return "\n".join(lines) + "\n"


def main():
    own, more = sys.argv[1:], []
    if "--" in own:
        own, more = own[: own.index("--")], own[own.index("--") + 1 :]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("rows", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="more than one spoils the times")
    parser.add_argument("--only", help="IDs of rows")
    parser.add_argument("--again", action="store_true", help="also rooms that are there already")
    parser.add_argument("--timeout", type=float, default=300)
    options = parser.parse_args(own)
    with open(options.rows, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if options.only:
        wanted = set(options.only.split(","))
        rows = [row for row in rows if row["ID"] in wanted]
    options.folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(lambda row: generate(options, row, more), rows))

    results = [json.loads((options.folder / f"{row['ID']}.result.json").read_text()) for row in rows]
    scores_file = options.folder / "scores.json"
    # Rooms that cannot be read are told and end nothing.
    subprocess.run([options.roomgen, "--quiet", "evaluate", "--requirements", options.rows, "--rooms", options.folder,
                    "--json-file", scores_file, "--markdown", options.folder / "scores.md"],
                   stdout=subprocess.DEVNULL)
    text = table(json.loads(scores_file.read_text()), results)
    (options.folder / "table.md").write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main()
