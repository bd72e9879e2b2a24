"""What trimesh finds in GLB files: a line of JSON each."""

import json
import sys

import trimesh


def read(path):
    scene = trimesh.load(path, force="scene")
    edges = scene.graph.transforms.edge_data
    found = {}
    for (_, name), edge in edges.items():
        # A mesh of several materials hangs below its node as several more.
        extras = edge.get("metadata") or {}
        if name in scene.graph.nodes_geometry and not len(scene.geometry[scene.graph[name][1]].vertices):
            raise ValueError(f"{name} has no vertices")
        if "shell" not in extras and "id" in extras:
            found.setdefault(extras["id"], {"name": name, "id": extras["id"]})
    return list(found.values())


for file in sys.argv[1:]:
    try:
        print(json.dumps({"file": file, "nodes": read(file)}), flush=True)
    except Exception as error:  # whatever it is, it is the finding
        print(json.dumps({"file": file, "error": f"{type(error).__name__}: {error}"}), flush=True)
