"""What Blender finds in the GLB files named on standard input: a line of JSON each. After a tab may stand a thing to move
and OUT: then the file is written again, with custom properties (OUT-extras.glb) and without, its default (OUT-names.glb)."""

import contextlib
import json
import os
import sys

import bpy

MOVE = 0.15


@contextlib.contextmanager
def quiet():
    """Blender prints to the descriptor itself."""
    kept, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)


def load(file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=file)


def nodes():
    return [{"name": one.name, "id": one.get("id")} for one in bpy.data.objects if "shell" not in one]


def trip(moved, out):
    next(one for one in bpy.data.objects if one.get("id") == moved and "shell" not in one).location.x += MOVE
    for name, extras in (("extras", True), ("names", False)):
        bpy.ops.export_scene.gltf(filepath=f"{out}-{name}.glb", export_format="GLB", export_extras=extras)


def answer(file, rest):
    with quiet():
        load(file)
        found = nodes()
        if rest:
            trip(*rest)
    return {"file": file, "nodes": found}


tasks = [line.rstrip("\n").split("\t") for line in sys.stdin]
for path, *more in tasks:
    try:
        line = answer(path, more)
    except Exception as error:  # whatever it is, it is the finding
        line = {"file": path, "error": f"{type(error).__name__}: {error}"}
    print(json.dumps(line), flush=True)
