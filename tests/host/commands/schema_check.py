"""Whether a scene keeps to what `kfast schema --json` says: independent of the compiler."""

import math

NUMBERS = ("number", "whole number", "time", "moment")


def fits_kind(unit, value, kind):
    type_name = kind["type"]
    if unit is not None and type_name not in ("time", "moment"):
        return False
    if type_name in NUMBERS and isinstance(value, str):
        return True  # an expression, which only the compiler computes
    if type_name in NUMBERS:
        is_number = isinstance(value, float)
        return (is_number and kind.get("least", -math.inf) <= value <= kind.get("most", math.inf)
                and (type_name != "whole number" or value == int(value)))
    if type_name == "truth":
        return isinstance(value, bool)
    return isinstance(value, str) and value in kind.get("words", [value])


def mistakes_in_way(node, way):
    """What is wrong with a node if it is written that way."""
    found = []
    kinds, count = way["values"]["kinds"], len(node.arguments)
    if count < way["values"]["least"] or (way["values"]["most"] is not None and count > way["values"]["most"]):
        found.append(f"{node.name} has {count} values")
    for place, (unit, value) in enumerate(node.arguments[:count if kinds else 0]):
        if not fits_kind(unit, value, kinds[min(place, len(kinds) - 1)]):
            found.append(f"{node.name} has the value {value}")
    known = {each["name"]: each for each in way["properties"]}
    for name, (unit, value) in node.properties.items():
        kind = known.get(name, way.get("any_property"))
        if kind is None:
            found.append(f"{node.name} has no property {name}")
        elif not fits_kind(unit, value, kind):
            found.append(f"{node.name} has {name}={value}")
    found += [f"{node.name} needs {name}" for name, each in known.items()
              if each.get("required") and name not in node.properties]
    return found


def ways_of(name, ids, schema):
    """How a node of that name may be written where the nodes `ids` may stand."""
    here = [way for way in schema["nodes"] if way["id"] in ids]
    named = [way for way in here if way["name"] == name and not way.get("any_name")]
    return named or [way for way in here if way.get("any_name")]


def mistakes_in(nodes, ids, schema, holder="a scene"):
    found = []
    for node in nodes:
        ways = ways_of(node.name, ids, schema)
        if not ways:
            found.append(f"{holder} has no node {node.name}")
            continue
        # The way that knows the nodes inside is the one that is meant, and then the one with the fewest mistakes.
        found += min((mistakes_in_way(node, way) + mistakes_in(node.nodes, way["nodes"], schema, node.name)
                      for way in ways), key=lambda each: (sum(f"{node.name} has no node" in one for one in each), len(each)))
    return found


def mistakes(nodes, schema):
    return mistakes_in(nodes, schema["outermost"], schema)
