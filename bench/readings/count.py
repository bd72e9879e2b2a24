#!/usr/bin/env python3
"""count.py: how much of what wishes say a model's reading holds (bench/results/readings.json).

judged.txt has the clauses that a reader who had not seen the program listed for wishes.txt, and what a second
one found of each in the readings of a strong model (roomgen plan --explain --json --reader model): Y held, P in
part or otherwise, N not, + what the wish does not say.
"""
import collections, json, pathlib, re

here = pathlib.Path(__file__).parent
marks = collections.Counter(line[0] for line in (here / "judged.txt").read_text().splitlines() if re.match(r"[YPN+] ", line))
clauses = marks["Y"] + marks["P"] + marks["N"]
json.dump({"wishes": len((here / "wishes.txt").read_text().splitlines()), "clauses": clauses, "held": marks["Y"],
           "in_part": marks["P"], "not_held": marks["N"], "invented": marks["+"],
           "held_percent": round(100 * marks["Y"] / clauses, 1),
           "invented_percent": round(100 * marks["+"] / clauses, 1)},
          open(here.parent / "results" / "readings.json", "w"), indent=1)
