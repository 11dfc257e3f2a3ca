"""A case with all keys that are lists of numbers, in two and three dimensions; used by json_schema.py."""

CASE = '''name = "lengths"
[domain]
size = {ones}
elements = {eights}
grading = {{ box = [{quarters}, {three_quarters}] }}
[fluid]
viscosity = 0.01
capillarity = 0.1
temperature = 0.39
contact_angle = 90.0
wall_law = "energy"
contact_angle_range = [80, 100]
gravity = {zeros}
initial = [0.01, 0.8]
[substrate]
thickness = 0.5
young = 1.0
poisson = 0.3
material = "neo_hookean"
prestretch = {stretches}
surface_modulus = [1, 1]
gravity = {zeros}
gel = {{ exponent = 0.5, time = 1.0, decades = [-2, 2] }}
[[droplet]]
centre = {three_quarters}
radius = 0.1
stretch = {ones}
velocity = {zeros}
[[film]]
box = [{quarters}, {three_quarters}]
[[wave]]
field = "density"
amplitude = 0.01
mode = {twos}
[[load]]
box = [{tenths}, {quarters}]
force = {zeros}
path = {zeros}
[[needle]]
stiffness = 1.0
box = [{tenths}, {quarters}]
path = {zeros}
[[probe]]
name = "at_a_point"
quantity = "density"
point = {three_quarters}
[[probe]]
name = "in_a_box"
quantity = "density"
operation = "mean"
box = [{three_quarters}, {three_quarters}]
[initial]
from = "another_run"
time = [1]
velocity = {zeros}
displacement = {zeros}
[boundary]
bottom = "free"
foundation = [1, 1]
foundation_damping = [1, 1]
[time]
end = 0  # wrong: reading ends here, with all that is wrong, before the scene is made
[output]
history = {{ track = {track} }}
'''
NUMBERS = {"ones": "1.0", "eights": "8", "zeros": "0.0", "twos": "2", "tenths": "0.1", "quarters": "0.25", "three_quarters": "0.75"}


def case(dimension):
    lists = {name: f"[{', '.join([number] * dimension)}]" for name, number in NUMBERS.items()}
    track = "[1, 0]" if dimension == 3 else "[]"
    return CASE.format(**lists, stretches=f"[{', '.join(['1.1'] * (dimension - 1))}]", track=track)


def lists_of(schema, prefix=""):
    """(name, schema) of all keys that are lists of one number or text each, or boxes of two corners; a table of a list
    is its first."""
    for name, one in schema.get("properties", {}).items():
        items = one.get("items", {})
        if "properties" in one:
            yield from lists_of(one, f"{prefix}{name}.")
        elif "properties" in items:
            yield from lists_of(items, f"{prefix}{name}[0].")
        elif any("items" in choice for choice in (one, *one.get("anyOf", ()))):
            yield prefix + name, one


def resized(value, count):
    """A list of `count` entries: its own, then the last one again; or a box with such corners."""
    if value and isinstance(value[0], list):
        return [resized(corner, count) for corner in value]
    return [*value, *value[-1:] * count][:count]


def value_of(case, name):
    """The value of the key of that name, "load[0].box"; None where the case has none."""
    *tables, key = name.split(".")
    for table in tables:
        case = case.get(table.removesuffix("[0]"), {})
        case = case[0] if table.endswith("[0]") else case
    return case.get(key)
