#!/usr/bin/env python3
"""How many of the edit sentences are understood as meant.

    run.py ROOMGEN open|more|learned|held-out|kept [--rooms FOLDER] [--jobs N] [--show] [--reader bench_edit_sentences]

For each sentence the room of its scene is made (once, in FOLDER), what comes `before` is carried out, and
`roomgen edit --dry-run` says which operations it takes the sentence for. What should be done counts when these
are the operations meant, on the kinds of things meant; what should be asked back, when it exits with 2; what
should be refused, when the edit itself exits with 1 or 2 and scene.json stays as it was. With --reader sentences that have nothing
`before` are read by that program, all in one process: as the command reads them, and much sooner. --show lists what went
wrong, for what may be looked at.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MARKED = HERE.parent.parent / "data" / "language" / "edits"
FILES = {**{part: HERE / f"{part}.jsonl" for part in ("open", "more", "kept")},
         **{part: MARKED / f"{part}.jsonl" for part in ("learned", "held-out")}}
SAME_DEED = {"put": "move", "shift": "move", "turn": "rotate", "face": "rotate", "recolor": "recolour",
             "cover": "recolour", "reform": "edit form", "open": "room", "close": "room", "refit": "room",
             "reshape": "room"}
# What the sentences call things, and what scenes may call them.
SAME_THING = [{"bin", "trash", "basket", "wastebasket"}, {"fridge", "refrigerator"}, {"tv", "television"},
              {"painting", "picture", "poster", "map", "art"}, {"wall", "walls"}, {"crib", "cot"},
              {"tub", "bathtub"}, {"basin", "washbasin", "sink", "vanity"}, {"chaise", "longue"},
              {"stove", "range", "oven", "cooker"}, {"screen", "divider"}, {"stool", "stools"},
              {"plant", "plants"}, {"counter", "bar"}, {"mat", "rug"}, {"cabinet", "sideboard", "cupboard"},
              {"hamper", "basket"}, {"bookshelf", "bookcase", "shelf"}, {"couch", "sofa"}, {"toy", "toys"}]


def words_of(text):
    return {w[:-1] if w.endswith("s") and len(w) > 3 else w for w in re.findall(r"[a-z]+", (text or "").lower())}


def alike(meant, found):
    a, b = words_of(meant), words_of(found)
    if a & b:
        return True
    return any((group & a) and (group & b) for group in ({w.rstrip("s") if len(w) > 3 else w for w in g} | g for g in SAME_THING))


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)


def place_of(operation, document, objects):
    """What stands where a thing is put, and what is below it there."""
    x, y = operation["position"]
    there = [o for o in document["objects"]
             if abs(o["position"][0] - x) < 0.02 and abs(o["position"][1] - y) < 0.02 and o["id"] != operation["object"]]
    return " ".join([objects.get(operation.get("on"), "")] + [objects[o["id"]] for o in there])


def things_of(operation, objects, document):
    """(deed, what it is done to, towards what) for each thing."""
    deed = SAME_DEED.get(operation["do"], operation["do"])
    if deed == "lock" and not operation.get("locked", True):
        deed = "unlock"
    name = lambda i: objects.get(i, re.sub(r"-\d+$", "", i))
    target = " ".join([name(r.split(",", 1)[1].strip()) if "," in r else r for r in operation.get("relations", [])])
    target = target or name(operation.get("target", ""))
    if operation["do"] == "put":
        target = place_of(operation, document, objects)
    if deed == "swap":
        return [(deed, name(operation["first"]) + " " + name(operation["second"]), "")]
    if deed == "add":
        return [(deed, operation["category"] + " " + operation.get("description", ""), target)]
    if "part" in operation:
        return [(deed, operation["part"], target)]
    if deed == "room":
        what = operation.get("openings", [operation.get("opening") or operation.get("kind") or operation.get("wall")])
        return [(deed, re.sub(r"-\d+", "", i or "ceiling"), target) for i in what]
    return [(deed, name(i), target) for i in operation.get("objects", [operation.get("object", "")])]


def is_covering(meant):
    """Of the room, but a colour or a stuff for what is there."""
    parts = words_of("floor walls ceiling")
    return meant["op"] == "room" and bool(meant.get("to")) and not meant.get("amount") and \
        bool(words_of(meant["kind"]) & parts)


def is_meant(operations, meaning, objects, document):
    # To stand around something, or in a line, is to be moved there.
    meaning = [{**m, "op": "move" if m["op"] == "rearrange" and m.get("relation") else m["op"]} for m in meaning]
    meaning = [{**m, "op": "recolour" if is_covering(m) else m["op"]} for m in meaning]
    said = [thing for operation in operations for thing in things_of(operation, objects, document)]
    # With a group go the chairs around it.
    for operation in operations:
        if operation.get("group"):
            said += [(operation["do"], "chairs stools", "around " + said[0][1])]
            meaning = [{**m, "target": None} if m["op"] == "move" else m for m in meaning]
    if any(operation["do"] == "revert" for operation in operations):
        return any(m["op"] == "undo" or "former place" in str(m.get("relation")) for m in meaning)
    everything = [m for m in meaning if m.get("kind") in (None, "everything")]
    for m in meaning:
        mine = [s for s in said if s[0] == m["op"] and (m in everything or alike(m["kind"], s[1]))]
        if not mine:
            return False
        mine = [s for s in mine if words_of(m["kind"]) <= words_of(s[1])] or mine
        if m["op"] == "swap" and not alike(m["target"], mine[0][1]):
            return False
        if m["op"] in ("move", "add", "rotate") and m.get("target") and m["target"] not in ("room", "wall") and \
                not str(m.get("amount") or "").strip() and not all(alike(m["target"], s[2]) for s in mine):
            return False
    return all(any(s[0] == m["op"] and (m in everything or alike(m["kind"], s[1])) for m in meaning) for s in said)


def read_at_once(reader, rooms, cases):
    """What the reader says to those that stand alone, by id."""
    alone = [case for case in cases if not case.get("before") and case["outcome"] != "refused"]
    lines = "".join(json.dumps(case) + "\n" for case in alone)
    said = subprocess.run([reader, rooms], input=lines, capture_output=True, text=True, check=True).stdout
    return {answer["id"]: answer for answer in map(json.loads, said.splitlines())}


def verdict_on(case, operations, said, document):
    """`operations`: nothing if they were not understood."""
    objects = {o["id"]: o["category"] + " " + o["description"] for o in document["objects"]}
    if case["outcome"] == "ambiguous":
        return ("as meant" if operations is None else "wrong"), said
    if operations is None:
        return "not understood", said
    return ("as meant" if is_meant(operations, case["meaning"], objects, document) else "wrong"), said


def outcome(program, folder, case):
    scene = folder / "scene.json"
    for sentence in case.get("before", []):
        run(program, "edit", scene, sentence, "--no-pictures", "--quiet")
    document = json.loads(scene.read_text())
    dry = run(program, "edit", scene, case["sentence"], "--dry-run", "--quiet")
    said = dry.stdout if dry.returncode == 0 else dry.stderr
    if case["outcome"] == "refused":
        before = scene.read_bytes()
        done = run(program, "edit", scene, case["sentence"], "--no-pictures", "--quiet")
        same = scene.read_bytes() == before
        return ("as meant" if done.returncode in (1, 2) and same else "wrong"), said + done.stderr
    return verdict_on(case, json.loads(dry.stdout) if dry.returncode == 0 else None, said, document)


def make_rooms(program, folder, scenes):
    for scene in scenes:
        room = folder / scene["id"]
        if not (room / "scene.json").exists():
            run(program, "generate", scene["prompt"], "--seed", scene["seed"], "-o", room, "--no-pictures", "--quiet")


def judge(program, rooms, case, read):
    if case["id"] in read:
        answer = read[case["id"]]
        document = json.loads((rooms / case["scene"] / "scene.json").read_text())
        return verdict_on(case, answer.get("operations"), json.dumps(answer.get("operations") or answer.get("error")), document)
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "room"
        copy.mkdir()
        shutil.copy(rooms / case["scene"] / "scene.json", copy)
        return outcome(program, copy, case)


def lines_of(path):
    return list(map(json.loads, path.read_text().splitlines()))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("part", choices=list(FILES))
    parser.add_argument("--rooms", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "roomgen-edit-rooms")
    parser.add_argument("--jobs", type=int, default=2, help="sentences at a time")
    parser.add_argument("--reader", help="bench_edit_sentences")
    parser.add_argument("--show", action="store_true")
    options = parser.parse_args()
    cases = lines_of(FILES[options.part])
    make_rooms(options.program, options.rooms, lines_of(HERE / "scenes.jsonl"))
    read = read_at_once(options.reader, options.rooms, cases) if options.reader else {}
    counts = {"as meant": 0, "not understood": 0, "wrong": 0}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as workers:
        verdicts = list(workers.map(lambda case: judge(options.program, options.rooms, case, read), cases))
    for case, (verdict, said) in zip(cases, verdicts):
        counts[verdict] += 1
        if options.show and options.part not in ("kept", "held-out") and verdict != "as meant":
            print(f"{case['id']} {verdict}: {case['sentence']}\n    {' '.join(said.split())[:400]}")
    share = 100.0 * counts["as meant"] / len(cases)
    print(f"{options.part}: {counts['as meant']} of {len(cases)} as meant ({share:.0f} %), "
          f"{counts['not understood']} not understood, {counts['wrong']} wrong")


if __name__ == "__main__":
    main()
