#!/usr/bin/env python3
"""Scores rooms a second time, from scene.json alone, and compares with `roomgen evaluate`:
cross_check.py ROOMGEN SOURCE_DIR FOLDER

Makes a few rooms, asks of each how many there are of every kind and how pairs of its things stand to each other, and
recomputes the answers here: counts from the labels and names in data/, relations by points drawn in the boxes as
SceneEval draws them, the free floor on a map of its own. Verdicts near the limit of one half are not compared.
Needs numpy.
"""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np

PROMPTS = ["a bedroom with a double bed, two nightstands, a wardrobe and a desk with a laptop on it",
           "a living room with a sofa, a coffee table, a television on a tv stand and a bookshelf",
           "an office with two desks, two office chairs, a printer and a plant"]
SIDES = {"left": (0, -1), "right": (0, 1), "front": (1, -1), "behind": (1, 1), "above": (2, 1), "under": (2, -1)}
POINTS = 4000
UNSURE = 0.15  # points by chance and points on a grid differ by less


class Box:
    def __init__(self, thing):
        size, position = np.array(thing["size"]), np.array(thing["position"], float)
        self.half, self.center = size / 2, position + [0, 0, size[2] / 2]
        self.hangs = thing["mount"] == "wall"
        angle = math.radians(thing["yaw_deg"])
        self.turn = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])

    def draw(self, rng):
        return self.center + (rng.uniform(-1, 1, (POINTS, 3)) * self.half) @ self.turn.T

    def local(self, points):
        return (points - self.center) @ self.turn


def beyond(points, box, axis, sign, outside, margin):
    local = box.local(points)
    held = sign * local[:, axis] >= (box.half[axis] if outside else 0)
    for other in {0, 1, 2} - {axis}:
        held &= np.abs(local[:, other]) <= box.half[other] * (1 + margin)
    return held.mean()


