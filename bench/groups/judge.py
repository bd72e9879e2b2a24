#!/usr/bin/env python3
"""Judges groups of furniture in scene.json files by poses and sizes alone; README.md has the rules.
Usage: judge.py [--json] [--half open|kept] FOLDER [wishes.json]  (FOLDER/<id>/scene.json)  |  judge.py --self-test"""
import argparse, json, math, os, re, sys
from itertools import combinations
TOL = 0.05                                                 # metres off the regular place
TABLE_ZONE, DESK_ZONE, VISITOR_ZONE, LOUNGE_ZONE = (-0.35, 0.15), (-0.35, 0.30), (-0.35, 0.60), (0.15, 1.20)
SEAT_RULES = ("seats at table", "chair at desk", "visitors", "stools at bar")

class Obj:
    def __init__(self, o):
        self.id, self.cat = o["id"], o["category"].lower().strip()
        self.w, self.d, self.h = (float(v) for v in o["size"])
        self.x, self.y, self.z = (float(v) for v in o["position"])
        self.yaw = float(o.get("yaw_deg") or 0)
        if not (0 < self.w < 99 and 0 < self.d < 99 and math.isfinite(self.x + self.y + self.z + self.yaw)): raise ValueError("not a size or a pose")
        self.front, self.round = (k in (["front"] if o.get("traits") is None else o["traits"]) for k in ("front", "round"))
        c, s = math.cos(math.radians(self.yaw)), math.sin(math.radians(self.yaw))
        self.u, self.v, self.p, self.f = (c, s), (-s, c), (self.x, self.y), (s, -c)     # f: front, -Y at yaw 0
        self.weight = max(1, int(self.w / 0.55)) if re.search(r"(bench|banquette|pew)$", self.cat) else 1
    def local(self, p): return dot(sub(p, self.p), self.u), dot(sub(p, self.p), self.v)     # in this object's frame
    def reach(self, n): return abs(dot(self.u, n)) * self.w / 2 + abs(dot(self.v, n)) * self.d / 2     # half extent
    def fronts(self, wish):                                # the way it looks that suits `wish` best, and its half depth there
        if self.front: return self.f, self.d / 2
        f = wish if self.round else max((self.f, self.u, self.v, (-self.u[0], -self.u[1])), key=lambda g: dot(g, wish))
        return f, self.reach(f)
    def sides(self):                                       # name, middle, inward normal, tangent, length
        for name, k, n, t, half, length in (("front", -1, self.v, self.u, self.d / 2, self.w), ("back", 1, self.v, self.u, self.d / 2, self.w),
                                            ("left", -1, self.u, self.v, self.w / 2, self.d), ("right", 1, self.u, self.v, self.w / 2, self.d)):
            yield name, (self.x + k * half * n[0], self.y + k * half * n[1]), (-k * n[0], -k * n[1]), t, length
