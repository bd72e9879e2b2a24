"""Every constraint, true and false, in several yaws, with answers found by hand."""

import math
import unittest

from cases import RECTANGLE, scene, thing
from roomgen_checker.constraints import LOOSE, STRICT, Judge, parse
from roomgen_checker.geometry import rotate

YAWS = (0, 90, 180, 270, 37)


def turned(point, yaw):
    """A point of an unturned drawing around (10, 10), the drawing turned by `yaw` degrees."""
    x, y = rotate(*point, math.radians(yaw))
    return 10 + x, 10 + y


HALL = ((0, 0), (20, 0), (20, 20), (0, 20))


class Case(unittest.TestCase):
    def holds(self, a_scene, name, text, limits=STRICT):
        return Judge(a_scene, limits).holds(a_scene.by_id[name], parse(text))

    def pair(
        self, text, offset, facing=0, target_size=(2, 1), size=(0.4, 0.4), traits=(), others=(), limits=STRICT
    ):
        """Whether `text` holds for a box at `offset` in the target's frame, the same in all yaws."""
        answers = set()
        for yaw in YAWS:
            a = thing("a-0", *turned(offset, yaw), size, yaw + facing, relations=(text, *others))
            t = thing("t-0", 10, 10, target_size, yaw, traits=tuple(traits))
            answers.add(self.holds(scene(t, a, polygon=HALL), "a-0", text, limits))
        self.assertEqual(len(answers), 1, f"{text} at {offset} depends on the yaw")
        return answers.pop()

    def yes(self, *args, **more):
        self.assertTrue(self.pair(*args, **more), args)

    def no(self, *args, **more):
        self.assertFalse(self.pair(*args, **more), args)


class Sides(Case):
    #                  behind
    #             +-------------+
    #    right    |    t-0      |   left      the target, 2 x 1, looks down:
    #    of it    |             |   of it     its left hand is at +x
    #             +-------------+
    #                 v front
    def test_in_front_of(self):
        self.yes("in front of, t-0", (0, -1))
        self.yes("in front of, t-0", (0.99, -3))
        self.no("in front of, t-0", (1.05, -3))
        self.no("in front of, t-0", (0, 1))
        self.no("in front of, t-0", (0, -0.45))

    def test_behind(self):
        self.yes("behind, t-0", (0, 1))
        self.yes("behind, t-0", (-0.99, 0.6))
        self.no("behind, t-0", (-1.05, 0.6))
        self.no("behind, t-0", (0, -1))

    def test_left_and_right_are_the_targets_own(self):
        self.yes("left of, t-0", (1.3, 0))
        self.yes("left of, t-0", (4, 0.49))
        self.no("left of, t-0", (4, 0.55))
        self.no("left of, t-0", (-1.3, 0))
        self.yes("right of, t-0", (-1.3, 0))
        self.no("right of, t-0", (1.3, 0))
        self.no("right of, t-0", (-1.3, -0.6))

    def test_side_of(self):
        self.yes("side of, t-0", (1.3, 0))
        self.yes("side of, t-0", (-1.3, 0))
        self.no("side of, t-0", (0.9, 0))
        self.no("side of, t-0", (0, -1))

    def test_names_are_not_case_sensitive(self):
        self.yes("In Front  Of , T-0", (0, -1))


