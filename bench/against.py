#!/usr/bin/env python3
"""Compares two builds of roomgen by processor time, run by run in turns: against.py BEFORE AFTER [--runs N]

For each prompt: the plan (a process), the whole of `generate` without pictures (a process), and what placing took by
the program's own clock. A table in Markdown with the medians and their ratios."""

import argparse
import json
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROMPTS = [
    ("12 things", "a bedroom", 5),
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--runs", type=int, default=7)
    options = parser.parse_args()
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
