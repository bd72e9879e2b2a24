#!/usr/bin/env python3
"""Constraint programs over many seeds: are all constraints met, is every room valid, how long does it take?

    bench/programs/run.py ROOMGEN FOLDER [--programs FILE...] [--seeds 20] [--jobs 2] [-- more options of optimise]

Each room is examined by `roomgen check`. A line a program and one for all; FOLDER/runs.csv has every run."""
import argparse
import concurrent.futures
import csv
import json
import pathlib
import statistics
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "tests/data/programs").glob("*.json")) + sorted((ROOT / "examples/programs").glob("*.json"))


def run_one(roomgen, program, seed, folder, more):
    out = folder / f"{program.stem}-{seed}"
    start = time.monotonic()
    done = subprocess.run([roomgen, "optimise", program, "-o", out, "--force", "--seed", str(seed), "--no-pictures",
                           "--json", "--quiet", *more], capture_output=True, text=True)
    seconds = time.monotonic() - start
    row = {"program": program.stem, "seed": seed, "seconds": round(seconds, 2)}
    if done.returncode != 0:
        return row | {"error": done.stderr.strip()[-300:]}
    said = json.loads(done.stdout)
    checked = subprocess.run([roomgen, "check", out / "scene.json"], capture_output=True, text=True)
    return row | {"objects": said["objects"], "held": said["held"], "constraints": len(said["constraints"]),
                  "violation": said["violation"], "loss": said["loss"], "occupancy": said["occupancy"],
                  "moves": said["moves"]["tried"], "valid": int(checked.returncode == 0),
                  "faults": "" if checked.returncode == 0 else (checked.stdout + checked.stderr).strip()[-300:]}


def line(name, rows):
    good = [row for row in rows if "error" not in row]
    if not good:
        return f"{name:<16} no room: {rows[0]['error']}"
    met = sum(row["held"] == row["constraints"] for row in good)
    valid = sum(row["valid"] for row in good)
    seconds = statistics.median(row["seconds"] for row in good)
    things = statistics.mean(row["objects"] for row in good)
    covered = statistics.mean(row["occupancy"] for row in good)
    return (f"{name:<16} {met:4} of {len(rows)} met  {valid:4} valid  {things:5.1f} things  {100 * covered:4.1f} % covered  "
            f"{seconds:5.1f} s  {len(rows) - len(good)} failed")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--programs", nargs="+", type=pathlib.Path, default=EXAMPLES)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--jobs", type=int, default=1)
    known, more = parser.parse_known_args()
    more = [option for option in more if option != "--"]
    known.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(known.jobs) as pool:
        jobs = [pool.submit(run_one, known.roomgen, program, seed, known.folder, more)
                for program in known.programs for seed in range(1, known.seeds + 1)]
        for job in jobs:
            rows.append(job.result())
    keys = ["program", "seed", "seconds", "objects", "held", "constraints", "violation", "loss", "occupancy", "moves",
            "valid", "faults", "error"]
    with open(known.folder / "runs.csv", "w", newline="") as out:
        writer = csv.DictWriter(out, keys)
        writer.writeheader()
        writer.writerows(rows)
    for program in known.programs:
        print(line(program.stem, [row for row in rows if row["program"] == program.stem]))
    print(line("all", rows))


if __name__ == "__main__":
    main()