def on_wall_side(word, target, anchor):
    """What hangs on walls: behind at any height, above and below a thin sheet in any depth near its wall."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    reach = anchor.local(target.center + (corners * target.half) @ target.turn.T)
    low, high, middle = reach.min(axis=0), reach.max(axis=0), anchor.local(target.center)
    if word == "behind":
        return (target.hangs and middle[1] > 0 and high[1] >= anchor.half[1] - 0.05
                and abs(middle[0]) <= anchor.half[0])
    if word not in ("above", "under") or not anchor.hangs or anchor.half[1] > 0.025:
        return False
    return ((1 if word == "above" else -1) * middle[2] >= anchor.half[2] and high[1] >= anchor.half[1] - 0.3
            and abs(middle[0]) <= max(anchor.half[0], (high - low)[0] / 2))


def relation(word, target, anchor, rng):
    points = target.draw(rng)
    on_top = beyond(points, anchor, 2, 1, False, 0)
    if word == "on":
        return on_top
    if word == "inside":
        return (np.abs(anchor.local(points)) <= anchor.half).all(axis=1).mean()
    if word == "center":
        return math.exp(-np.sum((target.center - anchor.center)[:2] ** 2) / (2 * 0.25**2))
    if on_wall_side(word, target, anchor):
        return 1
    axis, sign = SIDES[word]
    score = beyond(points, anchor, axis, sign, True, 0.25)
    if word == "under":  # also: in the lower half of the box, or the anchor on the target
        inside = (np.abs(anchor.local(points)) <= anchor.half).all(axis=1)
        below = anchor.local(points)[:, 2] <= 0
        score = max(score, (inside & below).mean(), beyond(anchor.draw(rng), target, 2, 1, False, 0))
    return score


def navigability(scene):
    """On a map of 256 x 256 cells, for rooms that are rectangles along the axes."""
    floor = np.array(scene["room"]["polygon"])
    low, high = floor.min(axis=0), floor.max(axis=0)
    scale = (high - low).max() / 2 + 0.2
    reach = int(0.2 / scale * 128) / 2 * scale / 128
    place = (np.arange(256) - 128) * scale / 128
    x, y = np.meshgrid(place + (low + high)[0] / 2, place + (low + high)[1] / 2)
    free = (x >= low[0] + reach) & (x <= high[0] - reach) & (y >= low[1] + reach) & (y <= high[1] - reach)
    for box in map(Box, scene["objects"]):
        if box.center[2] <= 2:
            points = np.stack([x.ravel(), y.ravel(), np.full(x.size, box.center[2])], axis=1)
            off = np.maximum(np.abs(box.local(points)) - box.half, 0)
            free &= (np.hypot(off[:, 0], off[:, 1]) > reach).reshape(free.shape)
    # Spread the largest label over touching cells until nothing changes.
    label = np.where(free, np.arange(free.size).reshape(free.shape) + 1, 0)
    while True:
        wide = np.pad(label, 1)
        most = np.max([wide[i:i + 256, j:j + 256] for i in range(3) for j in range(3)], axis=0) * free
        if (most == label).all():
            break
        label = most
    sizes = np.bincount(label[free])
    return sizes.max() / free.sum() if free.any() else 0


def kind_of(thing, seen):
    procedural = thing["asset"].get("procedural")
    if procedural:
        return procedural.get("params", {}).get("kind", procedural["recipe"])
    return seen.get(thing["asset"].get("library", ""), {}).get(thing["asset"].get("id", ""), {}).get("kind", "")


def check(roomgen, source, folder, number, prompt):
    room = folder / str(number)
    subprocess.run([roomgen, "--quiet", "generate", prompt, "-o", room, "--no-pictures", "--force"], check=True)
    scene = json.loads((room / "scene.json").read_text())
    things = {thing["id"]: thing for thing in scene["objects"]}
    seen = json.loads((source / "data/furniture-seen.json").read_text())["assets"]
    kinds = {name: kind_of(thing, seen) for name, thing in things.items()}
    categories = sorted({kind for kind in kinds.values() if kind})
    # One thing of a kind: a relation between two kinds is one between two things.
    single = [kind for kind in categories if list(kinds.values()).count(kind) == 1]
    pairs = [(word, a, b) for word in [*SIDES, "on", "inside", "center"] for a in single for b in single if a != b]
    row = {"ID": number, "Description": prompt, "Difficulty": "easy",
           "ObjCount": ";".join(f"ge,1,{kind}" for kind in categories),
           "OORel": ";".join(f"ge,1,{word},0,{b},{a}" for word, a, b in pairs)}
    rows = folder / f"{number}.csv"
    with open(rows, "w", newline="") as file:
        writer = csv.DictWriter(file, list(row))
        writer.writeheader()
        writer.writerow(row)
    told = json.loads(subprocess.run([roomgen, "--quiet", "--json", "evaluate", "--requirements", rows, room, "--id",
                                      str(number)], check=True, capture_output=True, text=True).stdout)["scores"][0]
    problems, compared = [], 0
    for kind, verdict in zip(categories, told["CNT"]):
        expected = sorted(name for name, own in kinds.items() if own == kind)
        compared += 1
        if sorted(told["matched"].get(kind, [])) != expected or not verdict["satisfied"]:
            problems.append(f"{kind}: {told['matched'].get(kind)} instead of {expected}")
    rng = np.random.default_rng(number)
    boxes = {kinds[name]: Box(thing) for name, thing in things.items()}
    shelves = json.loads((source / "data/evaluate/relations.json").read_text())["shelves"]
    for (word, a, b), verdict in zip(pairs, told["OOR"]):
        if word == "on" and any(b.endswith(shelf) for shelf in shelves):
            continue  # on a shelf may be in it
        score = relation(word, boxes[a], boxes[b], rng)
        if abs(score - 0.5) < UNSURE:
            continue
        compared += 1
        if verdict["satisfied"] != (score > 0.5):
            problems.append(f"{a} {word} {b}: {score:.2f}, told {verdict}")
    free = navigability(scene)
    compared += 1
    if abs(free - told["navigability"]) > 0.02:
        problems.append(f"free floor: {free:.3f} against {told['navigability']}")
    print(f"{prompt}: {compared} compared, {len(problems)} differ")
    return [f"{number}: {problem}" for problem in problems], compared


def main():
    roomgen, source, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    problems, compared = [], 0
    for number, prompt in enumerate(PROMPTS):
        found, count = check(roomgen, source, folder, number, prompt)
        problems += found
        compared += count
    print("\n".join(problems))
    sys.exit(1 if problems or compared < 100 else 0)


if __name__ == "__main__":
    main()