def dot(a, b): return a[0] * b[0] + a[1] * b[1]
def sub(a, b): return a[0] - b[0], a[1] - b[1]
def unit(a): return (a[0] / math.hypot(*a), a[1] / math.hypot(*a)) if math.hypot(*a) > 1e-9 else (0.0, 0.0)
def angle(a, b): return math.degrees(math.acos(max(-1.0, min(1.0, dot(unit(a), unit(b))))))
def turn(a, b, period=360): return min((a - b) % period, (b - a) % period)     # difference of yaws
def median(v): return sorted(v)[(len(v) - 1) // 2]
def gap(a, o):                                             # from the thing's near edge to the target's box, roughly
    x, y = o.local(a.p)
    return max(0.0, math.hypot(max(0, abs(x) - o.w / 2), max(0, abs(y) - o.d / 2)) - min(a.w, a.d) / 2)
def is_a(cat, words):                                      # the category's last words; "-word" excludes
    head = re.split(r" (?:with|on|of|for|in) ", cat.replace("_", " ").replace("’", "'"))[0]
    end = lambda w: head == w or head.endswith(" " + w) or head.endswith("-" + w)
    return any(end(w) for w in words if w[0] != "-") and not any(end(w[1:]) for w in words if w[0] == "-")
def fit_line(s, symmetric=False, lowest=0.3):
    """Indexes of the values within TOL of equal pitch (about 0 if symmetric)."""
    n = len(s)
    if n < 2: return {i for i in range(n) if not symmetric or abs(s[i]) <= TOL + 1e-6}
    order, m, ks, mean = sorted(range(n), key=lambda i: s[i]), (n - 1) / 2, range(n), sum(s) / n
    v = [s[i] for i in order]
    ls = sum((k - m) * v[k] for k in ks) / sum((k - m) ** 2 for k in ks)
    pitches = [ls] + [(v[j] - v[i]) / (j - i) for i, j in combinations(ks, 2)]
    ok = lambda a, p: {order[k] for k in ks if abs(v[k] - a - k * p) <= TOL + 1e-6}
    tries = [(-m * p, p) for p in pitches + [v[k] / (k - m) for k in ks if abs(k - m) > 0.1]] if symmetric else \
            [(mean - m * ls, ls)] + [(v[i] - i * p, p) for i, p in zip((i for i, _ in combinations(ks, 2)), pitches[1:])]
    best = max((ok(a, p) for a, p in tries if p >= lowest), key=len, default=set())
    if symmetric and n >= 3 and ls >= lowest and abs(mean) <= ls / 2 + TOL and len(ok(mean - m * ls, ls)) == n: best = set(ks)  # one place short at an end
    return best
def fit_angles(phi, radii):
    """Indexes of the angles at equal angles all round, or at an equal pitch over an arc."""
    n, best, full = len(phi), set(), 2 * math.pi
    if n <= 1: return set(range(n))
    for base in [p + q * TOL / max(r, 0.1) for p, r in zip(phi, radii) for q in (0, -0.99, -0.5, 0.5, 0.99)]:
        slots = {}
        for i, p in enumerate(phi):
            k = round((p - base) * n / full)
            if abs(p - base - k * full / n) * radii[i] <= TOL + 1e-6: slots.setdefault(k % n, i)
        best = max(best, set(slots.values()), key=len)
    order = sorted(p % full for p in phi)
    start = order[max(range(n), key=lambda k: (order[k] - order[k - 1]) % full)]      # after the widest gap
    arc = n >= 3 and len(fit_line([(p - start) % full * median(radii) for p in order])) == n
    return set(range(n)) if arc else best

def at_sides(seats, targets, zone, names=None, ang=10, slack=0.0, symmetric=True, radial="pattern", best_side=False, each=None):
    """The seats that stand right at an edge (or rim) of one of the targets."""
    spot = {}                                              # seat -> (wrongly turned, |e|, target, side, lateral)
    def consider(i, t, side, e, lateral, aslant, extra=0):
        v = (aslant, abs(e) + extra, t, side, lateral)
        if zone[0] - 1e-6 <= e <= zone[1] + 1e-6 and (i not in spot or v[:2] < spot[i][:2]): spot[i] = v
    for i, t, s, o in ((i, t, s, o) for i, s in enumerate(seats) for t, o in enumerate(targets)):
        circle = o.round and max(o.w, o.d) < 1.12 * min(o.w, o.d)
        for name, mid, n, tan, length in () if circle and radial else (v for v in o.sides() if not names or not o.front or v[0] in names):
            f, half = s.fronts(n)
            aslant = angle(f, n) > ang + 1e-6
            if aslant: f, half = n, s.reach(n)             # for the pattern only
            lat = dot(sub(s.p, mid), tan)
            if abs(lat) <= length / 2 + slack + 1e-6: consider(i, t, name, -dot(sub((s.x + f[0] * half, s.y + f[1] * half), mid), n), lat, aslant)
        to, (a, b) = unit(sub(o.p, s.p)), o.local(s.p)
        f, half = s.fronts(to)
        if radial and (o.round or radial == "any" and turn(s.yaw, o.yaw, 90) > 10):
            c, aslant = unit((a, b)), angle(f, to) > 10 + 1e-6
            rim = 1 / math.hypot(c[0] / (o.w / 2), c[1] / (o.d / 2)) if o.round else min(o.w / 2 / max(abs(c[0]), 1e-9), o.d / 2 / max(abs(c[1]), 1e-9))
            consider(i, t, "rim", math.hypot(a, b) - half - rim, (math.atan2(b, a), math.hypot(a, b)), aslant, 0 if circle else 1)
    right = set()
    for t in range(len(targets)):
        found = []
        for side in ("front", "back", "left", "right", "rim"):
            every = [k for k, v in spot.items() if v[2:4] == (t, side)]
            facing, best = [k for k in every if not spot[k][0]], []
            for ks in (facing, every):                     # one that looks away still keeps its place in the pattern
                at = [spot[k][4] for k in ks]
                if side != "rim": ok = fit_line(at, symmetric)
                else: ok = fit_angles([v[0] for v in at], [v[1] for v in at]) if radial == "pattern" else range(len(ks))
                best = max(best, [ks[j] for j in sorted(ok) if ks[j] in facing], key=len)
            found.append(best)
        chosen = max(found, key=len) if best_side else [k for f in found for k in f]
        right |= set(chosen[:each] if each else chosen)
    return right

def in_rows(things, rule, targets):
    left, right = list(range(len(things))), set()
    while left:
        near = lambda i: [j for j in left if turn(things[j].yaw, things[i].yaw, 180 if rule.get("half_turn") or not things[j].front else 360) <= 3 + 1e-6]
        o, group = max(((things[i], near(i)) for i in left), key=lambda v: len(v[1]))
        left = [j for j in left if j not in group]
        c, rows = {j: (dot(things[j].p, o.u), dot(things[j].p, o.v)) for j in group}, []
        for j in sorted(group, key=lambda j: c[j][1]):
            if rows and c[j][1] - c[rows[-1][-1]][1] <= 0.25: rows[-1].append(j)
            else: rows.append([j])
        columns = sum(len(r) == 1 for r in rows) * 2 > len(rows)   # one thing in each row
        if rule.get("rows"): rows = sorted(sorted(rows, key=len, reverse=True)[:rule["rows"]], key=lambda r: c[r[0]][1])
        elif not columns: rows = [r for r in rows if len(r) > 1]
        lines = [median([c[j][1] for j in r]) for r in rows]
        across = [sorted(c[j][0] for j in r) for r in rows]
        gaps, mid = [b - a for r in across for a, b in zip(r, r[1:])], median([r[0] for r in across]) if rows else 0
        ok, good = set(), pitch(lines) if len(rows) > 2 else range(len(rows))
        for k, r in enumerate(rows):
            line = [j for j in r if abs(c[j][1] - lines[k]) <= TOL + 1e-6]
            if k in good and columns and len(r) == 1: ok |= {j for j in r if abs(c[j][0] - mid) <= TOL + 1e-6}
            elif k in good: ok |= {line[i] for i in pitch([c[j][0] for j in line], median(gaps) if gaps else None)}
        if targets and o.front and group:                  # something to look at, ahead and not far aside
            way, (a, b) = 1 if rule.get("reverse") else -1, zip(*c.values())
            if not any(min(a) - 1 <= dot(t.p, o.u) <= max(a) + 1 and dot(t.p, o.v) * way > max(y * way for y in b) for t in targets): ok = set()
        right |= ok
        if not rule.get("turned"): break
    return right
def pitch(values, common=None):
    """Indexes at equal pitch in blocks between aisles."""
    order = sorted(range(len(values)), key=lambda i: values[i])
    if len(order) < 2: return set(order)
    p, blocks, out = common or median([values[b] - values[a] for a, b in zip(order, order[1:])]), [[order[0]]], set()
    for a, b in zip(order, order[1:]):
        if values[b] - values[a] > 1.35 * p: blocks.append([])
        blocks[-1].append(b)
    for b in blocks:
        if len(b) == 2 and abs(values[b[1]] - values[b[0]] - p) > TOL + 1e-6: out.add(b[0])
        else: out |= {b[i] for i in fit_line([values[j] for j in b], lowest=0.2)}
    return out

def in_circle(things, sign=1):
    best, n = set(), len(things)
    centres = [(sum(o.x for o in things) / n, sum(o.y for o in things) / n)] if n > 2 else []
    for a, b, c in combinations([o.p for o in things], 3):
        d = 2 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]))
        q = [dot(p, p) / d for p in (a, b, c)] if abs(d) > 0.1 else None
        if q: centres.append((q[0] * (b[1] - c[1]) + q[1] * (c[1] - a[1]) + q[2] * (a[1] - b[1]), q[0] * (c[0] - b[0]) + q[1] * (a[0] - c[0]) + q[2] * (b[0] - a[0])))
    for m in centres:
        r, inward = median([math.dist(o.p, m) for o in things]), lambda o: (sign * (m[0] - o.x), sign * (m[1] - o.y))
        ks = [i for i, o in enumerate(things) if abs(math.dist(o.p, m) - r) <= TOL + 1e-6 and angle(o.fronts(unit(inward(o)))[0], inward(o)) <= 10]
        if len(ks) > len(best): best = max(best, {ks[i] for i in fit_angles([math.atan2(things[i].y - m[1], things[i].x - m[0]) for i in ks], [r] * len(ks))}, key=len)
    return best
