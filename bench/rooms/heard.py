#!/usr/bin/env python3
"""What the words of many prompts are taken for: the share of content words that each meaning has.

usage: heard.py ROOMGEN PROMPTS.csv [--words] [--unchecked]

PROMPTS.csv has a column Description. With --words the runs that were not understood are listed, the
commonest first, with --unchecked those that were heard as something that should be checked and that no requirement checks,
and words in no entry at all; not for prompts that are kept for figures only.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import random
import re
import subprocess


def plan(roomgen, prompt):
    done = subprocess.run([roomgen, "plan", "--json", "--seed", "1", "--", prompt],
                          capture_output=True, text=True, timeout=120)
    return json.loads(done.stdout) if done.returncode == 0 else None


def words_of(plan):
    """How many words each meaning has, and the runs that were not understood."""
    counts, lost = collections.Counter(), []
    for heard in plan.get("heard", []):
        counts[heard["as"]] += len(heard["text"].split())
        if heard["as"] == "not understood":
            lost.append(heard["text"].lower())
    return counts, lost


CHECKED = {"thing", "count", "attribute", "relation", "absence", "room", "activity"}


def unchecked(prompt, plan):
    """Runs that nothing checks, each with what it was heard as, and words that no entry has ("only", "each")."""
    heard = plan.get("heard", [])
    runs = [(each["as"], each["text"].lower()) for each in heard if each["as"] in CHECKED and not each.get("requirements")]
    raw, spans = prompt.encode(), [each["span"] for each in heard]
    for match in re.finditer(rb"\b(only|each|every|both|none|nothing|neither|except|all|per)\b", raw, re.I):
        if not any(begin <= match.start() < end for begin, end in spans):
            runs.append(("silent", raw[match.start(): match.end() + 30].decode(errors="replace")))
    return runs


def interval(shares, rounds=2000):
    """The 95 % bootstrap interval of a ratio of sums, over prompts."""
    draw = random.Random(1)
    means = []
    for _ in range(rounds):
        sample = [draw.choice(shares) for _ in shares]
        means.append(sum(lost for lost, _ in sample) / max(1, sum(all_ for _, all_ in sample)))
    means.sort()
    return means[int(0.025 * rounds)], means[int(0.975 * rounds)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("roomgen")
    parser.add_argument("prompts")
    parser.add_argument("--words", action="store_true")
    parser.add_argument("--unchecked", action="store_true")
    arguments = parser.parse_args()
    with open(arguments.prompts, newline="", encoding="utf-8") as file:
        prompts = [row["Description"] for row in csv.DictReader(file)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        plans = list(pool.map(lambda prompt: plan(arguments.roomgen, prompt), prompts))
    total, lost, shares = collections.Counter(), collections.Counter(), []
    for each in plans:
        if each is None:
            continue
        counts, runs = words_of(each)
        total += counts
        lost.update(runs)
        shares.append((counts["not understood"], sum(counts.values())))
    words = sum(total.values())
    print(f"{len(prompts)} prompts, {plans.count(None)} refused, {words} content words")
    for meaning, count in total.most_common():
        print(f"  {meaning:16} {100 * count / words:5.1f} %")
    low, high = interval(shares)
    print(f"  not understood, 95 % interval over prompts: {100 * low:.1f} to {100 * high:.1f} %")
    if arguments.unchecked:
        found = collections.Counter(run for prompt, each in zip(prompts, plans) if each for run in unchecked(prompt, each))
        for (meaning, run), count in found.most_common():
            print(f"{count:4} {meaning:10} {run}")
    if arguments.words:
        for run, count in lost.most_common():
            print(f"{count:4} {run}")


if __name__ == "__main__":
    main()
