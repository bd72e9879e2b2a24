"""Reads what tests/checker/check_scene.py --json prints and writes one line about all scenes."""

import json
import sys

reports = json.load(sys.stdin)
held = sum(r["constraints"]["held"] for r in reports)
total = sum(r["constraints"]["total"] for r in reports)
print(
    f"- {sys.argv[1]}: {held} of {total} constraints held ({100 * held / total:.1f} %), "
    f"{sum(r['objects'] for r in reports)} objects placed, {sum(len(r['unplaced']) for r in reports)} left out, "
    f"{sum(len(r['violations']) for r in reports)} violations in {len(reports)} scenes"
)