def in_horseshoe(things, sign):
    best, n = set(), len(things)
    centre = (sum(o.x for o in things) / n, sum(o.y for o in things) / n)
    for o in things:
        arms = [[i for i, t in enumerate(things) if turn(t.yaw, o.yaw + q) <= 3 and dot(sub(centre, t.p), t.f) * sign > 0] for q in (0, 90, -90)]
        ok = {a[i] for a in arms for i in in_rows([things[k] for k in a], {"rows": 1}, [])}
        if all(arms) and len(ok) > len(best): best = ok
    return max(best, in_circle(things, sign), key=len)
def in_islands(things, size):
    def touch(a, b):
        x, y = b.local(a.p)
        return abs(x) <= a.reach(b.u) + b.w / 2 + 0.1 and abs(y) <= a.reach(b.v) + b.d / 2 + 0.1
    right = set()
    for i, o in enumerate(things):
        island = {i}
        for _ in range(size + 1): island |= {j for j, t in enumerate(things) if any(touch(t, things[k]) for k in island)}
        rel = [o.local(things[j].p) for j in island if j != i and turn(o.yaw, things[j].yaw, 90) <= 3]
        if len(island) == size and min((min(abs(a), abs(b)) for a, b in rel), default=1) <= TOL + 1e-6: right.add(i)
    return right

