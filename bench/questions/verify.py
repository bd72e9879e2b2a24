#!/usr/bin/env python3
"""Works out the answers of questions anew, from scene.json and from the pixels of the frames' instance layers.

    verify.py FOLDER...        each with scene.json (or beside it), frames.jsonl, frames/*.instance.png and questions.jsonl

Shares no code with roomgen. Prints what differs; exit code 1 if anything does.
"""

import json
import math
import re
import struct
import sys
import zlib
from collections import Counter
from pathlib import Path

import numpy as np

CLEAR, SEEN, FAINT = 0.004, 0.002, 0.0002  # shares of a picture, as docs/questions.md defines them
PARENTS = {}  # kind: its parent, from data/kinds


def read_kinds(folder):
    for file in sorted(folder.glob("*.json")):
        data = json.loads(file.read_text())
        kinds = data.get("kinds", data)
        for name, kind in kinds.items() if isinstance(kinds, dict) else ((k.get("name"), k) for k in kinds):
            if isinstance(kind, dict) and kind.get("is"):
                PARENTS[name] = kind["is"]


def is_a(kind, ancestor):
    while kind:
        if kind == ancestor:
            return True
        kind = PARENTS.get(kind)
    return False


def read_png16(path):
    """A grey PNG of 16 bits as an array."""
    data = path.read_bytes()
    width, height, bits, color = struct.unpack(">IIBB", data[16:26])
    assert (bits, color) == (16, 0), path
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + length]
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 2 * width)
    out = np.zeros((height, 2 * width), np.uint8)
    for y in range(height):
        method, line = rows[y, 0], rows[y, 1:]
        if method == 0:
            out[y] = line
        elif method == 1:
            out[y] = np.cumsum(line.reshape(width, 2), axis=0, dtype=np.uint64).astype(np.uint8).reshape(-1)
        elif method == 2:
            out[y] = line + (out[y - 1] if y else 0)
        else:
            raise ValueError(f"{path}: filter {method}")
    return out.view(">u2").astype(np.uint16)


class Room:
    def __init__(self, folder):
        scene = folder / "scene.json"
        self.scene = json.loads((scene if scene.exists() else folder.parent / "scene.json").read_text())
        self.objects = {o["id"]: o for o in self.scene["objects"]}
        self.numbers = {o["id"]: k for k, o in enumerate(self.scene["objects"])}
        self.frames = [json.loads(line) for line in (folder / "frames.jsonl").read_text().splitlines()]
        count = len(self.objects)
        self.shares = np.zeros((len(self.frames), count))
        for f, frame in enumerate(self.frames):
            pixels = read_png16(folder / frame["files"]["instance"])
            sums = np.bincount(pixels.reshape(-1), minlength=count + 1)[1 : count + 1]
            self.shares[f] = sums / pixels.size

    def first(self, name, share, start=0):
        found = np.nonzero(self.shares[start:, self.numbers[name]] >= share)[0]
        return start + int(found[0]) if len(found) else math.inf

    def frame(self, number):
        return next(f for f in self.frames if f["frame"] == number)

    def row(self, number):
        return next(k for k, f in enumerate(self.frames) if f["frame"] == number)

    def stops(self):
        return [f["target"] for f in self.frames if f.get("target")]


def floor_place(thing):
    return np.array(thing["position"][:2])


def outline(thing):
    w, d = thing["size"][:2]
    yaw = math.radians(thing.get("yaw_deg", 0))
    c, s = math.cos(yaw), math.sin(yaw)
    if "round" in thing.get("traits", []):
        angles = np.linspace(0, 2 * math.pi, 721)
        local = np.stack([0.5 * w * np.cos(angles), 0.5 * d * np.sin(angles)], 1)
    else:
        local = np.array([[-w, -d], [w, -d], [w, d], [-w, d], [-w, -d]]) / 2
    return floor_place(thing) + local @ np.array([[c, s], [-s, c]])


def point_distance(point, line):
    a, b = line[:-1], line[1:]
    along = b - a
    t = np.clip(((point - a) * along).sum(1) / np.maximum((along**2).sum(1), 1e-12), 0, 1)
    return float(np.min(np.linalg.norm(a + t[:, None] * along - point, axis=1)))


def gap(a, b):
    one, other = outline(a), outline(b)
    return min(min(point_distance(p, other) for p in one), min(point_distance(p, one) for p in other))


def polygon_area(points):
    p = np.array(points)
    x, y = p[:, 0], p[:, 1]
    return abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))) / 2


def ahead(frame):
    m = np.array(frame["camera"]["world_from_camera"])
    return m[:3, 3], m[:3, 2]


def angle_from_view(room, frame, name):
    eye, looks = ahead(frame)
    way = floor_place(room.objects[name]) - eye[:2]
    return math.degrees(math.acos(np.clip(np.dot(looks[:2], way) / np.linalg.norm(looks[:2]) / np.linalg.norm(way), -1, 1)))


