"""Could a suggestion be followed? A second opinion, by the checker that shares no code with roomgen.

A suggestion is feasible when, beside what stood at that moment, some pose within 0.10 m and 5 degrees of it breaks no
rule and keeps all constraints of the answer.
"""

import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "checker"))

from roomgen_checker import files, geometry as geo, reach, rules  # noqa: E402
from roomgen_checker.constraints import Judge, parse  # noqa: E402
from roomgen_checker.meshes import Bodies  # noqa: E402

NEAR, TURN = 0.10, math.radians(5.0)
STEP = 0.03
FLUSH = 0.005
LEVEL = 0.015  # metres between the heights of one surface
KINDS = files.Categories.default()


class PosedBodies(Bodies):
    """The meshes of a finished scene, each where a thing stands at some moment."""

    def __init__(self, locals_, things):
        self.locals = locals_
        super().__init__({t.id: self.posed(t) for t in things if t.id.lower() in locals_})

    def posed(self, thing):
        points, triangles = self.locals[thing.id.lower()]
        c, s = math.cos(thing.yaw), math.sin(thing.yaw)
        x, y, z = points.T
        turned = np.column_stack([c * x - s * y, s * x + c * y, z])
        return turned + np.asarray(thing.position), triangles

    def with_thing(self, thing):
        """The same with one more, or one elsewhere."""
        other = PosedBodies(self.locals, [])
        other.meshes, other.models = dict(self.meshes), dict(self.models)
        if thing.id.lower() in self.locals:
            other.meshes[thing.id.lower()] = self.posed(thing)
            other.models.pop(thing.id.lower(), None)
        return other


def local_meshes(glb, things):
    """The meshes of things in their own frames."""
    found = Bodies.load(glb, [t.id for t in things]).meshes
    locals_ = {}
    for t in things:
        if t.id.lower() not in found:
            continue
        points, triangles = found[t.id.lower()]
        x, y, z = (points - np.asarray(t.position)).T
        c, s = math.cos(-t.yaw), math.sin(-t.yaw)
        locals_[t.id.lower()] = (np.column_stack([c * x - s * y, s * x + c * y, z]), triangles)
    return locals_


def heights_at(mesh, points):
    """The highest point of a mesh under each of the points; NaN where there is none."""
    vertices, triangles = mesh
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    d1, d2 = (b - a)[:, :2], (c - a)[:, :2]
    det = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        found = []
        for p in points:
            q = np.asarray(p) - a[:, :2]
            u = (q[:, 0] * d2[:, 1] - q[:, 1] * d2[:, 0]) / det
            v = (d1[:, 0] * q[:, 1] - d1[:, 1] * q[:, 0]) / det
            hit = (np.abs(det) > 1e-12) & (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9)
            z = a[:, 2] + u * (b - a)[:, 2] + v * (c - a)[:, 2]
            found.append(z[hit].max() if hit.any() else np.nan)
    return np.array(found)


def on_surface(thing, carrier, bodies):
    """The thing at the height of the carrier's top under it, or None where that is not level."""
    if carrier is None or carrier.id not in bodies:
        return None
    w, d = thing.size[:2]
    samples = [
        geo.to_world((x * w / 2, y * d / 2), thing.centre, thing.yaw)
        for x in (-0.98, -0.5, 0, 0.5, 0.98)
        for y in (-0.98, -0.5, 0, 0.5, 0.98)
        if "round" not in thing.traits or math.hypot(x, y) <= 1
    ]
    heights = heights_at(bodies.meshes[carrier.id.lower()], samples)
    if np.isnan(heights).any() or np.ptp(heights) > LEVEL:
        return None
    return replace(thing, position=(*thing.centre, float(heights.max())))


class Moment:
    """A room as it stood when a question was asked."""

    def __init__(self, room, things, locals_):
        self.scene = files.Scene("", room, list(things))
        self.bodies = PosedBodies(locals_, things)
        self.faults = self.keys(self.scene, self.bodies)

    @staticmethod
    def keys(scene, bodies):
        walk = reach.WalkMap(scene)
        found = reach.check_connected(scene, walk) + reach.check_usable(scene, KINDS, walk)
        found += rules.check_doors(scene) + rules.check_windows(scene) + rules.check_mounts(scene)
        return {(v.rule, v.objects) for v in found}

    def holds(self, thing):
        """Does the thing, where it stands, keep its constraints and all rules?"""
        bodies = self.bodies.with_thing(thing)
        alone = files.Scene("", self.scene.room, [thing])
        if rules.check_inside(alone):
            return False
        scene = files.Scene("", self.scene.room, [*self.scene.things, thing])
        judge = Judge(scene)
        if not all(judge.holds(thing, parse(text)) for text in thing.relations):
            return False
        others = [t for t in self.scene.things if t.solid and thing.solid]
        if any(rules.overlap_reason(thing, t, bodies) for t in others if not rules.inside_support(thing, t)):
            return False
        return self.keys(scene, bodies) <= self.faults

    def is_feasible(self, thing, yaws):
        carrier = self.scene.by_id.get((thing.on or "").lower())
        for pose in self.poses_near(thing, yaws):
            if thing.mount == "surface":
                pose = on_surface(pose, carrier, self.bodies)
            if pose is not None and self.holds(pose):
                return True
        return False

    def poses_near(self, thing, yaws):
        """The suggestion itself, flush with walls it nearly touches, then all around it."""
        for yaw in yaws:
            here = replace(thing, yaw=yaw)
            yield here
            for wall in self.scene.room.walls:
                if geo.angle_between(yaw, geo.yaw_looking(wall.inward)) > 1e-3:
                    continue
                off = wall.coordinates(thing.centre)[1] - thing.size[1] / 2
                if abs(off - FLUSH) <= NEAR:
                    yield moved(here, *(n * (FLUSH - off) for n in wall.inward))
        steps = np.arange(-3, 4) * STEP
        around = sorted(((x, y) for x in steps for y in steps if 0 < math.hypot(x, y) < NEAR), key=lambda p: math.hypot(*p))
        for dx, dy in around:
            for yaw in yaws:
                yield moved(replace(thing, yaw=yaw), dx, dy)


def moved(thing, dx, dy):
    x, y, z = thing.position
    return replace(thing, position=(x + dx, y + dy, z))


def wall_yaws(room):
    return sorted({round((geo.yaw_looking(w.inward) + k * math.pi / 2) % (2 * math.pi), 6) for w in room.walls for k in range(4)})


def yaws_for(wanted, room):
    """The yaw that was suggested and those of walls near it; without one all of the walls."""
    walls = wall_yaws(room)
    if wanted is None:
        return walls
    return [wanted] + [w for w in walls if 1e-3 < geo.angle_between(w, wanted) <= TURN]