class Gaps(Case):
    #      +---+  gap   +---+
    #      | t |<------>| a |      boxes half 1 (or 0.5) and 0.2 wide
    #      +---+        +---+
    def test_near_and_far(self):
        self.yes("near, t-0", (1 + 1.45 + 0.2, 0))
        self.no("near, t-0", (1 + 1.55 + 0.2, 0))
        self.yes("far, t-0", (1 + 1.55 + 0.2, 0))
        self.no("far, t-0", (1 + 1.45 + 0.2, 0))
        self.yes("near, t-0", (0, 0.5 + 1.45 + 0.2))
        self.no("near, t-0", (0, 0.5 + 1.55 + 0.2))

    def test_next_to(self):
        self.yes("next to, t-0", (1 + 0.45 + 0.2, 0))
        self.no("next to, t-0", (1 + 0.55 + 0.2, 0))

    def test_so_far(self):
        self.yes("gap 0.5 m, t-0", (1 + 0.59 + 0.2, 0))
        self.yes("gap 0.5 m, t-0", (1 + 0.41 + 0.2, 0))
        self.no("gap 0.5 m, t-0", (1 + 0.61 + 0.2, 0))
        self.no("gap 0.5 m, t-0", (1 + 0.39 + 0.2, 0))
        self.yes("gap at least 1.25 m, t-0", (1 + 3.0 + 0.2, 0))
        self.no("gap at least 1.25 m, t-0", (1 + 1.1 + 0.2, 0))
        self.yes("gap at most 1 m, t-0", (1 + 0.2, 0))
        self.no("gap at most 1 m, t-0", (1 + 1.15 + 0.2, 0))
        self.no("gap wide, t-0", (1 + 0.5 + 0.2, 0))

    #        .-'''-.
    #       (   t   )               the corner of a round target's box is empty:
    #        `-...-'                the diagonal gap is larger than that of the box
    #                 [a]
    def test_round_target(self):
        r, diagonal = 1.0, math.sqrt(0.5)
        at = lambda gap: ((r + gap) * diagonal + 0.2, -(r + gap) * diagonal - 0.2)
        self.yes("near, t-0", at(1.45), target_size=(2, 2), traits=["round"])
        self.no("near, t-0", at(1.55), target_size=(2, 2), traits=["round"])
        self.yes("near, t-0", at(1.55), target_size=(2, 2))
        self.yes("near, t-0", at(1.55), target_size=(2, 2), traits=["round"], limits=LOOSE)

    #      an ellipse 2 x 1: its end at (1, 0) is where the box has its side
    def test_ellipse(self):
        self.yes("near, t-0", (1 + 1.45 + 0.2, 0), traits=["round"])
        self.no("near, t-0", (1 + 1.55 + 0.2, 0), traits=["round"])
        self.no("near, t-0", (0, 0.5 + 1.55 + 0.2), traits=["round"])

    def test_corner_target(self):
        # .________
        # |a        the nearest corner serves near, the farthest far
        s = scene(thing("a-0", 0.5, 0.5), thing("b-0", 2.5, 2))
        self.assertTrue(self.holds(s, "a-0", "near, corner"))
        self.assertTrue(self.holds(s, "a-0", "far, corner"))
        self.assertFalse(self.holds(s, "b-0", "near, corner"))

    def test_walls_and_openings(self):
        #  +--[window-0]--+
        #  |              |
        #  |       b      |
        #  | a            |
        #  +--door-0------+
        s = scene(
            thing("a-0", 0.6, 0.5),
            thing("b-0", 2.5, 2),
            openings=[("door-0", 0, 0.3, 1.2), ("window-0", 2, 3, 4)],
        )
        self.assertTrue(self.holds(s, "a-0", "near, door-0"))
        self.assertTrue(self.holds(s, "a-0", "far, window-0"))
        self.assertTrue(self.holds(s, "a-0", "near, wall-3"))
        self.assertTrue(self.holds(s, "b-0", "far, wall-1"))
        self.assertFalse(self.holds(s, "b-0", "near, wall-1"))

    def test_missing_target(self):
        s = scene(thing("a-0", 1, 1))
        for text in ("near, b-0", "far, b-0", "far, a-0", "near", "beside, wall-0", "far, wall-9"):
            self.assertFalse(self.holds(s, "a-0", text), text)


