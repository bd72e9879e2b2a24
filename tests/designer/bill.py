#!/usr/bin/env python3
"""What roomgen says that a model took is what the endpoint counted, however the endpoint behaves.

    bill.py ROOMGEN FOLDER

Every mode of endpoint.py over a real HTTP server; exit code 1 if a bill differs, or a bound does not hold.
"""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from endpoint import MODES, Endpoint

PROMPT = "a bedroom with a bed, a nightstand, a wardrobe and a desk"
PRICE = (2.5e-6, 10e-6)  # dollars a token of gpt-4o, in and out (data/prices.json)
BY_RULES = {"thinking_empty", "thinking_until_4000", "error_200", "error_string", "context", "slow", "repeat"}
OPTIONS = {"slow": ["--idle-seconds", "0.5"]}
# How often each is asked at most within these bounds.
BOUNDS = [
    ("thinking_empty", ["--max-tokens", "5300"], 1),
    ("thinking_empty", ["--max-dollars", "0.05"], 1),
    ("thinking_empty", ["--max-calls", "2"], 2),
    ("error_200", ["--max-calls", "3"], 3),
    ("lmstudio_no_schema", ["--max-calls", "1"], 1),
    ("slow", ["--max-tokens", "5300", *OPTIONS["slow"]], 1),
    ("loading", ["--max-calls", "4"], 4),
    ("good", ["--max-tokens", "7000"], 100),
]


def measure(roomgen, folder, mode, *options):
    """A room furnished by an endpoint of this mode: exit code, summary if any, what was said, and the endpoint's bill."""
    with Endpoint(mode) as endpoint:
        command = [roomgen, "--json", "generate", PROMPT, "-o", str(folder), "--force", "--no-pictures", "--designer", "model", "--reader", "rules", "--steps", "objects", "--plan-tokens", "4096",
                   "--model", "gpt-4o", "--base-url", endpoint.url, *options]  # fmt: skip
        done = subprocess.run(command, capture_output=True, text=True)
    summary = json.loads(done.stdout) if done.stdout else None
    return done.returncode, summary, done.stderr, endpoint


def differences(mode, summary, endpoint):
    """What of a bill is not as the endpoint counted."""
    bill = summary["model"]
    wanted = {"calls": endpoint.requests, "estimated_calls": endpoint.uncounted}
    if not endpoint.uncounted:
        wanted |= {"input_tokens": endpoint.input_tokens, "output_tokens": endpoint.output_tokens}
    dollars = bill["input_tokens"] * PRICE[0] + bill["output_tokens"] * PRICE[1]
    found = [f"{mode}: {bill[key]} {key}, not {value}" for key, value in wanted.items() if bill[key] != value]
    if abs(bill["dollars"] - dollars) > 1e-6:
        found.append(f"{mode}: {bill['dollars']} dollars, not {dollars}")
    if bill["input_tokens"] < endpoint.input_tokens or bill["output_tokens"] < endpoint.output_tokens:
        found.append(f"{mode}: fewer tokens than the endpoint counted")
    return found


def check_mode(roomgen, folder, mode):
    code, summary, said, endpoint = measure(roomgen, folder / mode, mode, *OPTIONS.get(mode, []))
    if code or not summary:
        return [f"{mode}: exit {code}: {said}"]
    found = differences(mode, summary, endpoint)
    bill = summary["model"]
    by_rules = bill["plan_by_rules"] or bill["fallbacks"] > 0
    if by_rules != (mode in BY_RULES):
        found.append(f"{mode}: by rules: {by_rules}, why: {bill['why_rules']}, {said}")
    if by_rules and not bill["why_rules"]:
        found.append(f"{mode}: not said why rules took over")
    if mode == "slow" and "--idle-seconds" not in bill["why_rules"]:
        found.append(f"slow: the option is not named: {bill['why_rules']}")
    if mode.startswith("no_vision") and said.count("asked without them") != 1:
        found.append(f"{mode}: not said once that there are no pictures: {said}")
    return found


def check_bound(roomgen, folder, mode, options, most):
    found, name = [], f"{mode} {' '.join(options)}"
    code, summary, said, endpoint = measure(roomgen, folder / name, mode, *options)
    if not 1 <= endpoint.requests <= most:
        found.append(f"{name}: {endpoint.requests} requests, not {most}")
    if options[0] == "--max-tokens" and endpoint.input_tokens + endpoint.output_tokens > int(options[1]):
        found.append(f"{name}: {endpoint.input_tokens} + {endpoint.output_tokens} tokens")
    if summary:
        found += differences(name, summary, endpoint)
    elif f"{endpoint.requests} call" not in said:
        found.append(f"{name}: exit {code} without a bill: {said}")
    return found


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    with ThreadPoolExecutor(4) as pool:  # some modes are waited for
        modes = pool.map(lambda mode: check_mode(roomgen, folder, mode), MODES)
        bounds = pool.map(lambda bound: check_bound(roomgen, folder, *bound), BOUNDS)
        found = [line for lines in (*modes, *bounds) for line in lines]
    print("\n".join(found) or f"{len(MODES)} modes and {len(BOUNDS)} bounds are as the endpoint counted")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
