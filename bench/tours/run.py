#!/usr/bin/env python3
"""Rooms, tours, frames and questions by the list bench/tours/rooms.csv, checked by geometry of their own; prints tables.

    run.py ROOMGEN FOLDER [--jobs N] [--only sparse,dense] [--seeds N] [--size 320x240] [--fps 2] [--per-form 40]

Needs numpy (build/venv/bin/python has it). A row of the list is a prompt with so many seeds. FOLDER/NAME gets the room with
its tour, frames (of the instance layer) and questions, and steps.json: processor seconds of each command, what check.py
and ../questions/verify.py find. What steps.json has is not done again: a run that was killed goes on where it was.
FOLDER/tables.md has what is printed. Exit code 1 if a view or an answer is wrong, or a way is not free.
"""

import argparse
import csv
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import zlib
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "questions")]
import check  # noqa: E402
import guess  # noqa: E402
import verify  # noqa: E402

VIEWS, PLACES = 4, 40  # of a room: drawn again; looked from at what a tour did not see


def rooms_of(options):
    with open(options.list, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for number, row in enumerate(rows):
        if options.only and row["level"] not in options.only.split(","):
            continue
        for seed in range(min(int(row["seeds"]), options.seeds)):
            yield {"name": f"{row['level']}-{number:02d}-{seed}", "level": row["level"], "prompt": row["prompt"], "seed": seed}


def seconds_of(command):
    """Processor seconds of a command and of what it started."""
    with tempfile.TemporaryFile() as messages:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=messages)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            messages.seek(0)
            raise SystemExit(f"{' '.join(map(str, command))}: exit {process.returncode}: {messages.read().decode(errors='replace')}")
    return round(usage.ru_utime + usage.ru_stime, 3)


def verified(folder):
    room, count, wrong = verify.Room(folder / "tour"), 0, []
    for line in (folder / "tour" / "questions.jsonl").read_text().splitlines():
        question = json.loads(line)
        count += 1
        complaint = verify.complaint(room, question)
        if complaint:
            wrong.append(complaint)
    return {"questions": count, "wrong": wrong}


def triangles_of(folder):
    meshes = check.read_meshes(folder / "scene.glb")
    names = {thing["id"] for thing in json.loads((folder / "scene.json").read_text())["objects"]}
    return sum(len(mesh) for name, mesh in meshes.items() if name in names)


def do_room(options, room):
    folder = options.folder / room["name"]
    tour, scene = folder / "tour", folder / "scene.json"
    steps_file = options.folder / f"{room['name']}.steps.json"
    steps = json.loads(steps_file.read_text()) if steps_file.exists() else {}
    steps = {step: value for step, value in steps.items() if step not in options.again.split(",")}
    quiet = [options.roomgen, "--quiet"]
    commands = {
        "generate": quiet + ["generate", room["prompt"], "--seed", str(room["seed"]), "--no-pictures", "--force", "-o", folder],
        "tour": quiet + ["tour", scene, "-o", tour],
        "frames": quiet + ["frames", scene, "--tour", tour, "--layers", "instance", "--threads", "1", "--size", options.size, "--fps", options.fps],
        "questions": quiet + ["questions", scene, "--tour", tour, "--per-form", options.per_form],
    }

    def keep(step, value):
        steps[step] = value
        steps_file.write_text(json.dumps(steps, indent=1) + "\n")

    for step, command in commands.items():
        if step not in steps:
            keep(step, seconds_of(command))
    if "scene" not in steps:
        frames = (tour / "frames.jsonl").read_text().count("\n")
        read = json.loads(scene.read_text())
        keep("scene", {"objects": len(read["objects"]), "rooms": max(1, len(read.get("rooms", []))), "triangles": triangles_of(folder),
                       "frames": frames})
    if "check" not in steps:
        # Not hash(): that is another one in every run.
        keep("check", check.check(folder, VIEWS, PLACES, np.random.default_rng(zlib.crc32(room["name"].encode()))))
    if "verify" not in steps:
        keep("verify", verified(folder))
    print(f"{room['name']}: {steps['check']['seen']} of {steps['check']['targets']} targets, {steps['verify']['questions']} questions, "
          f"{len(steps['verify']['wrong'])} wrong", file=sys.stderr, flush=True)
    return {**room, **steps}


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|"] + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def sight_row(name, rooms):
    checks = [room["check"] for room in rooms]
    total = lambda key: sum(one[key] for one in checks)
    visible = total("seen") + total("missed")
    return [name, len(rooms), f"{total('seen')} of {total('targets')}", total("missed"), f"{100 * total('seen') / max(visible, 1):.1f} %",
            total("checked"), total("beyond"), f"{max(one['worst'] for one in checks):.3f}", f"{min(one['tight'] for one in checks):.3f} m",
            sum(room["verify"]["questions"] for room in rooms), sum(len(room["verify"]["wrong"]) for room in rooms)]


