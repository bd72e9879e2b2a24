#!/usr/bin/env python3
"""Do rooms hold what their descriptions ask for, in numbers? Fidelity as InfiniBench defines it: counts and occupancy against the prompt.

    bench/programs/fidelity.py ROOMGEN DESCRIPTIONS.jsonl FOLDER [--jobs 2] [--seed 1] [--show] [-- options of compose]

Each description is composed (`roomgen compose`) and its scene.json counted here, from kinds' names and boxes alone. A demand
is a count of one kind, or seats, shelves, all things, the share of the floor; fidelity of a room is the share of its
demands that are met, of a file the mean over its rooms. FOLDER/fidelity.csv has every demand."""
import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import re
import statistics
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def read_kinds():
    kinds, names = {}, {}
    for file in sorted((ROOT / "data/kinds").glob("*.json")):
        document = json.loads(file.read_text())
        for name, kind in document.get("kinds", document).items():
            if isinstance(kind, dict):
                kinds[name] = kind
                for other in [name, *kind.get("names", []), *kind.get("loose_names", []), *kind.get("resembles", [])]:
                    names.setdefault(other, name)
    return kinds, names


KINDS, NAMES = read_kinds()


def lineage(kind):
    found = []
    while kind in KINDS and kind not in found:
        found.append(kind)
        kind = KINDS[kind].get("is", "")
    return found or [kind]


def planned(kind):
    return KINDS[kind].get("is", kind) if KINDS.get(kind, {}).get("variant") else kind


def kind_of(noun):
    """The kind that a noun names, or the one of its longest known ending; else the noun itself."""
    words = noun.lower().replace("-", " ").split()
    for first in range(len(words)):
        ending = " ".join(words[first:])
        if ending in NAMES:
            return planned(NAMES[ending])
    return noun


def counts_of(scene, wanted):
    """Per demanded kind: nouns, bounds and how many things are it; a thing counts for the nearest demanded kind it is of."""
    demands = {}
    for noun, (low, high) in wanted.items():
        nouns, lows, highs = demands.get(kind_of(noun), ([], 0, 0))
        demands[kind_of(noun)] = (nouns + [noun], lows + (low or 0), None if high is None or highs is None else highs + high)
    numbers = dict.fromkeys(demands, 0)
    for thing in scene["objects"]:
        line = lineage(thing["category"]) + [kind_of(thing["category"])]
        nearest = next((kind for kind in line if kind in demands), None)
        if nearest is not None:
            numbers[nearest] += 1
    return [(" and ".join(nouns), (low, high), numbers[kind]) for kind, (nouns, low, high) in demands.items()]


def seats_of(thing):
    line, width = lineage(thing["category"]), thing["size"][0]
    if "sofa" in line:
        return 2 if width < 1.91 else 3 if width < 2.55 else 4
    if "bench" in line:
        return max(1, math.floor(width / 0.5 + 0.01))
    return 1 if "seat" in line and "ottoman" not in line else 0


def shelves_of(thing):
    return int(any("shelf" in k or "shelving" in k or "bookcase" in k or k == "etagere" for k in lineage(thing["category"]))
               and thing.get("mount", "floor") == "floor")


def area(points):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2


def occupancy(scene):
    """By counting 2 cm cells: nothing of the optimiser's own arithmetic."""
    polygon = scene["room"]["polygon"]
    low = [min(p[i] for p in polygon) for i in (0, 1)]
    high = [max(p[i] for p in polygon) for i in (0, 1)]
    cell = 0.02
    columns, rows = (math.ceil((high[i] - low[i]) / cell) for i in (0, 1))
    covered = set()
    for thing in scene["objects"]:
        traits = thing.get("traits", [])
        if thing.get("mount", "floor") != "floor" or "flat" in traits:
            continue
        width, depth = thing["size"][:2]
        turn = math.radians(thing.get("yaw_deg", 0.0))
        c, s = math.cos(turn), math.sin(turn)
        reach = math.hypot(width, depth) / 2
        x, y = thing["position"][:2]
        for i in range(max(0, int((x - reach - low[0]) / cell)), min(columns, int((x + reach - low[0]) / cell) + 1)):
            for j in range(max(0, int((y - reach - low[1]) / cell)), min(rows, int((y + reach - low[1]) / cell) + 1)):
                dx, dy = low[0] + (i + 0.5) * cell - x, low[1] + (j + 0.5) * cell - y
                u, v = (c * dx + s * dy) / (width / 2), (-s * dx + c * dy) / (depth / 2)
                if (u * u + v * v <= 1) if "round" in traits else (abs(u) <= 1 and abs(v) <= 1):
                    covered.add((i, j))
    return len(covered) * cell * cell / area(polygon)


