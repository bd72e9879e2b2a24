#!/usr/bin/env python3
"""Compares what roomgen says that a model took with what its endpoint counted, in every way that one may behave.

    bill.py ROOMGEN FOLDER [--write bench/results/bill.json]

A bedroom for each mode of tests/designer/endpoint.py, over a real HTTP server. Prints Markdown.
"""

import argparse
import json
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


def report(rows):
    """What the modes come to: of each a row of figures()."""
    commit = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True)
    counted = [row for row in rows if not row["requests without a count"]]
    values = {
        "ways in which the endpoint answers": (len(rows), "modes"),
        "calls of the summary are the endpoint's requests": (sum(r["requests"] == r["calls"] for r in rows), "modes"),
        "in which the endpoint counts every answer's tokens": (len(counted), "modes"),
        "tokens of the summary are those of the endpoint": (
            sum(r["tokens counted"] == r["tokens billed"] for r in counted), "modes"),
        "requests in all": (sum(r["requests"] for r in rows), "requests"),
    }
    return {
        "title": "The bill of language models",
        "what": "What `generate` says that a model took, against what an endpoint counted that answers as servers are "
                "reported to: thinking without an answer, errors inside a 200, event streams, no pictures, and so on.",
        "command": "bench/bill.py build/release/roomgen $OUT",
        "machine": "2 cores",
        "commit": commit.stdout.strip(),
        "date": date.today().isoformat(),
        "values": [{"name": name, "value": value, "unit": unit} for name, (value, unit) in values.items()],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--write", type=Path)
    args = parser.parse_args()
    rows = []
    for mode in MODES:
        row = figures(args.roomgen, args.folder, mode)
        if not rows:
            print("| mode | " + " | ".join(row) + " |\n" + "|---" * (1 + len(row)) + "|")
            columns = list(row)
        print(f"| {mode} | " + " | ".join(str(row[column]) for column in columns) + " |", flush=True)
        rows.append(row)
    if args.write:
        args.write.write_text(json.dumps(report(rows), indent=1) + "\n")


if __name__ == "__main__":
    main()
