#!/usr/bin/env python3
"""A reader of texts alone: learns which words go with right answers, then guesses questions about other rooms.

    guess.py FOLDER...        each with questions.jsonl: a group of its own, guessed by what the others teach

Guesses choices by naive Bayes: by wording and order alone, and by the things that are named too. Chance is one
of the choices offered; its interval is of 95 %.
"""

import json
import math
import re
import sys
from collections import defaultdict
from pathlib import Path

FOLDS = 5


def wording(question):
    """Of each choice: its place, its length among the others, and the way in which it is described."""
    form, count = question["form"], len(question["choices"])
    lengths = sorted(question["choices"], key=len)
    for place, choice in enumerate(question["choices"]):
        yield [(form, count, place), (form, count, "length", lengths.index(choice)), (form, "nearest" in choice)]


def everything(question):
    """And the thing that it names, beside each word of the question."""
    form = question["form"]
    words = set(re.findall(r"[a-z-]+", question["question"].lower()))
    for choice, found in zip(question["choices"], wording(question)):
        yield found + [(form, choice)] + [(form, word, choice) for word in words]


def learn(questions, features):
    known = defaultdict(lambda: [0.0, 0.0])
    for question in questions:
        share = 1 / len(question["choices"])
        for place, found in enumerate(features(question)):
            for feature in found:
                known[feature][0] += place == question["answer_index"]
                known[feature][1] += share
    return known


def guessed(known, question, features):
    scores = [sum(math.log((known[f][0] + 1) / (known[f][1] + 1)) for f in found if f in known) for found in features(question)]
    return scores.index(max(scores)) == question["answer_index"]


def report(questions):
    """`questions` are pairs of a group and a question; no group is guessed by what itself teaches."""
    choices = [(group, question) for group, question in questions if "choices" in question]
    names = sorted({group for group, _ in choices})
    fold = {name: k % FOLDS for k, name in enumerate(names)}
    by_form = defaultdict(lambda: [0, 0, 0, 0.0, 0.0])  # right by wording, by everything, all, by chance, variance
    for number in range(min(FOLDS, len(names))):
        taught = [question for group, question in choices if fold[group] != number]
        readers = [(learn(taught, features), features) for features in (wording, everything)]
        for group, question in choices:
            if fold[group] != number:
                continue
            share = 1 / len(question["choices"])
            right = [guessed(known, question, features) for known, features in readers]
            for form in (question["form"], "all"):
                for k, value in enumerate([*right, 1, share, share * (1 - share)]):
                    by_form[form][k] += value
    lines = ["| choices guessed from the text alone | number | by wording and order | by the things named too | by chance |", "|---|---|---|---|---|"]
    for form, (plain, full, count, chance, variance) in sorted(by_form.items(), key=lambda item: (item[0] == "all", item[0])):
        lines.append(f"| {form} | {count} | {100 * plain / count:.1f} % | {100 * full / count:.1f} % | "
                     f"{100 * chance / count:.1f} ± {196 * math.sqrt(variance) / count:.1f} % |")
    return "\n".join(lines) + "\n"


def main():
    print(report([(folder, json.loads(line)) for folder in sys.argv[1:] for line in (Path(folder) / "questions.jsonl").read_text().splitlines()]))


if __name__ == "__main__":
    main()
