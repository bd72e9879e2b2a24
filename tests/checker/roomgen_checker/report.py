"""One scene's findings, as a dictionary and as text."""

import time
from dataclasses import dataclass
from pathlib import Path

from . import files, reach, rules
from .constraints import STRICT, Judge, parse
from .meshes import Bodies

MESH_FITS_BOX = 0.02


@dataclass
class Options:
    categories: files.Categories
    limits: object = STRICT
    meshes: str = "auto"  # auto, always, never
    problem: files.Problem | None = None
    lenience: float = reach.LENIENCE


def load_bodies(path, scene, mode):
    """The meshes beside a scene file, if there are any and they are wanted."""
    glb = Path(path).with_name("scene.glb")
    if mode == "never" or (mode == "auto" and not glb.exists()):
        return None
    return Bodies.load(glb, [t.id for t in scene.things])


def find_violations(scene, categories, bodies=None, lenience=reach.LENIENCE):
    """All broken hard rules of a scene."""
    walk = reach.WalkMap(scene, lenience)
    return (
        rules.check_inside(scene)
        + rules.check_solid(scene, bodies)
        + rules.check_doors(scene)
        + rules.check_windows(scene)
        + rules.check_mounts(scene)
        + rules.check_rugs(scene, bodies)
        + reach.check_connected(scene, walk)
        + reach.check_usable(scene, categories, walk)
    )


def judge_thing(thing, judge):
    return [{"text": text, "held": judge.holds(thing, parse(text))} for text in thing.relations]


def relations_of_unplaced(entry, problem):
    """What was asked of an object that was left out; all of it is lost."""
    asked = {o["id"]: o["relations"] for o in problem.objects} if problem else {}
    return entry.get("relations") or asked.get(entry["id"].lower(), [])


def judge_constraints(scene, limits, problem=None):
    """{id: [{"text", "held"}]}, objects that were left out included."""
    judge = Judge(scene, limits)
    found = {t.id: judge_thing(t, judge) for t in scene.things}
    for entry in scene.unplaced:
        found[entry["id"]] = [{"text": text, "held": False} for text in relations_of_unplaced(entry, problem)]
    return found


def by_name(judged):
    """{constraint name: [held, all]}."""
    table = {}
    for results in judged.values():
        for r in results:
            row = table.setdefault(parse(r["text"]).name, [0, 0])
            row[0] += r["held"]
            row[1] += 1
    return dict(sorted(table.items()))


def normal(text):
    c = parse(text)
    return c.name, c.target


def compare_with_problem(scene, problem):
    """What a scene changed in, or lost from, its problem."""
    found = []
    if scene.room.polygon.symmetric_difference(problem.room.polygon).area > 1e-3:
        found.append(rules.Violation("problem", (), "another room"))
    left_out = {u["id"].lower() for u in scene.unplaced}
    for asked in problem.objects:
        thing = scene.by_id.get(asked["id"])
        if thing is None:
            if asked["id"] not in left_out:
                found.append(rules.Violation("problem", (asked["id"],), "neither placed nor left out"))
            continue
        if max(abs(a - b) for a, b in zip(thing.size, asked["size"])) > 1e-3:
            found.append(rules.Violation("problem", (thing.id,), "another size"))
        if sorted(map(normal, thing.relations), key=str) != sorted(map(normal, asked["relations"]), key=str):
            found.append(rules.Violation("problem", (thing.id,), "other constraints"))
    asked_ids = {o["id"] for o in problem.objects}
    found += [
        rules.Violation("problem", (t.id,), "was not asked for")
        for t in scene.things
        if t.id.lower() not in asked_ids
    ]
    return found


def notes_on(scene, bodies, categories):
    """Things that are no violations but worth a look."""
    notes = [
        f"{t.id}: unknown category {t.category!r}, so no use zones"
        for t in scene.things
        if categories.lookup(t.category) is None
    ]
    for t in scene.things if bodies else []:
        if t.id not in bodies:
            notes.append(f"{t.id}: no mesh of this name")
        elif bodies.bounds_off(t) > MESH_FITS_BOX:
            notes.append(f"{t.id}: the mesh is off its box by {bodies.bounds_off(t):.3f} m")
    return notes


def check(scene, options, bodies=None):
    """The report on one scene."""
    begin = time.perf_counter()
    violations = find_violations(scene, options.categories, bodies, options.lenience)
    if options.problem:
        violations += compare_with_problem(scene, options.problem)
    judged = judge_constraints(scene, options.limits, options.problem)
    results = [r for rs in judged.values() for r in rs]
    floor = [t.footprint.area for t in scene.things if t.solid and t.mount == "floor"]
    return {
        "scene": scene.name,
        "objects": len(scene.things),
        "unplaced": [u["id"] for u in scene.unplaced],
        "incomplete": scene.incomplete,
        "fill": round(sum(floor) / scene.room.polygon.area, 3),
        "violations": [v.as_json() for v in violations],
        "constraints": {
            "held": sum(r["held"] for r in results),
            "total": len(results),
            "by_name": by_name(judged),
            "objects": judged,
        },
        "meshes": len(bodies.meshes) if bodies else 0,
        "notes": notes_on(scene, bodies, options.categories),
        "seconds": round(time.perf_counter() - begin, 3),
    }


def check_file(path, options):
    """The report on a scene.json, with the meshes beside it."""
    data = files.read_json(path)
    scene = files.read_scene(data, str(path))
    return check(scene, options, load_bodies(path, scene, options.meshes))


def as_text(report, verbose=True):
    """The report for people."""
    c = report["constraints"]
    share = f" ({100 * c['held'] / c['total']:.0f} %)" if c["total"] else ""
    lines = [
        f"{report['scene']}: {report['objects']} objects, {len(report['unplaced'])} left out, "
        f"{c['held']} of {c['total']} constraints{share}, "
        f"{len(report['violations'])} violations, {report['seconds']:.2f} s"
    ]
    if report["incomplete"]:
        lines.append("  marked as incomplete")
    lines += [
        f"  VIOLATION {v['rule']}: {', '.join(v['objects'])}: {v['detail']}" for v in report["violations"]
    ]
    lines += [f"  left out: {name}" for name in report["unplaced"]]
    if verbose:
        lines += [
            f"  not held: {name}: {r['text']}"
            for name, rs in c["objects"].items()
            for r in rs
            if not r["held"]
        ]
        lines += [f"  note: {n}" for n in report["notes"]]
    return "\n".join(lines)
