"""The hard rules and reachability, on rooms whose answers are known by hand."""

import math
import struct
import json
import unittest

import numpy as np
import shapely

from cases import RECTANGLE, broken, scene, thing
from roomgen_checker import files, geometry as geo, meshes, reach


class Inside(unittest.TestCase):
    #    +--------+
    #    |       [a]   1 mm is forgiven, 3 mm are not
    #    +--------+
    def test_at_the_wall(self):
        self.assertEqual(broken(scene(thing("box-0", 4.5005, 2))), set())
        self.assertEqual(broken(scene(thing("box-0", 4.503, 2))), {("inside", "box-0")})

    #    +---+ [a]
    #    |   +-----+    outside of the polygon, but inside its bounds
    #    +---------+
    def test_l_room(self):
        room = ((0, 0), (6, 0), (6, 2.6), (3, 2.6), (3, 5), (0, 5))
        self.assertEqual(broken(scene(thing("box-0", 4.5, 4), polygon=room)), {("inside", "box-0")})
        self.assertEqual(broken(scene(thing("box-0", 3.3, 2.4), polygon=room)), {("inside", "box-0")})
        self.assertEqual(broken(scene(thing("box-0", 1.5, 4), polygon=room)), set())

    #      .--.
    #     /(a) \      a disc fits where its box would reach through the slanted wall
    #    /______\
    def test_round_thing_at_slanted_wall(self):
        room = ((0, 0), (6, 0), (6, 2), (4, 4), (0, 4))
        at = 0.52 / math.sqrt(2)
        for traits, expected in ((("round",), set()), ((), {("inside", "box-0")})):
            box = thing("box-0", 5 - at, 3 - at, (1, 1), traits=traits)
            self.assertEqual(broken(scene(box, polygon=room)), expected)

    def test_height(self):
        self.assertEqual(broken(scene(thing("box-0", 2, 2, (1, 1, 2.8)))), {("inside", "box-0")})
        self.assertEqual(broken(scene(thing("box-0", 2, 2, (1, 1, 2.7)))), set())


class Solid(unittest.TestCase):
    #   [a][b]    touching is not overlapping
    def test_boxes(self):
        a = thing("box-0", 2, 2)
        self.assertEqual(broken(scene(a, thing("box-1", 3, 2))), set())
        self.assertEqual(broken(scene(a, thing("box-1", 2.98, 2))), {("solid", "box-0", "box-1")})
        self.assertEqual(broken(scene(a, thing("box-1", 2.9, 2, z=0.9, mount="ceiling"), height=1.8)), set())

    #   [a]/\     turned by 45 degrees its corner comes nearer
    #      \/
    def test_turned(self):
        a = thing("box-0", 2, 2)
        reach_out = 0.5 + math.sqrt(0.5)
        self.assertEqual(broken(scene(a, thing("box-1", 2 + reach_out + 0.01, 2, yaw=45))), set())
        self.assertEqual(
            broken(scene(a, thing("box-1", 2 + reach_out - 0.05, 2, yaw=45))), {("solid", "box-0", "box-1")}
        )

    #   (a)       discs side by side on the diagonal: their boxes overlap, they do not
    #      (b)
    def test_round(self):
        for traits, expected in ((("round",), set()), ((), {("solid", "box-0", "box-1")})):
            a, b = (thing(f"box-{k}", 2 + 0.8 * k, 2 + 0.8 * k, traits=traits) for k in (0, 1))
            self.assertEqual(broken(scene(a, b)), expected)

    def test_rug_is_no_solid(self):
        rug = thing("box-0", 2, 2, (2, 2, 0.02), traits=("flat",))
        self.assertEqual(broken(scene(rug, thing("box-1", 2, 2))), set())

    #    [a]       on the rug with all of it, or beside it, never partly
    #   =====
    def test_standing_on_a_rug(self):
        rug = thing("box-0", 2, 2, (2, 2, 0.02), traits=("flat",))
        self.assertEqual(broken(scene(rug, thing("box-1", 2.4, 2, z=0.02))), set())
        self.assertEqual(broken(scene(rug, thing("box-1", 2.6, 2, z=0.02))), {("rugs", "box-1")})
        self.assertEqual(broken(scene(rug, thing("box-1", 2, 2, z=0.03))), {("rugs", "box-1")})

    def test_thing_on_a_shelf_within_its_box(self):
        shelf = thing("box-0", 2, 2, (1, 1, 2))
        vase = thing("box-1", 2, 2, (0.2, 0.2, 0.3), z=1.0, mount="surface", on="box-0")
        self.assertEqual(broken(scene(shelf, vase)), set())
        self.assertEqual(
            broken(scene(shelf, thing("box-1", 2, 2, (0.2, 0.2, 0.3), z=1.0))),
            {("solid", "box-0", "box-1"), ("mount", "box-1")},
        )


