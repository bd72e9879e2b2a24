#!/usr/bin/env python3
"""How many chairs stand at a table or desk in rooms that have chairs for their tables: seats.py ROOMGEN [--seeds N]

A chair is at a table when its middle is at most 0.35 m from the table's rectangle and it faces it (the ray ahead of it meets the
rectangle): told from the poses and sizes of scene.json alone. What is left out counts as not at a table.
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

PROMPTS = ["a classroom", "a classroom with eight desks and eight chairs", "a cafe", "a cafe with four tables and eight chairs",
           "an office with four desks and four chairs", "a restaurant with six round tables and 24 chairs",
           "a meeting room with a long table and ten chairs", "a library with three tables and twelve chairs",
           "a canteen with eight tables and 32 chairs", "a school room with 12 desks with a chair each"]
FARTHEST, AHEAD, STEP = 0.35, 0.8, 0.02


def is_chair(thing):
    return "chair" in thing["category"] and "armchair" not in thing["category"]


def is_table(thing):
    return thing["mount"] == "floor" and ("table" in thing["category"] or "desk" in thing["category"])


def distance(point, table):
    """From a point to the table's rectangle."""
    turn = math.radians(table["yaw_deg"])
    dx, dy = point[0] - table["position"][0], point[1] - table["position"][1]
    x, y = dx * math.cos(turn) + dy * math.sin(turn), -dx * math.sin(turn) + dy * math.cos(turn)
    return math.hypot(max(0.0, abs(x) - 0.5 * table["size"][0]), max(0.0, abs(y) - 0.5 * table["size"][1]))


def sits_at(chair, table):
    if distance(chair["position"], table) > FARTHEST:
        return False
    turn = math.radians(chair["yaw_deg"])
    ahead = (math.sin(turn), -math.cos(turn))  # the front is -y
    steps = [i * STEP for i in range(int(AHEAD / STEP) + 1)]
    return any(distance([chair["position"][0] + s * ahead[0], chair["position"][1] + s * ahead[1]], table) == 0.0 for s in steps)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--seeds", type=int, default=4)
    options = parser.parse_args()
    print("| room | chairs | at a table |\n|---|---|---|")
    chairs = seated = 0
    for prompt in PROMPTS:
        own = at_table = 0
        for seed in range(1, options.seeds + 1):
            with tempfile.TemporaryDirectory() as folder:
                room = pathlib.Path(folder) / "room"
                subprocess.run([options.program, "--quiet", "generate", prompt, "--seed", str(seed), "-o", room, "--no-pictures"],
                               check=True, capture_output=True)
                scene = json.loads((room / "scene.json").read_text())
            tables = [o for o in scene["objects"] if is_table(o)]
            here = [o for o in scene["objects"] if is_chair(o)]
            own += len(here) + sum(map(is_chair, scene["unplaced"]))
            at_table += sum(any(sits_at(chair, table) for table in tables) for chair in here)
        print(f"| {prompt} | {own} | {at_table} |")
        chairs, seated = chairs + own, seated + at_table
    print(f"| all | {chairs} | {seated} ({100.0 * seated / chairs:.1f} %) |")


if __name__ == "__main__":
    main()
