"""Every combination that programs have to hold really is in those of the first 500 seeds, and how often.

    test_grammar.py [--count N] [--seed S]

Both distance modes with both levels of retraction in all planes, changes of units and offsets within a series of canned
cycles, cutter compensation in both planes, and each form of flow. Read from the texts, not from what the grammar means to write.
"""
import argparse
import collections
import re

import generator

CODES = re.compile(r"[GM] ?\d+(?:\.\d+)?")
CYCLES = ("G73", "G74", "G81", "G82", "G83", "G84", "G85", "G86", "G89")
FLOW = ("sub", "endsub", "call", "return", "if", "elseif", "else", "endif", "while", "endwhile", "do", "repeat", "endrepeat",
        "break", "continue")
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
COMPENSATION = ("G41", "G42", "G41.1", "G42.1")
MOTIONS = ("G0", "G1", "G2", "G3", "G5", "G5.1", "G5.2", "G33", "G33.1", "G76", "G38.2", "G80", "G53", "G28", "G30", "M2", "M30")


def count(text, counts):
    """Adds what one program has."""
    modes, series = {"distance": "G90", "retract": "G98", "plane": "G17"}, None
    for line in text.splitlines():
        flow = re.match(r"o(?:\d+|<[^>]*>) ([a-z]+)", line)
        if flow:
            counts["o " + flow[1]] += 1
        codes = CODES.findall(re.sub(r"\([^)]*\)|;.*|#<[^>]*>", "", line).upper())
        for code in codes:
            if code in ("G90", "G91"):
                modes["distance"] = code
            elif code in ("G98", "G99"):
                modes["retract"] = code
            elif code in ("G17", "G18", "G19"):
                modes["plane"] = code
            elif series and code in ("G20", "G21"):
                counts[f"within {modes['retract']} {modes['plane']}: units"] += 1
            elif series and (code in SYSTEMS or code.startswith("G92")):
                counts[f"within {modes['retract']} {modes['plane']}: offsets"] += 1
        cycle = next((code for code in codes if code in CYCLES), None)
        series = cycle or (None if any(code in MOTIONS for code in codes) else series)
        for code in codes:
            if code in COMPENSATION:
                counts[f"{code} {modes['plane']}"] += 1
        if cycle:
            counts[cycle] += 1
            counts[" ".join(("series", *modes.values()))] += 1


def wanted():
    planes, retracts = ("G17", "G18", "G19"), ("G98", "G99")
    names = [f"series {distance} {retract} {plane}" for distance in ("G90", "G91") for retract in retracts for plane in planes]
    names += [f"within {retract} {plane}: {what}" for retract in retracts for plane in planes for what in ("units", "offsets")]
    names += [f"{code} {plane}" for code in COMPENSATION for plane in ("G17", "G18")]
    return names + [*CYCLES] + ["o " + word for word in FLOW]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    counts = collections.Counter()
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        count(generator.program(seed), counts)
    for name in wanted():
        print(f"{counts[name]:7} {name}")
    missing = [name for name in wanted() if not counts[name]]
    assert not missing, f"no program has {missing}"


if __name__ == "__main__":
    main()
