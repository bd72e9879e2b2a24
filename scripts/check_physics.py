"""What of a furnished room stays where it is: two seconds of MuJoCo with convex pieces by CoACD.

Furniture and what stands on it is free; the room, rugs, and what hangs from walls and ceilings are not.
Where a convex piece is in another thing at the start although the mesh is not (physics/bulges.py), it only
weighs, and the surface of the mesh itself is what touches.
Usage: check_physics.py [--json FILE] FOLDER..., each with scene.json and scene.glb.
"""

import argparse
import json
import math
import os
import sys

import mujoco
import numpy as np

from physics.bulges import bulges
from physics.glb import read_glb
from physics.pieces import convex_pieces
from physics.surface import sheets

SECONDS = 2.0
MOST_MOVED = 0.01  # metres
MOST_TILTED = 0.1  # radians
GOAL = 0.98
NEAR = 0.01  # metres about other things where the mesh itself may be touched
MOST_ROUNDS = 6  # of looking for bulging pieces


def numbers(values):
    return " ".join(f"{v:.6g}" for v in np.ravel(values))


def rotation(yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def rooms_of(scene):
    """The rooms of a dwelling, or the one that there is."""
    return scene["rooms"] if "rooms" in scene else [scene["room"]]


def edges_of(scene):
    """Both ends of every wall's inner face, the inside to the left, and the wall's height."""
    for room in rooms_of(scene):
        polygon = room["polygon"]
        for a, b in zip(polygon, polygon[1:] + polygon[:1]):
            yield np.array(a, float), np.array(b, float), room["height"]


def near_others(name, points, faces, boxes, edges):
    """Which triangles are near the floor, a wall or pieces of other things."""
    low, high = points[faces].min(1), points[faces].max(1)
    near = low[:, 2] < NEAR
    for other, pieces in boxes.items():
        for least, most in pieces if other != name else ():
            near |= ((low < most + NEAR) & (high > least - NEAR)).all(1)
    for a, b, _ in edges:
        along = (b - a) / np.linalg.norm(b - a)
        inward = (points[:, :2] - a) @ np.array([-along[1], along[0]])
        near |= (np.abs(inward[faces]) < NEAR).any(1)
    return near


def build(scene, meshes, bulging=None):
    """The MuJoCo model, and the names of the free bodies; of `bulging` pieces the mesh is touched."""
    bulging = bulging or {}
    assets, bodies, free = [], [], []
    pieces, boxes = {}, {}
    for thing in scene["objects"]:
        if thing["id"] not in meshes or "flat" in thing.get("traits", []):
            continue
        points, faces = meshes[thing["id"]]
        own = rotation(math.radians(thing["yaw_deg"]))
        position = np.array(thing["position"])
        found = convex_pieces((points - position) @ own, faces)
        if not found:
            print(f"  {thing['id']}: no solid piece, left out", file=sys.stderr)
            continue
        pieces[thing["id"]] = found
        turned = [piece @ own.T + position for piece in found]
        boxes[thing["id"]] = [(piece.min(0), piece.max(0)) for piece in turned]
    for thing in scene["objects"]:
        if thing["id"] not in pieces:
            continue
        points, faces = meshes[thing["id"]]
        own = rotation(math.radians(thing["yaw_deg"]))
        position = np.array(thing["position"])
        fixed = thing["mount"] in ("wall", "ceiling")
        geoms = ""
        for k, piece in enumerate(pieces[thing["id"]]):
            name = f"{thing['id']}/{k}"
            assets.append(f'<mesh name="{name}" vertex="{numbers(piece)}"/>')
            touch = ' contype="0" conaffinity="0"' if k in bulging.get(thing["id"], ()) else ""
            geoms += f'<geom name="{name}" type="mesh" mesh="{name}"{touch}/>'
        if thing["id"] in bulging:
            near = near_others(thing["id"], points, faces, boxes, edges_of(scene))
            for k, sheet in enumerate(sheets((points - position) @ own, faces[near])):
                name = f"{thing['id']}/sheet-{k}"
                assets.append(f'<mesh name="{name}" inertia="legacy" vertex="{numbers(sheet)}"/>')
                geoms += f'<geom name="{name}" type="mesh" mesh="{name}" mass="0"/>'
        half = math.radians(thing["yaw_deg"]) / 2
        joint = "" if fixed else "<freejoint/>"
        bodies.append(
            f'<body name="{thing["id"]}" pos="{numbers(position)}" '
            f'quat="{numbers([math.cos(half), 0, 0, math.sin(half)])}">{joint}{geoms}</body>')
        if not fixed:
            free.append(thing["id"])
    walls = ""
    for a, b, height in edges_of(scene):
        along = (b - a) / np.linalg.norm(b - a)
        outward = np.array([along[1], -along[0]])
        centre = 0.5 * (a + b) + 0.05 * outward
        walls += (
            f'<geom type="box" pos="{numbers([*centre, height / 2])}" '
            f'size="{numbers([np.linalg.norm(b - a) / 2, 0.05, height / 2])}" '
            f'euler="0 0 {math.degrees(math.atan2(along[1], along[0])):.6f}"/>')
    xml = f"""<mujoco><compiler angle="degree" balanceinertia="true" boundmass="1e-4" boundinertia="1e-8"/>
      <option timestep="0.002" integrator="implicitfast" cone="elliptic" impratio="10"/>
      <size memory="1G"/>
      <default><geom density="400" friction="0.8 0.005 0.0001" solref="0.006 1" condim="4"/></default>
      <asset>{''.join(assets)}</asset>
      <worldbody><geom type="plane" size="0 0 1"/>{walls}{''.join(bodies)}</worldbody></mujoco>"""
    return mujoco.MjModel.from_xml_string(xml), free


def set_up(scene, meshes):
    """The model at rest, without overlaps that only convex pieces have; and the free bodies' names."""
    bulging = {}
    for _ in range(MOST_ROUNDS):
        model, free = build(scene, meshes, bulging)
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        more = bulges(model, data, meshes)
        if not more:
            break
        for name, pieces in more.items():
            bulging.setdefault(name, set()).update(pieces)
    return model, data, free


def drop(folder):
    """For each free object how far it moved (metres) and tilted (radians)."""
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        scene = json.load(file)
    model, data, free = set_up(scene, read_glb(os.path.join(folder, "scene.glb")))
    before = {name: (data.body(name).xpos.copy(), data.body(name).xmat.reshape(3, 3).copy()) for name in free}
    while data.time < SECONDS:
        mujoco.mj_step(model, data)
    result = {}
    for name in free:
        moved = float(np.linalg.norm(data.body(name).xpos - before[name][0]))
        turn = before[name][1].T @ data.body(name).xmat.reshape(3, 3)
        angle = math.acos(min(1.0, max(-1.0, (np.trace(turn) - 1) / 2)))
        result[name] = (moved, angle)
    carriers = {thing["id"]: thing.get("on") for thing in scene["objects"]}
    return result, carriers


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--json", help="write the figures of every object to this file")
    arguments = parser.parse_args()
    total = stays = 0
    report = {}
    for folder in arguments.folders:
        result, carriers = drop(folder)
        fallen = {n: r for n, r in result.items() if not (r[0] < MOST_MOVED and r[1] < MOST_TILTED)}
        print(f"{folder}: {len(result) - len(fallen)} of {len(result)} stay")
        for name, (moved, angle) in fallen.items():
            on = f" on {carriers[name]}" if carriers.get(name) else ""
            print(f"  {name}{on}: moved {100 * moved:.1f} cm, turned {angle:.2f} rad")
        report[folder] = result
        total += len(result)
        stays += len(result) - len(fallen)
    share = stays / max(1, total)
    print(f"{stays} of {total} objects stay ({100 * share:.1f} %)")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump({"objects": total, "stay": stays, "rooms": report}, file, indent=1)
    return 0 if share >= GOAL else 1


if __name__ == "__main__":
    sys.exit(main())
