#!/usr/bin/env python3
"""Compares two builds of roomgen by processor time, run by run in turns: against.py BEFORE AFTER [--runs N]

For each prompt: the plan (a process), the whole of `generate` without pictures (a process), and what placing took by
the program's own clock, meshes included. With --instructions, under callgrind: what planning and placing take without
meshes, files and tables, whatever else the machine does. Tables in Markdown with medians and ratios."""

import argparse
import json
import os
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROMPTS = [
    ("a bedroom", "a bedroom", 5),
    ("a living room", "a living room", 3),
    ("a kitchen", "a kitchen", 3),
    ("44 things", (HERE / "rooms/full-living-room.txt").read_text().strip(), 2),
]


def cpu_seconds(command):
    """Processor time of a process and of those it waited for, and what it printed."""
    before = os.times()
    output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    after = os.times()
    return (after.children_user + after.children_system - before.children_user - before.children_system), output


def placing_seconds(folder, output):
    """Builds of different ages write it in different places."""
    steps = json.loads(output).get("steps")
    if steps is None:
        lines = (folder / "trace.jsonl").read_text().splitlines()
        steps = [json.loads(line) for line in lines]
    return sum(step.get("seconds", 0.0) for step in steps)


def measure(roomgen, prompt, seed, folder):
    plan, _ = cpu_seconds([roomgen, "--quiet", "plan", prompt, "--seed", str(seed), "-o", str(folder / "plan.json")])
    room = folder / "room"
    whole, output = cpu_seconds([roomgen, "--quiet", "--json", "generate", prompt, "--seed", str(seed), "--no-pictures",
                                 "--force", "-o", str(room)])
    things = len(json.loads((room / "scene.json").read_text())["objects"])
    return {"plan": plan, "placing": placing_seconds(room, output), "whole": whole, "things": things}


# What belongs to planning and placing, in any build; what is in another of them is taken off. Tables are read once
# by each process, however many rooms it makes.
COUNTED = {r"RuleDesigner::plan\(": 1, r"RuleDesigner::place\(": 1, r"roomgen::place\(": 1, r"roomgen::improve\(": 1,
           r"roomgen::fit_rugs\(": 1, r"roomgen::dry_run\(": -1,
           r"StyleWords::built_in\(\) \[": -1}


def instructions(roomgen, prompt, seed, folder):
    """Millions of instructions of planning and placing, and of the whole process."""
    profile = folder / "callgrind"
    subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", roomgen, "--quiet", "generate", prompt,
                    "--seed", str(seed), "--no-pictures", "--force", "-o", str(folder / "room")],
                   capture_output=True, check=True)
    lines = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", str(profile)], capture_output=True,
                           text=True, check=True).stdout.splitlines()
    counts = [(int(found.group(1).replace(",", "")), line) for line in lines if (found := re.match(r"\s*([\d,]+) \(", line))]
    whole = next(count for count, line in counts if "PROGRAM TOTALS" in line)
    part = sum(sign * max((count for count, line in counts if re.search(pattern, line)), default=0)
               for pattern, sign in COUNTED.items())
    return part / 1e6, whole / 1e6


def compare_instructions(options):
    print("| room | planning and placing, million instructions | whole process |")
    print("|---|---|---|")
    for name, prompt, seed in PROMPTS:
        with tempfile.TemporaryDirectory() as place:
            before = instructions(options.before, prompt, seed, Path(place))
            after = instructions(options.after, prompt, seed, Path(place))
        cells = [f"{old:.0f} -> {new:.0f} ({old / new:.1f} times)" for old, new in zip(before, after)]
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--instructions", action="store_true", help="count instructions (valgrind), not seconds")
    options = parser.parse_args()
    if options.instructions:
        return compare_instructions(options)
    print("| room | things before, now | plan, s | placing, s | plan and placing | whole process, s |")
    print("|---|---|---|---|---|---|")
    for name, prompt, seed in PROMPTS:
        runs = {"before": [], "after": []}
        with tempfile.TemporaryDirectory() as place:
            for i in range(options.runs + 1):
                for side in runs:
                    folder = Path(place) / side
                    folder.mkdir(exist_ok=True)
                    result = measure(getattr(options, side), prompt, seed, folder)
                    if i > 0:  # the first fills caches
                        runs[side].append(result)

        def median(side, key):
            return statistics.median(run[key] for run in runs[side])

        def cell(key):
            old, new = median("before", key), median("after", key)
            return f"{old:.2f} -> {new:.2f} ({old / new:.1f} times)"

        both = statistics.median(
            (a["plan"] + a["placing"]) / (b["plan"] + b["placing"]) for a, b in zip(runs["before"], runs["after"]))
        things = f"{runs['before'][0]['things']}, {runs['after'][0]['things']}"
        print(f"| {name} | {things} | {cell('plan')} | {cell('placing')} | {both:.1f} times | {cell('whole')} |", flush=True)


if __name__ == "__main__":
    main()
