"""What score.py says about things whose answers are known: score.py --self-test."""

import json
import tempfile
from pathlib import Path

import numpy as np
import trimesh

import pieces
from score import CHECKS, judge, judge_refusal, labelled_groups, part_failure, perfect, program_bodies, report


def box(size, at):
    """A box that stands at a place."""
    mesh = trimesh.creation.box(size)
    mesh.apply_translation([at[0], at[1], at[2] + size[2] / 2])
    return mesh


def cylinder(radius, height, at=(0, 0, 0), sections=48):
    mesh = trimesh.creation.cylinder(radius, height, sections=sections)
    mesh.apply_translation([at[0], at[1], at[2] + height / 2])
    return mesh


def turned(mesh, degrees, axis=(0, 1, 0)):
    mesh = mesh.copy()
    mesh.apply_transform(trimesh.transformations.rotation_matrix(np.radians(degrees), axis))
    return mesh


def loft(levels):
    """A solid through rings of points [[x, y, z], ...] of the same number, closed at both ends."""
    count = len(levels[0])
    vertices = [point for level in levels for point in level]
    faces = []
    for level in range(len(levels) - 1):
        for index in range(count):
            a, b = level * count + index, level * count + (index + 1) % count
            faces += [[a, b, b + count], [a, b + count, a + count]]
    top = (len(levels) - 1) * count
    for index in range(1, count - 1):
        faces += [[0, index + 1, index], [top, top + index, top + index + 1]]
    return trimesh.Trimesh(vertices, faces, process=False)


def tube(centres, radius):
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    radii = np.broadcast_to(radius, len(centres))
    return loft([[[x + r * np.cos(t), y + r * np.sin(t), z] for t in turn] for (x, y, z), r in zip(centres, radii)])


def ring(count, rx=1.0, ry=1.0, start=0.0):
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False) + start
    return [[rx * np.cos(t), ry * np.sin(t), 0] for t in turn]


def plate(polygon, height):
    """A convex plate."""
    return loft([[[x, y, 0] for x, y, _ in polygon], [[x, y, height] for x, y, _ in polygon]])


def plate_of(polygon, height):
    """A plate whose outline need not be convex: quads between the two ends of the outline's columns."""
    half = len(polygon) // 2
    points = np.array(polygon)
    strips = []
    for index in range(half):
        a, b = points[index], points[index + 1]
        d, c = points[-index % len(points)], points[-(index + 1) % len(points)]
        quad = [p for k, p in enumerate((a, b, c, d)) if k == 0 or np.abs(p - (a, b, c, d)[k - 1]).max() > 1e-9]
        if index == 0:
            quad = [a, b, c]
        if index == half - 1:
            quad = [a, b, d]
        strips.append(loft([[[x, y, 0] for x, y, _ in quad], [[x, y, height] for x, y, _ in quad]]))
    return trimesh.util.concatenate(strips)


def save(base, bodies, materials=1, listed=True):
    """A model as the builder writes it: a mesh for each material that holds its bodies one after another, Y up."""
    scene = trimesh.Scene()
    summary = []
    for material in range(materials):
        mine = [body for index, body in enumerate(bodies) if index % materials == material]
        mesh = trimesh.util.concatenate([body[1] for body in mine])
        mesh = trimesh.Trimesh(
            mesh.triangles.reshape(-1, 3), np.arange(3 * len(mesh.faces)).reshape(-1, 3), process=False
        )
        mesh.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, (1, 0, 0)))
        scene.add_geometry(mesh, geom_name=f"material-{material}")
    for index, (label, mesh) in enumerate(bodies):
        summary.append(
            {
                "name": f"{label}-{index}",
                "label": label,
                "triangles": len(mesh.faces),
                "size": [round(float(v), 4) for v in mesh.extents],
            }
        )
    Path(f"{base}.glb").write_bytes(scene.export(file_type="glb"))
    if listed:
        Path(f"{base}.summary.json").write_text(json.dumps({"name": "thing", "bodies": summary}))


def table(legs=4, lift=0.0):
    places = [[0.5, 0.3, lift], [-0.5, 0.3, lift], [-0.5, -0.3, lift], [0.5, -0.3, lift]]
    bodies = [("leg", box([0.05, 0.05, 0.72], place)) for place in places[:legs]]
    return bodies + [("top", box([1.2, 0.8, 0.03], [0, 0, 0.72 + lift]))]