def expect(room, q):
    """The true number, the true choice, or a complaint."""
    form, arguments = q["form"], q["arguments"]
    thing = {place: room.objects[name] for place, name in arguments.items() if isinstance(name, str) and name in room.objects}
    if form == "height":
        return thing["a"]["size"][2]
    if form == "length":
        return max(thing["a"]["size"][:2])
    if form == "area":
        return thing["a"]["size"][0] * thing["a"]["size"][1]
    if form == "room area":
        return polygon_area(room.scene["room"]["polygon"])
    if form == "distance":
        return float(np.linalg.norm(floor_place(thing["a"]) - floor_place(thing["b"])))
    if form == "gap":
        return gap(thing["a"], thing["b"])
    if form == "count":
        return sum(is_a(o["category"], arguments["kind"]) and room.first(name, CLEAR) < math.inf for name, o in room.objects.items())
    if form == "side":
        a, b, c = (floor_place(thing[p]) for p in "abc")
        turn = (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]
        return "on the left" if turn > 0 else "on the right"
    if form == "behind":
        frame, right = room.frame(arguments["frame"]), arguments["right"]
        if frame.get("target") != arguments["a"] or angle_from_view(room, frame, right) < 119.9:
            return "not behind"
        row = room.row(arguments["frame"])
        if room.shares[row, room.numbers[right]] > 0:
            return "in the picture"
        others = [name for name in q["objects"] if name not in (right, arguments["a"])]
        wrong = [n for n in others if n in room.objects and room.shares[row, room.numbers[n]] < CLEAR and angle_from_view(room, frame, n) > 90]
        # Things that descriptions name besides are no choices.
        wrong = [n for n in wrong if any(room.objects[n]["category"] == c.removeprefix("the ") for c in q["choices"])]
        return "another is behind: " + wrong[0] if wrong else q["answer"]
    if form == "order":
        order = arguments["order"]
        for one, next_one in zip(order, order[1:]):
            if room.first(one, SEEN) >= room.first(next_one, FAINT):
                return f"{next_one} may come first"
        return q["answer"]
    if form == "first":
        right, row = arguments["right"], room.row(arguments["frame"])
        if room.frames[row]["target"] != arguments["a"] or any(room.shares[row, room.numbers[n]] >= FAINT for n in arguments["of"]):
            return "one is in sight at the stop"
        late = all(room.first(right, SEEN, row + 1) < room.first(n, FAINT, row + 1) for n in arguments["of"] if n != right)
        return q["answer"] if late else "another may come first"
    if form == "between":
        a, b = arguments["a"], arguments["b"]
        for name in arguments["of"]:
            surely_inside = room.first(a, SEEN) < room.first(name, FAINT) and room.first(name, SEEN) < room.first(b, FAINT)
            surely_outside = room.first(name, SEEN) < room.first(a, FAINT) or room.first(b, SEEN) < room.first(name, FAINT)
            if not (surely_inside if name == arguments["right"] else surely_outside or name in (a, b)):
                return f"{name} is on the wrong side"
        return q["answer"]
    if form == "carried":
        return q["answer"] if thing["right"].get("on") == arguments["a"] else "not on it"
    if form == "carrier":
        return q["answer"] if thing["a"].get("on") == arguments["right"] else "not on it"
    if form == "nearest":
        near = gap(thing["a"], thing["right"])
        for name in q["objects"]:
            other = room.objects[name]
            if name in (arguments["a"], arguments["right"]) or not any(c.endswith(other["category"]) for c in q["choices"]):
                continue
            if other.get("mount", "floor") == "floor" and gap(thing["a"], other) < near + 0.29:
                return f"{name} is as near"
        return q["answer"]
    if form == "in room":
        rooms = {r["id"]: r["type"] for r in room.scene.get("rooms", [])}
        return "the " + rooms[thing["a"]["room"]]
    if form == "kind":
        return room.objects[room.stops()[arguments["nth"] - 1]]["category"]
    if form == "in sight":
        row = room.row(arguments["frame"])
        return "yes" if room.shares[row, room.numbers[arguments["b"]]] > 0 else "no"
    if form == "color":
        return q["answer"]  # of the mesh: looked at by people
    return "unknown form"


def doubtful_neighbour(room, q):
    """A description "the KIND nearest to the OTHER" that does not mean one thing, or not one of the question's."""
    categories = Counter(o["category"] for o in room.objects.values())
    kinds = "|".join(re.escape(kind) for kind in sorted(categories, key=len, reverse=True))
    for text in [q["question"], *q.get("choices", [])]:
        for kind, other in re.findall(rf"the ({kinds}) nearest to the ({kinds})(?![\w-])", text):
            if categories[other] != 1:
                continue
            beside = next(o for o in room.objects.values() if o["category"] == other)
            near = sorted((gap(o, beside), name) for name, o in room.objects.items() if o["category"] == kind)
            if near[0][1] not in q["objects"] or (len(near) > 1 and near[1][0] < near[0][0] + 0.39):
                return f"which {kind} is nearest to the {other}?"
    return None


def round_slack(room, q):
    things = [room.objects[name] for name in q["arguments"].values() if name in room.objects]
    return sum(0.5 * max(thing["size"][:2]) for thing in things if "round" in thing.get("traits", [])) * (1 / math.cos(math.pi / 24) - 1)


def agrees(room, q, truth):
    if "choices" not in q:
        # Round things are circles here and have 24 sides there.
        return isinstance(truth, (int, float)) and abs(truth - q["answer"]) <= (0.002 + round_slack(room, q) if q["form"] == "gap" else 0.0006)
    return truth == q["answer"] and q["choices"][q["answer_index"]] == q["answer"] and len(set(q["choices"])) == len(q["choices"])


def complaint(room, q):
    """What is wrong with a question, or nothing."""
    truth = doubtful_neighbour(room, q) or expect(room, q)
    return None if agrees(room, q, truth) else f"{q['id']}: {q['question']} {q.get('choices', '')} {q['answer']}; here {truth}"


def main():
    read_kinds(Path(__file__).resolve().parents[2] / "data" / "kinds")
    checked, wrong = Counter(), 0
    for folder in map(Path, sys.argv[1:]):
        room = Room(folder)
        for line in (folder / "questions.jsonl").read_text().splitlines():
            q = json.loads(line)
            checked[q["form"]] += 1
            if found := complaint(room, q):
                wrong += 1
                print(f"{folder}: {found}")
    print(f"{sum(checked.values())} questions, {wrong} wrong: " + ", ".join(f"{form} {count}" for form, count in sorted(checked.items())))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