def one_to_one(things, of, fits):
    right, used = set(), set()
    for i, o in enumerate(things):
        k = next((k for k, t in enumerate(of) if k not in used and t is not o and fits(o, t, *t.local(o.p))), None)
        if k is not None: right.add(i); used.add(k)
    return right
# Below (x, y) is the place of the thing o in the frame of the target t.
def beside(o, t, x, y):
    return (not o.front and o.round or turn(o.yaw, t.yaw, 360 if o.front else 90) <= 5 + 1e-6) and -0.05 <= abs(x) - t.w / 2 - o.reach(t.u) <= 0.15 + 1e-6 and abs(y + o.reach(t.v) - t.d / 2) <= 0.10 + 1e-6
def over(o, t, x, y): return abs(x) <= TOL + 1e-6 and abs(y) <= t.d / 2 and o.z >= t.z + t.h - 0.1
def at_mirror(o, t, x, y): return abs(x) <= TOL + 1e-6 and 0.2 <= -y <= 2.2 and turn(o.yaw, t.yaw + 180) <= 10 + 1e-6
def before(o, t, x, y): return abs(x) <= TOL + 1e-6 and -0.2 <= -y - t.d / 2 - o.reach(t.v) <= 0.8
def opposite(o, t, x, y): return turn(o.yaw, t.yaw) >= 175 - 1e-6 and abs(x) <= TOL + 1e-6 and 0 < -y - o.d / 2 - t.d / 2 <= 4
def toward(o, t, x, y): return -o.local(t.p)[1] > 0 and abs(o.local(t.p)[0]) <= t.reach(o.u) and gap(o, t) <= 4
def flanking(o, p, t):
    (a, b), (c, d) = t.local(o.p), t.local(p.p)
    return abs(a + c) <= 2 * TOL and a * c < 0 and abs(b - d) <= TOL + 1e-6 and abs(turn(o.yaw, t.yaw) - turn(p.yaw, t.yaw)) <= 5
PAIRS = {"over": over, "facing mirror at station": at_mirror, "before": before}     # one thing to one other
SIDES = {"seats at table": dict(zone=TABLE_ZONE), "chair at desk": dict(zone=DESK_ZONE, names=["front"], radial=None),
         "visitors": dict(zone=VISITOR_ZONE, names=["back"], ang=20, radial=None),
         "stools at bar": dict(zone=TABLE_ZONE, symmetric=False, radial=None, best_side=True), "around": dict(zone=LOUNGE_ZONE, slack=0.6, radial="any")}
