#!/usr/bin/env python3
"""Compares what roomgen says that a model took with what its endpoint counted, in every way that one may behave.

    bill.py ROOMGEN FOLDER [--write bench/results/bill.json]

A bedroom for each mode of tests/designer/endpoint.py, over a real HTTP server. Prints Markdown.
"""

import argparse
import json
import platform
import subprocess
import sys
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "designer"))

from bill import MODES, OPTIONS, measure  # noqa: E402


def figures(roomgen, folder, mode):
    """Requests and tokens as the endpoint counted them, and as the summary has them."""
    code, summary, said, endpoint = measure(roomgen, folder / mode, mode, *OPTIONS.get(mode, []))
    if summary is None:
        raise SystemExit(f"{mode}: exit {code}: {said}")
    bill = summary["model"]
    return {
        "requests": endpoint.requests,
        "calls": bill["calls"],
        "tokens counted": endpoint.input_tokens + endpoint.output_tokens,
        "tokens billed": bill["input_tokens"] + bill["output_tokens"],
        "requests without a count": endpoint.uncounted,
        "calls estimated": bill["estimated_calls"],
        "places by rules": bill["fallbacks"],
    }


def report(values):
    commit = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"], capture_output=True, text=True)
    return {
        "what": "what roomgen says that a model took, against what the endpoint counted",
        "command": "bench/bill.py build/release/roomgen FOLDER",
        "machine": f"{platform.machine()}, {platform.system()}, loopback",
        "commit": commit.stdout.strip(),
        "date": date.today().isoformat(),
        "values": values,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--write", type=Path)
    args = parser.parse_args()
    values = []
    for mode in MODES:
        row = figures(args.roomgen, args.folder, mode)
        if not values:
            print("| mode | " + " | ".join(row) + " |\n" + "|---" * (1 + len(row)) + "|")
            columns = list(row)
        print(f"| {mode} | " + " | ".join(str(row[column]) for column in columns) + " |", flush=True)
        values += [{"name": f"{mode}: {key}", "value": value, "unit": key.split()[0]} for key, value in row.items()]
    if args.write:
        args.write.write_text(json.dumps(report(values), indent=1) + "\n")


if __name__ == "__main__":
    main()