class Facing(Case):
    #      +-----+
    #      |  t  |<--- a       the ray from the centre along the front
    #      +-----+
    def test_used_facing(self):
        wall = thing("t-0", 10, 14, (2, 1), 0)
        for kind, yaw in (("desk", 0), ("writing desk", 0), ("sofa", 180), ("vanity", 180)):
            for turn in (0, 180):
                user = thing(f"{kind}-0", 10, 10, (1, 1), yaw + turn, relations=("used facing, t-0",))
                s = scene(wall, user, polygon=HALL)
                self.assertEqual(self.holds(s, user.id, "used facing, t-0"), turn == 0, (kind, turn))

    def test_face_to(self):
        self.yes("face to, t-0", (0, 2), facing=0)  # above it, looking down
        self.no("face to, t-0", (0, 2), facing=180)
        self.yes("face to, t-0", (0, -2), facing=180)
        self.yes("face to, t-0", (3, 0), facing=270)  # at +x, looking to -x
        self.no("face to, t-0", (3, 0), facing=90)
        self.yes("face to, t-0", (3, 0.49), facing=270)
        self.no("face to, t-0", (3, 0.51), facing=270)

    def test_face_to_misses_the_empty_corner_of_an_ellipse(self):
        self.yes("face to, t-0", (1.4, 0.9), facing=-45)
        self.no("face to, t-0", (1.4, 0.9), facing=-10)
        self.yes("face to, t-0", (0, -1.3), facing=135)
        self.no("face to, t-0", (0, -1.3), facing=135, traits=["round"])
        self.yes("face to, t-0", (0.95, 2), facing=0, traits=["round"])
        self.no("face to, t-0", (1.01, 2), facing=0, traits=["round"])

    def test_face_to_opening_and_wall(self):
        s = scene(thing("a-0", 3.5, 2, yaw=180), openings=[("window-0", 2, 1, 2)])
        self.assertTrue(self.holds(s, "a-0", "face to, window-0"))  # wall 2 runs from x = 5
        self.assertTrue(self.holds(s, "a-0", "face to, wall-2"))
        self.assertFalse(self.holds(s, "a-0", "face to, wall-0"))

    def test_face_same_and_opposite(self):
        self.yes("face same as, t-0", (0, 2), facing=0.5)
        self.no("face same as, t-0", (0, 2), facing=1.5)
        self.no("face same as, t-0", (0, 2), facing=180)
        self.yes("face opposite to, t-0", (0, 2), facing=180.5)
        self.no("face opposite to, t-0", (0, 2), facing=181.5)
        self.yes("face same as, t-0", (0, 2), facing=360)

    def test_openings_look_into_the_room(self):
        s = scene(thing("a-0", 2, 2, yaw=0), openings=[("window-0", 2, 1, 2)])
        self.assertTrue(self.holds(s, "a-0", "face same as, window-0"))
        self.assertTrue(self.holds(s, "a-0", "face opposite to, wall-0"))

    def test_around(self):
        self.yes("around, t-0", (0, -0.5 - 0.55 - 0.2), facing=180)
        self.no("around, t-0", (0, -0.5 - 0.65 - 0.2), facing=180)
        self.no("around, t-0", (0, -0.5 - 0.55 - 0.2), facing=0)


class Aligned(Case):
    #        |              lateral: across the target's front
    #    +---|---+
    #  - | - t - | - - a    longitudinal: along its depth
    #    +---|---+
    #        v
    def test_either_when_alone(self):
        for word in ("aligned, t-0", "center aligned, t-0"):
            self.yes(word, (3, 0.04))
            self.yes(word, (0.04, 3))
            self.no(word, (3, 0.06))
            self.no(word, (0.06, 3))

    def test_lateral_with_in_front_of(self):
        self.yes("aligned, t-0", (0.04, -2), others=["in front of, t-0"])
        self.no("aligned, t-0", (2, 0.04), others=["in front of, t-0"])
        self.no("aligned, t-0", (2, 0.04), others=["behind, t-0"])

    def test_longitudinal_with_sides(self):
        for side in ("left of", "right of", "side of"):
            self.yes("aligned, t-0", (2, 0.04), others=[f"{side}, t-0"])
            self.no("aligned, t-0", (0.04, 2), others=[f"{side}, t-0"])

    def test_another_targets_side_does_not_count(self):
        self.yes("aligned, t-0", (2, 0.04), others=["in front of, wall-0"])

    def test_loose_takes_either(self):
        self.yes("aligned, t-0", (2, 0.04), others=["in front of, t-0"], limits=LOOSE)