def right_ones(r, things, of, scene):
    name, sign = r["rule"], -1 if r.get("reverse") else 1
    some = lambda fits, others: {i for i, o in enumerate(things) if any(t is not o and fits(o, t, *t.local(o.p)) for t in others)}
    if name in SIDES: return at_sides(things, of, each=r.get("each"), **SIDES[name])
    if name in PAIRS: return one_to_one(things, of, PAIRS[name])
    if name == "rows": return in_rows(things, r, [o for o in scene if is_a(o.cat, r.get("facing", []))])
    if name == "circle": return in_circle(things)
    if name == "horseshoe": return in_horseshoe(things, sign)
    if name == "islands": return in_islands(things, r["size"])
    if name == "beside": return some(beside, of)
    if name == "face to face": return some(opposite, things)
    if name == "toward": return some(lambda o, t, x, y: toward(o, t, x, y) and (abs(x) <= TOL + 1e-6 or not r.get("centred")), of)
    if name == "flanking": return some(lambda o, p, x, y: any(flanking(o, p, t) for t in of), things)
    if name == "there": return set(range(len(things)))
    raise ValueError("unknown rule " + name)

def judge(wish, scene):
    rules, out, lists = wish["expect"], [], []
    for r in rules:
        of = [o for o in scene if is_a(o.cat, next((r[k] for k in ("table", "desk", "bar", "of") if k in r), []))]
        things = [o for o in scene if is_a(o.cat, r.get("seat") or r.get("thing") or [])]
        lists.append((things, of, {things[i].id for i in right_ones(r, things, of, scene)} if things else set()))
    claimed, mine = {}, {k: [] for k in range(len(rules))}
    weigh = lambda k, o: 1 if rules[k].get("unit") == "things" else o.weight
    want = lambda k: rules[k].get("count") or rules[k].get("least") or rules[k].get("each", 1) * max(1, len(lists[k][1]))
    seat_rules = [k for k, r in enumerate(rules) if r["rule"] in SEAT_RULES]
    for k in seat_rules:                                   # a seat belongs to one seat rule: where it stands right ...
        for o in lists[k][0]:
            if o.id in lists[k][2] and claimed.setdefault(o.id, k) == k: mine[k].append(o)
    for o in scene:                                        # ... or else the nearest, first where one lacks
        options = [k for k in seat_rules if o.id not in claimed and any(t is o for t in lists[k][0])]
        def cost(k): return round(2 * min([gap(o, t) for t in lists[k][1]] or [9])), sum(weigh(k, m) for m in mine[k]) >= want(k)
        if options: mine[min(options, key=cost)].append(o)
    for k, r in enumerate(rules):
        things, of, ok = lists[k]
        if k in seat_rules:
            found, right = sum(weigh(k, o) for o in mine[k]), sum(weigh(k, o) for o in mine[k] if o.id in ok)
            spare = sum(weigh(k, o) for o in mine[k] if o.id not in ok and min([gap(o, t) for t in of] or [9]) > 1)
            if "count" in r: found -= min(spare, max(0, found - want(k)))     # spare seats far from every table are nobody's
        else: found, right = len(things) if r["rule"] == "there" else max(len(ok), min(len(things), want(k))), len(ok)
        out.append({"rule": r["rule"], "found": found, "right": right, "wanted": want(k)})
    return out
def load(folder, wish_id):
    for name in (str(wish_id), "%02d" % wish_id, "%03d" % wish_id):
        try:
            with open(os.path.join(folder, name, "scene.json"), encoding="utf-8") as f: objects = list(json.load(f)["objects"])
        except (OSError, ValueError, KeyError, TypeError): continue
        scene = []
        for n, o in enumerate(objects):
            try: scene.append(Obj(dict(o, id=n)))
            except (KeyError, ValueError, TypeError, AttributeError): pass
        return scene

def totals(results):
    out = {"wishes": len(results), "scenes": sum(w["scene"] for w in results),
           "wishes_whole": sum(all(r["right"] == r["found"] >= r["wanted"] for r in w["rules"]) for w in results)}
    share = lambda a, b: round(a / b, 4) if b else None
    for kind in ("seats", "others", "all"):
        rs = [r for w in results for r in w["rules"] if kind == "all" or (r["rule"] in SEAT_RULES) == (kind == "seats")]
        placed = [r for r in rs if r["rule"] != "there"]   # `there` asks for presence only
        found, right, wanted = (sum(r[k] for r in placed) for k in ("found", "right", "wanted"))
        out[kind] = {"found": found, "right": right, "wanted": wanted, "right_share": share(right, found),
                     "there_share": share(sum(min(r["found"], r["wanted"]) for r in rs), sum(r["wanted"] for r in rs)),
                     "there_and_right_share": share(sum(min(r["right"], r["wanted"]) for r in placed), wanted)}
    return out

