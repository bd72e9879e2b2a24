#!/usr/bin/env python3
"""Checks tours against geometry of its own: ways, shares that are hidden, and targets that could have been seen.

    check.py [--views N] [--places N] ROOM_FOLDER...      each with scene.json, scene.glb and tour/tour.json

Shares no code with roomgen: meshes are read from scene.glb and drawn into a depth buffer here. Per room N views are
drawn again, and each target that the tour did not see is looked for from N walkable places. Prints a line per room and
the sums; exit code 1 if a way is not free or a share lies beyond its range by more than 0.05.
"""

import argparse
import json
import math
import struct
import sys
from pathlib import Path

import numpy as np

NEAR = 0.05
SLACK = 0.05  # of shares: holes in foliage are solid here
PERSON = 1.8  # metres: what begins below is in the way


def read_meshes(path):
    """Triangles of each object in the room's frame, by its id."""
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    gltf = json.loads(data[20 : 20 + length])
    binary = data[28 + length :]

    def accessor(number):
        a = gltf["accessors"][number]
        view = gltf["bufferViews"][a["bufferView"]]
        kind = {5126: "<f4", 5125: "<u4", 5123: "<u2", 5121: "u1"}[a["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[a["type"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        return np.frombuffer(binary, kind, a["count"] * width, start).reshape(a["count"], width)

    meshes = {}
    for node in gltf["nodes"]:
        if "mesh" not in node:
            continue
        x, y, z, w = node.get("rotation", [0, 0, 0, 1])
        turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
        triangles = []
        for part in gltf["meshes"][node["mesh"]]["primitives"]:
            points = accessor(part["attributes"]["POSITION"]).astype(float) * node.get("scale", [1, 1, 1])
            points = points @ turn.T + node.get("translation", [0, 0, 0])
            points = np.stack([points[:, 0], -points[:, 2], points[:, 1]], 1)  # Y up to Z up
            triangles.append(points[accessor(part["indices"]).reshape(-1, 3)])
        extras = node.get("extras", {})
        meshes["shell" not in extras and extras.get("id") or node["name"]] = np.concatenate(triangles)
    return meshes


def rooms_of(scene):
    return scene.get("rooms") or [scene["room"]]


def edges_of(room):
    p = np.array(room["polygon"])
    return list(zip(p, np.roll(p, -1, axis=0)))


def pieces(room, number, is_open):
    """Of a wall, along it: what lies beside openings, and the openings themselves, as (from, to, opening or None)."""
    a, b = edges_of(room)[number]
    at, result = 0.0, []
    for o in sorted((o for o in room.get("openings", []) if o["wall"] == number and is_open(o)), key=lambda o: o["from"]):
        result += [(at, o["from"], None), (o["from"], o["to"], o)]
        at = o["to"]
    return result + [(at, float(np.linalg.norm(b - a)), None)]


def is_way(opening):
    """Doors between the rooms of a dwelling are passed; that to the outdoors is shut."""
    return "leads_to" in opening


def is_hole(opening):
    """Panes of windows hide nothing, but what is outdoors is nothing."""
    return is_way(opening) or opening["type"] == "window"


def walls_for_walking(scene):
    for room in rooms_of(scene):
        for number, (a, b) in enumerate(edges_of(room)):
            along = (b - a) / np.linalg.norm(b - a)
            for s0, s1, opening in pieces(room, number, is_way):
                if opening is None:
                    yield a + s0 * along, a + s1 * along


def wall_meshes(scene):
    """The inner faces of all walls, with holes: what hides one room from another."""
    triangles = []
    for room in rooms_of(scene):
        for number, (a, b) in enumerate(edges_of(room)):
            along = (b - a) / np.linalg.norm(b - a)
            for s0, s1, opening in pieces(room, number, is_hole):
                bands = [(0.0, room["height"])] if opening is None else [(0.0, opening["sill"]), (opening["head"], room["height"])]
                for low, high in bands:
                    if high - low < 1e-6 or s1 - s0 < 1e-6:
                        continue
                    p, q = a + s0 * along, a + s1 * along
                    c = [[*p, low], [*q, low], [*q, high], [*p, high]]
                    triangles += [[c[0], c[1], c[2]], [c[0], c[2], c[3]]]
    return np.array(triangles, float)


def split(triangles, longest=0.25):
    """Into such as have no edge longer than that, metres."""
    done = []
    while len(triangles):
        edges = np.linalg.norm(triangles - np.roll(triangles, -1, axis=1), axis=2)
        small = edges.max(1) <= longest
        done.append(triangles[small])
        t, k = triangles[~small], edges[~small].argmax(1)
        rows = np.arange(len(t))
        a, b, c = t[rows, k], t[rows, (k + 1) % 3], t[rows, (k + 2) % 3]
        middle = (a + b) / 2
        triangles = np.concatenate([np.stack([a, middle, c], 1), np.stack([middle, b, c], 1)])
    return np.concatenate(done)


class Camera:
    def __init__(self, camera, position, yaw, pitch):
        self.width, self.height = camera["width"], camera["height"]
        self.focal = camera["focal_length_px"][0]
        self.eye = np.array(position)
        c, s, cp, sp = math.cos(yaw), math.sin(yaw), math.cos(pitch), math.sin(pitch)
        ahead = np.array([s * cp, -c * cp, sp])
        right = np.array([-c, -s, 0.0])
        self.axes = np.stack([right, -np.cross(right, ahead), ahead])

    def see(self, points):
        """u, v and distance along the axis."""
        p = (points - self.eye) @ self.axes.T
        z = np.where(np.abs(p[..., 2]) < 1e-9, 1e-9, p[..., 2])
        return np.stack([self.width / 2 + self.focal * p[..., 0] / z, self.height / 2 + self.focal * p[..., 1] / z, p[..., 2]], -1)

    def depths(self, triangles, buffer):
        """Draws into a depth buffer; only what lies wholly before the eye."""
        t = self.see(triangles)
        t = t[(t[:, :, 2] > NEAR).all(1)]
        low = np.ceil(t[:, :, :2].min(1) - 0.5).astype(int).clip(0)
        high = np.floor(t[:, :, :2].max(1) - 0.5).astype(int)
        high = np.minimum(high, [self.width - 1, self.height - 1])
        size = (high - low + 1).clip(0)
        area = size[:, 0] * size[:, 1]
        keep = area > 0
        t, low, size, area = t[keep], low[keep], size[keep], area[keep]
        for chunk in np.array_split(np.arange(len(t)), max(1, int(area.sum() // 2_000_000) + 1)):
            if len(chunk) == 0:
                continue
            which = np.repeat(chunk, area[chunk])
            inside = np.arange(len(which)) - np.repeat(np.cumsum(area[chunk]) - area[chunk], area[chunk])
            x = low[which, 0] + inside % size[which, 0]
            y = low[which, 1] + inside // size[which, 0]
            a, b, c = t[which, 0], t[which, 1], t[which, 2]
            px, py = x + 0.5, y + 0.5
            whole = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
            whole = np.where(np.abs(whole) < 1e-12, np.inf, whole)
            wb = ((px - a[:, 0]) * (c[:, 1] - a[:, 1]) - (py - a[:, 1]) * (c[:, 0] - a[:, 0])) / whole
            wc = ((b[:, 0] - a[:, 0]) * (py - a[:, 1]) - (b[:, 1] - a[:, 1]) * (px - a[:, 0])) / whole
            wa = 1 - wb - wc
            hit = (wa >= 0) & (wb >= 0) & (wc >= 0)
            depth = 1 / (wa / a[:, 2] + wb / b[:, 2] + wc / c[:, 2])
            np.minimum.at(buffer, (y[hit], x[hit]), depth[hit])
        return buffer

    def empty(self):
        return np.full((self.height, self.width), np.inf)


def hidden_share(camera, meshes, target):
    """Of the target's pixels, those that others hide; and how many there are."""
    alone = camera.depths(meshes[target], camera.empty())
    mine = np.isfinite(alone)
    if not mine.any():
        return 1.0, 0
    rows, columns = np.nonzero(mine.any(1))[0], np.nonzero(mine.any(0))[0]
    box = (columns[0], rows[0], columns[-1] + 1, rows[-1] + 1)
    others = camera.empty()
    for name, triangles in meshes.items():
        if name == target:
            continue
        seen = camera.see(triangles.reshape(-1, 3))
        before = seen[:, 2] > NEAR
        if not before.any():
            continue
        s = seen[before]
        if s[:, 0].max() < box[0] or s[:, 0].min() > box[2] or s[:, 1].max() < box[1] or s[:, 1].min() > box[3]:
            continue
        camera.depths(triangles, others)
    return float((others[mine] < alone[mine] - 1e-4).mean()), int(mine.sum())


def outline_distance(thing, points):
    """Metres from the box of a thing, seen from above; below 0 inside."""
    yaw = math.radians(thing.get("yaw_deg", 0))
    c, s = math.cos(yaw), math.sin(yaw)
    local = np.abs((points - thing["position"][:2]) @ np.array([[c, -s], [s, c]]))
    beyond = local - np.array(thing["size"][:2]) / 2
    return np.where((beyond <= 0).all(-1), beyond.max(-1), np.linalg.norm(beyond.clip(0), axis=-1))


def blocks(thing, eye):
    flat = "flat" in thing.get("traits", []) or thing["category"] in ("curtain", "blind")
    bottom, top = thing["position"][2], thing["position"][2] + thing["size"][2]
    at_eye = bottom < eye + 0.1 and top > eye - 0.1
    on_floor = thing.get("mount", "floor") == "floor" and not flat and bottom < PERSON
    return on_floor or at_eye


def clearance(scene, points, eye):
    least = np.full(len(points), np.inf)
    for a, b in walls_for_walking(scene):
        along = b - a
        t = (((points - a) @ along) / (along @ along)).clip(0, 1)
        least = np.minimum(least, np.linalg.norm(a + t[:, None] * along - points, axis=1))
    for thing in scene["objects"]:
        if not blocks(thing, eye):
            continue
        if "round" in thing.get("traits", []):
            # Its box would ask too much of ways.
            around = np.linalg.norm(points - np.array(thing["position"][:2]), axis=-1) - min(thing["size"][:2]) / 2
            least = np.minimum(least, around)
        else:
            least = np.minimum(least, outline_distance(thing, points))
    return least


def all_in_picture(camera, thing):
    yaw = math.radians(thing.get("yaw_deg", 0))
    c, s = math.cos(yaw), math.sin(yaw)
    w, d, h = thing["size"]
    corners = np.array([[c * x - s * y, s * x + c * y, z] for x in (-w / 2, w / 2) for y in (-d / 2, d / 2) for z in (0, h)])
    seen = camera.see(corners + thing["position"])
    return (seen[:, 2] > NEAR).all() and (seen[:, :2] >= 0).all() and (seen[:, 0] <= camera.width).all() and (seen[:, 1] <= camera.height).all()


def walkable(scene, tour, start):
    """Places on a grid that can be walked to from the start."""
    eye, pitch = start[2], 0.1
    p = np.concatenate([room["polygon"] for room in rooms_of(scene)])
    xs, ys = np.arange(p[:, 0].min(), p[:, 0].max(), pitch), np.arange(p[:, 1].min(), p[:, 1].max(), pitch)
    grid = np.stack(np.meshgrid(xs, ys, indexing="ij"), -1)
    free = clearance(scene, grid.reshape(-1, 2), eye).reshape(grid.shape[:2]) >= tour["agent_radius"] + 0.02
    reached = np.zeros_like(free)
    near = np.argmin(np.where(free, np.linalg.norm(grid - start[:2], axis=-1), np.inf))
    stack = [np.unravel_index(near, free.shape)]
    while stack:
        i, j = stack.pop()
        if not (0 <= i < free.shape[0] and 0 <= j < free.shape[1]) or reached[i, j] or not free[i, j]:
            continue
        reached[i, j] = True
        stack += [(i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)]
    return grid[reached]


def could_be_seen(scene, meshes, tour, target, places, random, tries):
    thing = next(o for o in scene["objects"] if o["id"] == target)
    eye = tour["keyframes"][0]["position"][2]
    low, high = tour["hidden_range"]
    middle = np.array(thing["position"]) + [0, 0, thing["size"][2] / 2]
    away = outline_distance(thing, places)
    near = places[(away >= 0.3) & (away <= 4.0)]
    random.shuffle(near)
    for place in near[:tries]:
        way = middle - [*place, eye]
        pitch = math.atan2(way[2], math.hypot(way[0], way[1]))
        if abs(pitch) > math.radians(75):
            continue
        camera = Camera(tour["camera"], [*place, eye], math.atan2(way[0], -way[1]), pitch)
        if not all_in_picture(camera, thing):
            continue
        hidden, pixels = hidden_share(camera, meshes, target)
        if pixels >= 16 and low <= hidden <= high:
            return True
    return False


def check(folder, views, tries, random):
    scene, tour = json.loads((folder / "scene.json").read_text()), json.loads((folder / "tour" / "tour.json").read_text())
    names = {o["id"] for o in scene["objects"]}
    meshes = {name: m for name, m in read_meshes(folder / "scene.glb").items() if name in names}
    if len(rooms_of(scene)) > 1:
        # A name that no thing has. They are cut into small ones: what reaches behind the eye is not drawn.
        meshes[""] = split(wall_meshes(scene))
    keyframes = tour["keyframes"]
    figures = {"targets": len(tour["views"]) + len(tour["unseen"]), "seen": len(tour["views"]), "missed": 0, "checked": 0,
               "beyond": 0, "worst": 0.0, "tight": 9.0}
    if not keyframes:
        return figures
    p = np.array([k["position"] for k in keyframes])
    between = np.concatenate([p[:-1] + f * (p[1:] - p[:-1]) for f in np.linspace(0, 1, 6)]) if len(p) > 1 else p
    figures["tight"] = float(clearance(scene, between[:, :2], p[0, 2]).min() - tour["agent_radius"])
    low, high = tour["hidden_range"]
    sample = random.permutation(len(tour["views"]))[:views]
    for view in (tour["views"][k] for k in sample):
        camera = Camera(tour["camera"], view["position"], math.radians(view["yaw_deg"]), math.radians(view["pitch_deg"]))
        hidden, _ = hidden_share(camera, meshes, view["target"])
        figures["checked"] += 1
        figures["worst"] = max(figures["worst"], abs(1 - hidden - view["visible_share"]))
        figures["beyond"] += not (low - SLACK <= hidden <= high + SLACK)
    places = walkable(scene, tour, p[0]) if tour["unseen"] else []
    for target in tour["unseen"]:
        if could_be_seen(scene, meshes, tour, target["target"], places, random, tries):
            figures["missed"] += 1
            print(f"  {folder.name}: {target['target']} could be seen: {target['cause']}")
    return figures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("rooms", type=Path, nargs="+")
    parser.add_argument("--views", type=int, default=4)
    parser.add_argument("--places", type=int, default=40)
    options = parser.parse_args()
    random = np.random.default_rng(1)
    sums = {}
    for folder in options.rooms:
        figures = check(folder, options.views, options.places, random)
        print(folder.name, figures)
        for key, value in figures.items():
            sums[key] = min(sums.get(key, 9.0), value) if key == "tight" else max(sums.get(key, 0.0), value) if key == "worst" else sums.get(key, 0) + value
    visible = sums["seen"] + sums["missed"]
    print(f"{len(options.rooms)} rooms: {sums['targets']} targets, {sums['seen']} seen, {sums['missed']} missed "
          f"({100 * sums['seen'] / max(visible, 1):.1f} % of what could be seen); {sums['checked']} views drawn again, "
          f"{sums['beyond']} beyond their range, shares differ by {sums['worst']:.3f} at most; "
          f"least clearance beyond the radius {sums['tight']:.4f} m")
    return 1 if sums["beyond"] or sums["tight"] < -0.001 else 0


if __name__ == "__main__":
    sys.exit(main())
