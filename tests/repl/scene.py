"""A room of boxes, so that no furniture is needed."""

import json

SCENE = {
    "format": "roomgen-scene", "version": 1,
    "room": {"type": "study", "polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "height": 2.7,
             "openings": [{"id": "door-0", "type": "door", "wall": 0, "from": 0.4, "to": 1.3}]},
    "objects": [
        {"id": "stool-0", "category": "stool", "asset": None, "size": [0.4, 0.4, 0.5],
         "position": [1, 2, 0], "yaw_deg": 0},
        {"id": "wardrobe-0", "category": "wardrobe", "asset": None, "size": [1, 0.6, 2],
         "position": [3, 3.7, 0], "yaw_deg": 0}]}


def write(path, **more):
    path.write_text(json.dumps({**SCENE, **more}))


def x_of(path, id):
    return next(each for each in json.loads(path.read_text())["objects"] if each["id"] == id)["position"][0]
