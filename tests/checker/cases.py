"""Short ways to write down rooms and things for tests."""

import math

from roomgen_checker import files, reach, report

CATEGORIES = files.Categories(
    {
        "kinds": {
            "seat": {
                "zones": [
                    {"side": "front", "depth": 0.35, "partners": ["table"]},
                    *({"side": s, "depth": 0.35} for s in ("left", "right", "back")),
                ]
            },
            "chair": {"is": "seat"},
            "sofa": {"is": "seat", "names": ["couch"]},
            "table": {
                "zones": [
                    {"side": s, "depth": 0.6, "partners": ["seat"]}
                    for s in ("front", "back", "left", "right")
                ]
            },
            "desk": {"is": "table", "zones": [{"side": "front", "depth": 0.75, "partners": ["seat"]}]},
            "wardrobe": {"zones": [{"side": "front", "depth": 0.75}]},
            "bookshelf": {"zones": [{"side": "front", "depth": 0.6}], "names": ["bookcase"]},
            "box": {"zones": []},
        }
    }
)
RECTANGLE = ((0, 0), (5, 0), (5, 4), (0, 4))


def thing(name, x, y, size=(1, 1, 0.9), yaw=0, z=0.0, relations=(), **more):
    """`chair-0` with its centre at (x, y), `yaw` in degrees."""
    size = tuple(size) if len(size) == 3 else (*size, 0.9)
    return files.Thing(
        name,
        files.category_of_name(name),
        size,
        (x, y, z),
        math.radians(yaw),
        relations=tuple(relations),
        **more
    )


def scene(*things, polygon=RECTANGLE, openings=(), height=2.7):
    """A scene; openings are (id, wall, from, to[, {more}])."""
    room = files.make_room("test", polygon, height, [])
    for name, wall, begin, end, *more in openings:
        kind = name.rpartition("-")[0]
        entry = {
            "id": name,
            "type": kind,
            "wall": wall,
            "from": begin,
            "to": end,
            "sill": 0.9 if kind == "window" else 0.0,
            "head": 2.05,
            **(more[0] if more else {}),
        }
        room.openings.append(files.read_opening(entry, room.walls))
    return files.Scene("test", room, list(things))


def broken(a_scene, bodies=None, lenience=reach.LENIENCE):
    """{(rule, ids...)} of all violations."""
    found = report.find_violations(a_scene, CATEGORIES, bodies, lenience)
    return {(v.rule, *v.objects) for v in found}