def scene_of(rows, degrees=0, at=(3, 2)):                  # (category, w, d, x, y, yaw[, traits[, z, h]]) in a turned room
    c, s_, out = math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), []
    for n, (cat, w, d, x, y, yaw, *more) in enumerate(rows):
        traits, z, h = more + [["front"], 0, 0.8][len(more):]
        out.append(Obj({"id": n, "category": cat, "size": [w, d, h], "position": [at[0] + c * x - s_ * y, at[1] + s_ * x + c * y, z], "yaw_deg": yaw + degrees, "traits": traits}))
    return out
def self_test():
    chair = lambda x, y, yaw, cat="dining chair": (cat, 0.45, 0.5, x, y, yaw)
    table = ("dining table", 1.8, 0.9, 0, 0, 0, [])
    six = [table] + [chair(x, k * 0.6, yaw) for x in (-0.45, 0.45) for k, yaw in ((1, 0), (-1, 180))] + [chair(1.05, 0, -90), chair(-1.05, 0, 90)]
    def but(rows, k, **kw):                                # the scene with one thing at another pose
        return rows[:k] + [rows[k][:3] + tuple(kw.get(n, v) for n, v in zip(("x", "y", "yaw"), rows[k][3:])) + rows[k][6:]] + rows[k + 1:]
    polar = lambda n, r, cat="dining chair", off=0: [chair(r * math.cos(t), r * math.sin(t), math.degrees(t) - 90 + off, cat) for t in (2 * math.pi * k / n for k in range(n))]
    seats = {"rule": "seats at table", "seat": ["chair"], "table": ["table"], "count": 6}
    five, roundt = dict(seats, count=5), ("table", 1.2, 1.2, 0, 0, 0, ["round"])
    desk = [("desk", 1.4, 0.7, 0, 0, 0), chair(0, -0.55, 180, "office chair"), chair(-0.35, 0.75, 0, "visitor chair"), chair(0.35, 0.75, 0, "visitor chair")]
    sit, vis = {"rule": "chair at desk", "seat": ["chair"], "desk": ["desk"], "count": 1}, {"rule": "visitors", "seat": ["chair"], "desk": ["desk"], "count": 2}
    bed = [("bed", 1.6, 2.1, 0, 0, 0), ("nightstand", 0.45, 0.4, 1.05, 0.85, 0), ("nightstand", 0.45, 0.4, -1.05, 0.85, 0)]
    night = {"rule": "beside", "thing": ["nightstand"], "of": ["bed"], "each": 2}
    bar = [("bar counter", 3.0, 0.6, 0, 0, 180)] + [("bar stool", 0.4, 0.4, x, 0.55, 0) for x in (-1.2, -0.6, 0, 0.6, 1.2)]
    stools = {"rule": "stools at bar", "seat": ["stool"], "bar": ["counter"], "count": 5}
    rows = [("seat", 0.5, 0.5, x, y, 0) for y in (0, 1, 2) for x in (0, 0.6, 1.2, 2.6, 3.2, 3.8)] + [("screen", 2, 0.1, 2, -3, 180)]
    audience = {"rule": "rows", "thing": ["seat"], "rows": 3, "count": 18, "facing": ["screen"]}
    salon = [row for x in (0, 1.5) for row in (("mirror", 0.7, 0.03, x, 3, 0, ["front"], 0.9, 1.0), ("styling chair", 0.6, 0.6, x, 2.1, 180))]
    mirror = {"rule": "facing mirror at station", "thing": ["chair"], "of": ["mirror"], "count": 2}
    hob = [("stove", 0.6, 0.6, 0, 0, 0, ["front"], 0, 0.9), ("range hood", 0.6, 0.4, 0.03, 0.1, 0, ["front"], 1.6, 0.5)]
    hood = {"rule": "over", "thing": ["hood"], "of": ["stove"], "count": 1}
    sofas = [("coffee table", 1.2, 0.6, 0, 0, 0, []), ("sofa", 2, 0.9, 0, 1.15, 0), ("sofa", 2, 0.9, 0, -1.15, 180), ("armchair", 0.8, 0.8, 1.4, 0, -90)]
    face, about = {"rule": "face to face", "thing": ["sofa"], "count": 2}, {"rule": "around", "thing": ["sofa", "armchair"], "of": ["coffee table"], "count": 3}
    isle = [("student desk", 0.6, 0.5, x + 0.3 * i, y + 0.25 * j, 90 + 90 * j) for x in (0, 3) for y in (0,) for i in (-1, 1) for j in (-1, 1)]
    shoe = [("desk", 0.7, 0.5, x, 0, 0) for x in (0, 0.7, 1.4)] + [("desk", 0.7, 0.5, q, y, yaw) for q, yaw in ((-0.7, 90), (2.1, -90)) for y in (-0.9, -1.6)]
    cases = [("six at a table", six, seats, (6, 6, 6)), ("turned 180", but(six, 1, yaw=180), seats, (6, 5, 6)), ("15 degrees aslant", but(six, 5, yaw=-75), seats, (6, 5, 6)),
             ("off centre at the head", but(six, 5, y=0.08), seats, (6, 5, 6)), ("4 cm off", but(six, 5, y=0.04), seats, (6, 6, 6)), ("too far out", but(six, 5, x=1.35), seats, (6, 5, 6)),
             ("too far in", but(six, 6, x=-0.75), seats, (6, 5, 6)), ("one of two shifted", but(six, 1, x=-0.25), seats, (6, 5, 6)), ("spare far chair", six + [chair(4, 4, 0)], seats, (6, 6, 6)),
             ("only five", six[:6], seats, (5, 5, 6)), ("no table", six[1:], seats, (6, 0, 6)), ("empty", [], seats, (0, 0, 6)), ("table too many wanted", six, dict(seats, each=4), (6, 4, 6)),
             ("bench", [table, ("bench", 1.7, 0.35, 0, 0.5, 0, [])], {"rule": "seats at table", "seat": ["bench"], "table": ["table"], "count": 3}, (3, 3, 3)),
             ("round five", [roundt] + polar(5, 0.75), five, (5, 5, 5)), ("round, one looks aside", but([roundt] + polar(5, 0.75), 2, yaw=90), five, (5, 0 + 4, 5)),
             ("round, one 15 cm along", [roundt] + polar(5, 0.75)[:4] + [chair(0.75 * math.cos(-1.456), 0.75 * math.sin(-1.456), -173.4)], five, (5, 4, 5)),
             ("desk chair", desk, sit, (3, 1, 1)), ("desk, all", desk, [sit, vis], [(1, 1, 1), (2, 2, 2)]), ("desk chair behind", but(desk, 1, y=0.55, yaw=0), [sit, vis], [(0, 0, 1), (3, 3, 2)]),
             ("visitor turned away", but(desk, 2, yaw=180), [sit, vis], [(1, 1, 1), (2, 1, 2)]), ("desk chair 10 cm aside", but(desk, 1, x=0.1), [sit, vis], [(1, 0, 1), (2, 2, 2)]),
             ("nightstands", bed, night, (2, 2, 2)), ("at the foot", but(bed, 1, y=-0.85), night, (2, 1, 2)), ("20 cm off", but(bed, 1, x=1.25), night, (2, 1, 2)), ("turned", but(bed, 1, yaw=90), night, (2, 1, 2)),
             ("stools", bar, stools, (5, 5, 5)), ("stool off pitch", but(bar, 3, x=0.1), stools, (5, 4, 5)), ("stool turned away", but(bar, 5, yaw=180), stools, (5, 4, 5)), ("stool behind", but(bar, 5, y=-0.55, yaw=180), stools, (5, 4, 5)),
             ("rows with aisle", rows, audience, (18, 18, 18)), ("seat back", but(rows, 1, y=0.1), audience, (18, 17, 18)), ("seat turned", but(rows, 1, yaw=5), audience, (18, 17, 18)),
             ("seat aside", but(rows, 1, x=0.68), audience, (18, 17, 18)), ("screen behind", but(rows, 18, y=5), audience, (18, 0, 18)),
             ("salon", salon, mirror, (2, 2, 2)), ("chair beside mirror", but(salon, 1, x=0.1), mirror, (2, 1, 2)), ("chair backwards", but(salon, 3, yaw=0), mirror, (2, 1, 2)),
             ("hood", hob, hood, (1, 1, 1)), ("hood aside", but(hob, 1, x=0.08), hood, (1, 0, 1)), ("sofas", sofas, face, (2, 2, 2)), ("sofas shifted", but(sofas, 1, x=0.1), face, (2, 0, 2)),
             ("seating group", sofas, about, (3, 3, 3)), ("armchair away", but(sofas, 3, yaw=90), about, (3, 2, 3)), ("sofa off centre", but(sofas, 1, x=0.2), about, (3, 2, 3)),
             ("circle", polar(8, 2), {"rule": "circle", "thing": ["chair"], "count": 8}, (8, 8, 8)), ("circle, one in", but(polar(8, 2), 0, x=1.8), {"rule": "circle", "thing": ["chair"], "count": 8}, (8, 7, 8)),
             ("islands", isle, {"rule": "islands", "thing": ["desk"], "size": 4, "count": 8}, (8, 8, 8)), ("island broken", but(isle, 0, x=1.2), {"rule": "islands", "thing": ["desk"], "size": 4, "count": 8}, (8, 4, 8)),
             ("horseshoe", shoe, {"rule": "horseshoe", "thing": ["desk"], "count": 7}, (7, 7, 7)), ("desk chairs at a long desk", [("desk", 2.8, 0.7, 0, 0, 0), chair(-0.7, -0.5, 180), chair(0.7, -0.5, 180)], dict(sit, count=2), (2, 2, 2)),
             ("music stands", [("chair", 0.5, 0.5, 0, 0, 30), ("music stand", 0.5, 0.4, 0.3, -0.52, 210)], {"rule": "before", "thing": ["music stand"], "of": ["chair"], "count": 1}, (1, 1, 1)),
             ("fireside", [("fireplace", 1.4, 0.4, 0, 0, 0), ("wing chair", 0.8, 0.8, 1, -1, -45), ("wing chair", 0.8, 0.8, -1, -1, 45)], {"rule": "flanking", "thing": ["chair"], "of": ["fireplace"], "count": 2}, (2, 2, 2)),
             ("to the fire", [("fireplace", 1.4, 0.4, 0, 0, 0), ("sofa", 2, 0.9, 0, -2, 180)], {"rule": "toward", "thing": ["sofa"], "of": ["fireplace"], "centred": 1, "count": 1}, (1, 1, 1)),
             ("sofa beside the fire's axis", [("fireplace", 1.4, 0.4, 0, 0, 0), ("sofa", 2, 0.9, 0.1, -2, 180)], {"rule": "toward", "thing": ["sofa"], "of": ["fireplace"], "centred": 1, "count": 1}, (1, 0, 1)),
             ("horseshoe, one askew", but(shoe, 4, yaw=60), {"rule": "horseshoe", "thing": ["desk"], "count": 7}, (7, 6, 7))]
    bad = 0
    for name, scene, rules, wanted in cases:
        for degrees in (0, 37, 90, 200, -61.3):
            got = [(r["found"], r["right"], r["wanted"]) for r in judge({"expect": rules if isinstance(rules, list) else [rules]}, scene_of(scene, degrees))]
            if wanted is not None and got != (wanted if isinstance(wanted, list) else [wanted]):
                bad += print("FAILED %s at %s degrees: %s, expected %s" % (name, degrees, got, wanted)) is None
    return print("%d cases in 5 rooms each, %d failed" % (len(cases), bad)) or int(bad > 0)

