#!/usr/bin/env python3
"""count.py: how much of what wishes say a model's reading holds.

judged.txt has the clauses that a reader who had not seen the program listed for wishes.txt, and what a second
one found of each in the readings of a strong model (roomgen plan --explain --json --reader model): Y held, P in
part or otherwise, N not, + what the wish does not say.
"""
import collections, pathlib, re

here = pathlib.Path(__file__).parent
marks = collections.Counter(line[0] for line in (here / "judged.txt").read_text().splitlines() if re.match(r"[YPN+] ", line))
clauses = marks["Y"] + marks["P"] + marks["N"]
print(f"clauses: {clauses}")
for mark, what in (("Y", "held"), ("P", "held in part"), ("N", "not held"), ("+", "not said")):
    print(f"{what}: {100 * marks[mark] / clauses:.1f} %")