def cuboid(x0, x1, y0, y1, z0, z1):
    """(vertices, triangles) of a closed block with outward faces."""
    points = np.array([(x, y, z) for x in (x0, x1) for y in (y0, y1) for z in (z0, z1)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def together(*parts):
    offsets = np.cumsum([0] + [len(p) for p, _ in parts[:-1]])
    return (
        np.concatenate([p for p, _ in parts]),
        np.concatenate([t + o for (_, t), o in zip(parts, offsets)]),
    )


def table_mesh(w=1.6, d=0.9, h=0.75, leg=0.06):
    """A top of 4 cm on four legs, around the origin."""
    legs = [
        cuboid(x, x + leg, y, y + leg, 0, h - 0.04)
        for x in (-w / 2, w / 2 - leg)
        for y in (-d / 2, d / 2 - leg)
    ]
    return together(cuboid(-w / 2, w / 2, -d / 2, d / 2, h - 0.04, h), *legs)


def chair_mesh(w=0.46, d=0.5, seat=0.45, h=0.9):
    """A seat block with a back at +y, front at -y."""
    return together(
        cuboid(-w / 2, w / 2, -d / 2, d / 2, 0, seat), cuboid(-w / 2, w / 2, d / 2 - 0.04, d / 2, seat, h)
    )


def placed(mesh, t):
    """A mesh moved to where a thing stands."""
    points = np.array([(*geo.to_world(p[:2], t.centre, t.yaw), p[2] + t.bottom) for p in mesh[0]])
    return points, mesh[1]


def write_glb(bodies):
    """A scene.glb with one node a body, Y-up, the translation in the node."""
    nodes, views, accessors, gltf_meshes, blob = [], [], [], [], b""
    for name, (points, triangles) in bodies.items():
        origin = points.mean(axis=0)
        local = points - origin
        y_up = np.column_stack([local[:, 0], local[:, 2], -local[:, 1]]).astype("<f4")
        for data, kind, width in ((y_up, 5126, "VEC3"), (triangles.astype("<u4").ravel(), 5125, "SCALAR")):
            accessors.append(
                {"bufferView": len(views), "componentType": kind, "count": len(data), "type": width}
            )
            views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": data.nbytes})
            blob += data.tobytes()
        gltf_meshes.append(
            {"primitives": [{"attributes": {"POSITION": len(accessors) - 2}, "indices": len(accessors) - 1}]}
        )
        nodes.append(
            {"name": name, "mesh": len(gltf_meshes) - 1, "translation": [origin[0], origin[2], -origin[1]]}
        )
    text = json.dumps(
        {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": list(range(len(nodes)))}],
            "nodes": nodes,
            "meshes": gltf_meshes,
            "accessors": accessors,
            "bufferViews": views,
            "buffers": [{"byteLength": len(blob)}],
        }
    ).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


class Meshes(unittest.TestCase):
    #      ________________
    #     |_______________|      side view: the seat goes under the top, between the legs
    #     | |   |seat|  | |
    #     | |   |____|__|_|__ back
    def table_and_chair(self, gap, x=2.5):
        """A chair whose seat's front is `gap` beyond the table's front edge (negative: tucked)."""
        table = thing("table-0", 2.5, 2, (1.6, 0.9, 0.75))
        chair = thing("chair-0", x, 2 - 0.45 - 0.25 - gap, (0.46, 0.5, 0.9), yaw=180)
        bodies = {"table-0": placed(table_mesh(), table), "chair-0": placed(chair_mesh(), chair)}
        return scene(table, chair), bodies

    def overlaps(self, gap, x=2.5, glb=False):
        s, bodies = self.table_and_chair(gap, x)
        if glb:
            bodies = meshes.Glb(write_glb(bodies)).named(set(bodies))
        return ("solid", "table-0", "chair-0") in broken(s, meshes.Bodies(bodies))

    def test_chair_tucked_under_a_table(self):
        self.assertFalse(self.overlaps(-0.30))
        self.assertTrue(
            ("solid", "table-0", "chair-0") in broken(self.table_and_chair(-0.3)[0]),
            "without meshes the boxes decide",
        )

    def test_chair_back_through_the_top(self):
        self.assertTrue(self.overlaps(-0.47 - 0.02))
        self.assertFalse(self.overlaps(-0.455))

    def test_chair_in_a_leg(self):
        self.assertTrue(self.overlaps(-0.30, x=2.5 - 0.8 + 0.2))

    def test_a_touch_of_some_millimetres_is_forgiven(self):
        # the chair's back enters the table top by 2 mm; moving it 5 mm away parts them
        self.assertFalse(self.overlaps(-(0.46 + 0.002)))

    def test_one_within_the_other(self):
        outer, inner = thing("box-0", 2, 2), thing("box-1", 2, 2, (0.2, 0.2, 0.3), z=0.02)
        bodies = {
            "box-0": placed(cuboid(-0.5, 0.5, -0.5, 0.5, 0, 0.9), outer),
            "box-1": placed(cuboid(-0.1, 0.1, -0.1, 0.1, 0, 0.3), inner),
        }
        self.assertEqual(broken(scene(outer, inner), meshes.Bodies(bodies)), {("solid", "box-0", "box-1")})

    def test_glb_is_read_in_the_scenes_frame(self):
        s, bodies = self.table_and_chair(-0.30)
        read = meshes.Bodies(meshes.Glb(write_glb(bodies)).named(set(bodies)))
        for t in s.things:
            self.assertLess(read.bounds_off(t), 1e-5)
        self.assertFalse(self.overlaps(-0.30, glb=True))
        self.assertTrue(self.overlaps(-0.50, glb=True))

    def test_mesh_turned_against_its_box_is_noticed(self):
        t = thing("box-0", 2, 2, (1, 0.5), 90)
        mesh = cuboid(1.5, 2.5, 1.75, 2.25, 0, 0.9)
        self.assertGreater(meshes.Bodies({"box-0": mesh}).bounds_off(t), 0.2)


class Doors(unittest.TestCase):
    #    +--------------+
    #    |              |
    #    |  [table]     |     the leaf needs 0.9 m
    #    +---door-------+
    def at(self, y, width=0.9, **door):
        opening = ("door-0", 0, 1, 1 + width, door)
        return broken(scene(thing("box-0", 1.5, y + 0.5), openings=[opening]))

    def test_depth(self):
        blocked = {("doors", "box-0", "door-0")}
        self.assertEqual(self.at(0.95), set())
        self.assertEqual(self.at(0.85), blocked)
        self.assertEqual(self.at(1.05, width=1.2), blocked)
        self.assertEqual(self.at(1.25, width=1.2), set())
        self.assertEqual(self.at(0.85, swing="out"), set())
        self.assertEqual(self.at(0.65, swing="sliding"), set())
        self.assertIn(("doors", "box-0", "door-0"), self.at(0.55, swing="out"))

    def test_passage(self):
        near = scene(thing("box-0", 1.5, 1.2), openings=[("passage-0", 0, 1, 2)])
        self.assertEqual(broken(near), set())

    def test_beside_over_and_under(self):
        door = [("door-0", 0, 1, 1.9)]
        self.assertEqual(broken(scene(thing("box-0", 2.4, 0.5), openings=door)), set())
        lamp = thing("box-0", 1.5, 0.5, (0.4, 0.4, 0.5), z=2.2, mount="ceiling")
        self.assertEqual(broken(scene(lamp, openings=door)), set())
        low = thing("box-0", 1.5, 0.5, (0.4, 0.4, 0.8), z=1.9, mount="ceiling")
        self.assertEqual(broken(scene(low, openings=door)), {("doors", "box-0", "door-0")})
        rug = thing("box-0", 1.5, 0.5, (0.8, 0.8, 0.02), traits=("flat",))
        self.assertEqual(broken(scene(rug, openings=door)), set())

    #        \ door in a slanted wall, with something in the way
    def test_slanted(self):
        room = ((0, 0), (6, 0), (6, 2), (4, 4), (0, 4))
        door = [("door-0", 2, 1, 1.9)]
        at = lambda off: (5 - off / math.sqrt(2), 3 - off / math.sqrt(2))
        self.assertEqual(
            broken(scene(thing("box-0", *at(1.2), (0.5, 0.5), -45), polygon=room, openings=door)), set()
        )
        self.assertEqual(
            broken(scene(thing("box-0", *at(1.1), (0.5, 0.5), -45), polygon=room, openings=door)),
            {("doors", "box-0", "door-0")},
        )


class Windows(unittest.TestCase):
    #    +--==window==--+
    #    |  [wardrobe]  |     taller than the sill + 0.1 within 0.5 m
    #    |              |
    def test_heights(self):
        window = [("window-0", 2, 1, 3)]
        wall = lambda h, x=3, off=0: thing("box-0", x, 3.7 - off, (1, 0.6, h))
        blocked = {("windows", "box-0", "window-0")}
        self.assertEqual(broken(scene(wall(2.0), openings=window)), blocked)
        self.assertEqual(broken(scene(wall(1.02), openings=window)), blocked)
        self.assertEqual(broken(scene(wall(1.0), openings=window)), set())
        self.assertEqual(broken(scene(wall(2.0, x=1.4), openings=window)), set())
        self.assertEqual(broken(scene(wall(2.0, off=0.52), openings=window)), set())
        self.assertEqual(broken(scene(wall(2.0, off=0.45), openings=window)), blocked)


class Mounts(unittest.TestCase):
    def test_wall(self):
        # [picture] back at the wall; over a window; off the wall
        window = [("window-0", 2, 1, 2, {"sill": 0.9})]
        picture = lambda x, y, z=1.4: thing("box-0", x, y, (0.6, 0.04, 0.4), z=z, mount="wall")
        self.assertEqual(broken(scene(picture(2, 3.97), openings=window)), set())
        self.assertEqual(broken(scene(picture(2, 3.9), openings=window)), {("mount", "box-0")})
        self.assertIn(("mount", "box-0", "window-0"), broken(scene(picture(3.5, 3.97), openings=window)))
        self.assertEqual(broken(scene(picture(3.5, 3.97, 2.2), openings=window)), set())

    def test_surface(self):
        table = thing("box-0", 2, 2, (1, 1, 0.7))
        cup = lambda x, z, on="box-0": thing("box-1", x, 2, (0.1, 0.1, 0.1), z=z, mount="surface", on=on)
        self.assertEqual(broken(scene(table, cup(2.4, 0.7))), set())
        self.assertEqual(broken(scene(table, cup(2.6, 0.7))), {("mount", "box-1", "box-0")})
        self.assertEqual(broken(scene(table, cup(2, 0.8))), {("mount", "box-1", "box-0")})
        self.assertEqual(broken(scene(table, cup(2, 0.7, "box-7"))), {("mount", "box-1")})

    def test_ceiling_and_floor(self):
        self.assertEqual(broken(scene(thing("box-0", 2, 2, (1, 1, 0.3), z=2.4, mount="ceiling"))), set())
        self.assertEqual(
            broken(scene(thing("box-0", 2, 2, (1, 1, 0.3), z=2.2, mount="ceiling"))), {("mount", "box-0")}
        )
        self.assertEqual(broken(scene(thing("box-0", 2, 2, z=0.2))), {("mount", "box-0")})


DOOR = [("door-0", 0, 0.2, 1.1)]


class Usable(unittest.TestCase):
    #    +---------+
    #    | [wardr] |     its doors open towards the wall: 0.75 m are needed
    #    |    v    |
    #    +---------+
    def test_wardrobe_facing_a_wall(self):
        facing = lambda gap: scene(thing("wardrobe-0", 3, gap + 0.3, (1.2, 0.6, 2)), openings=DOOR)
        self.assertEqual(broken(facing(0.70)), {("usable", "wardrobe-0")})
        self.assertEqual(broken(facing(0.74)), set())
        self.assertEqual(broken(facing(0.80)), set())

    def test_blocked_by_another(self):
        wardrobe = thing("wardrobe-0", 3, 3.7, (1.2, 0.6, 2))
        before = lambda y: broken(scene(wardrobe, thing("box-0", 3, y, (0.5, 0.5)), openings=DOOR))
        self.assertEqual(before(2.5), {("usable", "wardrobe-0")})
        self.assertEqual(before(2.3), set())
        rug = thing("box-0", 3, 2.5, (0.5, 0.5, 0.02), traits=("flat",))
        self.assertEqual(broken(scene(wardrobe, rug, openings=DOOR)), set())
        shelf = thing("box-0", 3, 3.2, (0.5, 0.2, 0.3), z=2.1, mount="floor")
        self.assertNotIn(("usable", "wardrobe-0"), broken(scene(wardrobe, shelf, openings=DOOR)))

    #     [desk]
    #     (chair)      a partner may stand in the zone, a box may not
    def test_partner(self):
        desk = thing("desk-0", 3, 3.7, (1.2, 0.6, 0.75))
        for name, expected in (("chair-0", set()), ("box-0", {("usable", "desk-0")})):
            other = thing(name, 3, 3.1, (0.5, 0.5), yaw=180)
            self.assertEqual(broken(scene(desk, other, openings=DOOR)), expected)

    #    +---------------+
    #    |  [W] |        |      a wall of boxes with a corridor of the given width
    #    |   v  |        |
    #    |     gap       |
    #    +-door-----+----+
    def corridor(self, width, yaw_room=0):
        def turn(p):
            x, y = geo.rotate(*p, math.radians(yaw_room))
            return 10 + x, 10 + y

        polygon = [turn(p) for p in RECTANGLE]
        barrier = thing("box-0", *turn((2.5, 0.5 * (4 - width))), (0.4, 4 - width), yaw_room)
        wardrobe = thing("wardrobe-0", *turn((4.5, 1.0)), (1.2, 0.6, 2), 270 + yaw_room)
        return broken(scene(barrier, wardrobe, polygon=polygon, openings=DOOR))

    def test_corridor(self):
        for yaw in (0, 90, 17, 45):
            self.assertEqual(self.corridor(0.45, yaw), {("usable", "wardrobe-0")}, yaw)
            self.assertEqual(self.corridor(0.50, yaw), set(), yaw)
            self.assertEqual(self.corridor(0.55, yaw), set(), yaw)

    def test_high_and_flat_things_do_not_block_a_corridor(self):
        wall = lambda **more: thing("box-0", 2.5, 2, (0.4, 4.0, more.pop("h", 0.9)), **more)
        wardrobe = thing("wardrobe-0", 4.7, 1.0, (1.2, 0.6, 2), 270)
        for barrier, free in (
            (wall(), False),
            (wall(traits=("flat",)), True),
            (wall(z=2.0, h=0.7, mount="ceiling"), True),
            (wall(z=1.76, h=0.94, mount="ceiling"), True),
            (wall(z=1.7, h=1.0, mount="ceiling"), False),
        ):
            found = broken(scene(barrier, wardrobe, openings=DOOR))
            self.assertEqual(found, set() if free else {("usable", "wardrobe-0")})

    def test_categories_without_zones_and_unknown_ones(self):
        walled_in = [thing("box-0", 4.5, 3.5, (0.2, 0.2)), thing("riddle-0", 0.3, 3.7, (0.2, 0.2))]
        self.assertEqual(broken(scene(*walled_in, openings=DOOR)), set())

    #   two doors, a barrier between them
    #   +---------------+
    #   |      ||       |
    #   +-door-++--door-+
    def test_connected(self):
        doors = DOOR + [("door-1", 0, 3.8, 4.7)]
        barrier = lambda length: scene(thing("box-0", 2.5, length / 2, (0.4, length)), openings=doors)
        self.assertEqual(broken(barrier(4.0)), {("connected", "door-0", "door-1")})
        self.assertEqual(broken(barrier(3.55)), {("connected", "door-0", "door-1")})
        self.assertEqual(broken(barrier(3.45)), set())

    def test_raster_agrees_with_exact_polygons(self):
        """The same question answered by growing polygons instead of by a raster."""
        random = np.random.default_rng(5)
        decided = 0
        for _ in range(60):
            boxes = [
                thing(
                    f"box-{k}",
                    *random.uniform((0.5, 1.2), (4.5, 3.5)),
                    tuple(random.uniform(0.3, 1.4, 2)),
                    random.uniform(0, 360),
                )
                for k in range(7)
            ]
            s = scene(*boxes, openings=DOOR + [("door-1", 2, 0.2, 1.1)])
            answers = {exact_connection(s, r) for r in (0.222, 0.238)}
            if len(answers) == 1:
                decided += 1
                walk = reach.WalkMap(s)
                self.assertEqual(bool(walk.from_door["door-0"] & walk.from_door["door-1"]), answers.pop())
        self.assertGreater(decided, 40)


def exact_connection(s, radius):
    """Whether a disc gets from the first entrance's clearance to the second's."""
    free = s.room.polygon.buffer(-radius).difference(
        shapely.union_all([t.footprint.buffer(radius, quad_segs=32) for t in s.things])
    )
    parts = shapely.get_parts(free)
    first, second = (reach.door_clearance(o) for o in s.room.entrances)
    return any(p.intersects(first) and p.intersects(second) for p in parts)


class Lookup(unittest.TestCase):
    def test_names(self):
        known = files.Categories.default()
        for text, expected in (
            ("bed", "bed"),
            ("Couch", "sofa"),
            ("oak writing desk", "desk"),
            ("bookshelves", "bookshelf"),
            ("dining chairs", "dining chair"),
            ("striped velvet sofa", "sofa"),
            ("spaceship", None),
        ):
            self.assertEqual(known.lookup(text), expected, text)

    def test_inheritance(self):
        known = files.Categories.default()
        self.assertTrue(known.is_a("office chair", "seat"))
        self.assertTrue(known.is_a("writing desk", "table"))
        self.assertFalse(known.is_a("bed", "seat"))
        self.assertEqual(known.zones("lamp"), [])
        self.assertEqual(len(known.zones("dining table")), 4)


if __name__ == "__main__":
    unittest.main()
