#!/usr/bin/env python3
"""Furnishes the wishes of a file offline and counts what became of them.

    bench/designs/wishes.py build/release/roomgen WISHES.txt OUT.json [--designer book] [--seed 1] [--keep FOLDER] [--lines odd|even|all]

One wish a line. Counts: clauses met, not met and not judged; things left out; whether the book has a design of
the wish's kind of room; processor seconds (libraries and pictures of the meshes are read anew for each)."""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile


def furnish(roomgen, designer, wish, seed, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([roomgen, "generate", wish, "--designer", designer, "-o", str(folder), "--force", "--seed", str(seed), "--json"],
                          capture_output=True, text=True, stdin=subprocess.DEVNULL)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    row = {"wish": wish, "exit": done.returncode, "seconds": round(seconds, 2)}
    try:
        summary = json.loads(done.stdout)
    except json.JSONDecodeError:
        return {**row, "error": done.stderr.strip()[-300:]}
    plan = json.loads((folder / "plan.json").read_text())
    notes = [note for room in plan.get("rooms", [plan]) for note in room.get("notes", [])]
    verdicts = [one["verdict"] for one in summary["requirements"]]
    row.update(met=verdicts.count("met"), not_met=verdicts.count("not met"),
               not_judged=len(verdicts) - verdicts.count("met") - verdicts.count("not met"),
               objects=summary["objects"], left_out=len(summary["unplaced"]), type=summary.get("room_type", "dwelling"),
               lost=[one["clause"] for one in summary["requirements"] if one["verdict"] == "not met"],
               unplaced=[f"{one['id']}: {one['reason'][:120]}" for one in summary["unplaced"]],
               design=[note.split('"')[1] for note in notes if note.startswith("designed after")],
               of_kind=not any("the book has no design of" in note for note in notes))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("wishes", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--designer", default="book")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--lines", default="all", choices=["odd", "even", "all"])
    options = parser.parse_args()
    wishes = [line.strip() for line in options.wishes.read_text().splitlines() if line.strip()]
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for number, wish in enumerate(wishes, 1):
            if options.lines != "all" and (number % 2 == 1) != (options.lines == "odd"):
                continue
            folder = (options.keep or pathlib.Path(scratch)) / str(number)
            rows.append({"line": number, **furnish(options.roomgen, options.designer, wish, options.seed, folder)})
    good = [row for row in rows if "error" not in row]
    clauses = sum(row["met"] + row["not_met"] for row in good)
    times = sorted(row["seconds"] for row in good)
    values = {
        "wishes": len(rows), "failed": len(rows) - len(good),
        "of_their_kind_percent": round(100 * sum(row["of_kind"] for row in good) / max(1, len(rows)), 1),
        "clauses_met_percent": round(100 * sum(row["met"] for row in good) / max(1, clauses), 1), "clauses": clauses,
        "left_out_percent": round(100 * sum(row["left_out"] for row in good) / max(1, sum(row["objects"] + row["left_out"] for row in good)), 2),
        "objects_mean": round(sum(row["objects"] for row in good) / max(1, len(good)), 1),
        "seconds_median": times[len(times) // 2] if times else None,
    }
    options.out.write_text(json.dumps({"values": values, "rows": rows}, indent=1) + "\n")
    print(json.dumps(values))
    return 0


if __name__ == "__main__":
    sys.exit(main())