def cost_row(name, rooms):
    middle = lambda values: statistics.median(list(values))
    a_target = middle(room["tour"] / max(1, room["check"]["targets"]) for room in rooms)
    a_frame = middle(room["frames"] / room["scene"]["frames"] for room in rooms)
    a_question = middle(room["questions"] / max(1, room["verify"]["questions"]) for room in rooms)
    return [name, len(rooms), f"{middle(room['scene']['triangles'] for room in rooms):.0f}", f"{middle(room['generate'] for room in rooms):.1f}",
            f"{middle(room['tour'] for room in rooms):.1f}", f"{max(room['tour'] for room in rooms):.1f}", f"{a_target:.2f}", f"{a_frame:.3f}",
            f"{middle(room['questions'] for room in rooms):.2f}", f"{1 / a_question:.0f}"]


def groups(rooms, value, bounds):
    for low, high in zip(bounds, bounds[1:]):
        inside = [room for room in rooms if low <= value(room) < high]
        if inside:
            yield (f"{low}" if high == low + 1 else f"{low} to {high - 1}"), inside


def tables(rooms, options):
    levels = list(dict.fromkeys(room["level"] for room in rooms))
    text = table(["rooms", "number", "targets seen", "missed, though visible", "seen of those visible", "views drawn again", "beyond the range",
                  "greatest difference of a share", "least clearance beyond the radius", "answers verified", "wrong"],
                 [sight_row(level, [room for room in rooms if room["level"] == level]) for level in levels] + [sight_row("all", rooms)])
    head = ["rooms", "triangles", "generate, s", "tour, s", "longest", "a target, s", "a frame, s", "questions, s", "questions a second"]
    single = [room for room in rooms if room["scene"]["rooms"] == 1]
    text += f"\nMedians of processor seconds of whole commands; frames of the instance layer alone, {options.size}.\n\n"
    text += table(["objects"] + head, [cost_row(*group) for group in groups(single, lambda room: room["scene"]["objects"], (1, 6, 11, 16, 21, 31, 41, 61, 500))])
    if len(single) < len(rooms):
        text += "\n" + table(["rooms of a dwelling"] + head, [cost_row(*group) for group in groups(rooms, lambda room: room["scene"]["rooms"], (1, 2, 3, 4, 5, 6, 7, 8, 9))])
    questions = [(re.sub(r"-\d+$", "", room["name"]), json.loads(line)) for room in rooms
                 for line in (options.folder / room["name"] / "tour" / "questions.jsonl").read_text().splitlines()]
    return text + "\n" + guess.report(questions)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--list", type=Path, default=HERE / "rooms.csv")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", help="levels of the list")
    parser.add_argument("--seeds", type=int, default=1000, help="of a prompt at most")
    parser.add_argument("--again", default="", help="steps that are done anew: generate,tour,frames,questions,scene,check,verify")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--fps", default="2")
    parser.add_argument("--per-form", default="40")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    verify.read_kinds(HERE.parents[1] / "data" / "kinds")
    with ProcessPoolExecutor(options.jobs) as pool:
        rooms = list(pool.map(do_room, *zip(*((options, room) for room in rooms_of(options)))))
    for room in rooms:
        for complaint in room["verify"]["wrong"]:
            print(f"{room['name']}: {complaint}", file=sys.stderr)
    text = tables(rooms, options)
    (options.folder / "tables.md").write_text(text)
    print(text)
    bad = any(room["verify"]["wrong"] or room["check"]["beyond"] or room["check"]["tight"] < -0.001 for room in rooms)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
