"""What of a furnished room stays where it is: two seconds of MuJoCo with convex pieces by CoACD.

Furniture and what stands on it is free; the room, rugs, and what hangs from walls and ceilings are not.
Usage: check_physics.py [--json FILE] FOLDER..., each with scene.json and scene.glb.
"""

import argparse
import hashlib
import json
import math
import os
import struct
import sys

import coacd
import mujoco
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull, QhullError

SECONDS = 2.0
MOST_MOVED = 0.01  # metres
MOST_TILTED = 0.1  # radians
GOAL = 0.98
MOST_SHELLS = 250  # of a mesh, the largest; leaves of plants beyond them carry nothing
MOST_INTRICATE = 4  # of them cut into convex pieces, others count as their hulls
CACHE = os.path.join(os.environ.get("XDG_CACHE_HOME", os.path.expanduser("~/.cache")), "roomgen", "convex")


def read_glb(path):
    """Vertices and triangles of every node that has a mesh, in metres, Z up, by the node's name."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack("<I", data[12:16])[0]
    gltf = json.loads(data[20 : 20 + length])
    binary = data[20 + length + 8 :]

    def accessor(index):
        a = gltf["accessors"][index]
        view = gltf["bufferViews"][a["bufferView"]]
        kind = {5126: np.float32, 5125: np.uint32, 5123: np.uint16, 5121: np.uint8}[a["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[a["type"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        return np.frombuffer(binary, kind, a["count"] * width, start).reshape(a["count"], width)

    def matrix(node):
        if "matrix" in node:
            return np.array(node["matrix"], float).reshape(4, 4).T
        result = np.eye(4)
        x, y, z, w = node.get("rotation", [0, 0, 0, 1])
        result[:3, :3] = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        ) @ np.diag(node.get("scale", [1, 1, 1]))
        result[:3, 3] = node.get("translation", [0, 0, 0])
        return result

    found = {}

    def visit(index, parent, name):
        node = gltf["nodes"][index]
        to_world = parent @ matrix(node)
        name = node.get("name", name)
        if "mesh" in node:
            for part in gltf["meshes"][node["mesh"]]["primitives"]:
                points = accessor(part["attributes"]["POSITION"]).astype(float)
                points = points @ to_world[:3, :3].T + to_world[:3, 3]
                faces = accessor(part["indices"]).reshape(-1, 3).astype(np.int64)
                if np.linalg.det(to_world[:3, :3]) < 0:
                    faces = faces[:, ::-1]
                found.setdefault(name, []).append((points, faces))
        for child in node.get("children", []):
            visit(child, to_world, name)

    up = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)
    for root in gltf["scenes"][gltf.get("scene", 0)]["nodes"]:
        visit(root, up, "")
    meshes = {}
    for name, parts in found.items():
        start, points, faces = 0, [], []
        for p, f in parts:
            points.append(p)
            faces.append(f + start)
            start += len(p)
        meshes[name] = (np.vstack(points), np.vstack(faces))
    return meshes


def hull_of(points):
    """The hull's corners, and how deep the deepest point lies under it; sheets get a thickness of 1 mm."""
    points = np.unique(np.round(points, 6), axis=0)
    if len(points) < 3:
        return None
    centre = points.mean(0)
    _, spread, axes = np.linalg.svd(points - centre, full_matrices=False)
    if len(points) < 4 or spread[-1] / math.sqrt(len(points)) < 2e-4:
        points = np.vstack([points + 5e-4 * axes[-1], points - 5e-4 * axes[-1]])
    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):
        return None
    if hull.volume < 1e-9:
        return None
    equations = np.unique(np.round(hull.equations, 6), axis=0)
    depth = 0.0
    for start in range(0, len(points), 2000):
        under = -(points[start : start + 2000] @ equations[:, :3].T + equations[:, 3])
        depth = max(depth, float(under.min(1).max()))
    return points[hull.vertices], depth