class Walls(Case):
    #          wall-2
    #     +---------------+
    #     |  [back to it] |       front down: its back is at wall-2
    #     |               |
    #     +---------------+
    def at_wall(self, text, x, y, yaw, size=(1, 0.6), polygon=RECTANGLE, limits=STRICT):
        return self.holds(scene(thing("a-0", x, y, size, yaw), polygon=polygon), "a-0", text, limits)

    def test_edge_at_every_wall(self):
        for x, y, yaw in ((2, 3.66, 0), (2, 0.34, 180), (0.34, 2, 90), (4.66, 2, 270)):
            self.assertTrue(self.at_wall("edge", x, y, yaw), yaw)
            self.assertFalse(self.at_wall("edge", x, y, yaw + 180), yaw)
            self.assertFalse(self.at_wall("edge", x, y, yaw + 90), yaw)
            self.assertFalse(self.at_wall("edge", x, y, yaw + 1.5), yaw)
            self.assertTrue(self.at_wall("edge", x, y, yaw + 0.5), yaw)

    def test_edge_distance(self):
        self.assertTrue(self.at_wall("edge", 2, 4 - 0.3 - 0.049, 0))
        self.assertFalse(self.at_wall("edge", 2, 4 - 0.3 - 0.06, 0))
        self.assertTrue(self.at_wall("edge", 2, 4 - 0.3 - 0.06, 0, limits=LOOSE))

    #     +-------+
    #     |       |          L: the line of the upper arm's wall goes on through the room,
    #     |   |[a]+-----+    but there is no wall beside a thing that stands on it further right
    #     |          [b]|
    #     +-------------+
    L_ROOM = ((0, 0), (6, 0), (6, 2.6), (3, 2.6), (3, 5), (0, 5))

    def test_edge_needs_the_wall_beside_it(self):
        self.assertTrue(self.at_wall("edge", 4.5, 2.3, 0, polygon=self.L_ROOM))
        self.assertFalse(self.at_wall("edge", 2.4, 2.3, 0, polygon=self.L_ROOM))
        self.assertTrue(self.at_wall("edge", 2.7, 4, 270, polygon=self.L_ROOM))
        self.assertFalse(self.at_wall("edge", 2.7, 2.0, 270, polygon=self.L_ROOM))

    #     +------------.
    #     |          a  \        a slanted wall at 45 degrees
    #     |              \
    #     +---------------+
    def test_slanted_wall(self):
        room = ((0, 0), (6, 0), (6, 2), (4, 4), (0, 4))
        inward = 0.32 / math.sqrt(2)
        self.assertTrue(self.at_wall("edge", 5 - inward, 3 - inward, 315, polygon=room))
        self.assertFalse(self.at_wall("edge", 5 - inward, 3 - inward, 270, polygon=room))
        self.assertFalse(self.at_wall("edge", 5 - inward, 3 - inward, 313, polygon=room))

    def test_winding_does_not_matter(self):
        for polygon in (RECTANGLE, tuple(reversed(RECTANGLE))):
            self.assertTrue(self.at_wall("edge", 2, 3.66, 0, polygon=polygon))
            self.assertFalse(self.at_wall("edge", 2, 3.66, 180, polygon=polygon))

    #     +----------+
    #     |[a]       |
    #     |          |
    def test_corner(self):
        self.assertTrue(self.at_wall("corner", 0.5, 3.7, 0))
        self.assertTrue(self.at_wall("corner", 0.59, 3.7, 0))
        self.assertFalse(self.at_wall("corner", 0.62, 3.7, 0))
        self.assertTrue(self.at_wall("corner", 4.5, 3.7, 0))
        self.assertFalse(self.at_wall("corner", 0.5, 3.6, 0))

    #      a reflex corner is no corner to stand in
    #         |  +--
    #     [a] +--+
    def test_reflex_corner(self):
        self.assertFalse(self.at_wall("corner", 3.55, 2.3, 0, polygon=self.L_ROOM))

    #     +----------+
    #     |  +----+  |  0.30 m all around
    #     |  | a  |  |
    def test_middle(self):
        self.assertTrue(self.at_wall("middle", 0.81, 2, 0))
        self.assertFalse(self.at_wall("middle", 0.79, 2, 0))
        self.assertFalse(self.at_wall("middle", 2, 4 - 0.59, 0))
        self.assertFalse(self.at_wall("middle", 0.85, 2, 45, size=(1, 0.6)))

    def test_middle_of_a_round_thing(self):
        # its box turned by 45 degrees would be nearer to the wall than the disc is
        round_one = thing("a-0", 0.82, 2, (1, 1), 45, traits=("round",))
        square = thing("b-0", 0.82, 2, (1, 1), 45)
        s = scene(round_one, square)
        self.assertTrue(self.holds(s, "a-0", "middle"))
        self.assertFalse(self.holds(s, "b-0", "middle"))


