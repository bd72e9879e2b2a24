"""Validation against the JSON schemas in docs/."""

from pathlib import Path

from .files import read_json

DOCS = Path(__file__).resolve().parents[3] / "docs"
OF_FORMAT = {"roomgen-scene": "scene", "roomgen-plan": "plan", "roomgen-shape": "shape", "roomgen-program": "program",
             "roomgen-tour": "tour", "roomgen-design": "design"}


def schema_named(name):
    return read_json(DOCS / f"{name}.schema.json")


def validator(name):
    import jsonschema  # optional: only this module needs it
    from referencing import Registry, Resource

    names = [p.name.removesuffix(".schema.json") for p in DOCS.glob("*.schema.json")]
    resources = [(f"{n}.schema.json", Resource.from_contents(schema_named(n))) for n in names]
    return jsonschema.Draft202012Validator(schema_named(name), registry=Registry().with_resources(resources))


def errors(data, name=None):
    """Readable messages, each with the JSON pointer of the place."""
    name = name or OF_FORMAT.get(data.get("format"), "problem")
    found = sorted(validator(name).iter_errors(data), key=lambda e: list(map(str, e.absolute_path)))
    return [f"/{'/'.join(map(str, e.absolute_path))}: {e.message}" for e in found]