def main():
    a = argparse.ArgumentParser(description=__doc__)
    for name in ("folder", "wishes"): a.add_argument(name, nargs="?", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "wishes.json") if name == "wishes" else None)
    a.add_argument("--half", choices=["open", "kept"])
    for flag in ("--json", "--self-test"): a.add_argument(flag, action="store_true")
    args = a.parse_args()
    if args.self_test or not args.folder: return self_test() if args.self_test else a.error("a folder is needed")
    results = []
    for w in json.load(open(args.wishes, encoding="utf-8")):
        scene = load(args.folder, w["id"])
        if args.half in (None, w["half"]): results.append({"id": w["id"], "half": w["half"], "scene": scene is not None, "rules": judge(w, scene or [])})
    sums = {h: totals([r for r in results if h in ("all", r["half"])]) for h in ("open", "kept", "all")}
    if args.json: return print(json.dumps({"wishes": results, "totals": sums}, indent=1))
    for w in results:
        for r in w["rules"]: print("%3d %s  %-26s found %3d  right %3d  wanted %3d%s" % (w["id"], w["half"], r["rule"], r["found"], r["right"], r["wanted"], "" if w["scene"] else "  (no scene)"))
    for h, t in sums.items():
        print("%s: %d wishes, %d scenes, %d whole" % (h, t["wishes"], t["scenes"], t["wishes_whole"]))
        for k in ("seats", "others", "all"): print("   %-6s" % k, "  ".join("%s %s" % (n, t[k][n]) for n in ("found", "right", "wanted", "right_share", "there_share", "there_and_right_share")))
if __name__ == "__main__": sys.exit(main())
