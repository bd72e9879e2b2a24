"""What must be so for every placed object: inside, solid, doors, windows, mounts."""

from dataclasses import asdict, dataclass

from shapely.geometry import MultiPoint, Point

from . import geometry as geo
from .constraints import Judge
from .files import Categories

WINDOW_STRIP = 0.5
WINDOW_OVER_SILL = 0.1
DOOR_SWING_DEPTH = 0.9
DOOR_OTHER_DEPTH = 0.6
SOLID_SLACK = 0.005
AT_WALL = 0.05
RESTS = 0.02
LIFTED = 0.05
RUG_EDGE = 0.003
CATEGORIES = Categories.default()


@dataclass(frozen=True)
class Violation:
    rule: str
    objects: tuple
    detail: str

    def as_json(self):
        return {**asdict(self), "objects": list(self.objects)}


def check_inside(scene):
    """Footprints within the polygon and bodies between floor and ceiling, to a millimetre."""
    room, found = scene.room, []
    grown = room.polygon.buffer(geo.SLACK + 1e-6, join_style="mitre")
    for t in scene.things:
        if not grown.covers(t.footprint):
            area = t.footprint.difference(room.polygon).area
            found.append(Violation("inside", (t.id,), f"{area:.4f} m2 outside the room"))
        if t.top > room.height + geo.SLACK:
            found.append(Violation("inside", (t.id,), f"reaches {t.top:.3f} m, over the ceiling"))
        if t.bottom < -geo.SLACK:
            found.append(Violation("inside", (t.id,), f"starts at {t.bottom:.3f} m, under the floor"))
    return found


def boxes_overlap(a, b, slack):
    """Whether the bodies of two things reach into each other, round ones as elliptic columns."""
    if min(a.top, b.top) - max(a.bottom, b.bottom) <= slack:
        return False
    return geo.share_area(a.footprint, b.footprint, slack)


def inside_support(a, b):
    """A thing that stands on, or within, the other: the boxes overlap by intent."""
    return any(
        top.mount == "surface" and top.on and top.on.lower() == support.id.lower()
        for top, support in ((a, b), (b, a))
    )


def overlap_reason(a, b, meshes):
    """Why two things overlap, or None."""
    if not meshes or a.id not in meshes or b.id not in meshes:
        if inside_support(a, b) or not boxes_overlap(a, b, SOLID_SLACK):
            return None
        shared = a.footprint.intersection(b.footprint).area
        return f"boxes share {shared:.4f} m2 seen from above"
    if not boxes_overlap(a, b, geo.SLACK):
        return None
    return meshes.overlap(a.id, b.id)


def check_solid(scene, meshes=None):
    """No two solids share space; meshes decide where boxes overlap."""
    solids = [t for t in scene.things if t.solid]
    found = []
    for i, a in enumerate(solids):
        for b in solids[i + 1 :]:
            reason = overlap_reason(a, b, meshes)
            if reason:
                found.append(Violation("solid", (a.id, b.id), reason))
    return found


def swings_in(opening):
    return opening.type == "door" and opening.swing == "in"


def door_clearance(opening):
    """The rectangle before a door or passage where people pass."""
    depth = DOOR_SWING_DEPTH if swings_in(opening) else DOOR_OTHER_DEPTH
    return opening.wall.strip(opening.begin, opening.end, depth)


def door_keep_out(opening):
    """The clearance, and the quarter discs that the leaves of a door sweep."""
    area = door_clearance(opening)
    if not swings_in(opening):
        return area
    leaf = opening.width / opening.leaves
    square = opening.wall.strip(opening.begin, opening.end, leaf)
    for end, hinge in ((opening.begin, "from"), (opening.end, "to")):
        if opening.leaves > 1 or opening.hinge == hinge:
            area = area.union(Point(opening.wall.point(end)).buffer(leaf, 64).intersection(square))
    return area


def check_doors(scene):
    found = []
    for opening in scene.room.entrances:
        clearance = door_keep_out(opening)
        for t in scene.things:
            low = t.bottom < opening.head - geo.SLACK
            if t.solid and t.mount != "surface" and low and geo.share_area(t.footprint, clearance, geo.SLACK):
                found.append(Violation("doors", (t.id, opening.id),
                                       "stands in the clearance of the door"))
    return found


def covers_window(thing):
    return thing.mount == "wall" and CATEGORIES.covers_window(thing.category)