class Between(Case):
    #   a     b
    # [ 1 ] [ 1 ]   the gap is 2 wide
    def place(self, x, y):
        beds = thing("a-0", 1, 2, (1, 1)), thing("b-0", 4, 2, (1, 1))
        one = thing("c-0", x, y, (0.4, 0.4), relations=("between, a-0", "between, b-0"))
        return self.holds(scene(*beds, one), "c-0", "between, a-0")

    def test_between(self):
        self.assertTrue(self.place(2.5, 2))
        self.assertTrue(self.place(1.6, 2.45))
        self.assertFalse(self.place(2.5, 2.6))
        self.assertFalse(self.place(1.3, 2))
        self.assertFalse(self.place(4.8, 2))

    def test_between_needs_two(self):
        lone = thing("c-0", 2.5, 2, (0.4, 0.4), relations=("between, a-0",))
        self.assertFalse(self.holds(scene(thing("a-0", 1, 2), lone), "c-0", "between, a-0"))


class Regions(Case):
    def test_in_part(self):
        s = scene(thing("a-0", 1, 3))
        for name in ("north-half", "west-half", "north-west-quarter", "west-third"):
            self.assertTrue(self.holds(s, "a-0", f"in part, {name}"), name)
        for name in ("south-half", "east-half", "south-west-quarter", "middle-third", "up-half", "north"):
            self.assertFalse(self.holds(s, "a-0", f"in part, {name}"), name)


class UpAndDown(Case):
    def test_on(self):
        s = scene(
            thing("t-0", 2, 2),
            thing("a-0", 2, 2, (0.2, 0.2, 0.3), z=0.9, mount="surface", on="t-0"),
            thing("b-0", 4, 2),
        )
        self.assertTrue(self.holds(s, "a-0", "on, t-0"))
        self.assertFalse(self.holds(s, "a-0", "on, b-0"))
        self.assertFalse(self.holds(s, "b-0", "on, t-0"))

    #   [picture]
    #             0.2
    #   [ sofa  ]
    def test_above_and_under(self):
        sofa = thing("sofa-0", 2, 3.55, (2, 0.9, 0.8))
        over = thing("picture-0", 2.9, 3.98, (1, 0.04, 0.6), z=1.0, mount="wall")
        beside = thing("picture-1", 3.1, 3.98, (1, 0.04, 0.6), z=1.0, mount="wall")
        low = thing("picture-2", 2.0, 3.98, (1, 0.04, 0.6), z=0.7, mount="wall")
        s = scene(sofa, over, beside, low)
        self.assertTrue(self.holds(s, "picture-0", "above, sofa-0"))
        self.assertFalse(self.holds(s, "picture-1", "above, sofa-0"))
        self.assertFalse(self.holds(s, "picture-2", "above, sofa-0"))
        self.assertFalse(self.holds(s, "sofa-0", "under, picture-2"))
        table, lamp = thing("t-0", 1, 1, (1, 1, 0.7)), thing("lamp-0", 1.15, 1, (0.4, 0.4, 0.5), z=2.2)
        s = scene(table, lamp)
        self.assertTrue(self.holds(s, "lamp-0", "above, t-0"))
        self.assertTrue(self.holds(s, "t-0", "under, lamp-0"))

    def test_hang_from(self):
        s = scene(
            thing("lamp-0", 2, 2, (0.4, 0.4, 0.5), z=2.2, mount="ceiling"),
            thing("lamp-1", 2, 2, (0.4, 0.4, 0.5), z=1.9, mount="ceiling"),
            thing("picture-0", 2, 3.98, (1, 0.04, 0.6), z=1.0, mount="wall"),
        )
        self.assertTrue(self.holds(s, "lamp-0", "hang from, ceiling"))
        self.assertFalse(self.holds(s, "lamp-1", "hang from, ceiling"))
        self.assertTrue(self.holds(s, "picture-0", "hang from, wall-2"))
        self.assertFalse(self.holds(s, "picture-0", "hang from, wall-1"))


if __name__ == "__main__":
    unittest.main()