TABLE = {
    "prompt": "a table",
    "group": "common",
    "kind": "table",
    "parts": [
        {"label": "top", "count": 1, "shape": "rectangular"},
        {"label": "leg", "count": 4},
        {"label": "drawer", "count": 0},
    ],
    "size": [[1, 2], [0.6, 1], [0.7, 0.8]],
    "mount": "floor",
}
ANYTHING = {**TABLE, "parts": [], "size": [[0, 9]] * 3}


def run():
    wrong = []

    def expect(name, condition, told=""):
        if not condition:
            wrong.append(name)
            print(f"FAILED: {name} {told}")

    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder) / "001"

        def judged(bodies, entry=ANYTHING, **options):
            for file in Path(folder).iterdir():
                file.unlink()
            save(base, bodies, **options)
            return judge(entry, base)

        def failing(result):
            return [check for check in CHECKS if result[check] is False]

        for materials in (1, 2):
            good = judged(table(), TABLE, materials=materials)
            expect(f"a good table in {materials} materials", perfect(good) and not good["failures"], good)
        expect("the report has a row a group and a total", len(report([TABLE], [good])) == 4)
        expect("a table without a list of bodies", judged(table(), TABLE, listed=False)["parts"] == (1, 3))

        three = judged(table(3), TABLE)
        expect("a table of three legs at three corners stands", failing(three) == [], three)
        expect("three legs are not four", three["parts"] == (2, 3), three)
        beside = judged([("leg", box([0.05, 0.05, 0.72], [0.5, y, 0])) for y in (0.3, -0.3)] + table(0))
        expect("a table of two legs at one side falls", failing(beside) == ["stable"], beside)
        expect("a table in the air", failing(judged(table(lift=0.004), TABLE)) == ["grounded"])
        expect("a table within a millimetre", perfect(judged(table(lift=0.0008), TABLE)))
        expect("a small table", failing(judged(table(), {**TABLE, "size": [[2, 3], [0.6, 1], [0.7, 0.8]]})) == ["size"])

        apart = [("block", box([0.2, 0.2, 0.2], [-0.2, 0, 0])), ("block", box([0.2, 0.2, 0.2], [0.2, 0, 0]))]
        expect("two boxes apart", failing(judged(apart)) == ["connected"], judged(apart))
        for gap, whole in ((0.0, True), (0.002, True), (0.004, False)):
            two = [("block", box([0.2, 0.2, 0.2], [0, 0, 0])), ("block", box([0.2, 0.2, 0.2], [0.2 + gap, 0, 0]))]
            expect(f"boxes {gap} m apart", judged(two)["connected"] is whole)
        inside = [("block", box([0.4, 0.4, 0.4], [0, 0, 0])), ("block", box([0.1, 0.1, 0.1], [0, 0, 0.1]))]
        expect("a box inside a box", perfect(judged(inside)))
        corner = [("block", box([0.2, 0.2, 0.2], [0, 0, 0])), ("block", box([0.2, 0.2, 0.2], [0.2, 0.2, 0]))]
        expect("boxes that share an edge", perfect(judged(corner)), judged(corner))
        hollow = trimesh.creation.annulus(0.3, 0.32, 0.4)
        hollow.apply_translation([0, 0, 0.2])
        ball = trimesh.creation.icosphere(2, 0.1)
        ball.apply_translation([0, 0, 0.2])
        expect("a ball that floats in a pipe", failing(judged([("pipe", hollow), ("ball", ball)])) == ["connected"])

        def tower(degrees, height=1.2):
            lean = np.tan(np.radians(degrees))
            steps = [[k * 0.1 * lean, 0, k * 0.1] for k in range(round(height / 0.1) + 1)]
            return [
                (
                    "block",
                    loft(
                        [
                            [[x + a, b, z] for a, b in ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1))]
                            for x, _, z in steps
                        ]
                    ),
                )
            ]

        leaning, upright, little = judged(tower(14)), judged(tower(0)), judged(tower(5))
        expect("a leaning tower falls", failing(leaning) == ["stable"], leaning)
        expect("an upright tower stands", perfect(upright), upright)
        expect("a tower that leans a little stands", perfect(little), little)
        for degrees, falls in ((8.5, False), (10.5, True)):  # the centre passes the edge at 9.46 degrees
            expect(f"a tower at {degrees} degrees", (judged(tower(degrees))["stable"] is False) is falls)
        expect(
            "what hangs on the wall need not stand", judged(tower(14), {**ANYTHING, "mount": "wall"})["stable"] is None
        )
        heavy = [
            ("seat", cylinder(0.18, 0.04, (0, 0, 0.7))),
            ("leg", cylinder(0.02, 0.7)),
            ("base", cylinder(0.2, 0.02)),
        ]
        expect("a stool on a plate stands", perfect(judged(heavy)), judged(heavy))
        narrow = [
            ("seat", cylinder(0.18, 0.04, (0.15, 0, 0.7))),
            ("leg", cylinder(0.02, 0.7)),
            ("base", cylinder(0.03, 0.02)),
        ]
        expect("a lopsided one falls", failing(judged(narrow)) == ["stable"])

        holed = box([0.2, 0.2, 0.2], [0, 0, 0])
        holed.update_faces(np.arange(len(holed.faces)) > 0)
        expect("a box with a hole", failing(judged([("block", holed)])) == ["watertight"])
        expect(
            "many triangles",
            failing(judged([("ball", trimesh.creation.icosphere(6, 0.3).apply_translation([0, 0, 0.3]))]))[-1]
            == "light",
        )

        Path(f"{base}.glb").write_bytes(b"glTF, or so it says")
        expect("a broken file", not judge(TABLE, base)["made"])
        Path(f"{base}.glb").unlink()
        Path(f"{base}.summary.json").unlink()
        gone = judge(TABLE, base)
        expect("nothing made", not gone["made"] and gone["parts"] == (0, 3) and len(failing(gone)) == len(CHECKS), gone)

        refusal = {"prompt": "a long sentence about a car", "refuse": True, "mention": ["car"]}
        for result, right in (
            ({"exit": 2, "message": "a car is no furniture"}, True),
            ({"exit": 2, "message": "usage"}, False),
            ({"exit": 2, "message": "cannot make a long sentence about a car"}, False),
            ({"exit": 0, "message": "a car"}, False),
            ({"exit": -11, "message": "a car"}, False),
            ({"exit": None, "message": "a car"}, False),
        ):
            Path(f"{base}.result.json").write_text(json.dumps(result))
            expect(f"refusal {result}", (judge_refusal(refusal, base) is None) is right)

    bodies = [{"label": label} for label in ("leg", "leg", "Side-Rail")]
    for label, count, right in (
        ("leg", 2, True),
        ("leg", 3, False),
        ("leg", None, True),
        ("back", None, False),
        ("back", 0, True),
        ("leg", 0, False),
        ("leg", [1, 3], True),
        ("leg", [3, 4], False),
        ("rung|side rail", 1, True),
        ("rail", 1, True),
        ("side", 0, True),
    ):
        failure = part_failure({"label": label, "count": count}, bodies, [None] * 3)
        expect(f"{label} {count}", (failure is None) is right, failure)
    program = {
        "components": [
            {"name": "leg", "label": "leg", "box": {}, "operations": [{"mirror": "x"}, {"mirror": "y"}]},
            {
                "name": "slat",
                "label": "slat",
                "box": {},
                "operations": [{"array": {"count": 5}}, {"join": True}, {"mirror": "x"}],
            },
            {
                "name": "unit",
                "label": "drawer",
                "operations": [{"radial": {"count": 3}}],
                "group": {"components": [{"name": "front", "box": {}}, {"name": "knob", "label": "handle", "box": {}}]},
            },
        ]
    }
    labels = [body["label"] for body in program_bodies(program)]
    expect(
        "copies in a program",
        {n: labels.count(n) for n in set(labels)} == {"leg": 4, "slat": 2, "drawer": 3, "handle": 3},
        labels,
    )

    back = {"name": "back", "label": "back", "group": {"components": [{"name": "rail", "label": "rail", "box": {}}]}}
    found = labelled_groups(
        {"components": [{"name": "chair", "group": {"components": [back]}}, *program["components"]]}
    )
    expect("a back of rails is a back", [(label, times) for label, times, _ in found] == [("back", 1)], found)
    expect(
        "its rails are known by name",
        found and found[0][2].match("chair.back.rail-1") and not found[0][2].match("chair.rail"),
    )

    curve = [[0.15 * np.sin(np.pi * k / 12), 0, 0.05 * k] for k in range(13)]
    straight = tube([[0, 0, 0], [0, 0, 0.6]], 0.02)
    kidney = [
        [np.cos(t) * (1 + 0.0), np.sin(t) * 0.6 + 0.45 * np.cos(t) ** 2, 0]
        for t in np.linspace(0, 2 * np.pi, 48, endpoint=False)
    ]
    bodies = {
        "disc": (cylinder(0.2, 0.03), {"round", "curved"}),
        "tall cylinder": (cylinder(0.1, 0.5), {"round", "cylindrical"}),
        "ellipse": (plate(ring(48, 0.6, 0.4), 0.03), {"oval", "curved"}),
        "square": (box([0.4, 0.4, 0.03], [0, 0, 0]), {"square", "rectangular"}),
        "oblong": (box([0.8, 0.4, 0.03], [0, 0, 0]), {"rectangular"}),
        "triangle": (plate(ring(3, 0.3, 0.3), 0.03), {"triangular"}),
        "hexagon": (plate(ring(6, 0.3, 0.3), 0.03), {"hexagonal"}),
        "octagon": (plate(ring(8, 0.3, 0.3), 0.03), {"octagonal"}),
        "ball": (trimesh.creation.icosphere(3, 0.2), {"spherical", "round"}),
        "cone": (trimesh.creation.cone(0.2, 0.4), {"conical", "round"}),
        "leg": (straight, set()),
        "slanted leg": (turned(straight, 8), {"slanted"}),
        "bent leg": (tube(curve, 0.02), {"curved"}),
        "tapered leg": (tube([[0, 0, 0], [0, 0, 0.6]], [0.012, 0.02]), {"tapered"}),
        "l": (
            trimesh.util.concatenate([box([1.6, 0.6, 0.03], [0, 0, 0]), box([0.6, 0.8, 0.03], [-0.5, -0.7, 0])]),
            {"l-shaped"},
        ),
        "kidney": (plate_of(kidney, 0.03), {"kidney"}),
    }
    asked = {
        "round": {"disc", "tall cylinder", "ellipse", "square", "oblong", "triangle", "hexagon", "octagon"},
        "oval": {"disc", "ellipse", "square", "oblong", "triangle", "hexagon", "octagon"},
        "square": {"disc", "ellipse", "square", "oblong", "triangle", "hexagon", "octagon"},
        "rectangular": {"disc", "ellipse", "square", "oblong", "triangle", "hexagon", "octagon"},
        "triangular": {"disc", "ellipse", "square", "triangle", "hexagon", "octagon"},
        "hexagonal": {"disc", "ellipse", "square", "triangle", "hexagon", "octagon"},
        "octagonal": {"disc", "ellipse", "square", "triangle", "hexagon", "octagon"},
        "l-shaped": {"l", "square", "disc", "oblong"},
        "kidney": {"kidney", "square", "disc", "oblong", "ellipse"},
        "slanted": {"leg", "slanted leg", "tapered leg"},
        "curved": {"disc", "tall cylinder", "leg", "slanted leg", "bent leg", "square", "oblong"},
        "tapered": {"leg", "slanted leg", "tapered leg"},
        "conical": {"cone", "tall cylinder", "square"},
        "spherical": {"ball", "square", "tall cylinder", "cone"},
        "cylindrical": {"ball", "tall cylinder", "square", "cone"},
    }
    expect("every shape is tried", set(asked) == set(pieces.SHAPES))
    for shape, names in asked.items():
        for name in sorted(names):
            mesh, shapes = bodies[name]
            expect(
                f"is the {name} {shape}?", pieces.has_shape(shape, [np.asarray(mesh.triangles)]) == (shape in shapes)
            )

    here = Path(__file__).resolve().parent
    prompts = json.loads((here / "prompts.json").read_text())
    groups = [entry["group"] for entry in prompts]
    expect("150 sentences", [groups.count(group) for group in ("common", "edge", "strange")] == [50, 60, 40])
    for entry in prompts:
        expect(
            f"{entry['prompt']}: shapes are known", all(part.get("shape", "round") in asked for part in entry["parts"])
        )
        expect(f"{entry['prompt']}: sizes", len(entry["size"]) == 3 and all(low < high for low, high in entry["size"]))
        expect(f"{entry['prompt']}: mount", entry["mount"] in ("floor", "wall", "ceiling", "surface"))
    expect("30 refusals", len(json.loads((here / "refused.json").read_text())) == 30)
    print("self-test:", "failed" if wrong else "passed")
    return 1 if wrong else 0