def judge(scene, expect):
    demands = []

    def demand(name, bounds, value):
        low, high = bounds
        slack = 0.003 if name == "occupancy" else 0.0
        met = value >= (low or 0) - slack and (high is None or value <= high + slack)
        demands.append({"demand": name, "low": low, "high": high, "reached": round(value, 3), "met": int(met)})

    for noun, bounds, number in counts_of(scene, expect.get("counts", {})):
        demand(noun, bounds, number)
    for name, measure in (("seats", lambda: sum(map(seats_of, scene["objects"]))),
                          ("shelves", lambda: sum(map(shelves_of, scene["objects"]))),
                          ("objects", lambda: len(scene["objects"])), ("occupancy", lambda: occupancy(scene))):
        if expect.get(name):
            demand(name, expect[name], measure())
    return demands


def run_one(known, line, more):
    folder = known.folder / line["id"]
    start = time.monotonic()
    done = subprocess.run([known.roomgen, "compose", line["text"], "-o", folder, "--force", "--seed", str(known.seed),
                           "--no-pictures", "--quiet", "--json", *more], capture_output=True, text=True)
    row = {"id": line["id"], "seconds": time.monotonic() - start, "error": "", "demands": [], "unmet": 0, "valid": 0, "rounds": 0}
    if done.returncode != 0:
        empty = {"room": {"polygon": [[0, 0], [1, 0], [1, 1]]}, "objects": []}
        return row | {"error": done.stderr.strip()[-200:],
                      "demands": [d | {"met": 0} for d in judge(empty, line["expect"])]}
    said = json.loads(done.stdout)
    scene = json.loads((folder / "scene.json").read_text())
    checked = subprocess.run([known.roomgen, "check", folder / "scene.json"], capture_output=True, text=True)
    held = sum(c["held"] for c in said["constraints"])
    return row | {"demands": judge(scene, line["expect"]), "held": held, "constraints": len(said["constraints"]),
                  "valid": int(checked.returncode == 0), "rounds": said["rounds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("descriptions", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="ids, as P001,P007")
    parser.add_argument("--show", action="store_true", help="every demand that is not met (not of the kept half)")
    known, more = parser.parse_known_args()
    more = [option for option in more if option != "--"]
    lines = [json.loads(line) for line in known.descriptions.read_text().splitlines() if line.strip()]
    if known.only:
        lines = [line for line in lines if re.fullmatch("|".join(known.only.split(",")), line["id"])]
    known.folder.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(known.jobs) as pool:
        rows = list(pool.map(lambda line: run_one(known, line, more), lines))
    with open(known.folder / "fidelity.csv", "w", newline="") as out:
        writer = csv.DictWriter(out, ["id", "demand", "low", "high", "reached", "met"])
        writer.writeheader()
        for row in rows:
            writer.writerows({"id": row["id"], **demand} for demand in row["demands"])
    if known.show:
        for row, line in zip(rows, lines):
            lost = [f"{d['demand']} {d['low']}..{d['high']}: {d['reached']}" for d in row["demands"] if not d["met"]]
            if lost or row["error"] or not row["valid"]:
                print(row["id"], "valid" if row["valid"] else "INVALID", row["error"], "; ".join(lost))
    judged = [row for row in rows if row["demands"]]
    fidelity = statistics.mean(statistics.mean(d["met"] for d in row["demands"]) for row in judged)
    whole = sum(all(d["met"] for d in row["demands"]) for row in judged)
    met = sum(d["met"] for row in judged for d in row["demands"])
    demands = sum(len(row["demands"]) for row in judged)
    good = [row for row in rows if not row["error"]]
    held = sum(row["held"] for row in good) / max(1, sum(row["constraints"] for row in good))
    print(f"fidelity {fidelity:.3f}  demands met {met} of {demands}  rooms with all {whole} of {len(rows)}  constraints held "
          f"{held:.3f}  valid {sum(row['valid'] for row in rows)}  failed {len(rows) - len(good)}  rounds "
          f"{statistics.mean(row['rounds'] for row in good):.2f}  median {statistics.median(row['seconds'] for row in rows):.1f} s")


if __name__ == "__main__":
    main()
