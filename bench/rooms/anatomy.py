#!/usr/bin/env python3
"""Which stage lost what rows ask for: anatomy.py ROWS.csv FOLDER [--list STAGE]

FOLDER is what run.py made of ROWS.csv. Every count and relation that does not hold is laid to the first stage that
lost it, read from the ledger of the room (scene.json) and the scores; with --list those of one stage, or `all`.
Not for rows that are kept for figures only.
"""
import argparse
import collections
import json
from pathlib import Path

def singular(word):
    return word[:-1] if word.endswith("s") and not word.endswith("ss") else word


def last_word(name):
    return singular(name.replace("_", " ").split()[-1])


def says(text, name):
    return last_word(name) in [singular(word) for word in text.lower().replace("-", " ").split()]


class Room:
    def __init__(self, scene, score):
        self.scene, self.matched = scene, score.get("matched", {})
        self.requirements = scene.get("requirements", [])
        self.relations = [one for one in self.requirements if one["kind"] == "relation"]

    def ids(self, name):
        return set(self.matched.get(name, []))

    def lost_thing(self, name):
        """Why nothing of a name is in the room."""
        for one in self.scene.get("unplaced", []):
            if says(one["category"], name) or says(one.get("description", ""), name):
                return "asked, not placed"
        for one in self.scene["objects"]:
            if says(one.get("description", ""), name) or says(one["category"], name):
                return "stand-in" if "stand_in" in one else "there, not known as such"
        named = [one for one in self.requirements if one["kind"] == "count" and says(one["clause"], name)]
        if named:
            return "said, made as another kind"
        words = [one for one in self.scene.get("heard", []) if says(one["text"], name)]
        if not words:
            return "name not in the words"
        return "not understood" if all(one["as"] == "not understood" for one in words) else \
            "heard as " + words[0]["as"]

    def lost_count(self, parts):
        wanted, name = int(parts[1]), parts[2]
        there = self.ids(name)
        if not there:
            return self.lost_thing(name)
        about = [one for one in self.requirements
                 if one["kind"] == "count" and there & set(one.get("subjects", []))]
        asked = sum(one.get("count", 0) for one in about)
        if not about:
            return "unasked things count"
        if asked != wanted:
            return "number misread"
        return "asked, not placed" if len(there) < wanted else "more than asked"

    def lost_relation(self, parts):
        """eq,N,relation,anchor,A,B"""
        anchor = int(parts[3]) if parts[3].lstrip("-").isdigit() else 0
        names = parts[4:]
        for name in names:
            if not self.ids(name):
                return "thing missing: " + self.lost_thing(name)
        target = names[anchor if 0 <= anchor < len(names) else 0]
        subject = next((name for name in names if name != target), target)
        a, b = self.ids(subject), self.ids(target)
        tied = [one for one in self.relations if
                (a & set(one["subjects"]) and b & set(one.get("targets", []))) or
                (b & set(one["subjects"]) and a & set(one.get("targets", [])))]
        if tied:
            if all(one["met"] for one in tied):
                return "asked and met, the scorer says no"
            return "asked, not met"
        if any(a & set(one["subjects"]) and one.get("targets") for one in self.relations):
            return "tied to another thing"
        return "relation not read"

    def lost_room_relation(self, parts):
        """eq,N,relation,A,part"""
        things = self.ids(parts[3])
        if not things:
            return "thing missing: " + self.lost_thing(parts[3])
        part = parts[4] if len(parts) > 4 else "room"
        mine = [one for one in self.relations if things & set(one["subjects"])]
        of_room = [one for one in mine
                   if not one.get("targets") or
                   any(target.split("-")[0] in ("window", "door", "wall", "middle") or "-" in target and
                       target.split("-")[-1] in ("half", "third", "quarter") for target in one["targets"])]
        mounts = [one for one in self.requirements if one["kind"] == "attribute" and
                  one.get("attribute", "").startswith("mount") and things & set(one["subjects"])]
        if not of_room and not mounts:
            return "tied to another thing" if mine else f"relation not read ({part})"
        if all(one["met"] for one in of_room + mounts):
            return "asked and met, the scorer says no"
        return "asked, not met"


def anatomy(folder, scores):
    for score in scores["scores"]:
        path = folder / score["id"] / "scene.json"
        if not path.exists():
            continue
        room = Room(json.loads(path.read_text()), score)
        for measure, why in (("CNT", room.lost_count), ("OOR", room.lost_relation), ("OAR", room.lost_room_relation)):
            for one in score.get(measure, []):
                if one["satisfied"]:
                    continue
                parts = [part.strip() for part in one["requirement"].split(",")]
                yield measure, why(parts), score["id"], one


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("rows", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--list")
    options = parser.parse_args()
    scores = json.loads((options.folder / "scores.json").read_text())
    table = collections.defaultdict(collections.Counter)
    lines = []
    for measure, stage, row, one in anatomy(options.folder, scores):
        table[stage][measure] += 1
        if options.list in ("all", stage):
            lines.append(f"{row} {measure} {one['requirement']}: {stage} ({one['reason']})")
    print("| stage | CNT | OOR | OAR |\n|---|---|---|---|")
    for stage, counts in sorted(table.items(), key=lambda item: -sum(item[1].values())):
        print(f"| {stage} | {counts['CNT']} | {counts['OOR']} | {counts['OAR']} |")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