def shells(points, faces):
    """The parts of a mesh that hang together, vertices at one place taken as one; the largest first."""
    _, same = np.unique(np.round(points, 5), axis=0, return_inverse=True)
    same = same.reshape(-1)
    joined = same[faces]
    rows = np.concatenate([joined[:, 0], joined[:, 1]])
    columns = np.concatenate([joined[:, 1], joined[:, 2]])
    count = int(same.max()) + 1
    graph = coo_matrix((np.ones(len(rows)), (rows, columns)), shape=(count, count))
    _, label = connected_components(graph, directed=False)
    of_face = label[joined[:, 0]]
    order = np.argsort(of_face, kind="stable")
    groups = np.split(faces[order], np.flatnonzero(np.diff(of_face[order])) + 1)
    return sorted(groups, key=lambda g: -np.prod(np.ptp(points[g.ravel()], axis=0) + 1e-3))


def decomposed(points, faces):
    used, index = np.unique(faces, return_inverse=True)
    parts = coacd.run_coacd(
        coacd.Mesh(points[used], index.reshape(-1, 3)), threshold=0.05, max_convex_hull=32,
        preprocess_mode="auto", preprocess_resolution=30, resolution=300, mcts_nodes=8,
        mcts_iterations=20, mcts_max_depth=2, seed=0)
    # Pieces are of a remeshed surface; they end where the mesh ends.
    low, high = points[used].min(0), points[used].max(0)
    return [np.clip(np.asarray(p, float), low, high) for p, _ in parts]


def convex_pieces(points, faces):
    """Arrays of points, one for each piece; kept between runs."""
    key = hashlib.sha256(np.round(points, 4).tobytes() + faces.tobytes()).hexdigest()[:24]
    path = os.path.join(CACHE, key + ".npz")
    if os.path.exists(path):
        with np.load(path) as file:
            return [file[name] for name in file.files]
    coacd.set_log_level("error")
    pieces, intricate = [], []
    for shell in shells(points, faces)[:MOST_SHELLS]:
        found = hull_of(points[np.unique(shell)])
        if found is None:
            continue
        size = np.linalg.norm(np.ptp(found[0], axis=0))
        if found[1] < max(0.002, 0.02 * size) or size < 0.04 or len(intricate) >= MOST_INTRICATE:
            pieces.append(found[0])
        else:
            intricate.append(shell)
    for shell in intricate:
        for piece in decomposed(points, shell):
            found = hull_of(piece)
            if found is not None:
                pieces.append(found[0])
    os.makedirs(CACHE, exist_ok=True)
    np.savez(path, *pieces)
    return pieces


def numbers(values):
    return " ".join(f"{v:.6g}" for v in np.ravel(values))


def rotation(yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def build(scene, meshes):
    """The MuJoCo model, and the names of the free bodies."""
    assets, bodies, free = [], [], []
    for thing in scene["objects"]:
        if thing["id"] not in meshes or "flat" in thing.get("traits", []):
            continue
        points, faces = meshes[thing["id"]]
        own = rotation(math.radians(thing["yaw_deg"]))
        position = np.array(thing["position"])
        pieces = convex_pieces((points - position) @ own, faces)
        if not pieces:
            print(f"  {thing['id']}: no solid piece, left out", file=sys.stderr)
            continue
        fixed = thing["mount"] in ("wall", "ceiling")
        geoms = ""
        for k, piece in enumerate(pieces):
            name = f"{thing['id']}/{k}"
            assets.append(f'<mesh name="{name}" vertex="{numbers(piece)}"/>')
            geoms += f'<geom type="mesh" mesh="{name}"/>'
        half = math.radians(thing["yaw_deg"]) / 2
        joint = "" if fixed else "<freejoint/>"
        bodies.append(
            f'<body name="{thing["id"]}" pos="{numbers(position)}" '
            f'quat="{numbers([math.cos(half), 0, 0, math.sin(half)])}">{joint}{geoms}</body>')
        if not fixed:
            free.append(thing["id"])
    walls = ""
    polygon = scene["room"]["polygon"]
    height = scene["room"]["height"]
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        a, b = np.array(a), np.array(b)
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


def drop(folder):
    """For each free object how far it moved (metres) and tilted (radians)."""
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        scene = json.load(file)
    model, free = build(scene, read_glb(os.path.join(folder, "scene.glb")))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
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