def check_windows(scene):
    """Things that begin above the window's head are not before it."""
    found = []
    for opening in scene.room.openings:
        if opening.type != "window":
            continue
        strip = opening.wall.strip(opening.begin, opening.end, WINDOW_STRIP)
        limit = opening.sill + WINDOW_OVER_SILL
        for t in scene.things:
            before = t.top > limit + geo.SLACK and t.bottom < opening.head - geo.SLACK
            if covers_window(t):
                continue
            if before and t.mount != "surface" and geo.share_area(t.footprint, strip, geo.SLACK):
                found.append(Violation("windows", (t.id, opening.id),
                                       f"reaches {t.top:.2f} m, allowed {limit:.2f} m"))
    return found


def covers_opening(thing, wall, opening):
    """Whether a thing at a wall hides a part of an opening in it."""
    if opening.wall.index != wall.index:
        return False
    alongs = [wall.coordinates(c)[0] for c in thing.box.exterior.coords]
    apart = (
        max(alongs) <= opening.begin + geo.SLACK
        or min(alongs) >= opening.end - geo.SLACK
        or thing.top <= opening.sill + geo.SLACK
        or thing.bottom >= opening.head - geo.SLACK
    )
    return not apart


def check_wall_mount(thing, scene):
    walls = Judge(scene).walls_at_back(thing, AT_WALL)
    if not walls:
        return [Violation("mount", (thing.id,), "hangs on a wall but touches none")]
    return [
        Violation("mount", (thing.id, o.id), "hangs over an opening")
        for o in scene.room.openings
        if any(covers_opening(thing, w, o) for w in walls)
        and not (o.type == "window" and covers_window(thing))
    ]


def check_surface_mount(thing, scene):
    support = scene.by_id.get((thing.on or "").lower())
    if support is None:
        return [Violation("mount", (thing.id,), f"stands on {thing.on}, which is not there")]
    found = []
    if not support.footprint.buffer(geo.SLACK).covers(Point(thing.centre)):
        found.append(Violation("mount", (thing.id, support.id), "its centre is not on its support"))
    if not support.bottom - geo.SLACK <= thing.bottom <= support.top + RESTS:
        found.append(
            Violation(
                "mount",
                (thing.id, support.id),
                f"floats at {thing.bottom:.3f} m, the top is {support.top:.3f} m",
            )
        )
    return found


def hangs_from_a_thing(thing, scene):
    """Whether its top is at the underside of something that is over its middle, or beside it by a hand's breadth."""
    middle = Point(thing.centre)
    return any(
        abs(other.bottom - thing.top) <= RESTS and other.footprint.distance(middle) <= 0.15
        for other in scene.things
        if other.id != thing.id
    )


def check_mount(thing, scene):
    if thing.mount == "wall":
        return check_wall_mount(thing, scene)
    if thing.mount == "surface":
        return check_surface_mount(thing, scene)
    if thing.mount == "ceiling" and abs(thing.top - scene.room.height) > RESTS and not hangs_from_a_thing(thing, scene):
        return [Violation("mount", (thing.id,), f"top at {thing.top:.3f} m, not at the ceiling")]
    if thing.mount == "floor" and thing.bottom > LIFTED:
        return [Violation("mount", (thing.id,), f"floats at {thing.bottom:.3f} m over the floor")]
    return []


def check_mounts(scene):
    """Things hang at walls, rest on supports, and touch the ceiling or the floor."""
    return [v for t in scene.things for v in check_mount(t, scene)]


def low_part(thing, bodies):
    """What of a thing reaches its lowest 5 mm, from above."""
    if not bodies or thing.id not in bodies:
        return thing.footprint
    points = bodies.meshes[thing.id.lower()][0]
    return MultiPoint(points[points[:, 2] < thing.bottom + SOLID_SLACK][:, :2])


def check_rugs(scene, bodies=None):
    """What stands on the floor over a rug's height is on a rug with all its feet; with meshes also: what
    stands lower meets no rug."""
    rugs = [t for t in scene.things if not t.solid and t.mount == "floor"]
    found = []
    for t in scene.things if rugs else []:
        if not t.solid or t.mount != "floor":
            continue
        if geo.SLACK < t.bottom <= LIFTED:
            low = low_part(t, bodies)
            under = [r for r in rugs if abs(r.top - t.bottom) <= geo.SLACK]
            if not any(r.footprint.buffer(RUG_EDGE).covers(low) for r in under):
                found.append(Violation("rugs", (t.id,), f"is {t.bottom:.3f} m high, and not all of it on a rug"))
        elif t.bottom <= geo.SLACK and bodies:
            found += [
                Violation("rugs", (t.id, r.id), "stands in the rug")
                for r in rugs
                if t.id in bodies and r.id in bodies and overlap_reason(t, r, bodies)
            ]
    return found
